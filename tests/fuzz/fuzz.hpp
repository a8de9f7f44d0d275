// Random calls of the C API: where numbers come from, guarded arrays, and what holds after every call.
#ifndef QTRAJ_TESTS_FUZZ_HPP
#define QTRAJ_TESTS_FUZZ_HPP

#include <qtraj.h>

#include <cerrno>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace fuzz {

// ---- Faults ----

// Told with the number of the case, by which it can be run again.
void report_fault(const char* function, const std::string& what);

inline void check(bool holds, const char* function, const char* what) {
  if (!holds) report_fault(function, what);
}

// ---- Numbers ----

// By their bits: a comparison with a signalling NaN would raise a flag.
template <class Real>
bool is_finite(Real value) {
  using Bits = std::conditional_t<sizeof(Real) == 8, uint64_t, uint32_t>;
  Bits bits;
  std::memcpy(&bits, &value, sizeof bits);
  const Bits exponent = sizeof(Real) == 8 ? Bits(0x7ff0000000000000u) : Bits(0x7f800000u);
  return (bits & exponent) != exponent;
}

// How far from ordinary the numbers of a case are.
enum class Level { ordinary, finite, any };

class Source {
 public:
  explicit Source(uint64_t seed) : state_(seed) {}

  uint64_t bits() {  // splitmix64 (Vigna)
    state_ += 0x9e3779b97f4a7c15u;
    uint64_t mixed = state_;
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9u;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebu;
    return mixed ^ (mixed >> 31);
  }
  size_t below(size_t limit) { return static_cast<size_t>(bits() % limit); }
  bool one_in(size_t count) { return below(count) == 0; }
  double uniform(double low, double high) { return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53; }
  double power(double low, double high) { return std::pow(10.0, uniform(low, high)); }
  template <class Element, size_t Count>
  Element one_of(const Element (&elements)[Count]) {
    return elements[below(Count)];
  }
  // A constant of qtraj.h, now and then one that is none.
  int32_t constant(std::initializer_list<int32_t> known) {
    if (one_in(40)) return one_in(2) ? -1 : INT32_MAX;
    return known.begin()[below(known.size())];
  }

  template <class Real>
  Real number(Level level) {
    if (level == Level::ordinary || one_in(2)) return static_cast<Real>(one_in(8) ? 0.0 : uniform(-2, 2));
    using Limits = std::numeric_limits<Real>;
    const Real special[] = {0,
                            Real(-0.0),
                            Limits::denorm_min(),
                            -Limits::denorm_min(),
                            Limits::min(),
                            Limits::max(),
                            -Limits::max(),
                            Limits::epsilon(),
                            Real(3.141592653589793),
                            Real(-6.283185307179586),
                            Real(1e30),
                            Real(-1e-30),
                            std::sqrt(Limits::max()),
                            std::sqrt(Limits::min())};
    if (level == Level::any && one_in(4)) {
      using Bits = std::conditional_t<sizeof(Real) == 8, uint64_t, uint32_t>;
      const Bits random = static_cast<Bits>(bits());
      Real value;
      std::memcpy(&value, &random, sizeof value);
      return value;
    }
    if (one_in(2)) return one_of(special);
    const int range = sizeof(Real) == 8 ? 1070 : 145;
    return std::ldexp(static_cast<Real>(uniform(-1, 1)),
                      static_cast<int>(below(static_cast<size_t>(2 * range))) - range);
  }

 private:
  uint64_t state_;
};

// ---- Arrays ----

// Rooms between pages that may not be touched. An array ends right at such a page, or begins there; what is left of its
// room holds a pattern, and so does an array until it is written.
class Rooms {
 public:
  static constexpr size_t kBytes = size_t{1} << 16;
  static constexpr unsigned char kPattern = 0xa5;

  static Rooms& all();
  // To be called at the start of a case: all rooms are free.
  void clear() { used_ = 0; }
  unsigned char* take(size_t bytes, bool at_end);
  // Whether all rooms still hold the pattern around their arrays.
  bool are_intact() const;

 private:
  struct Room {
    unsigned char* begin;
    size_t offset, bytes;
  };
  std::vector<Room> rooms_;
  size_t used_ = 0;
};

template <class Element>
class Array {
 public:
  Array(Source& source, size_t count)
      : count_(count),
        data_(reinterpret_cast<Element*>(Rooms::all().take(count * sizeof(Element), source.one_in(2)))) {}
  Array(Source& source, size_t count, Level level) : Array(source, count) {
    for (size_t i = 0; i < count; ++i) data_[i] = source.number<Element>(level);
  }

  size_t count() const { return count_; }
  Element* data() const { return data_; }
  Element& operator[](size_t i) const { return data_[i]; }
  bool is_untouched() const {
    const auto* bytes = reinterpret_cast<const unsigned char*>(data_);
    for (size_t i = 0; i < count_ * sizeof(Element); ++i)
      if (bytes[i] != Rooms::kPattern) return false;
    return true;
  }
  // Of rows of `width` elements.
  bool row_is_finite(size_t row, size_t width) const {
    for (size_t k = row * width; k < row * width + width; ++k)
      if (!is_finite(data_[k])) return false;
    return true;
  }
  bool row_is_nan(size_t row, size_t width) const {
    for (size_t k = row * width; k < row * width + width; ++k)
      if (is_finite(data_[k]) || data_[k] == data_[k]) return false;
    return true;
  }

 private:
  size_t count_;
  Element* data_;
};

// Quaternions; faults are rare in a row, so that most of a long array is good.
template <class Real>
Array<Real> quaternions(Source& source, size_t count, Level level) {
  Array<Real> q(source, 4 * count, Level::ordinary);
  for (size_t row = 0; row < count; ++row) {
    if (level != Level::ordinary && source.one_in(8))
      for (size_t k = 4 * row; k < 4 * row + 4; ++k) q[k] = source.number<Real>(level);
    if (row > 0 && source.one_in(6))
      for (size_t k = 4 * row; k < 4 * row + 4; ++k) q[k] = source.one_in(2) ? q[k - 4] : -q[k - 4];
    if (level == Level::ordinary && q[4 * row] == 0) q[4 * row] = 1;
  }
  return q;
}

// Times that increase, but for faults.
inline Array<double> knots(Source& source, size_t count, Level level) {
  Array<double> times(source, count);
  const double decades = source.uniform(0, level == Level::ordinary ? 3 : 12);
  double time = source.one_in(4) ? source.number<double>(Level::finite) : source.uniform(-10, 10);
  if (!(std::abs(time) < 1e9)) time = 0;
  for (size_t i = 0; i < count; ++i) {
    times[i] = time;
    const double next = time + source.power(-decades, 0);
    time = next > time ? next : std::nextafter(time, HUGE_VAL);
  }
  if (level == Level::any && count > 0 && source.one_in(4)) times[source.below(count)] = source.number<double>(level);
  return times;
}

// Inside, outside and at the knots.
inline Array<double> query_times(Source& source, const Array<double>& knots, size_t count, Level level) {
  Array<double> times(source, count);
  for (size_t i = 0; i < count; ++i) {
    const double start = knots[0], end = knots[knots.count() - 1];
    times[i] = source.one_in(4) ? knots[source.below(knots.count())] : start + (end - start) * source.uniform(0, 1);
    if (source.one_in(8)) times[i] = start + (end - start) * source.uniform(-3, 4);
    if (level == Level::any && source.one_in(8)) times[i] = source.number<double>(level);
  }
  return times;
}

// ---- Calls ----

// What all kernels, or those of one kind, must agree on.
class Digest {
 public:
  template <class Number>
  void add(Number value) {
    const double number = value == value ? static_cast<double>(value) : -1.0;
    unsigned char bytes[sizeof number];
    std::memcpy(bytes, &number, sizeof bytes);
    for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 1099511628211u;
  }
  template <class Element>
  void add_all(const Array<Element>& array) {
    for (size_t i = 0; i < array.count(); ++i) add(array[i]);
  }
  uint64_t value() const { return hash_; }

 private:
  uint64_t hash_ = 14695981039346656037u;
};

struct Digests {
  Digest everywhere, of_kind;
};

// Calls, and checks what every function promises: a status that is known and no defect, errno and the floating-point
// flags left alone, nothing written outside of arrays.
template <class Call>
qtraj_status checked(const char* function, const Call& call) {
  constexpr int kErrno = 0x5a5a;
  errno = kErrno;
  std::feclearexcept(FE_ALL_EXCEPT);
  const qtraj_status status = call();
  check(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) == 0, function, "a floating-point flag");
  check(errno == kErrno, function, "errno");
  check(status != QTRAJ_E_INTERNAL, function, "INTERNAL");
  check(std::strcmp(qtraj_status_text(status), qtraj_status_text(INT32_MAX)) != 0, function, "unknown status");
  check(Rooms::all().are_intact(), function, "written outside of its arrays");
  return status;
}

// Rows of an output after a call that was not refused: each finite or all NaN, NaN where the first fault is; without a
// fault there is no NaN. AMBIGUOUS rows are valid ones.
template <class Real>
void check_rows(const char* function, const Array<Real>& out, size_t width, qtraj_status status, size_t bad_index) {
  const bool sound = status == QTRAJ_OK || status == QTRAJ_E_AMBIGUOUS;
  check((status == QTRAJ_OK) == (bad_index == SIZE_MAX) || !sound, function, "OK with an index");
  for (size_t row = 0; row * width < out.count(); ++row) {
    const bool finite = out.row_is_finite(row, width);
    check(finite || out.row_is_nan(row, width), function, "a row neither finite nor NaN");
    if (status == QTRAJ_OK || (bad_index != SIZE_MAX && row < bad_index))
      check(finite, function, "a NaN without fault");
  }
}

// Kinds of cases: functions over arrays, trajectories, many of them in one call, and vector curves.
void fuzz_arrays(Source& source, Digests& digests);
void fuzz_batch(Source& source, Digests& digests);
void fuzz_curve(Source& source, Digests& digests);
void fuzz_vectors(Source& source, Digests& digests);

}  // namespace fuzz

#endif
