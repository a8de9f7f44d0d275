// The functions over rows that are measured, as tables: what goes into each of them and what comes out.
#pragma once

#include "eigen_rows.hpp"
#include "loops.hpp"
#include "support.hpp"

namespace bench {

// What a row of an input is.
// `time` goes on in steps of 0.01, `late` comes after all of them, `number` lies between -1 and 1.
enum class Kind { orientation, neighbour, turn, vector, number, fraction, matrix, time, late, stamp };

template <class Real>
struct Function {
  const char* name;
  std::vector<Kind> in;
  std::vector<size_t> out;  // widths
  qtraj_status (*ours)(const Real* const* in, size_t count, Real* const* out);
  RowLoop<Real> eigen;
};

std::vector<Function<double>> row_functions(double);
std::vector<Function<float>> row_functions(float);

}  // namespace bench
