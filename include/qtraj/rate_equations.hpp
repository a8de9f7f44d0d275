// The equations for the body rates of a ROTATION_SPLINE at its knots: rotation_spline.hpp states them.
#pragma once

#include "qtraj/block_tridiagonal.hpp"
#include "qtraj/method.hpp"

namespace qtraj {

constexpr size_t kRotationSplineWorkspacePerKey = 51;

// Working space, each [count]: rates at the knots, the Newton step, the elimination, and a copy of the rates to go
// back to. R_i, the factors and the matrices of segment i are in row i.
struct RateWorkspace {
  double (*w)[3];
  double (*saved)[3];
  double (*r)[3];
  double (*turning)[3];   // factors of beta
  double (*jacobian)[9];  // Jr(R_i)
  double (*inverse)[9];   // A_i
  BlockSpace space;
};
static_assert(kRotationSplineWorkspacePerKey == 5 * 3 + 4 * 9, "five vectors and four matrices");
RateWorkspace rate_workspace_of(const Construction& construction);

// The equations for the rates, beta weighted by a factor from 0 to 1, and what solving them needs. Rows are multiplied
// by h_before h_after/(h_before + h_after): their weights are then shares of intervals, and nothing overflows.
class RateEquations {
 public:
  RateEquations(Construction& construction, const RateWorkspace& workspace)
      : construction_(construction), keys_(construction.keys), workspace_(workspace) {}

  // Matrices of the segments, and the rates that are fixed by end conditions, the others 0.
  Outcome prepare();
  // One Newton step; its size relative to the rates around each knot. False where it cannot be taken.
  bool step(double weight, double& size);
  // To go back to, and how far the rates have moved since, relative as in step.
  void save() const;
  void restore() const;
  double change_from_saved() const;
  // Largest jump of alpha that is left, in units of the largest of |alpha| and |omega|/h.
  double residual() const;

 private:
  bool closed() const { return construction_.options.closed(); }
  // A closed curve has one rate for its first and last knot.
  size_t unknowns() const { return closed() ? keys_.segments() : keys_.count; }

  double h(size_t segment) const { return keys_.step(segment); }
  Vector3 w(size_t knot) const { return load(workspace_.w[knot]); }
  Vector3 r(size_t segment) const { return load(workspace_.r[segment]); }
  Matrix3 jacobian(size_t segment) const { return Matrix3(workspace_.jacobian[segment]); }
  Matrix3 inverse(size_t segment) const { return Matrix3(workspace_.inverse[segment]); }
  // Segments on both sides of a knot, going on with the other end where the curve is closed.
  size_t before(size_t knot) const { return knot == 0 ? keys_.segments() - 1 : knot - 1; }
  size_t after(size_t knot) const { return knot == keys_.segments() ? 0 : knot; }

  const EndSetting* open_end(size_t knot) const;
  Outcome fix_end(size_t knot);
  bool is_fixed(size_t knot) const;

  BlockRow row(size_t knot, double weight) const;
  BlockRow inner_row(size_t knot, double weight) const;
  BlockRow natural_row(size_t knot, double weight) const;
  void add_turning(size_t segment, const Vector3& rate, double weight, BlockRow& row) const;

  bool apply_step(double& size);
  double local_rate(size_t knot) const;
  double fastest_rate() const;
  double longest_beside(size_t knot) const;
  double scale_at(size_t knot, double fastest) const;
  void copy(double (*from)[3], double (*to)[3]) const;

  Construction& construction_;
  const Keyframes& keys_;
  const RateWorkspace& workspace_;
};

}  // namespace qtraj
