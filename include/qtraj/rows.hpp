// Rows of a caller's arrays, float or double, and the loop that every function over rows is.
#pragma once

#include <cfloat>
#include <limits>

#include "qtraj/arrays.hpp"
#include "qtraj/floating.hpp"
#include "qtraj/quaternion.hpp"
#include "qtraj/status.hpp"

namespace qtraj {

// Rows of `Width` numbers to read, any alignment of their element; as double. repeated: one row that serves all.
template <int Width>
struct Rows {
  using Row = Eigen::Matrix<double, Width, 1>;

  const void* data;
  bool single;
  bool repeated = false;

  ArrayIn array() const { return {data, repeated}; }

  // Told by the bits in memory: converting a signalling NaN would raise FE_INVALID.
  bool is_finite(size_t row) const {
    const size_t first = first_element(row);
    for (size_t at = first; at < first + Width; ++at) {
      if (single ? !qtraj::is_finite(static_cast<const float*>(data)[at])
                 : !qtraj::is_finite(static_cast<const double*>(data)[at]))
        return false;
    }
    return true;
  }

  Row operator[](size_t row) const {
    Row values;
    for (int k = 0; k < Width; ++k) {
      const size_t at = first_element(row) + static_cast<size_t>(k);
      values[k] =
          single ? static_cast<double>(static_cast<const float*>(data)[at]) : static_cast<const double*>(data)[at];
    }
    return values;
  }

  // Of a finite row.
  bool is_zero(size_t row) const { return largest_component((*this)[row]) == 0; }

 private:
  size_t first_element(size_t row) const { return repeated ? 0 : row * Width; }
};

// Whether a row is a quaternion with a direction: not_finite, zero_norm or ok.
inline Status check_key(const Rows<4>& q, size_t row) {
  if (!q.is_finite(row)) return Status::not_finite;
  return q.is_zero(row) ? Status::zero_norm : Status::ok;
}

// Rows to write.
template <int Width>
struct OutputRows {
  using Row = Eigen::Matrix<double, Width, 1>;

  void* data;
  bool single;

  static Row zero() { return Row::Zero(); }

  // Whether the values are finite in the caller's type; they must not be NaN.
  bool holds(const Row& values) const {
    const double largest = single ? static_cast<double>(FLT_MAX) : DBL_MAX;
    return largest_component(values) <= largest;
  }

  void write(size_t row, const Row& values) const {
    for (int k = 0; k < Width; ++k) write(row * Width + static_cast<size_t>(k), values[k]);
  }
  void write_nan(size_t row) const { write(row, Row::Constant(std::numeric_limits<double>::quiet_NaN())); }

 private:
  void write(size_t at, double value) const {
    if (single)
      static_cast<float*>(data)[at] = static_cast<float>(value);
    else
      static_cast<double*>(data)[at] = value;
  }
};

// Two outputs with one row each for every input; the second may have no data. One at fault makes both NaN.
template <int Width>
struct OutputRowPairs {
  struct Row {
    typename OutputRows<Width>::Row first, second;
  };

  OutputRows<Width> first, second;

  static Row zero() { return {OutputRows<Width>::zero(), OutputRows<Width>::zero()}; }

  bool holds(const Row& values) const {
    return first.holds(values.first) && (!second.data || second.holds(values.second));
  }
  void write(size_t row, const Row& values) const {
    first.write(row, values.first);
    if (second.data) second.write(row, values.second);
  }
  void write_nan(size_t row) const {
    first.write_nan(row);
    if (second.data) second.write_nan(row);
  }
};

// Calls `compute(row, values)` for each row and writes what it leaves in `values`, or NaN where its status is neither
// ok nor ambiguous, or the values do not fit the caller's type. The outcome is that of the first row at fault. Row i of
// an input may be overwritten by row i of the output: `compute` reads before it writes.
// `vectors(row)` does rows from that one on by itself, all of them ok, and returns how many.
template <class Output, class Vectors, class Compute>
Outcome for_each_row(size_t count, const Output& out, const Vectors& vectors, const Compute& compute) {
  Outcome outcome;
  for (size_t row = 0; row < count; ++row) {
    row += vectors(row);
    if (row == count) break;
    typename Output::Row values = Output::zero();
    Status status = compute(row, values);
    const bool has_values = status == Status::ok || status == Status::ambiguous;
    if (has_values && !out.holds(values)) status = Status::not_finite;
    if (has_values && status != Status::not_finite)
      out.write(row, values);
    else
      out.write_nan(row);
    if (status != Status::ok && outcome.status == Status::ok) outcome = {status, row};
  }
  return outcome;
}
template <class Output, class Compute>
Outcome for_each_row(size_t count, const Output& out, const Compute& compute) {
  return for_each_row(
      count, out, [](size_t) { return size_t{0}; }, compute);
}

}  // namespace qtraj
