#!/usr/bin/env bash
# quickstart.sh: runs examples/quickstart.sh twice in a copy of the sources whose path has a blank, from elsewhere. It
# must print the samples and write to nothing but build/. Environment as for consumer.sh.
set -euo pipefail
copy="$FOLDER/quick start"
rm -rf "$copy"
mkdir -p "$copy/tests"
cp -R "$SOURCE"/{CMakeLists.txt,capi,examples,include,pkgconfig,src} "$copy"
cp -R "$SOURCE/tests/support" "$copy/tests"

state() { (cd "$copy" && find . -path ./build -prune -o -type f -exec cksum {} +) | sort; }
before=$(state)
cd /
for run in first second; do
  said=$("$copy/examples/quickstart.sh" 2>&1) || { echo "$said"; exit 1; }
  csv=$(sed -n 's/^== First samples of //p' <<<"$said")
  head -n 6 "$csv" | diff - <(tail -n 6 <<<"$said")
  [ "$(wc -l <"$csv")" -gt 9000 ]
  [[ $csv == "$copy"/build/* ]]
done
diff <(echo "$before") <(state)
