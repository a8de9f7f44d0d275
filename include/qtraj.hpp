/** @file qtraj.hpp
 * The C interface in C++17: values that free themselves, exceptions, arrays of any kind as they are.
 *
 * Header only, over qtraj.h, which says what each function does. float and double are overloads. Where the standard
 * library has std::expected (C++23), try_ forms give it instead of an exception.
 *
 * @par Arrays
 *   qtraj::rows<Real, Width> is a view of rows that lie side by side. It is made of C arrays, std::array, std::vector,
 *   std::span and Eigen matrices, of numbers or of whole rows such as std::array<double, 4>. Eigen matrices have their
 *   rows where they lie as such: Matrix<double, 4, Dynamic>, or Matrix<double, Dynamic, 4, RowMajor>; others do not
 *   compile. Eigen's quaternions store x y z w and do not compile either.
 * @par Errors
 *   A status that is not OK is thrown as qtraj::error, with the index of the first row at fault. Outputs of the caller
 *   are written as qtraj.h says: all rows but those at fault are right, and under AMBIGUOUS all of them hold an answer.
 *   Calls that return their result lose it with the exception. */
#ifndef QTRAJ_HPP
#define QTRAJ_HPP

#include <qtraj.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>
#if __has_include(<version>)
#include <version>
#endif
#ifdef __cpp_lib_expected
#include <expected>
#endif

namespace qtraj {

// ---- Constants ----

enum class method : std::int32_t {
  slerp = QTRAJ_SLERP,
  nlerp = QTRAJ_NLERP,
  squad = QTRAJ_SQUAD,
  log_spline = QTRAJ_LOG_SPLINE,
  rotation_spline = QTRAJ_ROTATION_SPLINE,
  hermite = QTRAJ_HERMITE,
  rotation_quintic = QTRAJ_ROTATION_QUINTIC,
  quaternion_quintic = QTRAJ_QUATERNION_QUINTIC,
  step = QTRAJ_STEP,
  quaternion_hermite = QTRAJ_QUATERNION_HERMITE
};
enum class vector_method : std::int32_t {
  step = QTRAJ_VECTOR_STEP,
  linear = QTRAJ_VECTOR_LINEAR,
  cubic = QTRAJ_VECTOR_CUBIC,
  hermite = QTRAJ_VECTOR_HERMITE,
  quintic = QTRAJ_VECTOR_QUINTIC
};
enum class frame : std::int32_t { body = QTRAJ_FRAME_BODY, world = QTRAJ_FRAME_WORLD };
enum class end : std::int32_t {
  standard = QTRAJ_END_DEFAULT,
  chord = QTRAJ_END_CHORD,
  natural = QTRAJ_END_NATURAL,
  not_a_knot = QTRAJ_END_NOT_A_KNOT,
  estimated = QTRAJ_END_ESTIMATED,
  given = QTRAJ_END_GIVEN,
  periodic = QTRAJ_END_PERIODIC
};
enum class tangent : std::int32_t {
  standard = QTRAJ_TANGENT_DEFAULT,
  catmull_rom = QTRAJ_TANGENT_CATMULL_ROM,
  mean_velocity = QTRAJ_TANGENT_MEAN_VELOCITY,
  given = QTRAJ_TANGENT_GIVEN,
  rest = QTRAJ_TANGENT_REST
};
enum class reference : std::int32_t {
  standard = QTRAJ_REFERENCE_DEFAULT,
  first = QTRAJ_REFERENCE_FIRST,
  mean = QTRAJ_REFERENCE_MEAN,
  given = QTRAJ_REFERENCE_GIVEN
};
enum class extrapolate : std::int32_t {
  standard = QTRAJ_EXTRAPOLATE_DEFAULT,
  error = QTRAJ_EXTRAPOLATE_ERROR,
  hold = QTRAJ_EXTRAPOLATE_HOLD,
  constant_rate = QTRAJ_EXTRAPOLATE_CONSTANT_RATE,
  periodic = QTRAJ_EXTRAPOLATE_PERIODIC
};
enum class turns : std::int32_t {
  standard = QTRAJ_TURNS_DEFAULT,
  shortest = QTRAJ_TURNS_SHORTEST,
  as_given = QTRAJ_TURNS_AS_GIVEN,
  from_rates = QTRAJ_TURNS_FROM_RATES,
  given = QTRAJ_TURNS_GIVEN
};
enum class path : std::int32_t { shortest = QTRAJ_PATH_SHORTEST, as_given = QTRAJ_PATH_AS_GIVEN };
enum class layout : std::int32_t { series_first = QTRAJ_LAYOUT_SERIES_FIRST, time_first = QTRAJ_LAYOUT_TIME_FIRST };
enum class status_class : std::int32_t {
  done = QTRAJ_CLASS_DONE,
  refused = QTRAJ_CLASS_REFUSED,
  data = QTRAJ_CLASS_DATA,
  one_of_several = QTRAJ_CLASS_ONE_OF_SEVERAL,
  defect = QTRAJ_CLASS_DEFECT
};

// ---- Values ----

template <class Real>
using basic_quaternion = std::array<Real, 4>;  // w x y z
template <class Real>
using basic_vector = std::array<Real, 3>;
using quaternion = basic_quaternion<double>;
using vector3 = basic_vector<double>;

inline constexpr std::size_t no_index = SIZE_MAX;

/** A status that is not OK, and the first row, key or series at fault: no_index where it is none. */
class error : public std::runtime_error {
 public:
  explicit error(qtraj_status status, std::size_t index = no_index)
      : std::runtime_error(qtraj_status_text(status)), status_(status), index_(index) {}
  qtraj_status status() const noexcept { return status_; }
  std::size_t index() const noexcept { return index_; }
  qtraj::status_class status_class() const noexcept {
    return static_cast<qtraj::status_class>(qtraj_status_class(status_));
  }

 private:
  qtraj_status status_;
  std::size_t index_;
};

namespace detail {

// By reference: the index is written by the call whose status stands beside it.
inline void check(qtraj_status status, const std::size_t& index = no_index) {
  if (status != QTRAJ_OK) throw error(status, index);
}

// Whether a class is an Eigen type, whose shape is known to the compiler in part; -1 stands for what is not.
template <class C, class = void>
struct matrix_of {
  static constexpr bool is_one = false;
};
template <class C>
struct matrix_of<C, std::void_t<decltype(C::RowsAtCompileTime), decltype(C::IsRowMajor)>> {
  static constexpr bool is_one = true;
  static constexpr int rows = static_cast<int>(C::RowsAtCompileTime), columns = static_cast<int>(C::ColsAtCompileTime);
  static constexpr bool is_row_major = C::IsRowMajor;
};
template <class C, class = void>
struct has_coeffs : std::false_type {};
template <class C>
struct has_coeffs<C, std::void_t<decltype(std::declval<const C&>().coeffs().data())>> : std::true_type {};

// Rows of Width numbers lie side by side in an Eigen matrix of this shape.
template <class C, std::size_t Width>
constexpr bool has_rows_of() {
  if constexpr (matrix_of<C>::is_one) {
    constexpr int width = static_cast<int>(Width);
    using shape = matrix_of<C>;
    if (shape::is_row_major ? shape::columns == width : shape::rows == width) return true;
    return (shape::rows == 1 || shape::columns == 1) && (Width == 1 || Width == 0);
  } else {
    return true;
  }
}

template <class C>
using element_of = std::remove_pointer_t<decltype(std::data(std::declval<C&>()))>;

// The number type of a row such as std::array<double, 4> or double[4], void for what is no such row.
template <class Row, class = void>
struct number_of {
  using type = void;
};
template <class Number, std::size_t Width>
struct number_of<std::array<Number, Width>> {
  using type = Number;
};
template <class Number, std::size_t Width>
struct number_of<Number[Width]> {
  using type = std::remove_cv_t<Number>;
};

}  // namespace detail

/** Rows of Width numbers side by side, as a view: rows<const double, 4> are quaternions to read. */
template <class Real, std::size_t Width>
class rows {
  using number = std::remove_const_t<Real>;

  // Whether elements of a container are numbers of a row, or whole rows.
  template <class E>
  static constexpr bool fits() {
    using plain = std::remove_cv_t<std::remove_all_extents_t<E>>;
    constexpr bool may_write = std::is_const_v<Real> || !std::is_const_v<std::remove_all_extents_t<E>>;
    if constexpr (std::is_same_v<plain, number>) {
      return may_write && (!std::is_array_v<E> || sizeof(E) == Width * sizeof(number));
    } else {
      using inner = typename detail::number_of<std::remove_cv_t<E>>::type;
      return may_write && std::is_same_v<inner, number> && sizeof(E) == Width * sizeof(number);
    }
  }

 public:
  constexpr rows() = default;
  constexpr rows(Real* data, std::size_t count) : data_(data), count_(count) {}
  /** Rows to read of rows to write. */
  template <class Other, class = std::enable_if_t<std::is_same_v<const Other, Real> && !std::is_const_v<Other>>>
  constexpr rows(const rows<Other, Width>& other) : data_(other.data()), count_(other.count()) {}
  /** Of anything that has std::data and std::size: numbers, whose count must be a multiple of Width, or whole rows. */
  template <class C, class E = detail::element_of<C>, class = std::enable_if_t<fits<E>()>>
  rows(C&& container)
      : data_(reinterpret_cast<Real*>(std::data(container))),
        count_(static_cast<std::size_t>(std::size(container)) * sizeof(E) / (Width * sizeof(number))) {
    static_assert(detail::has_rows_of<std::remove_cv_t<std::remove_reference_t<C>>, Width>(),
                  "an Eigen matrix whose rows of numbers do not lie side by side: 4 x n, or n x 4 in RowMajor");
    if (static_cast<std::size_t>(std::size(container)) * sizeof(E) != count_ * Width * sizeof(number)) {
      throw error(QTRAJ_E_COUNT);
    }
  }
  Real* data() const noexcept { return data_; }
  std::size_t count() const noexcept { return count_; }

 private:
  Real* data_ = nullptr;
  std::size_t count_ = 0;
};

template <class Real>
using quaternions_in = rows<const Real, 4>;
template <class Real>
using quaternions_out = rows<Real, 4>;
template <class Real>
using vectors_in = rows<const Real, 3>;
template <class Real>
using vectors_out = rows<Real, 3>;
using times_in = rows<const double, 1>;
using times_out = rows<double, 1>;

// ---- Library ----

inline const char* version() noexcept { return qtraj_version(); }
inline std::int32_t version_number() noexcept { return qtraj_version_number(); }
inline const char* status_text(std::int32_t status) noexcept { return qtraj_status_text(status); }
inline status_class class_of(std::int32_t status) noexcept {
  return static_cast<status_class>(qtraj_status_class(status));
}
/** Kernel that runs here and its arithmetic, such as "avx2 fused". */
inline const char* target() noexcept { return qtraj_target(); }

namespace detail {

// The C function of double or of float, by type: QTRAJ_TWINS(multiply) is detail::multiply<Real>().
#define QTRAJ_TWINS(name)                      \
  template <class Real>                        \
  constexpr auto c_##name() {                  \
    if constexpr (std::is_same_v<Real, float>) \
      return &qtraj_##name##_f32;              \
    else                                       \
      return &qtraj_##name;                    \
  }
QTRAJ_TWINS(create)
QTRAJ_TWINS(create_with_options)
QTRAJ_TWINS(create_with_rates)
QTRAJ_TWINS(create_with_turns)
QTRAJ_TWINS(create_with_tangents)
QTRAJ_TWINS(init)
QTRAJ_TWINS(init_with_tangents)
QTRAJ_TWINS(sample)
QTRAJ_TWINS(sample_rates)
QTRAJ_TWINS(sample_many)
QTRAJ_TWINS(sample_uniform)
QTRAJ_TWINS(sample_at)
QTRAJ_TWINS(sample_rates_at)
QTRAJ_TWINS(vector_create)
QTRAJ_TWINS(vector_init)
QTRAJ_TWINS(vector_sample)
QTRAJ_TWINS(vector_sample_uniform)
QTRAJ_TWINS(vector_sample_at)
QTRAJ_TWINS(sample_poses)
QTRAJ_TWINS(sample_pose_at)
QTRAJ_TWINS(batch_sample)
QTRAJ_TWINS(batch_sample_rates)
QTRAJ_TWINS(batch_mean_eigen)
QTRAJ_TWINS(slerp_pairs)
QTRAJ_TWINS(nlerp_pairs)
QTRAJ_TWINS(slerp)
QTRAJ_TWINS(nlerp)
QTRAJ_TWINS(slerp_pairs_between)
QTRAJ_TWINS(nlerp_pairs_between)
QTRAJ_TWINS(screw_pairs)
QTRAJ_TWINS(check_keys)
QTRAJ_TWINS(normalize)
QTRAJ_TWINS(make_continuous)
QTRAJ_TWINS(make_continuous_strided)
QTRAJ_TWINS(wxyz_from_xyzw)
QTRAJ_TWINS(xyzw_from_wxyz)
QTRAJ_TWINS(rows_from_columns)
QTRAJ_TWINS(columns_from_rows)
QTRAJ_TWINS(multiply)
QTRAJ_TWINS(exp)
QTRAJ_TWINS(log)
QTRAJ_TWINS(rotate)
QTRAJ_TWINS(distance)
QTRAJ_TWINS(rotation_vector_from_q)
QTRAJ_TWINS(q_from_rotation_vector)
QTRAJ_TWINS(matrix_from_q)
QTRAJ_TWINS(q_from_matrix)
QTRAJ_TWINS(mean_eigen)
QTRAJ_TWINS(mean_karcher)
QTRAJ_TWINS(moments_add)
#undef QTRAJ_TWINS

// The numbers of a container, of rows or of Eigen: double or float.
template <class E>
struct scalar_of {
  using inner = typename number_of<std::remove_cv_t<E>>::type;
  using type = std::conditional_t<std::is_void_v<inner>, std::remove_cv_t<std::remove_all_extents_t<E>>, inner>;
};
template <class C, class = void>
struct real_of_container {
  using type = typename scalar_of<element_of<const C>>::type;
};
template <class Real, std::size_t Width>
struct real_of_container<rows<Real, Width>> {
  using type = std::remove_const_t<Real>;
};
template <class C>
using real_of = typename real_of_container<std::remove_cv_t<std::remove_reference_t<C>>>::type;

// Arrays that stand row by row beside each other: as many rows, or none at all.
inline void same(std::size_t count, std::size_t other, bool may_be_none = false) {
  if (count != other && !(may_be_none && other == 0)) throw error(QTRAJ_E_COUNT);
}

}  // namespace detail

// ---- Options ----

/** A method and its settings: qtraj_options. Setters check at once, throw without effect, and can be chained. */
class options {
 public:
  explicit options(qtraj::method method) : options(static_cast<std::int32_t>(method)) {}
  explicit options(vector_method method) : options(static_cast<std::int32_t>(method)) {}

  options& ends(end start, end last) {
    return done(qtraj_options_set_ends(get(), static_cast<std::int32_t>(start), static_cast<std::int32_t>(last)));
  }
  /** Rates of ends that are GIVEN, rad/s; nullptr for an end that is not. */
  options& end_rates(frame in, const vector3* start, const vector3* last) {
    return done(qtraj_options_set_end_rates(get(), static_cast<std::int32_t>(in), start ? start->data() : nullptr,
                                            last ? last->data() : nullptr));
  }
  options& tangents(tangent rule) { return done(qtraj_options_set_tangents(get(), static_cast<std::int32_t>(rule))); }
  options& reference(qtraj::reference rule) {
    return done(qtraj_options_set_reference(get(), static_cast<std::int32_t>(rule), nullptr));
  }
  options& reference(const quaternion& q_wb) {
    return done(qtraj_options_set_reference(get(), QTRAJ_REFERENCE_GIVEN, q_wb.data()));
  }
  options& extrapolation(extrapolate before, extrapolate after) {
    return done(
        qtraj_options_set_extrapolation(get(), static_cast<std::int32_t>(before), static_cast<std::int32_t>(after)));
  }
  options& turns(qtraj::turns rule) { return done(qtraj_options_set_turns(get(), static_cast<std::int32_t>(rule))); }
  options& period(double seconds) { return done(qtraj_options_set_period(get(), seconds)); }
  options& closure(double angle) { return done(qtraj_options_set_closure(get(), angle)); }
  options& longest_gap(double seconds) { return done(qtraj_options_set_longest_gap(get(), seconds)); }

  qtraj_options* get() const noexcept { return handle_.get(); }

 private:
  explicit options(std::int32_t method) {
    qtraj_options* made = nullptr;
    detail::check(qtraj_options_create(method, &made));
    handle_.reset(made);
  }
  options& done(qtraj_status status) {
    detail::check(status);
    return *this;
  }
  struct destroy {
    void operator()(qtraj_options* options) const noexcept { qtraj_options_destroy(options); }
  };
  std::unique_ptr<qtraj_options, destroy> handle_;
};

// ---- Trajectories ----

/** Orientation and rates at one time: rad/s, rad/s^2 in the frame that was asked for. */
template <class Real>
struct basic_motion {
  basic_quaternion<Real> q;
  basic_vector<Real> omega, alpha;
};
using motion = basic_motion<double>;

/** Greatest rates, rad/s and rad/s^2, and their times, s. */
struct peaks {
  double omega, omega_time, alpha, alpha_time;
};

/** Where a time was found, for the next one: one for each sequence of times. */
class cursor {
 public:
  std::size_t* get() noexcept { return &segment_; }

 private:
  std::size_t segment_ = 0;
};

/** A curve through keyframes: qtraj_trajectory. Immutable; copies share it. */
class trajectory {
 public:
  /** With the default settings of a method. */
  template <class T, class Q>
  trajectory(qtraj::method method, const T& times, const Q& q_wb) {
    using Real = detail::real_of<Q>;
    const times_in t(times);
    const quaternions_in<Real> q(q_wb);
    detail::same(q.count(), t.count());
    make([&](qtraj_trajectory** out, std::size_t* bad) {
      return detail::c_create<Real>()(static_cast<std::int32_t>(method), t.data(), q.data(), q.count(), out, bad);
    });
  }
  template <class T, class Q>
  trajectory(const options& settings, const T& times, const Q& q_wb) {
    using Real = detail::real_of<Q>;
    const times_in t(times);
    const quaternions_in<Real> q(q_wb);
    detail::same(q.count(), t.count());
    make([&](qtraj_trajectory** out, std::size_t* bad) {
      return detail::c_create_with_options<Real>()(settings.get(), t.data(), q.data(), q.count(), out, bad);
    });
  }
  /** With rates at the keys; alpha may be empty. */
  template <class T, class Q, class W, class A>
  trajectory(const options& settings, frame in, const T& times, const Q& q_wb, const W& omega, const A& alpha) {
    using Real = detail::real_of<Q>;
    const rated<Real> keys(times, q_wb, omega, alpha);
    make([&](qtraj_trajectory** out, std::size_t* bad) {
      return detail::c_create_with_rates<Real>()(settings.get(), static_cast<std::int32_t>(in), keys.t.data(),
                                                 keys.q.data(), keys.omega.data(), keys.alpha.data(), keys.q.count(),
                                                 out, bad);
    });
  }
  /** With numbers of whole turns, one for each step; omega and alpha may be empty. */
  template <class T, class Q, class W, class A>
  trajectory(const options& settings, frame in, const T& times, const Q& q_wb, const W& omega, const A& alpha,
             const std::vector<std::int32_t>& turns) {
    using Real = detail::real_of<Q>;
    const rated<Real> keys(times, q_wb, omega, alpha);
    if (turns.size() + 1 < keys.q.count()) throw error(QTRAJ_E_COUNT);
    make([&](qtraj_trajectory** out, std::size_t* bad) {
      return detail::c_create_with_turns<Real>()(settings.get(), static_cast<std::int32_t>(in), keys.t.data(),
                                                 keys.q.data(), keys.omega.data(), keys.alpha.data(), turns.data(),
                                                 keys.q.count(), out, bad);
    });
  }
  /** QUATERNION_HERMITE: dq/dt before and after each key, 1/s; after may be empty, then one serves both. */
  template <class T, class Q, class B, class A>
  static trajectory with_tangents(const options& settings, const T& times, const Q& q_wb, const B& before,
                                  const A& after) {
    using Real = detail::real_of<Q>;
    const times_in t(times);
    const quaternions_in<Real> q(q_wb), in(before), out_of(after);
    detail::same(q.count(), t.count());
    detail::same(q.count(), in.count());
    detail::same(q.count(), out_of.count(), true);
    trajectory made;
    made.make([&](qtraj_trajectory** out, std::size_t* bad) {
      return detail::c_create_with_tangents<Real>()(settings.get(), t.data(), q.data(), in.data(), out_of.data(),
                                                    q.count(), out, bad);
    });
    return made;
  }
  /** Takes over a trajectory of the C interface, which it will destroy. */
  explicit trajectory(qtraj_trajectory* owned) : handle_(owned, qtraj_destroy) {}

  /** Bytes that in_memory() takes for so many keys. */
  static std::size_t bytes(const options& settings, std::size_t count) {
    std::size_t bytes = 0;
    detail::check(qtraj_init_size(settings.get(), count, &bytes));
    return bytes;
  }
  /** In memory of the caller, aligned to 8 bytes, which must outlive it and all its copies; omega and alpha may be
   * empty. */
  template <class T, class Q, class W, class A>
  static trajectory in_memory(void* memory, std::size_t bytes, const options& settings, frame in, const T& times,
                              const Q& q_wb, const W& omega, const A& alpha) {
    using Real = detail::real_of<Q>;
    const rated<Real> keys(times, q_wb, omega, alpha);
    return placed([&](qtraj_trajectory** out, std::size_t* bad) {
      return detail::c_init<Real>()(memory, bytes, settings.get(), static_cast<std::int32_t>(in), keys.t.data(),
                                    keys.q.data(), keys.omega.data(), keys.alpha.data(), nullptr, keys.q.count(), out,
                                    bad);
    });
  }
  template <class T, class Q, class B, class A>
  static trajectory in_memory_with_tangents(void* memory, std::size_t bytes, const options& settings, const T& times,
                                            const Q& q_wb, const B& before, const A& after) {
    using Real = detail::real_of<Q>;
    const times_in t(times);
    const quaternions_in<Real> q(q_wb), in(before), out_of(after);
    detail::same(q.count(), t.count());
    detail::same(q.count(), in.count());
    detail::same(q.count(), out_of.count(), true);
    return placed([&](qtraj_trajectory** out, std::size_t* bad) {
      return detail::c_init_with_tangents<Real>()(memory, bytes, settings.get(), t.data(), q.data(), in.data(),
                                                  out_of.data(), q.count(), out, bad);
    });
  }

  // One time. A time that is at fault throws.
  quaternion operator()(double time) const { return at<double>(time, nullptr); }
  quaternion operator()(double time, cursor& last) const { return at<double>(time, last.get()); }
  motion operator()(double time, frame in) const { return rates_at<double>(time, in, nullptr); }
  motion operator()(double time, frame in, cursor& last) const { return rates_at<double>(time, in, last.get()); }
  template <class Real>
  basic_quaternion<Real> at(double time, std::size_t* last = nullptr) const {
    basic_quaternion<Real> q;
    detail::check(detail::c_sample_at<Real>()(get(), time, last, q.data()));
    return q;
  }
  template <class Real>
  basic_motion<Real> rates_at(double time, frame in, std::size_t* last = nullptr) const {
    basic_motion<Real> m;
    detail::check(detail::c_sample_rates_at<Real>()(get(), static_cast<std::int32_t>(in), time, last, m.q.data(),
                                                    m.omega.data(), m.alpha.data()));
    return m;
  }

  /** Orientations at times, in any order. */
  template <class T, class Q>
  void sample(const T& times, Q&& q_out) const {
    using Real = detail::real_of<Q>;
    const times_in t(times);
    const quaternions_out<Real> q(q_out);
    detail::same(t.count(), q.count());
    std::size_t bad = no_index;
    detail::check(detail::c_sample<Real>()(get(), t.data(), t.count(), q.data(), &bad), bad);
  }
  template <class Real = double, class T>
  std::vector<basic_quaternion<Real>> sample(const T& times) const {
    std::vector<basic_quaternion<Real>> q(times_in(times).count());
    sample(times, q);
    return q;
  }
  /** Orientations and rates; any of the outputs may be empty, but not all. */
  template <class T, class Q, class W, class A>
  void sample_rates(frame in, const T& times, Q&& q_out, W&& omega_out, A&& alpha_out) const {
    using Real = detail::real_of<W>;
    const times_in t(times);
    const quaternions_out<Real> q(q_out);
    const vectors_out<Real> omega(omega_out), alpha(alpha_out);
    for (const std::size_t count : {q.count(), omega.count(), alpha.count()}) detail::same(t.count(), count, true);
    std::size_t bad = no_index;
    detail::check(detail::c_sample_rates<Real>()(get(), static_cast<std::int32_t>(in), t.data(), t.count(),
                                                 q.count() ? q.data() : nullptr, omega.count() ? omega.data() : nullptr,
                                                 alpha.count() ? alpha.data() : nullptr, &bad),
                  bad);
  }
  /** At start + i * step, as many as the output has rows. */
  template <class Q>
  void sample_uniform(double start, double step, Q&& q_out) const {
    using Real = detail::real_of<Q>;
    const quaternions_out<Real> q(q_out);
    std::size_t bad = no_index;
    detail::check(detail::c_sample_uniform<Real>()(get(), start, step, q.count(), q.data(), &bad), bad);
  }
  template <class Real = double>
  std::vector<basic_quaternion<Real>> sample_uniform(double start, double step) const {
    std::vector<basic_quaternion<Real>> q(uniform_count(start, step));
    sample_uniform(start, step, q);
    return q;
  }
  std::size_t uniform_count(double start, double step) const {
    std::size_t count = 0;
    detail::check(qtraj_uniform_count(get(), start, step, &count));
    return count;
  }
  std::vector<double> segment_times(std::size_t per_segment) const {
    if (per_segment < 2) throw error(QTRAJ_E_TOO_FEW);
    std::vector<double> times((key_count() - 1) * (per_segment - 1) + 1);
    detail::check(qtraj_segment_times(get(), per_segment, times.data()));
    return times;
  }
  /** The curve in R^4 that is normalised, and its derivatives; any output may be empty, but not all. */
  template <class T>
  void sample_unnormalized(const T& times, quaternions_out<double> p, quaternions_out<double> dp,
                           quaternions_out<double> ddp) const {
    const times_in t(times);
    for (const std::size_t count : {p.count(), dp.count(), ddp.count()}) detail::same(t.count(), count, true);
    std::size_t bad = no_index;
    detail::check(qtraj_sample_unnormalized(get(), t.data(), t.count(), p.data(), dp.data(), ddp.data(), &bad), bad);
  }

  qtraj::method method() const noexcept { return static_cast<qtraj::method>(qtraj_method(get())); }
  std::size_t key_count() const noexcept { return qtraj_key_count(get()); }
  double start_time() const noexcept { return qtraj_start_time(get()); }
  double end_time() const noexcept { return qtraj_end_time(get()); }
  std::size_t sign_flips() const noexcept { return qtraj_sign_flips(get()); }
  double worst_norm_error() const noexcept { return qtraj_worst_norm_error(get()); }
  double least_dot() const noexcept { return qtraj_least_dot(get()); }
  std::int32_t iterations() const noexcept { return qtraj_iterations(get()); }
  double residual() const noexcept { return qtraj_residual(get()); }
  std::vector<double> times() const {
    std::vector<double> times(key_count());
    detail::check(qtraj_keys(get(), times.data(), nullptr));
    return times;
  }
  std::vector<quaternion> keys() const {
    std::vector<quaternion> q(key_count());
    detail::check(qtraj_keys(get(), nullptr, q.front().data()));
    return q;
  }
  /** Smallest norm before normalising, and its time, s. */
  std::pair<double, double> least_norm() const {
    std::pair<double, double> found;
    detail::check(qtraj_curve_least_norm(get(), &found.first, &found.second));
    return found;
  }
  /** By how much omega and alpha jump at each key. */
  std::pair<std::vector<vector3>, std::vector<vector3>> jumps(frame in) const {
    std::pair<std::vector<vector3>, std::vector<vector3>> found{std::vector<vector3>(key_count()),
                                                                std::vector<vector3>(key_count())};
    detail::check(qtraj_curve_jumps(get(), static_cast<std::int32_t>(in), found.first.front().data(),
                                    found.second.front().data()));
    return found;
  }
  peaks peak_rates() const {
    peaks found{};
    detail::check(qtraj_curve_peak_rates(get(), &found.omega, &found.omega_time, &found.alpha, &found.alpha_time));
    return found;
  }
  /** Bounds of |omega|, rad/s, and |alpha|, rad/s^2. */
  std::pair<double, double> rate_bounds() const {
    std::pair<double, double> found;
    detail::check(qtraj_rate_bounds(get(), &found.first, &found.second));
    return found;
  }
  /** Largest angle, rad, between a step and what its rates make of it, and the index of the step. */
  std::pair<double, std::size_t> rate_mismatch() const {
    std::pair<double, std::size_t> found;
    detail::check(qtraj_rate_mismatch(get(), &found.first, &found.second));
    return found;
  }
  double energy() const {
    double energy = 0;
    detail::check(qtraj_curve_energy(get(), &energy));
    return energy;
  }
  double total_angle() const {
    double angle = 0;
    detail::check(qtraj_curve_total_angle(get(), &angle));
    return angle;
  }
  const qtraj_trajectory* get() const noexcept { return handle_.get(); }

 private:
  trajectory() = default;

  // Keys with rates, which may be empty.
  template <class Real>
  struct rated {
    template <class T, class Q, class W, class A>
    rated(const T& times, const Q& q_wb, const W& omega_at, const A& alpha_at)
        : t(times), q(q_wb), omega(omega_at), alpha(alpha_at) {
      detail::same(q.count(), t.count());
      detail::same(q.count(), omega.count(), true);
      detail::same(q.count(), alpha.count(), true);
      if (omega.count() == 0) omega = {};
      if (alpha.count() == 0) alpha = {};
    }
    times_in t;
    quaternions_in<Real> q;
    vectors_in<Real> omega, alpha;
  };
  template <class F>
  void make(F call) {
    qtraj_trajectory* made = nullptr;
    std::size_t bad = no_index;
    detail::check(call(&made, &bad), bad);
    handle_.reset(made, qtraj_destroy);
  }
  template <class F>
  static trajectory placed(F call) {
    qtraj_trajectory* made = nullptr;
    std::size_t bad = no_index;
    detail::check(call(&made, &bad), bad);
    trajectory result;
    result.handle_.reset(made, [](qtraj_trajectory*) {});
    return result;
  }
  std::shared_ptr<qtraj_trajectory> handle_;
};

/** Many curves at shared times; any output may be empty, but not all. */
template <class T, class Q, class W, class A>
void sample_many(const std::vector<trajectory>& curves, frame in, const T& times, layout order, Q&& q_out,
                 W&& omega_out, A&& alpha_out) {
  using Real = detail::real_of<Q>;
  std::vector<const qtraj_trajectory*> handles;
  for (const trajectory& curve : curves) handles.push_back(curve.get());
  const times_in t(times);
  const quaternions_out<Real> q(q_out);
  const vectors_out<Real> omega(omega_out), alpha(alpha_out);
  for (const std::size_t count : {q.count(), omega.count(), alpha.count()}) {
    detail::same(t.count() * curves.size(), count, true);
  }
  std::size_t bad = no_index;
  detail::check(detail::c_sample_many<Real>()(handles.data(), handles.size(), static_cast<std::int32_t>(in), t.data(),
                                              t.count(), static_cast<std::int32_t>(order),
                                              q.count() ? q.data() : nullptr, omega.count() ? omega.data() : nullptr,
                                              alpha.count() ? alpha.data() : nullptr, &bad),
                bad);
}

/** Times at even distances from first to last, both exact, s. */
inline std::vector<double> even_times(double first, double last, std::size_t count) {
  std::vector<double> times(count);
  detail::check(qtraj_even_times(first, last, count, times.data()));
  return times;
}

// ---- Vector curves and poses ----

/** A curve of vectors of dim numbers: qtraj_vector_curve. Immutable; copies share it. */
class vector_curve {
 public:
  /** Values of dim numbers a key, flat or in rows; first and second derivatives may be empty. */
  template <std::size_t Dim, class T, class V, class D = std::vector<double>, class S = std::vector<double>>
  static vector_curve of(const options& settings, const T& times, const V& values, const D& first = {},
                         const S& second = {}) {
    using Real = detail::real_of<V>;
    const keyed<Real, Dim> keys(times, values, first, second);
    vector_curve made;
    std::size_t bad = no_index;
    qtraj_vector_curve* handle = nullptr;
    detail::check(detail::c_vector_create<Real>()(settings.get(), keys.t.data(), keys.values.data(), keys.first,
                                                  keys.second, keys.values.count(), Dim, &handle, &bad),
                  bad);
    made.handle_.reset(handle, qtraj_vector_destroy);
    return made;
  }
  template <std::size_t Dim, class T, class V, class D = std::vector<double>, class S = std::vector<double>>
  static vector_curve of(vector_method method, const T& times, const V& values, const D& first = {},
                         const S& second = {}) {
    return of<Dim>(options(method), times, values, first, second);
  }
  /** Takes over a curve of the C interface, which it will destroy. */
  explicit vector_curve(qtraj_vector_curve* owned) : handle_(owned, qtraj_vector_destroy) {}

  static std::size_t bytes(const options& settings, std::size_t count, std::size_t dim) {
    std::size_t bytes = 0;
    detail::check(qtraj_vector_init_size(settings.get(), count, dim, &bytes));
    return bytes;
  }
  /** In memory of the caller, aligned to 8 bytes, which must outlive it and all its copies. */
  template <std::size_t Dim, class T, class V, class D = std::vector<double>, class S = std::vector<double>>
  static vector_curve in_memory(void* memory, std::size_t bytes, const options& settings, const T& times,
                                const V& values, const D& first = {}, const S& second = {}) {
    using Real = detail::real_of<V>;
    const keyed<Real, Dim> keys(times, values, first, second);
    std::size_t bad = no_index;
    qtraj_vector_curve* handle = nullptr;
    detail::check(detail::c_vector_init<Real>()(memory, bytes, settings.get(), keys.t.data(), keys.values.data(),
                                                keys.first, keys.second, keys.values.count(), Dim, &handle, &bad),
                  bad);
    vector_curve made;
    made.handle_.reset(handle, [](qtraj_vector_curve*) {});
    return made;
  }

  /** Values and derivatives, each of dim numbers a row; any output may be empty, but not all. */
  template <class T, class V, class D, class S>
  void sample(const T& times, V&& value_out, D&& first_out, S&& second_out) const {
    using Real = detail::real_of<V>;
    const times_in t(times);
    const rows<Real, 1> value(value_out), first(first_out), second(second_out);
    for (const std::size_t count : {value.count(), first.count(), second.count()}) {
      detail::same(t.count() * dim(), count, true);
    }
    std::size_t bad = no_index;
    detail::check(
        detail::c_vector_sample<Real>()(get(), t.data(), t.count(), some(value), some(first), some(second), &bad), bad);
  }
  template <class Real = double, class T>
  std::vector<Real> sample(const T& times) const {
    std::vector<Real> value(times_in(times).count() * dim()), none;
    sample(times, value, none, none);
    return value;
  }
  template <class V, class D, class S>
  void sample_uniform(double start, double step, std::size_t count, V&& value_out, D&& first_out,
                      S&& second_out) const {
    using Real = detail::real_of<V>;
    const rows<Real, 1> value(value_out), first(first_out), second(second_out);
    for (const std::size_t numbers : {value.count(), first.count(), second.count()}) {
      detail::same(count * dim(), numbers, true);
    }
    std::size_t bad = no_index;
    detail::check(detail::c_vector_sample_uniform<Real>()(get(), start, step, count, some(value), some(first),
                                                          some(second), &bad),
                  bad);
  }
  std::size_t uniform_count(double start, double step) const {
    std::size_t count = 0;
    detail::check(qtraj_vector_uniform_count(get(), start, step, &count));
    return count;
  }
  template <class Real = double>
  std::vector<Real> at(double time, std::size_t* last = nullptr) const {
    std::vector<Real> value(dim());
    detail::check(detail::c_vector_sample_at<Real>()(get(), time, last, value.data(), nullptr, nullptr));
    return value;
  }
  std::vector<double> operator()(double time) const { return at<double>(time); }

  vector_method method() const noexcept { return static_cast<vector_method>(qtraj_vector_method(get())); }
  std::size_t key_count() const noexcept { return qtraj_vector_key_count(get()); }
  std::size_t dim() const noexcept { return qtraj_vector_dim(get()); }
  double start_time() const noexcept { return qtraj_vector_start_time(get()); }
  double end_time() const noexcept { return qtraj_vector_end_time(get()); }
  std::vector<double> times() const {
    std::vector<double> times(key_count());
    detail::check(qtraj_vector_keys(get(), times.data(), nullptr));
    return times;
  }
  std::vector<double> keys() const {
    std::vector<double> values(key_count() * dim());
    detail::check(qtraj_vector_keys(get(), nullptr, values.data()));
    return values;
  }
  const qtraj_vector_curve* get() const noexcept { return handle_.get(); }

 private:
  vector_curve() = default;

  // Keys with derivatives, which may be empty: of as many rows, or of two at ends that are GIVEN.
  template <class Real, std::size_t Dim>
  struct keyed {
    template <class T, class V, class D, class S>
    keyed(const T& times, const V& values_at, const D& first_at, const S& second_at) : t(times), values(values_at) {
      detail::same(values.count(), t.count());
      first = derivative(first_at);
      second = derivative(second_at);
    }
    template <class D>
    const Real* derivative(const D& array) {
      if (std::size(array) == 0) return nullptr;
      if constexpr (std::is_same_v<detail::real_of<D>, Real>) {
        const rows<const Real, Dim> d(array);
        if (d.count() != 2) detail::same(values.count(), d.count());
        return d.data();
      } else {
        throw error(QTRAJ_E_VALUE);
      }
    }
    times_in t;
    rows<const Real, Dim> values;
    const Real *first = nullptr, *second = nullptr;
  };
  template <class Real>
  static Real* some(rows<Real, 1> array) {
    return array.count() ? array.data() : nullptr;
  }
  std::shared_ptr<qtraj_vector_curve> handle_;
};

/** A pose with its rates; positions of three numbers. */
template <class Real>
struct basic_pose {
  basic_quaternion<Real> q;
  basic_vector<Real> omega, alpha, position, velocity, acceleration;
};
using pose = basic_pose<double>;

/** The pose at one time; positions must have three numbers. */
template <class Real = double>
basic_pose<Real> pose_at(const trajectory& turning, const vector_curve& moving, frame in, double time,
                         std::size_t* last = nullptr) {
  if (moving.dim() != 3) throw error(QTRAJ_E_COUNT);
  basic_pose<Real> p;
  detail::check(detail::c_sample_pose_at<Real>()(turning.get(), moving.get(), static_cast<std::int32_t>(in), time, last,
                                                 p.q.data(), p.omega.data(), p.alpha.data(), p.position.data(),
                                                 p.velocity.data(), p.acceleration.data()));
  return p;
}
/** Poses at many times, with their rates. */
template <class Real = double, class T>
std::vector<basic_pose<Real>> sample_poses(const trajectory& turning, const vector_curve& moving, frame in,
                                           const T& times) {
  if (moving.dim() != 3) throw error(QTRAJ_E_COUNT);
  const times_in t(times);
  std::vector<basic_quaternion<Real>> q(t.count());
  std::vector<basic_vector<Real>> parts[5];
  for (auto& part : parts) part.resize(t.count());
  std::vector<basic_pose<Real>> poses(t.count());
  if (t.count() == 0) return poses;
  std::size_t bad = no_index;
  detail::check(detail::c_sample_poses<Real>()(turning.get(), moving.get(), static_cast<std::int32_t>(in), t.data(),
                                               t.count(), q[0].data(), parts[0][0].data(), parts[1][0].data(),
                                               parts[2][0].data(), parts[3][0].data(), parts[4][0].data(), &bad),
                bad);
  for (std::size_t i = 0; i < t.count(); ++i) {
    poses[i] = {q[i], parts[0][i], parts[1][i], parts[2][i], parts[3][i], parts[4][i]};
  }
  return poses;
}

// ---- Many curves, each of a series of keys ----

/** Results of a batch: rows of all series one after the other, and the status of each series. */
template <class Real>
struct basic_batch {
  std::vector<basic_quaternion<Real>> q;
  std::vector<basic_vector<Real>> omega, alpha;  // empty without rates
  std::vector<std::int32_t> status;              // qtraj_status of each series; a series at fault has NaN
};

namespace detail {

// Offsets [series + 1] that end within so many rows.
inline std::size_t series_of(const std::vector<std::int64_t>& offsets, std::size_t rows) {
  if (offsets.empty() || offsets.back() < 0 || static_cast<std::size_t>(offsets.back()) > rows)
    throw error(QTRAJ_E_COUNT);
  return offsets.size() - 1;
}
// A fault of a series is told by its status.
inline void check_batch(qtraj_status status, const std::size_t& index) {
  if (status != QTRAJ_OK && (index == no_index || status == QTRAJ_E_COUNT)) throw error(status, index);
}

}  // namespace detail

/** Samples many curves; sample_times may be empty: of each series evenly from its first to its last key. Throws for
 * what is wrong with the call; a series at fault has its status. */
template <class T, class Q>
basic_batch<detail::real_of<Q>> batch_sample(const options& settings, const std::vector<std::int64_t>& key_offsets,
                                             const T& key_times, const Q& key_q_wb,
                                             const std::vector<std::int64_t>& sample_offsets,
                                             const std::vector<double>& sample_times = {}) {
  using Real = detail::real_of<Q>;
  const times_in t(key_times);
  const quaternions_in<Real> q(key_q_wb);
  detail::same(q.count(), t.count());
  const std::size_t series = detail::series_of(key_offsets, q.count());
  detail::same(key_offsets.size(), sample_offsets.size());
  const std::size_t count = static_cast<std::size_t>(sample_offsets.back());
  detail::same(count, sample_times.size(), true);
  basic_batch<Real> batch{std::vector<basic_quaternion<Real>>(count), {}, {}, std::vector<std::int32_t>(series)};
  std::size_t bad = no_index;
  detail::check_batch(
      detail::c_batch_sample<Real>()(settings.get(), series, key_offsets.data(), t.data(), q.data(),
                                     sample_offsets.data(), sample_times.empty() ? nullptr : sample_times.data(),
                                     nullptr, 0, count ? batch.q[0].data() : nullptr, batch.status.data(), &bad),
      bad);
  return batch;
}
/** The same with rates: given at the keys, where the method takes them, and in the samples. */
template <class T, class Q, class W, class A>
basic_batch<detail::real_of<Q>> batch_sample_rates(const options& settings, frame in,
                                                   const std::vector<std::int64_t>& key_offsets, const T& key_times,
                                                   const Q& key_q_wb, const W& key_omega, const A& key_alpha,
                                                   const std::vector<std::int64_t>& sample_offsets,
                                                   const std::vector<double>& sample_times = {}) {
  using Real = detail::real_of<Q>;
  const times_in t(key_times);
  const quaternions_in<Real> q(key_q_wb);
  const vectors_in<Real> omega(key_omega), alpha(key_alpha);
  detail::same(q.count(), t.count());
  detail::same(q.count(), omega.count(), true);
  detail::same(q.count(), alpha.count(), true);
  const std::size_t series = detail::series_of(key_offsets, q.count());
  detail::same(key_offsets.size(), sample_offsets.size());
  const std::size_t count = static_cast<std::size_t>(sample_offsets.back());
  detail::same(count, sample_times.size(), true);
  basic_batch<Real> batch{std::vector<basic_quaternion<Real>>(count), std::vector<basic_vector<Real>>(count),
                          std::vector<basic_vector<Real>>(count), std::vector<std::int32_t>(series)};
  std::size_t bad = no_index;
  detail::check_batch(
      detail::c_batch_sample_rates<Real>()(
          settings.get(), static_cast<std::int32_t>(in), series, key_offsets.data(), t.data(), q.data(),
          omega.count() ? omega.data() : nullptr, alpha.count() ? alpha.data() : nullptr, sample_offsets.data(),
          sample_times.empty() ? nullptr : sample_times.data(), nullptr, 0, count ? batch.q[0].data() : nullptr,
          count ? batch.omega[0].data() : nullptr, count ? batch.alpha[0].data() : nullptr, batch.status.data(), &bad),
      bad);
  return batch;
}
/** Offsets of samples at a fixed step, s: one for all series, or one for each. A series at fault has none. */
inline std::vector<std::int64_t> batch_step_offsets(const std::vector<std::int64_t>& key_offsets, times_in key_times,
                                                    times_in step) {
  const std::size_t series = detail::series_of(key_offsets, key_times.count());
  std::vector<std::int64_t> offsets(series + 1);
  std::size_t bad = no_index;
  detail::check_batch(qtraj_batch_step_offsets(series, key_offsets.data(), key_times.data(), step.data(), step.count(),
                                               offsets.data(), nullptr, &bad),
                      bad);
  return offsets;
}
/** Times at a fixed step from the first key of each series on, at the rows of sample_offsets. */
inline std::vector<double> batch_times(const std::vector<std::int64_t>& key_offsets, times_in key_times, times_in step,
                                       const std::vector<std::int64_t>& sample_offsets) {
  const std::size_t series = detail::series_of(key_offsets, key_times.count());
  detail::same(key_offsets.size(), sample_offsets.size());
  if (sample_offsets.back() < 0) throw error(QTRAJ_E_COUNT);
  std::vector<double> times(static_cast<std::size_t>(sample_offsets.back()));
  std::size_t bad = no_index;
  detail::check_batch(qtraj_batch_times(series, key_offsets.data(), key_times.data(), step.data(), step.count(),
                                        sample_offsets.data(), times.data(), nullptr, &bad),
                      bad);
  return times;
}
/** Eigen means of groups; weights may be empty. A group at fault is NaN. */
template <class Q>
std::vector<basic_quaternion<detail::real_of<Q>>> batch_mean_eigen(
    const std::vector<std::int64_t>& offsets, const Q& samples, const std::vector<detail::real_of<Q>>& weights = {}) {
  using Real = detail::real_of<Q>;
  const quaternions_in<Real> q(samples);
  const std::size_t groups = detail::series_of(offsets, q.count());
  detail::same(q.count(), weights.size(), true);
  std::vector<basic_quaternion<Real>> means(groups);
  if (groups == 0) return means;
  std::size_t bad = no_index;
  detail::check_batch(
      detail::c_batch_mean_eigen<Real>()(groups, offsets.data(), q.data(), weights.empty() ? nullptr : weights.data(),
                                         means[0].data(), nullptr, nullptr, &bad),
      bad);
  return means;
}

// ---- Functions over rows: outputs of the caller, or a vector of new rows ----

namespace detail {

// How many rows a call has whose inputs have one row for all, or as many.
template <class... Counts>
std::size_t longest(Counts... counts) {
  std::size_t most = 0;
  bool none = false;
  for (const std::size_t count : {static_cast<std::size_t>(counts)...}) {
    most = count > most ? count : most;
    none = none || count == 0;
  }
  return none ? 0 : most;
}

// A number, or a row of several.
template <class Real, std::size_t Width>
using row_of = std::conditional_t<Width == 1, Real, std::array<Real, Width>>;

// A function of one array: rows of In numbers to rows of Out.
template <class Real, std::size_t In, std::size_t Out, class F, class X, class Y>
void one(F call, const X& from, Y&& to) {
  const rows<const Real, In> x(from);
  const rows<Real, Out> y(to);
  same(x.count(), y.count());
  std::size_t bad = no_index;
  check(call(x.data(), x.count(), y.data(), &bad), bad);
}
template <class Real, std::size_t In, std::size_t Out, class F, class X>
std::vector<row_of<Real, Out>> one(F call, const X& from) {
  std::vector<row_of<Real, Out>> to(rows<const Real, In>(from).count());
  one<Real, In, Out>(call, from, to);
  return to;
}
// A function of two arrays, each of one row for all or one for each.
template <class Real, std::size_t A, std::size_t B, std::size_t Out, class F, class X, class Y, class Z>
void two(F call, const X& a, const Y& b, Z&& to) {
  const rows<const Real, A> x(a);
  const rows<const Real, B> y(b);
  const rows<Real, Out> z(to);
  std::size_t bad = no_index;
  check(call(x.data(), x.count(), y.data(), y.count(), z.count(), z.data(), &bad), bad);
}
template <class Real, std::size_t A, std::size_t B, std::size_t Out, class F, class X, class Y>
std::vector<row_of<Real, Out>> two(F call, const X& a, const Y& b) {
  std::vector<row_of<Real, Out>> to(longest(rows<const Real, A>(a).count(), rows<const Real, B>(b).count()));
  two<Real, A, B, Out>(call, a, b, to);
  return to;
}
// Orders of components have no row that could be at fault.
template <class Real, class F>
auto without_index(F call) {
  return [call](const Real* from, std::size_t count, Real* to, std::size_t*) { return call(from, count, to); };
}

}  // namespace detail

/** Hamilton products a b, of quaternions as they are. */
template <class A, class B>
auto multiply(const A& a, const B& b) {
  return detail::two<detail::real_of<A>, 4, 4, 4>(detail::c_multiply<detail::real_of<A>>(), a, b);
}
template <class A, class B, class Out>
void multiply(const A& a, const B& b, Out&& out) {
  detail::two<detail::real_of<A>, 4, 4, 4>(detail::c_multiply<detail::real_of<A>>(), a, b, out);
}
/** Dot products, of double. */
template <class A, class B>
auto dot(const A& a, const B& b) {
  return detail::two<double, 4, 4, 1>(qtraj_dot, a, b);
}
template <class A, class B, class Out>
void dot(const A& a, const B& b, Out&& out) {
  detail::two<double, 4, 4, 1>(qtraj_dot, a, b, out);
}
/** World vectors of body vectors. */
template <class A, class B>
auto rotate(const A& a, const B& b) {
  return detail::two<detail::real_of<A>, 4, 3, 3>(detail::c_rotate<detail::real_of<A>>(), a, b);
}
template <class A, class B, class Out>
void rotate(const A& a, const B& b, Out&& out) {
  detail::two<detail::real_of<A>, 4, 3, 3>(detail::c_rotate<detail::real_of<A>>(), a, b, out);
}
/** Angles in four dimensions, rad, where signs count. */
template <class A, class B>
auto distance(const A& a, const B& b) {
  return detail::two<detail::real_of<A>, 4, 4, 1>(detail::c_distance<detail::real_of<A>>(), a, b);
}
template <class A, class B, class Out>
void distance(const A& a, const B& b, Out&& out) {
  detail::two<detail::real_of<A>, 4, 4, 1>(detail::c_distance<detail::real_of<A>>(), a, b, out);
}
/** Angles by which the body turns, rad, of double. */
template <class A, class B>
auto rotation_angle(const A& a, const B& b) {
  return detail::two<double, 4, 4, 1>(qtraj_rotation_angle, a, b);
}
template <class A, class B, class Out>
void rotation_angle(const A& a, const B& b, Out&& out) {
  detail::two<double, 4, 4, 1>(qtraj_rotation_angle, a, b, out);
}
/** Conjugates, of double. */
template <class In>
auto conjugate(const In& in) {
  return detail::one<double, 4, 4>(qtraj_conjugate, in);
}
template <class In, class Out>
void conjugate(const In& in, Out&& out) {
  detail::one<double, 4, 4>(qtraj_conjugate, in, out);
}
/** Inverses, of double. */
template <class In>
auto inverse(const In& in) {
  return detail::one<double, 4, 4>(qtraj_inverse, in);
}
template <class In, class Out>
void inverse(const In& in, Out&& out) {
  detail::one<double, 4, 4>(qtraj_inverse, in, out);
}
/** Norms, of double. */
template <class In>
auto norm(const In& in) {
  return detail::one<double, 4, 1>(qtraj_norm, in);
}
template <class In, class Out>
void norm(const In& in, Out&& out) {
  detail::one<double, 4, 1>(qtraj_norm, in, out);
}
/** Exponentials of half-angle vectors, rad. */
template <class In>
auto exp(const In& in) {
  return detail::one<detail::real_of<In>, 3, 4>(detail::c_exp<detail::real_of<In>>(), in);
}
template <class In, class Out>
void exp(const In& in, Out&& out) {
  detail::one<detail::real_of<In>, 3, 4>(detail::c_exp<detail::real_of<In>>(), in, out);
}
/** Logarithms: half-angle vectors, rad. */
template <class In>
auto log(const In& in) {
  return detail::one<detail::real_of<In>, 4, 3>(detail::c_log<detail::real_of<In>>(), in);
}
template <class In, class Out>
void log(const In& in, Out&& out) {
  detail::one<detail::real_of<In>, 4, 3>(detail::c_log<detail::real_of<In>>(), in, out);
}
/** Rotation vectors, rad: the shorter way. */
template <class In>
auto rotation_vector_from_q(const In& in) {
  return detail::one<detail::real_of<In>, 4, 3>(detail::c_rotation_vector_from_q<detail::real_of<In>>(), in);
}
template <class In, class Out>
void rotation_vector_from_q(const In& in, Out&& out) {
  detail::one<detail::real_of<In>, 4, 3>(detail::c_rotation_vector_from_q<detail::real_of<In>>(), in, out);
}
/** Quaternions of rotation vectors, rad. */
template <class In>
auto q_from_rotation_vector(const In& in) {
  return detail::one<detail::real_of<In>, 3, 4>(detail::c_q_from_rotation_vector<detail::real_of<In>>(), in);
}
template <class In, class Out>
void q_from_rotation_vector(const In& in, Out&& out) {
  detail::one<detail::real_of<In>, 3, 4>(detail::c_q_from_rotation_vector<detail::real_of<In>>(), in, out);
}
/** Matrices, row by row: v_world = matrix v_body. */
template <class In>
auto matrix_from_q(const In& in) {
  return detail::one<detail::real_of<In>, 4, 9>(detail::c_matrix_from_q<detail::real_of<In>>(), in);
}
template <class In, class Out>
void matrix_from_q(const In& in, Out&& out) {
  detail::one<detail::real_of<In>, 4, 9>(detail::c_matrix_from_q<detail::real_of<In>>(), in, out);
}
/** Quaternions of norm 1, signs kept. */
template <class In>
auto normalize(const In& in) {
  return detail::one<detail::real_of<In>, 4, 4>(detail::c_normalize<detail::real_of<In>>(), in);
}
template <class In, class Out>
void normalize(const In& in, Out&& out) {
  detail::one<detail::real_of<In>, 4, 4>(detail::c_normalize<detail::real_of<In>>(), in, out);
}
/** w x y z of x y z w. */
template <class In>
auto wxyz_from_xyzw(const In& in) {
  return detail::one<detail::real_of<In>, 4, 4>(
      detail::without_index<detail::real_of<In>>(detail::c_wxyz_from_xyzw<detail::real_of<In>>()), in);
}
template <class In, class Out>
void wxyz_from_xyzw(const In& in, Out&& out) {
  detail::one<detail::real_of<In>, 4, 4>(
      detail::without_index<detail::real_of<In>>(detail::c_wxyz_from_xyzw<detail::real_of<In>>()), in, out);
}
/** x y z w of w x y z. */
template <class In>
auto xyzw_from_wxyz(const In& in) {
  return detail::one<detail::real_of<In>, 4, 4>(
      detail::without_index<detail::real_of<In>>(detail::c_xyzw_from_wxyz<detail::real_of<In>>()), in);
}
template <class In, class Out>
void xyzw_from_wxyz(const In& in, Out&& out) {
  detail::one<detail::real_of<In>, 4, 4>(
      detail::without_index<detail::real_of<In>>(detail::c_xyzw_from_wxyz<detail::real_of<In>>()), in, out);
}
/** Turns of q, times an exponent: one for all or one for each; of double. */
template <class Q, class E>
std::vector<quaternion> pow(const Q& q, const E& exponent) {
  const quaternions_in<double> x(q);
  const rows<const double, 1> e(exponent);
  std::vector<quaternion> out(x.count());
  if (out.empty()) return out;
  std::size_t bad = no_index;
  detail::check(qtraj_pow(x.data(), e.data(), e.count(), x.count(), out[0].data(), &bad), bad);
  return out;
}
/** Quaternions, w >= 0, of the rotations nearest to matrices that are no farther than the limit from one. */
template <class M>
std::vector<basic_quaternion<detail::real_of<M>>> q_from_matrix(const M& matrices, double limit = 1e-3) {
  using Real = detail::real_of<M>;
  const rows<const Real, 9> m(matrices);
  std::vector<basic_quaternion<Real>> out(m.count());
  if (out.empty()) return out;
  std::size_t bad = no_index;
  detail::check(detail::c_q_from_matrix<Real>()(m.data(), m.count(), limit, out[0].data(), nullptr, &bad), bad);
  return out;
}
/** dq/dt and its derivative, 1/s and 1/s^2, of rates; of double. */
template <class Q, class W, class A>
std::pair<std::vector<quaternion>, std::vector<quaternion>> derivatives_from_rates(frame in, const Q& q_wb,
                                                                                   const W& omega, const A& alpha) {
  const quaternions_in<double> q(q_wb);
  const vectors_in<double> w(omega), a(alpha);
  detail::same(q.count(), w.count());
  detail::same(q.count(), a.count());
  std::pair<std::vector<quaternion>, std::vector<quaternion>> out{std::vector<quaternion>(q.count()),
                                                                  std::vector<quaternion>(q.count())};
  if (q.count() == 0) return out;
  std::size_t bad = no_index;
  detail::check(qtraj_derivatives_from_rates(static_cast<std::int32_t>(in), q.data(), w.data(), a.data(), q.count(),
                                             out.first[0].data(), out.second[0].data(), &bad),
                bad);
  return out;
}
/** Rates, rad/s and rad/s^2, of dq/dt and its derivative; of double. */
template <class Q, class D, class S>
std::pair<std::vector<vector3>, std::vector<vector3>> rates_from_derivatives(frame in, const Q& q_wb, const D& dq,
                                                                             const S& ddq) {
  const quaternions_in<double> q(q_wb), d(dq), s(ddq);
  detail::same(q.count(), d.count());
  detail::same(q.count(), s.count());
  std::pair<std::vector<vector3>, std::vector<vector3>> out{std::vector<vector3>(q.count()),
                                                            std::vector<vector3>(q.count())};
  if (q.count() == 0) return out;
  std::size_t bad = no_index;
  detail::check(qtraj_rates_from_derivatives(static_cast<std::int32_t>(in), q.data(), d.data(), s.data(), q.count(),
                                             out.first[0].data(), out.second[0].data(), &bad),
                bad);
  return out;
}

// ---- Interpolation of pairs ----

/** One pair at a fraction, by value. */
template <class Real>
basic_quaternion<Real> slerp(const basic_quaternion<Real>& a, const basic_quaternion<Real>& b, Real fraction,
                             path way = path::shortest) {
  basic_quaternion<Real> q;
  std::size_t bad = no_index;
  detail::check(
      detail::c_slerp<Real>()(a.data(), b.data(), &fraction, 1, static_cast<std::int32_t>(way), q.data(), &bad), bad);
  return q;
}
/** Pairs and fractions, each one for all or one for each. */
template <class A, class B, class F>
std::vector<basic_quaternion<detail::real_of<A>>> slerp_pairs(const A& a, const B& b, const F& fraction,
                                                              path way = path::shortest) {
  using Real = detail::real_of<A>;
  const quaternions_in<Real> x(a), y(b);
  const rows<const Real, 1> f(fraction);
  std::vector<basic_quaternion<Real>> q(detail::longest(x.count(), y.count(), f.count()));
  if (q.empty()) return q;
  std::size_t bad = no_index;
  detail::check(detail::c_slerp_pairs<Real>()(x.data(), x.count(), y.data(), y.count(), f.data(), f.count(), q.size(),
                                              static_cast<std::int32_t>(way), q[0].data(), &bad),
                bad);
  return q;
}
/** Pairs that have times, at times, s, each one for all or one for each. */
template <class A, class B>
std::vector<basic_quaternion<detail::real_of<A>>> slerp_pairs_between(const A& a, times_in time_a, const B& b,
                                                                      times_in time_b, times_in times,
                                                                      path way = path::shortest) {
  using Real = detail::real_of<A>;
  const quaternions_in<Real> x(a), y(b);
  detail::same(x.count(), time_a.count());
  detail::same(y.count(), time_b.count());
  std::vector<basic_quaternion<Real>> q(detail::longest(x.count(), y.count(), times.count()));
  if (q.empty()) return q;
  std::size_t bad = no_index;
  detail::check(detail::c_slerp_pairs_between<Real>()(x.data(), time_a.data(), x.count(), y.data(), time_b.data(),
                                                      y.count(), times.data(), times.count(), q.size(),
                                                      static_cast<std::int32_t>(way), q[0].data(), &bad),
                bad);
  return q;
}
/** One pair at a fraction, by value. */
template <class Real>
basic_quaternion<Real> nlerp(const basic_quaternion<Real>& a, const basic_quaternion<Real>& b, Real fraction,
                             path way = path::shortest) {
  basic_quaternion<Real> q;
  std::size_t bad = no_index;
  detail::check(
      detail::c_nlerp<Real>()(a.data(), b.data(), &fraction, 1, static_cast<std::int32_t>(way), q.data(), &bad), bad);
  return q;
}
/** Pairs and fractions, each one for all or one for each. */
template <class A, class B, class F>
std::vector<basic_quaternion<detail::real_of<A>>> nlerp_pairs(const A& a, const B& b, const F& fraction,
                                                              path way = path::shortest) {
  using Real = detail::real_of<A>;
  const quaternions_in<Real> x(a), y(b);
  const rows<const Real, 1> f(fraction);
  std::vector<basic_quaternion<Real>> q(detail::longest(x.count(), y.count(), f.count()));
  if (q.empty()) return q;
  std::size_t bad = no_index;
  detail::check(detail::c_nlerp_pairs<Real>()(x.data(), x.count(), y.data(), y.count(), f.data(), f.count(), q.size(),
                                              static_cast<std::int32_t>(way), q[0].data(), &bad),
                bad);
  return q;
}
/** Pairs that have times, at times, s, each one for all or one for each. */
template <class A, class B>
std::vector<basic_quaternion<detail::real_of<A>>> nlerp_pairs_between(const A& a, times_in time_a, const B& b,
                                                                      times_in time_b, times_in times,
                                                                      path way = path::shortest) {
  using Real = detail::real_of<A>;
  const quaternions_in<Real> x(a), y(b);
  detail::same(x.count(), time_a.count());
  detail::same(y.count(), time_b.count());
  std::vector<basic_quaternion<Real>> q(detail::longest(x.count(), y.count(), times.count()));
  if (q.empty()) return q;
  std::size_t bad = no_index;
  detail::check(detail::c_nlerp_pairs_between<Real>()(x.data(), time_a.data(), x.count(), y.data(), time_b.data(),
                                                      y.count(), times.data(), times.count(), q.size(),
                                                      static_cast<std::int32_t>(way), q[0].data(), &bad),
                bad);
  return q;
}
/** One pair that has times, at many times, s; of double. */
inline std::vector<quaternion> slerp_between(const quaternion& a, double time_a, const quaternion& b, double time_b,
                                             times_in times, path way = path::shortest) {
  std::vector<quaternion> q(times.count());
  if (q.empty()) return q;
  std::size_t bad = no_index;
  detail::check(qtraj_slerp_between(a.data(), time_a, b.data(), time_b, times.data(), times.count(),
                                    static_cast<std::int32_t>(way), q[0].data(), &bad),
                bad);
  return q;
}
/** Poses on screw motions, each input one for all or one for each: orientations and positions. */
template <class QA, class PA, class QB, class PB, class F>
std::pair<std::vector<basic_quaternion<detail::real_of<QA>>>, std::vector<basic_vector<detail::real_of<QA>>>>
screw_pairs(const QA& q_a, const PA& p_a, const QB& q_b, const PB& p_b, const F& fraction) {
  using Real = detail::real_of<QA>;
  const quaternions_in<Real> qa(q_a), qb(q_b);
  const vectors_in<Real> pa(p_a), pb(p_b);
  const rows<const Real, 1> f(fraction);
  detail::same(qa.count(), pa.count());
  detail::same(qb.count(), pb.count());
  const std::size_t count = detail::longest(qa.count(), qb.count(), f.count());
  std::pair<std::vector<basic_quaternion<Real>>, std::vector<basic_vector<Real>>> out{
      std::vector<basic_quaternion<Real>>(count), std::vector<basic_vector<Real>>(count)};
  if (count == 0) return out;
  std::size_t bad = no_index;
  detail::check(
      detail::c_screw_pairs<Real>()(qa.data(), pa.data(), qa.count(), qb.data(), pb.data(), qb.count(), f.data(),
                                    f.count(), count, out.first[0].data(), out.second[0].data(), &bad),
      bad);
  return out;
}
/** Inner controls a and b of SQUAD for keys whose signs are continuous; times may be empty: evenly spaced. */
inline std::pair<std::vector<quaternion>, std::vector<quaternion>> squad_controls(times_in times,
                                                                                  quaternions_in<double> q_wb) {
  detail::same(q_wb.count(), times.count(), true);
  std::pair<std::vector<quaternion>, std::vector<quaternion>> out{std::vector<quaternion>(q_wb.count()),
                                                                  std::vector<quaternion>(q_wb.count())};
  if (q_wb.count() == 0) return out;
  std::size_t bad = no_index;
  detail::check(qtraj_squad_controls(times.count() ? times.data() : nullptr, q_wb.data(), q_wb.count(),
                                     out.first[0].data(), out.second[0].data(), &bad),
                bad);
  return out;
}
/** SQUAD from q0 to q1 with inner controls a and b, at fractions. */
inline std::vector<quaternion> squad_segment(const quaternion& q0, const quaternion& q1, const quaternion& a,
                                             const quaternion& b, rows<const double, 1> fraction) {
  std::vector<quaternion> q(fraction.count());
  if (q.empty()) return q;
  std::size_t bad = no_index;
  detail::check(qtraj_squad_segment(q0.data(), q1.data(), a.data(), b.data(), fraction.data(), fraction.count(),
                                    q[0].data(), &bad),
                bad);
  return q;
}

// ---- Keys and tables ----

/** The status of each key, and what is suspicious in the recording. */
struct key_check {
  std::vector<std::int32_t> status;
  qtraj_key_report report;
};
/** All faults of a recording at once; keys at fault do not throw. */
template <class T, class Q>
key_check check_keys(const T& times, const Q& q_wb) {
  using Real = detail::real_of<Q>;
  const times_in t(times);
  const quaternions_in<Real> q(q_wb);
  detail::same(q.count(), t.count());
  key_check found{std::vector<std::int32_t>(q.count()), {}};
  const qtraj_status status =
      detail::c_check_keys<Real>()(t.data(), q.data(), q.count(), found.status.data(), &found.report, nullptr);
  if (class_of(status) != status_class::done && class_of(status) != status_class::data) throw error(status);
  return found;
}
/** Seconds of nanosecond stamps, since the origin. */
inline std::vector<double> seconds_from_ns(rows<const std::int64_t, 1> ns, std::int64_t origin) {
  std::vector<double> seconds(ns.count());
  detail::check(qtraj_seconds_from_ns(ns.data(), ns.count(), origin, seconds.data()));
  return seconds;
}
/** Makes the signs of keys continuous, in place: series of one length one after the other. Returns how many changed. */
template <class Q>
std::size_t make_continuous(Q&& keys, std::size_t series = 1) {
  using Real = detail::real_of<Q>;
  const quaternions_out<Real> q(keys);
  if (series == 0 || q.count() % series != 0) throw error(QTRAJ_E_COUNT);
  std::size_t flips = 0, bad = no_index;
  detail::check(detail::c_make_continuous<Real>()(q.data(), series, q.count() / series, q.data(), &flips, &bad), bad);
  return flips;
}
/** The same where keys of a series stand so many rows apart, and series so many. */
template <class Q>
std::size_t make_continuous(Q&& keys, std::size_t series, std::size_t series_stride, std::size_t length,
                            std::size_t key_stride) {
  using Real = detail::real_of<Q>;
  const quaternions_out<Real> q(keys);
  if (series != 0 && length != 0 && (series - 1) * series_stride + (length - 1) * key_stride >= q.count()) {
    throw error(QTRAJ_E_COUNT);
  }
  std::size_t flips = 0, bad = no_index;
  detail::check(detail::c_make_continuous_strided<Real>()(q.data(), series, series_stride, length, key_stride, q.data(),
                                                          &flips, &bad),
                bad);
  return flips;
}
/** Columns of equal length as rows, one number of each column beside the other. */
template <class Real>
std::vector<Real> rows_from_columns(const std::vector<std::vector<Real>>& columns) {
  const std::size_t count = columns.empty() ? 0 : columns.front().size();
  std::vector<const Real*> pointers;
  for (const auto& column : columns) {
    detail::same(count, column.size());
    pointers.push_back(column.data());
  }
  std::vector<Real> out(count * columns.size());
  detail::check(detail::c_rows_from_columns<Real>()(pointers.data(), columns.size(), count, out.data()));
  return out;
}
template <class Real>
std::vector<std::vector<Real>> columns_from_rows(const std::vector<Real>& table, std::size_t width) {
  if (width == 0 || table.size() % width != 0) throw error(QTRAJ_E_COUNT);
  std::vector<std::vector<Real>> columns(width, std::vector<Real>(table.size() / width));
  std::vector<Real*> pointers;
  for (auto& column : columns) pointers.push_back(column.data());
  detail::check(detail::c_columns_from_rows<Real>()(table.data(), width, table.size() / width, pointers.data()));
  return columns;
}

// ---- Means ----

/** Eigen mean; weights may be empty. Where the two best tie it throws AMBIGUOUS. */
template <class Q>
basic_quaternion<detail::real_of<Q>> mean_eigen(const Q& samples, const std::vector<detail::real_of<Q>>& weights = {},
                                                double* eigengap = nullptr) {
  using Real = detail::real_of<Q>;
  const quaternions_in<Real> q(samples);
  detail::same(q.count(), weights.size(), true);
  basic_quaternion<Real> mean;
  std::size_t bad = no_index;
  detail::check(detail::c_mean_eigen<Real>()(q.data(), weights.empty() ? nullptr : weights.data(), q.count(),
                                             mean.data(), eigengap, &bad),
                bad);
  return mean;
}
/** Karcher mean, proven to be the global one; else it throws AMBIGUOUS. */
template <class Q>
basic_quaternion<detail::real_of<Q>> mean_karcher(const Q& samples, const std::vector<detail::real_of<Q>>& weights = {},
                                                  double tolerance = 0, std::int32_t max_iterations = 64) {
  using Real = detail::real_of<Q>;
  const quaternions_in<Real> q(samples);
  detail::same(q.count(), weights.size(), true);
  basic_quaternion<Real> mean;
  std::size_t bad = no_index;
  detail::check(detail::c_mean_karcher<Real>()(q.data(), weights.empty() ? nullptr : weights.data(), q.count(),
                                               tolerance, max_iterations, mean.data(), nullptr, nullptr, &bad),
                bad);
  return mean;
}
/** Sums that means are made of; those of parts are added number by number. */
class moments {
 public:
  template <class Q>
  moments& add(const Q& samples, const std::vector<detail::real_of<Q>>& weights = {}) {
    using Real = detail::real_of<Q>;
    const quaternions_in<Real> q(samples);
    detail::same(q.count(), weights.size(), true);
    std::size_t bad = no_index;
    detail::check(detail::c_moments_add<Real>()(q.data(), weights.empty() ? nullptr : weights.data(), q.count(),
                                                sums.data(), &bad),
                  bad);
    return *this;
  }
  moments& operator+=(const moments& other) noexcept {
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += other.sums[i];
    return *this;
  }
  quaternion mean(double* eigengap = nullptr) const {
    quaternion q;
    detail::check(qtraj_mean_from_moments(sums.data(), q.data(), eigengap));
    return q;
  }
  std::array<double, 11> sums{};
};

// ---- Diagnostics of samples, and a spline ----

/** Mean rates between neighbours, rad/s, and the middles of their intervals, s. */
inline std::pair<std::vector<double>, std::vector<vector3>> estimate_omega(frame in, times_in times,
                                                                           quaternions_in<double> q_wb) {
  detail::same(q_wb.count(), times.count());
  if (q_wb.count() < 2) throw error(QTRAJ_E_TOO_FEW);
  std::pair<std::vector<double>, std::vector<vector3>> out{std::vector<double>(q_wb.count() - 1),
                                                           std::vector<vector3>(q_wb.count() - 1)};
  std::size_t bad = no_index;
  detail::check(qtraj_estimate_omega(static_cast<std::int32_t>(in), times.data(), q_wb.data(), q_wb.count(),
                                     out.first.data(), out.second[0].data(), &bad),
                bad);
  return out;
}
/** Sum that approximates the integral of |alpha|^2, rad^2/s^3. */
inline double estimate_energy(frame in, times_in times, quaternions_in<double> q_wb) {
  detail::same(q_wb.count(), times.count());
  double energy = 0;
  std::size_t bad = no_index;
  detail::check(
      qtraj_estimate_energy(static_cast<std::int32_t>(in), times.data(), q_wb.data(), q_wb.count(), &energy, &bad),
      bad);
  return energy;
}
/** By how much the estimated rate jumps at knots, rad/s. */
inline std::vector<vector3> estimate_jumps(frame in, times_in times, quaternions_in<double> q_wb, times_in knots) {
  detail::same(q_wb.count(), times.count());
  std::vector<vector3> jumps(knots.count());
  std::size_t bad = no_index;
  detail::check(qtraj_estimate_jumps(static_cast<std::int32_t>(in), times.data(), q_wb.data(), q_wb.count(),
                                     knots.data(), knots.count(), jumps.empty() ? nullptr : jumps[0].data(), &bad),
                bad);
  return jumps;
}
/** Angle of each key to the sample nearest in time, rad, and the index of that sample. */
inline std::pair<std::vector<double>, std::vector<std::size_t>> keyframe_errors(times_in key_times,
                                                                                quaternions_in<double> key_q,
                                                                                times_in times,
                                                                                quaternions_in<double> q_wb) {
  detail::same(key_q.count(), key_times.count());
  detail::same(q_wb.count(), times.count());
  std::pair<std::vector<double>, std::vector<std::size_t>> out{std::vector<double>(key_q.count()),
                                                               std::vector<std::size_t>(key_q.count())};
  std::size_t bad = no_index;
  detail::check(qtraj_keyframe_errors(key_times.data(), key_q.data(), key_q.count(), times.data(), q_wb.data(),
                                      q_wb.count(), out.first.data(), out.second.data(), &bad),
                bad);
  return out;
}
/** C2 cubic spline through y, of dim numbers a row, at queries. */
inline std::vector<double> cubic_spline(times_in x, rows<const double, 1> y, std::size_t dim, end start, end last,
                                        times_in queries) {
  if (y.count() != x.count() * dim) throw error(QTRAJ_E_COUNT);
  std::vector<double> out(queries.count() * dim);
  std::size_t bad = no_index;
  detail::check(qtraj_cubic_spline(x.data(), y.data(), x.count(), dim, static_cast<std::int32_t>(start),
                                   static_cast<std::int32_t>(last), queries.data(), queries.count(), out.data(), &bad),
                bad);
  return out;
}

// ---- Without exceptions ----

#ifdef __cpp_lib_expected
/** What a call gives, or its error: try_call([&] { return curve.sample(times); }). */
template <class F>
std::expected<std::invoke_result_t<F>, error> try_call(F&& call) {
  try {
    if constexpr (std::is_void_v<std::invoke_result_t<F>>) {
      std::forward<F>(call)();
      return {};
    } else {
      return std::forward<F>(call)();
    }
  } catch (const error& wrong) {
    return std::unexpected(wrong);
  }
}
/** A trajectory, or why there is none: arguments as of its constructors. */
template <class... Arguments>
std::expected<trajectory, error> try_trajectory(Arguments&&... arguments) {
  return try_call([&] { return trajectory(std::forward<Arguments>(arguments)...); });
}
#endif

}  // namespace qtraj
#endif
