// The kernels of exp, log, pow, rotation vectors and angles (rows/exponential.hpp, rows/logarithm.hpp, rows/power.hpp,
// rows/distances.hpp). Compiled for every target.
#include "rows/exponential.hpp"

#include "rows/distances.hpp"
#include "rows/logarithm.hpp"
#include "rows/power.hpp"
#include "targets/compiled.hpp"

namespace qtraj {
namespace QTRAJ_TARGET {

size_t exp(const UnaryRows<3, 4>& rows, size_t first, size_t count) {
  return run_rows<qtraj::exps<FullAngle, Arithmetic, Number, FloatNumber>, QTRAJ_SCALAR::exp>(rows, first, count);
}

size_t exp_of_half(const UnaryRows<3, 4>& rows, size_t first, size_t count) {
  return run_rows<qtraj::exps<HalfAngle, Arithmetic, Number, FloatNumber>, QTRAJ_SCALAR::exp_of_half>(rows, first,
                                                                                                      count);
}

size_t log(const UnaryRows<4, 3>& rows, size_t first, size_t count) {
  return run_rows<qtraj::logs<LogOf, Arithmetic, Number, FloatNumber>, QTRAJ_SCALAR::log>(rows, first, count);
}

size_t rotation_vectors(const UnaryRows<4, 3>& rows, size_t first, size_t count) {
  return run_rows<qtraj::logs<RotationVectorOf, Arithmetic, Number, FloatNumber>, QTRAJ_SCALAR::rotation_vectors>(
      rows, first, count);
}

size_t pow(const BinaryRows<4, 1, 4>& rows, size_t first, size_t count) {
  return run_rows<powers<Arithmetic, Number>, QTRAJ_SCALAR::pow>(rows, first, count);
}

size_t distance(const BinaryRows<4, 4, 1>& rows, size_t first, size_t count) {
  return run_rows<angles<DistanceOf, Arithmetic, Number>, QTRAJ_SCALAR::distance>(rows, first, count);
}

size_t rotation_angle(const BinaryRows<4, 4, 1>& rows, size_t first, size_t count) {
  return run_rows<angles<RotationAngleOf, Arithmetic, Number>, QTRAJ_SCALAR::rotation_angle>(rows, first, count);
}

}  // namespace QTRAJ_TARGET
}  // namespace qtraj
