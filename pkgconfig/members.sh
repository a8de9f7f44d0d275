#!/bin/sh
# members.sh archive objects...: makes the archive anew, a member for each object, whose internal symbols meet none of a
# program's. Weak ones, what the compiler made of inline functions and templates such as Eigen's, become local to their
# member: the linker cannot exchange them for the program's copies, which may be compiled with other settings. Those of
# C++ that members share get a prefix, so that a program may have a namespace qtraj of its own.
# From the environment: CC and the words MERGE, which with it make one object of one; NM, OBJCOPY, AR.
set -eu
export LC_ALL=C
archive=$1
shift
work=$archive.members
rm -rf "$work" "$archive"
mkdir "$work"
trap 'rm -rf "$work"' EXIT
for object in "$@"; do
  # CMakeFiles/qtraj_avx2.dir/src/targets/pairs.cpp.o: avx2_pairs.o
  library=${object##*CMakeFiles/qtraj_}
  name=$(basename "$object" .o)
  folder=$(basename "$(dirname "$object")")
  member=$work/${library%%.dir/*}_${folder}_${name%.cpp}.o
  [ ! -e "$member" ] || { echo "two objects would be the member ${member##*/}" >&2; exit 1; }
  "$NM" --defined-only --format=posix "$object" | sed -n 's/^\([^ ]*\) [WVu] .*/\1/p' >"$work/weak"
  if [ -s "$work/weak" ]; then
    # groups dissolved first: a COMDAT group could still be exchanged as a whole
    # shellcheck disable=SC2086
    "$CC" $MERGE "$object" -o "$member"
    "$OBJCOPY" --localize-symbols="$work/weak" "$member"
  else
    cp "$object" "$member"
  fi
done
"$NM" --defined-only --extern-only --format=posix "$work"/*.o |
  sed -n 's/^\(_Z[^ ]*\) .*/\1 qtraj_internal_\1/p' | sort -u >"$work/shared"
for member in "$work"/*.o; do
  "$OBJCOPY" --redefine-syms="$work/shared" "$member"
done
"$AR" qcsD "$archive" "$work"/*.o
