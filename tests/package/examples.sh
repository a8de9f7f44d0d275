#!/usr/bin/env bash
# examples.sh: builds the lessons, copied to a folder of their own, against the installed library, and compares what
# they print with what their closing comments say. Environment as for consumer.sh.
set -euo pipefail
libdir=$FOLDER/prefix/$LIBDIR
export PKG_CONFIG_PATH=$libdir/pkgconfig
export LD_LIBRARY_PATH=$libdir
unset PKG_CONFIG_LIBDIR PKG_CONFIG_SYSROOT_DIR CFLAGS LDFLAGS MAKEFLAGS

rm -rf "$FOLDER/examples"
cp -R "$SOURCE/examples" "$FOLDER/examples"
cd "$FOLDER/examples"

make CC="$CC" CFLAGS="-O2 -Wall -Wextra -pedantic -Wconversion -Werror"

# the commands after "$ " in the closing comment, each followed by what it prints
transcript() { sed -n -E '/^(\/\*|#) Prints, in this folder:/,$s/^( \*|#)   //p' "$1"; }

failed=0
for lesson in [0-9]*.c *.py; do
  expected=$(transcript "$lesson")
  [ -n "$expected" ] || { echo "$lesson does not say what it prints"; failed=1; }
  printed=$(sed -n 's/^\$ //p' <<<"$expected" | while read -r command; do
    echo "\$ $command"
    bash -c "$command" 2>&1 </dev/null || echo "status $?"
  done)
  diff <(echo "$expected") <(echo "$printed") || { echo "$lesson prints something else"; failed=1; }
  echo "$lesson: $(wc -l <<<"$printed") lines compared"
done
exit $failed
