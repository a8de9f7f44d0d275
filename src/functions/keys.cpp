#include "functions/keys.hpp"

#include <cstring>

#include "math/error_free.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

// An exact sum, kept as an expansion: doubles that do not overlap, the smallest first.
// Source: J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates",
// Discrete Comput. Geom. 18 (1997), theorem 10 (grow-expansion).
template <int Capacity>
class ExactSum {
 public:
  void add(double number) {
    for (int k = 0; k < count_; ++k) {
      const DoubleDouble sum = two_sum(number, parts_[k]);
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

// Rotates each row: moves its first MovedBytes bytes to the end.
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

constexpr RowKernel<NormalizeRows> kNormalizeKernels[] = QTRAJ_OF_EACH_TARGET(normalize);
constexpr RowKernel<ContinuousRows> kContinuousKernels[] = QTRAJ_OF_EACH_TARGET(make_continuous);

}  // namespace

bool is_opposed(const Quaternion& a, const Quaternion& b) {
  const Quaternion p = normalizing_scale(largest_component(a)) * a;
  const Quaternion r = normalizing_scale(largest_component(b)) * b;
  // components are below 4, so that the rounding error of the sum is below 4e-14
  const double rounded = dot(p, r);
  if (std::abs(rounded) > 1e-13) return rounded < 0;
  ExactSum<8> sum;
  for (int k = 0; k < 4; ++k) {
    const DoubleDouble product = two_product(p[k], r[k]);
    sum.add(product.error);
    sum.add(product.value);
  }
  return sum.is_negative();
}

Outcome normalize_keys(const NormalizeRows& rows, size_t count) {
  const auto kernel = [&](size_t row) { return kNormalizeKernels[target()](rows, row, count); };
  return for_each_row(count, rows.q_out, kernel, [&](size_t row, Quaternion& values) {
    const Status status = check_key(rows.q, row);
    if (status == Status::ok) values = normalize(row_of(rows.q, row)).unit.value;
    return status;
  });
}

Outcome make_continuous(const ContinuousRows& rows, size_t series, size_t length) {
  *rows.flips = 0;
  const Input<4> done = {rows.q_out.data, rows.q_out.rows, rows.q_out.is_float};
  Quaternion previous;
  bool has_previous = false;
  const auto kernel = [&](size_t row) {
    const size_t of_series = row % length;
    if (of_series == 0) return size_t{0};
    const size_t count = kContinuousKernels[target()](rows, row, row - of_series + length);
    if (count > 0) previous = row_of(done, row + count - 1);
    return count;
  };
  return for_each_row(series * length, rows.q_out, kernel, [&](size_t row, Quaternion& values) {
    if (row % length == 0) has_previous = false;
    const Status status = check_key(rows.q, row);
    if (status != Status::ok) return status;
    values = row_of(rows.q, row);
    if (has_previous && is_opposed(previous, values)) {
      values = -values;
      ++*rows.flips;
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
