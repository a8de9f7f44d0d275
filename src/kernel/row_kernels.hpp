// The functions over rows of one kernel. Vector: what rows are done in, double where one at a time.
#pragma once

#include "continuous_rows.hpp"
#include "keyframe_rows.hpp"
#include "log_rows.hpp"
#include "mean_rows.hpp"
#include "pair_rows.hpp"
#include "unit_rows.hpp"

namespace qtraj {
namespace {

template <class Arithmetic, class Vector>
constexpr RowKernels kRowKernels = {interpolate<SlerpRow, Arithmetic, Vector>,
                                    interpolate<NlerpRow, Arithmetic, Vector>,
                                    rotate<Vector>,
                                    normalize<Vector>,
                                    make_continuous<Vector>,
                                    unit_keys<Vector>,
                                    relative_rotations<Vector>,
                                    jacobians<Vector>,
                                    raise_to_weights<Vector>,
                                    add_scatter<Vector>,
                                    add_logs<Arithmetic, Vector>};

}  // namespace
}  // namespace qtraj
