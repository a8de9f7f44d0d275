// The equations for the rates of a ROTATION_SPLINE at its knots, which rotation_spline.cpp states and solves.
#pragma once

#include "base/times.hpp"
#include "math/block_tridiagonal.hpp"
#include "math/so3.hpp"
#include "methods/method.hpp"

namespace qtraj {

// The equation of a knot, multiplied by h_before h_after/(4 (h_before + h_after)): its weights are then shares of
// intervals, right = h_after/(h_before + h_after) and left, and nothing overflows. Its unknown is d_i = A_{i-1} w_i,
// the rate of the rotation vector at the end of the segment before, instead of w_i = J_i d_i, J_i = Jr(R_{i-1}): blocks
// above the diagonal are then multiples of the unit matrix. At the start of an open curve R_{-1} = 0, d_0 = w_0,
// J_0 = 1.
//   (right/2) J_i J_{i-1} d_{i-1} + J_i d_i + (left/2) d_{i+1} + (right h_{i-1}/4) beta(R_{i-1}, d_i)
//     = (3/2) (right R_{i-1}/h_{i-1} + left R_i/h_i).
// The equation of a natural end has the outer share 0 and the other 1; that of a fixed rate has both 0 and the rate on
// the right side.
struct RateEquation {
  double saved[3];         // the copy of d that restore() goes back to
  double reach;            // h_before h_after/(4 (h_before + h_after)); 0 where the rate is fixed
  double chord_rate;       // largest component of R/h on both sides
  double local_rate;       // the larger of that and the largest component of w
  double limit;            // of the magnitude of w's components
  double jacobian[9];      // J_i
  double w[3], d[3];       // the rates
  double r[3], h;          // of the segment before
  TurningFactors turning;  // right/4 times those of beta
  double constant[3];      // the right side
  double upper;            // left/2
  double lower[9];         // (right/2) J_i J_{i-1}
};

// Working space: the equations, and the elimination's vector and two matrices.
static_assert(sizeof(RateEquation) == (kRotationSplineWorkspacePerKey - 3 - 18) * sizeof(double));

// The equations for the rates and the steps of their solution, with beta weighted by a factor from 0 to 1. What is
// solved are the equations of the selected knots for their rates; all other rates stay as they are.
class RateEquations {
 public:
  explicit RateEquations(Construction& construction);

  // Sets up the equations, the rates that are fixed by end conditions, and all other rates to 0, and selects all knots.
  Outcome prepare();
  // Number of knots with a rate of their own.
  size_t unknowns() const { return unknowns_; }
  // Selects the knots first ... last - 1, or all.
  void select(size_t first, size_t last);
  void select_all() { select(0, unknowns_); }
  // Factorizes the matrix of the Newton step from the present rates; false where it is singular.
  bool factorize(double weight);
  // Takes one step with that matrix; its size is relative to the rates around each knot. False where a rate leaves its
  // limit.
  bool step(double weight, double& size);
  // Save the selected rates, go back to them, and tell how far they have moved since, relative as in step.
  void save();
  void restore();
  double change_from_saved() const;
  // Knots in all steps so far, each counted as often as it was selected; and that in steps of the whole curve, rounded
  // up.
  size_t work() const { return work_; }
  int32_t iterations() const { return static_cast<int32_t>((work_ + unknowns_ - 1) / unknowns_); }
  // Largest jump of alpha that is left, in units of the largest of |alpha| and |omega|/h.
  double residual() const;

  // R of a segment, and r' at its ends.
  Vector3 r(size_t segment) const { return load(rows_[end_of(segment)].r); }
  Vector3 start_rate(size_t segment) const { return load(rows_[segment].w); }
  Vector3 end_rate(size_t segment) const { return load(rows_[end_of(segment)].d); }
  // Body rate at a knot.
  Vector3 w(size_t knot) const { return load(rows_[knot == unknowns_ ? 0 : knot].w); }

 private:
  struct System;

  bool is_cyclic() const { return closed() && last_ - first_ == unknowns_; }
  bool closed() const { return construction_.options.closed(); }
  double h(size_t segment) const { return keys_.step(segment); }
  // The knots and segments beside a knot. Past an end these are at the other end of the curve; in an open curve they
  // have weight 0.
  size_t previous(size_t knot) const { return knot == 0 ? unknowns_ - 1 : knot - 1; }
  size_t next(size_t knot) const { return knot + 1 == unknowns_ ? 0 : knot + 1; }
  size_t end_of(size_t segment) const { return next(segment); }

  const EndSetting* open_end(size_t knot) const;
  IntervalShares shares(size_t knot) const;
  Outcome fix_end(size_t knot);
  Outcome prepare_steps();
  void prepare_segments();
  Vector3 estimated_rate(size_t knot) const;
  void prepare_row(size_t knot);

  double scale_at(const RateEquation& row) const;

  Construction& construction_;
  const Keyframes& keys_;
  const size_t unknowns_;  // a closed curve has one rate for its first and last knot
  RateEquation* rows_;     // [unknowns_]
  BlockSpace space_;
  size_t first_ = 0, last_ = 0;  // the selection
  double fastest_ = 0;           // the largest of the rates at selected knots and their chords
  size_t work_ = 0;
};

}  // namespace qtraj
