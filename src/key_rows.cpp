#include "qtraj/key_rows.hpp"

#include <cstring>

#include "kernel/kernel.hpp"
#include "qtraj/error_free.hpp"

namespace qtraj {
namespace {

// Sum of numbers without rounding, as numbers that do not overlap, the smallest first.
// Source: J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates",
// Discrete Comput. Geom. 18 (1997), theorem 10 (grow-expansion).
template <int Capacity>
class ExactSum {
 public:
  void add(double number) {
    for (int k = 0; k < count_; ++k) {
      const Exact sum = two_sum(number, parts_[k]);
      parts_[k] = sum.error;
      number = sum.value;
    }
    parts_[count_++] = number;
  }

  bool is_negative() const {
    for (int k = count_; k-- > 0;)
      if (parts_[k] != 0) return parts_[k] < 0;
    return false;
  }

 private:
  double parts_[Capacity];
  int count_ = 0;
};

// Rows of four numbers with their first ones moved to the end.
template <size_t MovedBytes, size_t RowBytes>
void rotate_rows(const void* from, size_t count, void* to) {
  const auto* source = static_cast<const unsigned char*>(from);
  auto* target = static_cast<unsigned char*>(to);
  for (size_t row = 0; row < count; ++row, source += RowBytes, target += RowBytes) {
    unsigned char moved[RowBytes];
    std::memcpy(moved, source + MovedBytes, RowBytes - MovedBytes);
    std::memcpy(moved + (RowBytes - MovedBytes), source, MovedBytes);
    std::memcpy(target, moved, RowBytes);
  }
}

}  // namespace

bool is_opposed(const Quaternion& a, const Quaternion& b) {
  const Quaternion p = normalizing_scale(largest_component(a)) * a;
  const Quaternion r = normalizing_scale(largest_component(b)) * b;
  // components are below 4, so that the rounding of the sum is below 4e-14
  const double rounded = dot(p, r);
  if (std::abs(rounded) > 1e-13) return rounded < 0;
  ExactSum<8> sum;
  for (int k = 0; k < 4; ++k) {
    const Exact product = two_product(p[k], r[k]);
    sum.add(product.error);
    sum.add(product.value);
  }
  return sum.is_negative();
}

Outcome normalize_rows(const Rows<4>& q, size_t count, const OutputRows<4>& out) {
  const KeyArrays arrays = {q.data, out.data, q.single};
  const auto vectors = [&](size_t row) { return kernel().rows.normalize(arrays, row, count); };
  return for_each_row(count, out, vectors, [&](size_t row, Quaternion& values) {
    const Status status = check_key(q, row);
    if (status != Status::ok) return status;
    values = normalize(q[row]).unit.value;
    return Status::ok;
  });
}

Outcome make_continuous_rows(const Rows<4>& q, size_t series, size_t length, const OutputRows<4>& out, size_t& flips) {
  flips = 0;
  const KeyArrays arrays = {q.data, out.data, q.single};
  const Rows<4> done = {out.data, out.single};
  Quaternion previous;
  bool has_previous = false;
  const auto vectors = [&](size_t row) {
    const size_t of_series = row % length;
    if (of_series == 0) return size_t{0};
    const size_t count = kernel().rows.make_continuous(arrays, row, row - of_series + length, flips);
    if (count == 0) return count;
    previous = done[row + count - 1];
    return count;
  };
  return for_each_row(series * length, out, vectors, [&](size_t row, Quaternion& values) {
    if (row % length == 0) has_previous = false;
    const Status status = check_key(q, row);
    if (status != Status::ok) return status;
    values = q[row];
    if (has_previous && is_opposed(previous, values)) {
      values = -values;
      ++flips;
    }
    previous = values;
    has_previous = true;
    return Status::ok;
  });
}

void wxyz_from_xyzw(const void* q_xyzw, size_t element_bytes, size_t count, void* q_out) {
  element_bytes == 4 ? rotate_rows<12, 16>(q_xyzw, count, q_out) : rotate_rows<24, 32>(q_xyzw, count, q_out);
}

void xyzw_from_wxyz(const void* q, size_t element_bytes, size_t count, void* q_xyzw_out) {
  element_bytes == 4 ? rotate_rows<4, 16>(q, count, q_xyzw_out) : rotate_rows<8, 32>(q, count, q_xyzw_out);
}

}  // namespace qtraj
