#!/usr/bin/env bash
# quickstart.sh: runs examples/quickstart.sh twice in a copy of the sources whose path has a blank, from elsewhere. It
# must show how the spacecraft turns, in rows of the file it wrote, and write to nothing but build/; what it tells to do
# next must work. Environment as for consumer.sh.
set -euo pipefail
copy="$FOLDER/quick start"
rm -rf "$copy"
mkdir -p "$copy/tests" "$copy/build/bin"
for name in CMakeLists.txt capi examples include pkgconfig src; do
  [ ! -e "$SOURCE/$name" ] || cp -R "$SOURCE/$name" "$copy"
done
cp -R "$SOURCE/tests/support" "$copy/tests"
ln -s "$(command -v "$CC")" "$copy/build/bin/cc"
PATH=$copy/build/bin:$PATH

fail() { echo "$*"; exit 1; }
state() { (cd "$copy" && find . -path ./build -prune -o -type f -exec cksum {} +) | sort; }
before=$(state)
export QTRAJ_CMAKE_ARGS=-DQTRAJ_TARGETS=scalar  # it is about the script; vector kernels take the compiler longest
cd /
for run in first second; do
  said=$("$copy/examples/quickstart.sh" 2>&1) || fail "$said"
  csv=$copy/$(sed -n 's/^   All samples: //p' <<<"$said")
  [ "$(wc -l <"$csv")" -gt 9000 ]
  [[ $csv == "$copy"/build/* ]]

  # each row is one of the file, rounded, and turned further than the one before it
  rows=$(grep -E '^ +[0-9]+ s .* degrees$' <<<"$said")
  [ "$(wc -l <<<"$rows")" -ge 5 ] || fail "shows fewer than five rows of a turn: $rows"
  awk -F, 'NR == FNR { sample[$1 + 0] = sprintf("%.3f %.3f %.3f %.3f", $2, $3, $4, $5); next }
    { split($0, part, " ") }
    sample[part[1]] != part[3] " " part[4] " " part[5] " " part[6] { print "not in the file: " $0; bad = 1 }
    FNR > 1 && part[7] < last + 3 { print "hardly turned: " $0; bad = 1 }
    { last = part[7] }
    END { exit bad || last < 90 }' "$csv" - <<<"$rows" || fail "$rows"
done
grep -qE '^== This takes some seconds' <<<"$said" || fail "the second run does not say that it takes seconds"
! grep -q 'Building CXX object' <<<"$said" || fail "the second run builds again: $said"
diff <(echo "$before") <(state)

# What next: the indented commands, from a path without a blank, as pkg-config needs it
ln -sfn "$copy" "$FOLDER/quick_start"
cd "$FOLDER/quick_start"
commands=$(sed -n '/^== What next/,$s/^     //p' <<<"$said")
[ "$(wc -l <<<"$commands")" -ge 4 ] || fail "does not tell what next"
printf '#include <qtraj.h>\nint main(void) { return qtraj_version()[0] != QTRAJ_VERSION_STRING[0]; }\n' >app.c
sh -e <<<"$commands" >/dev/null
LD_LIBRARY_PATH=$PWD/build/quickstart/prefix/lib ./app
