#!/bin/sh
# members.sh archive objects...: makes the archive anew, a member for each object. Weak symbols, what the compiler made of
# inline functions and templates such as Eigen's, become local to their member: the linker cannot exchange them for the
# copies of a user's program, which may be compiled with other settings. From the environment: CC, CFLAGS, NM, OBJCOPY, AR.
set -eu
archive=$1
shift
work=$archive.members
rm -rf "$work" "$archive"
mkdir "$work"
for object in "$@"; do
  # CMakeFiles/qtraj_avx2.dir/src/targets/pairs.cpp.o: avx2_pairs.o
  library=${object##*CMakeFiles/qtraj_}
  name=$(basename "$object" .cpp.o)
  folder=$(basename "$(dirname "$object")")
  member=$work/${library%%.dir/*}_${folder}_$name.o
  "$NM" --defined-only --format=posix "$object" | sed -n 's/^\([^ ]*\) [WVu] .*/\1/p' >"$work/weak"
  if [ -s "$work/weak" ]; then
    # groups dissolved first: a COMDAT group could still be exchanged as a whole
    # shellcheck disable=SC2086
    $CC $CFLAGS -r -nostdlib -Wl,--force-group-allocation "$object" -o "$member"
    "$OBJCOPY" --localize-symbols="$work/weak" "$member"
  else
    cp "$object" "$member"
  fi
done
rm "$work/weak"
"$AR" qcsD "$archive" "$work"/*.o
rm -r "$work"
