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

  // Its largest part, which has its sign; 0 where the sum is 0.
  double leading() const {
    for (int k = count_; k-- > 0;)
      if (parts_[k] != 0) return parts_[k];
    return 0;
  }

 private:
  double parts_[Capacity];
  int count_ = 0;
};

double power_of_two(int exponent) {
  const uint64_t bits = static_cast<uint64_t>(1023 + exponent) << 52;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return power;
}

int exponent_of_power(double power) {
  uint64_t bits;
  std::memcpy(&bits, &power, sizeof bits);
  return static_cast<int>(bits >> 52) - 1023;
}

// The product a b of any two numbers but 0, exactly: value 2^exponent, value below 16 and a multiple of 2^-104.
struct ExactProduct {
  DoubleDouble value;
  int exponent;
};

ExactProduct exact_product(double a, double b) {
  const double scale_a = normalizing_scale(a), scale_b = normalizing_scale(b);
  return {two_product(scale_a * a, scale_b * b), -exponent_of_power(scale_a) - exponent_of_power(scale_b)};
}

// Whether <a, b> < 0, exactly, for components of any size. Products are summed from the largest exponent down, those
// together whose exponents are less than 120 apart: a sum that is not 0 is at least 2^-104 of its last unit and
// decides, as all later products together are below 2^6 2^-120 of that.
bool has_negative_dot(const Quaternion& a, const Quaternion& b) {
  ExactProduct products[4];
  int count = 0;
  for (int k = 0; k < 4; ++k) {
    if (a[k] == 0 || b[k] == 0) continue;
    const ExactProduct product = exact_product(a[k], b[k]);
    int place = count++;
    for (; place > 0 && products[place - 1].exponent < product.exponent; --place) products[place] = products[place - 1];
    products[place] = product;
  }
  for (int first = 0, next = 0; first < count; first = next) {
    ExactSum<8> sum;
    do {
      const double unit = power_of_two(products[next].exponent - products[first].exponent);
      sum.add(unit * products[next].value.error);
      sum.add(unit * products[next].value.value);
      ++next;
    } while (next < count && products[next].exponent > products[next - 1].exponent - 120);
    if (sum.leading() != 0) return sum.leading() < 0;
  }
  return false;
}

// Lanes of two vectors of whole numbers, those of the second numbered after the first's.
template <int... Lanes, class Vector>
Vector shuffled(Vector a, Vector b) {
#if defined(__clang__) || __GNUC__ >= 12
  return __builtin_shufflevector(a, b, Lanes...);
#else
  return __builtin_shuffle(a, b, Vector{Lanes...});
#endif
}

// Rotates each row of four: its first `Moved` numbers go to the end. As vectors of whole numbers, 16 bytes each,
// because a signalling NaN may be changed on its way through a floating-point register.
template <int Moved>
void rotate_rows_of_float(const unsigned char* from, size_t count, unsigned char* to) {
  typedef uint32_t Row __attribute__((vector_size(16)));
  for (size_t row = 0; row < count; ++row, from += sizeof(Row), to += sizeof(Row)) {
    Row q;
    std::memcpy(&q, from, sizeof q);
    const Row rotated = shuffled<Moved, (Moved + 1) % 4, (Moved + 2) % 4, (Moved + 3) % 4>(q, q);
    std::memcpy(to, &rotated, sizeof rotated);
  }
}
template <int Moved>
void rotate_rows_of_double(const unsigned char* from, size_t count, unsigned char* to) {
  typedef uint64_t Half __attribute__((vector_size(16)));
  for (size_t row = 0; row < count; ++row, from += 2 * sizeof(Half), to += 2 * sizeof(Half)) {
    Half first, last;
    std::memcpy(&first, from, sizeof first);
    std::memcpy(&last, from + sizeof first, sizeof last);
    const Half inner = shuffled<1, 2>(first, last), outer = shuffled<1, 2>(last, first);
    std::memcpy(to, Moved == 1 ? &inner : &outer, sizeof inner);
    std::memcpy(to + sizeof inner, Moved == 1 ? &outer : &inner, sizeof inner);
  }
}
template <int Moved>
void rotate_rows(const void* from, size_t element_bytes, size_t count, void* to) {
  const auto rotate = element_bytes == 4 ? rotate_rows_of_float<Moved> : rotate_rows_of_double<Moved>;
  rotate(static_cast<const unsigned char*>(from), count, static_cast<unsigned char*>(to));
}

constexpr RowKernel<NormalizeRows> kNormalizeKernels[] = QTRAJ_OF_EACH_TARGET(normalize);
constexpr RowKernel<ContinuousRows> kContinuousKernels[] = QTRAJ_OF_EACH_TARGET(make_continuous);

}  // namespace

bool is_opposed(const Quaternion& a, const Quaternion& b) {
  const Quaternion p = normalizing_scale(largest_component(a)) * a;
  const Quaternion r = normalizing_scale(largest_component(b)) * b;
  // components are below 4, so that the rounding error of the sum is below 4e-14
  const double rounded = dot(p, r);
  return std::abs(rounded) > 1e-13 ? rounded < 0 : has_negative_dot(a, b);
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

size_t SeriesLayout::extent() const {
  if (series == 0 || length == 0) return 0;
  const auto reach = [](size_t count, size_t stride) {
    return count > 1 && stride > SIZE_MAX / (count - 1) ? SIZE_MAX : (count - 1) * stride;
  };
  const size_t of_series = reach(series, series_stride), of_keys = reach(length, key_stride);
  return of_keys == SIZE_MAX || of_series >= SIZE_MAX - 1 - of_keys ? SIZE_MAX : of_series + of_keys + 1;
}

bool SeriesLayout::is_apart() const {
  if (series == 0 || length == 0) return true;
  if (series > 1 && series_stride == 0) return false;
  if (length > 1 && key_stride == 0) return false;
  if (series == 1 || length == 1) return true;
  // divided, as the products may overflow
  return (series_stride - 1) / key_stride >= length - 1 || (key_stride - 1) / series_stride >= series - 1;
}

namespace {

// The rows of one series whose keys follow each other.
ContinuousRows rows_from(const ContinuousRows& rows, size_t first, size_t count) {
  const size_t bytes = first * 4 * (rows.q.is_float ? sizeof(float) : sizeof(double));
  return {{static_cast<const char*>(rows.q.data) + bytes, count, rows.q.is_float},
          {static_cast<char*>(rows.q_out.data) + bytes, count, rows.q_out.is_float},
          rows.flips};
}

// One key of a series, with the last good one before it in what is already written.
Status continue_key(const ContinuousRows& rows, const SeriesLayout& layout, size_t of_series, size_t key) {
  const size_t first = of_series * layout.series_stride, row = first + key * layout.key_stride;
  const Status status = check_key(rows.q, row);
  if (status != Status::ok) {
    write_nan(rows.q_out, row);
    return status;
  }
  const Input<4> done = {rows.q_out.data, rows.q_out.rows, rows.q_out.is_float};
  Quaternion q = row_of(rows.q, row);
  // keys at fault are passed over once, by the good one that follows them
  size_t before = key;
  while (before > 0 && !is_finite(done, first + (before - 1) * layout.key_stride)) --before;
  if (before > 0 && is_opposed(row_of(done, first + (before - 1) * layout.key_stride), q)) {
    q = -q;
    ++*rows.flips;
  }
  write_row(rows.q_out, row, q);
  return Status::ok;
}

}  // namespace

Outcome make_continuous(const ContinuousRows& rows, const SeriesLayout& layout) {
  size_t flips = 0;
  Outcome outcome;
  const auto keep_first = [&](const Outcome& found) {
    if (found.index < outcome.index) outcome = found;
  };
  if (layout.key_stride == 1) {
    for (size_t of_series = 0; of_series < layout.series; ++of_series) {
      const ContinuousRows one = rows_from(rows, of_series * layout.series_stride, layout.length);
      const Outcome found = make_continuous(one, 1, layout.length);
      if (found.status != Status::ok) keep_first({found.status, of_series * layout.length + found.index});
      flips += *rows.flips;
    }
    *rows.flips = flips;
    return outcome;
  }
  *rows.flips = 0;
  const auto visit = [&](size_t of_series, size_t key) {
    const Status status = continue_key(rows, layout, of_series, key);
    if (status != Status::ok) keep_first({status, of_series * layout.length + key});
  };
  // in the order of memory
  if (layout.key_stride > layout.series_stride) {
    for (size_t key = 0; key < layout.length; ++key)
      for (size_t of_series = 0; of_series < layout.series; ++of_series) visit(of_series, key);
  } else {
    for (size_t of_series = 0; of_series < layout.series; ++of_series)
      for (size_t key = 0; key < layout.length; ++key) visit(of_series, key);
  }
  return outcome;
}

void wxyz_from_xyzw(const void* q_xyzw, size_t element_bytes, size_t count, void* q_out) {
  rotate_rows<3>(q_xyzw, element_bytes, count, q_out);
}

void xyzw_from_wxyz(const void* q, size_t element_bytes, size_t count, void* q_xyzw_out) {
  rotate_rows<1>(q, element_bytes, count, q_xyzw_out);
}

}  // namespace qtraj
