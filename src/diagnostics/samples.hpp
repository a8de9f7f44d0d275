// Diagnostics of samples of any origin, of any norm but 0 and any sign: rates, energy, jumps and errors.
//
// Faults, for all four functions. A sample is faulty where its time or orientation is not finite (not_finite), its
// orientation is 0 (zero_norm), its time does not come after the last finite time before it, or so soon after it that
// 1/h^2 overflows (time_order), or the span from there or from the first finite time overflows (time_span). Every
// faulty sample is reported, also one that no row uses.
//   - Rows that use a faulty sample are NaN. A lookup of a time uses all times: where one is at fault, all rows of
//     estimate_jumps and keyframe_errors are NaN. estimate_energy is one row that uses all samples.
//   - The outcome is that of the lowest index at fault; indices count the arguments' elements in their order.
//   - Neighbours with <q_k, q_{k+1}> < 0 are taken with one sign changed; a tie keeps the given signs. Neighbours half
//     a turn apart, |<q_k, q_{k+1}>| <= 4 eps |q_k| |q_{k+1}|, turn in a direction that is a matter of rounding: what
//     rests on it is ambiguous, at the index of the later sample or, in estimate_jumps, of the knot.
#pragma once

#include "base/settings.hpp"
#include "functions/for_each_row.hpp"

namespace qtraj {

// Samples as the caller passed them.
struct Samples {
  Input<1> times;  // s, of double
  Input<4> q_wb;

  size_t count() const { return q_wb.rows; }
  double time(size_t sample) const { return static_cast<const double*>(times.data)[sample]; }
};

// Mean rates between neighbours, rad/s: row k is 2 log(q_{k+1} q_k^-1) / (t_{k+1} - t_k), world, or
// 2 log(q_k^-1 q_{k+1}) / (t_{k+1} - t_k), body, with log the half-angle vector; the rate of the slerp between the two.
// Row k of t_mid (data may be null) is (t_k + t_{k+1}) / 2, s, within 0.51 ulp. Rates are within 6 eps of their length
// plus 1e-30 rad / (t_{k+1} - t_k): good digits at steps far below the rounding of q. count >= 2.
Outcome estimate_omega(const Samples& samples, Frame frame, const Output<1>& t_mid, const Output<3>& omega);

// Sum over k of |w_{k+1} - w_k|^2 / (m_{k+1} - m_k), rad^2/s^3, with w the rates and m the times of estimate_omega:
// approximates the integral of |alpha|^2 from the first to the last mid-time. As good as rates with the error
// stated there make it, plus 8 eps relative, for any count. not_finite above 1e300, at the index of the sample that
// brings it there. NaN under every status but ambiguous, and that one only where nothing else is at fault. count >= 3.
Outcome estimate_energy(const Samples& samples, Frame frame, double& energy);

// Row k: the rate of the first interval between samples that begins at or after knots[k] minus that of the last one
// that ends at or before it, rad/s; rates as in estimate_omega. Knots may be in any order. time_range where one of the
// two intervals does not exist. The error is that of both rates. Indices count samples, then knots. count >= 2.
Outcome estimate_jumps(const Samples& samples, const double* knots, size_t knot_count, Frame frame,
                       const Output<3>& jumps);

// Row k: angle, rad in [0, pi], of the rotation between keys.q_wb[k] and the sample nearest to keys.times[k], the
// earlier one in an exact tie; index (may be null) is that sample's, kNoIndex in rows at fault. Key times may be any
// finite numbers in any order. The error is that of rotation_angle. Indices count keys, then samples. count >= 1.
Outcome keyframe_errors(const Samples& keys, const Samples& samples, const Output<1>& error, size_t* index);

}  // namespace qtraj
