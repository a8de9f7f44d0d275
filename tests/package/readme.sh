#!/usr/bin/env bash
# readme.sh: takes the snippets out of README.md and docs/, builds and runs them against the installed library as these
# say, checks what they claim about the library (readme/*.c), and that they name everything in the header, every build
# option, every lesson, and nothing that is not there. Environment as for consumer.sh.
set -euo pipefail
libdir=$FOLDER/prefix/$LIBDIR
header=$SOURCE/include/qtraj.h
export PKG_CONFIG_PATH=$libdir/pkgconfig
export LD_LIBRARY_PATH=$libdir
unset PKG_CONFIG_LIBDIR PKG_CONFIG_SYSROOT_DIR CFLAGS CXXFLAGS LDFLAGS

rm -rf "$FOLDER/readme"
mkdir "$FOLDER/readme"
cd "$FOLDER/readme"
failed=0
fail() { echo "$*"; failed=1; }

# architecture.md is about the sources, whose own names it may use
about_sources=$SOURCE/docs/architecture.md
pages=("$SOURCE/README.md")
for page in "$SOURCE"/docs/*.md; do
  [ "$page" = "$about_sources" ] || pages+=("$page")
done

# ---- Snippets: the block right after a line <!-- name --> is the file of that name ----

awk '/^<!-- [^ ]+ -->$/ { name = $2; next }
     /^```/ {
       inside = !inside
       if (!inside) name = ""
       else if (name in seen) { print FILENAME ": a second snippet " name; exit 1 }
       else if (name != "") seen[name]
       next
     }
     inside && name != "" { print >name }
     !inside { name = "" }' "${pages[@]}"
used="CMakeLists.txt app.c app.cpp app.py app.txt build.sh errors_snippet.c rates_snippet.c settings_snippet.c"
snippets=$(LC_ALL=C ls | xargs)
[ "$snippets" = "$used" ] || fail "the snippets are $snippets; those tried out here are $used"

mkdir bin
ln -s "$(command -v "$CC")" bin/cc
PATH=$PWD/bin:$PATH sh -e build.sh
./app | diff app.txt - || fail "README.md: the program prints something else"
./app_static | diff app.txt - || fail "README.md: the static program prints something else"
[ "$(wc -l <app.c)" -le 10 ] || fail "README.md: the program has more than ten lines"
[ "$(wc -l <app.py)" -le 6 ] || fail "README.md: the Python program has more than six lines"

# those in C++ and in Python print one row of the five
"$CMAKE" -G "$GENERATOR" -S . -B build -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_PREFIX_PATH="$FOLDER/prefix"
"$CMAKE" --build build
row=$(sed -n '3s/  *[^ ]* degrees$//p' app.txt)
[ -n "$row" ]
[ "$(build/app)" = "$row" ] || fail "README.md: the program built by CMake prints something else"
[ "$(python3 app.py)" = "$row" ] || fail "README.md: Python prints something else"

# ---- Claims ----

"$CC" -std=c99 -O1 -Wall -Wextra -pedantic -Wconversion -Werror -DQTRAJ_NODISCARD= "$SOURCE"/tests/package/readme/*.c -o claims \
  $(pkg-config --static --cflags qtraj) -I. -Wl,--wrap=malloc "$libdir/libqtraj.a" -lm
./claims || failed=1

# ---- Names ----

# named in the first, but not in the second
only_first() { comm -23 <(sort -u <<<"$1") <(sort -u <<<"$2") | xargs; }

text=$(cat "${pages[@]}")
in_header=$(grep -oE '\b(QTRAJ_[A-Z_0-9]+|qtraj_\w+)\b' "$header")
functions=$("$SOURCE/tests/gates/functions.sh" "$header")
enumerators=$(grep -oE '^ *(enum \w+ \{)? *QTRAJ_[A-Z_0-9]+ = |, QTRAJ_[A-Z_0-9]+ = ' "$header" |
  grep -oE 'QTRAJ_[A-Z_0-9]+' | grep -vx QTRAJ_STATUS_INT32)
cmake=$(tr '\n' ' ' <"$SOURCE/CMakeLists.txt")
options=$(grep -oE '\boption\(QTRAJ_[A-Z_]+|\bset\(QTRAJ_[A-Z_]+ [^()]*\bCACHE STRING\b' <<<"$cmake" |
  grep -oE '\(QTRAJ_[A-Z_]+' | tr -d '(')
[ "$(wc -w <<<"$functions")" -gt 80 ] && [ "$(wc -w <<<"$enumerators")" -gt 40 ] && [ "$(wc -w <<<"$options")" -gt 7 ]

named=$(grep -oE '\b(QTRAJ_[A-Z_0-9]*[A-Z0-9]|qtraj_[a-z_0-9]*[a-z0-9])\b' <<<"$text")
missing=$(only_first "$functions"$'\n'"$enumerators" "$named")
[ -z "$missing" ] || fail "README.md and docs/ do not name $missing"
unknown=$(only_first "$named" "$in_header"$'\n'"$options")
[ -z "$unknown" ] || fail "README.md or docs/ name what is not there: $unknown"

# options in the table of docs/building.md, with their defaults
for option in $options; do
  grep -qF "| \`$option\` | " "$SOURCE/docs/building.md" || fail "docs/building.md has no row of $option"
done
while read -r option default; do
  case $default in
    ON | OFF) words="\`$default\`" ;;
    *) words='`ON`, inside another project `OFF`' ;;
  esac
  grep -qF "| \`$option\` | $words |" "$SOURCE/docs/building.md" || fail "docs/building.md: $option is $words by default"
done < <(grep -oE '\boption\(QTRAJ_[A-Z_]+ "[^"]*" [^ )]+' <<<"$cmake" | sed -E 's/option\(([A-Z_]+) "[^"]*" /\1 /')

# the README's table of jobs: every lesson, with functions that it calls
for lesson in "$SOURCE"/examples/[0-9]*.c; do
  name=examples/$(basename "$lesson")
  jobs=$(grep -F "]($name) |" "$SOURCE/README.md") || fail "README.md does not name $name"
  for function in $(grep -oE '\bqtraj_\w+' <<<"$jobs"); do
    grep -qw "$function" "$lesson" || fail "README.md: $name does not call $function"
  done
done

# ---- Files ----

find "$SOURCE" -path "$SOURCE/build*" -prune -o -name '*.md' -exec python3 "$SOURCE/tests/package/readme/links.py" {} + ||
  failed=1
for page in "${pages[@]:1}" "$about_sources"; do
  name=$(basename "$page")
  [ "$name" = README.md ] || grep -qF "]($name)" "$SOURCE/docs/README.md" || fail "docs/README.md does not name $name"
done
for path in $(grep -ohE '`(examples|tests|bench|capi|src|include|docs|pkgconfig)/[A-Za-z0-9_./-]*`' "${pages[@]}" \
  "$about_sources" | tr -d '`'); do
  [ -e "$SOURCE/$path" ] || fail "README.md or docs/ name $path, which is not there"
done
for preset in $(sed -nE 's/^cmake .*--preset ([a-z-]+)$/\1/p' <<<"$text"); do
  grep -qF "\"name\": \"$preset\"" "$SOURCE/CMakePresets.json" || fail "there is no preset $preset"
done
[ "$(wc -l <"$SOURCE/README.md")" -le 170 ] || fail "README.md has more than 170 lines"

python3 "$SOURCE/docs/pictures/make.py" "$libdir/libqtraj.so.0" curves.svg
cmp curves.svg "$SOURCE/docs/pictures/curves.svg" || fail "docs/pictures/curves.svg is not what make.py draws"
exit $failed
