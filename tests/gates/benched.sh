#!/usr/bin/env bash
# benched.sh project: every function of docs/functions.md, and its twin, is measured in bench/, but for those named here.
set -euo pipefail
cd "$1"
declare -A left_out=(
  [qtraj_mean_from_moments]="eleven numbers, however many samples there were"
  [qtraj_segment_times]="qtraj_even_times for each segment"
  [qtraj_batch_mean_eigen]="qtraj_mean_eigen for each group"
)
# twins whose work is that of the function: it computes in double and rounds, or moves half the bytes
alike="qtraj_batch_mean_eigen qtraj_check_keys qtraj_columns_from_rows qtraj_mean_karcher qtraj_nlerp_pairs_between
  qtraj_rows_from_columns qtraj_sample_poses qtraj_slerp_pairs_between"
functions=$(tests/gates/functions.sh include/qtraj.h)
bad=0
for name in $(grep -o 'qtraj_[a-z0-9_]*' docs/functions.md | sort -u); do
  for function in "$name" "${name}_f32"; do
    grep -qx "$function" <<<"$functions" || continue
    [ -z "${left_out[$name]-}" ] || continue
    if [ "$function" != "$name" ] && grep -qw "$name" <<<"$alike"; then continue; fi
    grep -qw "$function" bench/*.cpp bench/*.hpp && continue
    echo "$function is not measured in bench/, nor left out in tests/gates/benched.sh with a reason"
    bad=1
  done
done
exit $bad
