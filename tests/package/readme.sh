#!/usr/bin/env bash
# readme.sh: takes the snippets out of README.md, builds and runs them against the installed library as the README says,
# checks the README's claims about the library (readme/*.c), and that it names everything in the header and nothing that
# is not there. Environment as for consumer.sh.
set -euo pipefail
libdir=$FOLDER/prefix/$LIBDIR
readme=$SOURCE/README.md
header=$SOURCE/include/qtraj.h
export PKG_CONFIG_PATH=$libdir/pkgconfig
export LD_LIBRARY_PATH=$libdir
unset PKG_CONFIG_LIBDIR PKG_CONFIG_SYSROOT_DIR CFLAGS LDFLAGS

rm -rf "$FOLDER/readme"
mkdir "$FOLDER/readme"
cd "$FOLDER/readme"
failed=0
fail() { echo "README.md: $*"; failed=1; }

# ---- Snippets: the block after a line <!-- name --> is the file of that name ----

awk '/^<!-- .* -->$/ { name = $2; next }
     /^```/ { inside = !inside; if (!inside) name = ""; next }
     inside && name != "" { print >name }' "$readme"

mkdir bin
ln -s "$(command -v "$CC")" bin/cc
PATH=$PWD/bin:$PATH sh -e build.sh
./app | diff app.txt - || fail "the program prints something else"
./app_static | diff app.txt - || fail "the static program prints something else"
[ "$(wc -l <app.c)" -le 10 ] || fail "the program has more than ten lines"

"$CMAKE" -G "$GENERATOR" -S . -B build -DCMAKE_C_COMPILER="$CC" -DCMAKE_PREFIX_PATH="$FOLDER/prefix"
"$CMAKE" --build build
build/app | diff app.txt - || fail "the program built by CMake prints something else"

[ "$(wc -l <app.py)" -le 6 ] || fail "the Python program has more than six lines"
[ "1 s  $(python3 app.py)" = "$(sed -n 2p app.txt)" ] || fail "Python prints something else"

# ---- Claims ----

"$CC" -std=c99 -O1 -Wall -Wextra -pedantic -Wconversion -Werror "$SOURCE"/tests/package/readme/*.c -o claims \
  $(pkg-config --static --cflags qtraj) -I. -Wl,--wrap=malloc "$libdir/libqtraj.a" -lm
./claims || failed=1

# ---- Names ----

# named in the first, but not in the second
only_first() { comm -23 <(sort -u <<<"$1") <(sort -u <<<"$2") | tr '\n' ' '; }

in_readme=$(grep -oE '\bQTRAJ_[A-Z_0-9]*[A-Z0-9]\b' "$readme")
in_header=$(grep -oE '\bQTRAJ_[A-Z_0-9]+\b' "$header")
enumerators=$(grep -oE '^ *(enum \w+ \{)? *QTRAJ_[A-Z_0-9]+ = |, QTRAJ_[A-Z_0-9]+ = ' "$header" |
  grep -oE 'QTRAJ_[A-Z_0-9]+' | grep -vx QTRAJ_STATUS_INT32)
options=$(sed -nE 's/^(option\(|set\()(QTRAJ_[A-Z_]+) .*(ON|OFF|\$\{qtraj_top_level\}|CACHE STRING .*)\)$/\2/p' \
  "$SOURCE/CMakeLists.txt")
[ "$(wc -w <<<"$enumerators")" -gt 40 ] && [ "$(wc -w <<<"$options")" -ge 7 ]

missing=$(only_first "$enumerators"$'\n'"$options" "$in_readme")
[ -z "$missing" ] || fail "does not name $missing"
unknown=$(only_first "$in_readme" "$in_header"$'\n'"$options")
[ -z "$unknown" ] || fail "names what is not there: $unknown"
unknown=$(only_first "$(grep -oE '\bqtraj_[a-z_0-9]*[a-z0-9]\b' "$readme")" "$(grep -oE '\bqtraj_\w+' "$header")")
[ -z "$unknown" ] || fail "names functions that are not there: $unknown"

for path in $(grep -oE '\]\([^)#]+\)' "$readme" | tr -d '])(') $(grep -oE '^\| `[a-z/]+/`' "$readme" | tr -d '|` ') \
  examples/quickstart.sh tests/run.sh; do
  [ -e "$SOURCE/$path" ] || fail "there is no $path"
done
for preset in $(sed -nE 's/^cmake .*--preset ([a-z-]+)$/\1/p' "$readme"); do
  grep -qF "\"name\": \"$preset\"" "$SOURCE/CMakePresets.json" || fail "there is no preset $preset"
done
exit $failed
