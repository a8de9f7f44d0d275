// The kernels of exp, log, pow, rotation vectors and angles (rows/exponential.hpp, rows/logarithm.hpp, rows/power.hpp,
// rows/distances.hpp). Compiled for every target.
#include "rows/exponential.hpp"

#include "rows/distances.hpp"
#include "rows/logarithm.hpp"
#include "rows/power.hpp"
#include "targets/compiled.hpp"

namespace qtraj {
namespace QTRAJ_TARGET {

size_t exp(const ExpRows& rows, size_t first, size_t count) {
  return run_rows<qtraj::exp<Arithmetic, Number, FloatNumber>, QTRAJ_SCALAR::exp>(rows, first, count);
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

size_t angles(const AngleRows& rows, size_t first, size_t count) {
  return run_rows<qtraj::angles<Arithmetic, Number>, QTRAJ_SCALAR::angles>(rows, first, count);
}

}  // namespace QTRAJ_TARGET
}  // namespace qtraj
