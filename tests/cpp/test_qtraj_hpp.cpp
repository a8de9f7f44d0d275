// qtraj.hpp through every door: compiled as C++17, 20 and 23, by GCC and Clang, without Catch2, which some of them
// lack. Ends with status 0, or says which check failed.
#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <qtraj.hpp>
#include <thread>
#if __has_include(<span>) && __cplusplus >= 202002L
#include <span>
#endif

namespace {

int failures = 0;
#define CHECK(condition)                                                         \
  do {                                                                           \
    if (!(condition)) std::printf("%d: %s\n", __LINE__, #condition), ++failures; \
  } while (false)

template <class F>
qtraj_status status_of(F call, std::size_t* index = nullptr) {
  try {
    call();
  } catch (const qtraj::error& wrong) {
    if (index != nullptr) *index = wrong.index();
    return wrong.status();
  }
  return QTRAJ_OK;
}

using qtraj::frame;
using qtraj::method;
using qtraj::quaternion;
using qtraj::vector3;

const std::vector<double> times{0, 1, 3};
const std::vector<quaternion> keys{{1, 0, 0, 0}, {0.8, 0, 0, 0.6}, {0.6, 0, 0.8, 0}};
const std::vector<vector3> no_rates;
const std::vector<quaternion> no_rows;

double angle(const quaternion& a, const quaternion& b) { return qtraj::rotation_angle(a, b)[0]; }

void arrays() {
  const double flat[] = {1, 0, 0, 0, 0.8, 0, 0, 0.6, 0.6, 0, 0.8, 0};
  const double table[3][4] = {{1, 0, 0, 0}, {0.8, 0, 0, 0.6}, {0.6, 0, 0.8, 0}};
  Eigen::Matrix<double, 4, Eigen::Dynamic> columns(4, 3);
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> lines(3, 4);
  for (int i = 0; i < 3; ++i) {
    columns.col(i) = Eigen::Map<const Eigen::Vector4d>(table[i]);
    lines.row(i) = Eigen::Map<const Eigen::RowVector4d>(table[i]);
  }
  const Eigen::VectorXd knots = Eigen::Vector3d(0, 1, 3);
  const qtraj::trajectory curve(method::squad, times, keys);
  for (const qtraj::trajectory& other :
       {qtraj::trajectory(method::squad, std::array<double, 3>{0, 1, 3}, flat),
        qtraj::trajectory(method::squad, times, table), qtraj::trajectory(method::squad, knots, columns),
        qtraj::trajectory(method::squad, knots, lines)}) {
    CHECK(other(0.7) == curve(0.7));
  }
#ifdef __cpp_lib_span
  CHECK(qtraj::trajectory(method::squad, std::span<const double>(times), std::span<const quaternion>(keys))(0.7) ==
        curve(0.7));
#endif
  Eigen::Matrix<double, 4, 2> out;
  curve.sample(std::array<double, 2>{0.7, 1.2}, out);
  CHECK(out(0, 0) == curve(0.7)[0] && out(3, 1) == curve(1.2)[3]);
  // what lies otherwise does not convert: x y z w, columns for rows, const to write
  using in = qtraj::rows<const double, 4>;
  using to = qtraj::rows<double, 4>;
  static_assert(!std::is_constructible_v<in, std::vector<Eigen::Quaterniond>&>);
  static_assert(!std::is_constructible_v<in, std::vector<float>&> &&
                !std::is_constructible_v<in, std::vector<vector3>&>);
  static_assert(!std::is_constructible_v<to, const std::vector<double>&> && std::is_constructible_v<in, to>);
  CHECK(status_of([] { in(std::vector<double>(7)); }) == QTRAJ_E_COUNT);
}

void curves() {
  const qtraj::trajectory curve(method::rotation_spline, times, keys);
  CHECK(curve.method() == method::rotation_spline && curve.key_count() == 3);
  CHECK(curve.start_time() == 0 && curve.end_time() == 3 && curve.times() == times);
  for (int i = 0; i < 3; ++i) CHECK(angle(curve.keys()[i], keys[i]) < 1e-15);
  const qtraj::motion m = curve(0.5, frame::body);
  qtraj::cursor last;
  CHECK(m.q == curve(0.5) && curve(0.5, last) == m.q && curve(0.5, frame::body, last).omega == m.omega);
  const vector3 world = curve(0.5, frame::world).omega;
  CHECK(std::abs(qtraj::rotate(m.q, m.omega)[0][2] - world[2]) < 1e-15);
  CHECK(curve.sample(std::vector<double>{0.5})[0] == m.q && std::abs(curve.sample<float>(times)[1][0] - 0.8F) < 1e-6F);
  CHECK(curve.uniform_count(0, 0.5) == 7 && curve.sample_uniform(0, 0.5)[1] == m.q);
  std::vector<quaternion> q(3);
  std::vector<vector3> omega(3), alpha(3), none;
  curve.sample_rates(frame::body, std::array<double, 3>{0.5, 1, 2}, q, omega, alpha);
  CHECK(q[0] == m.q && omega[0] == m.omega && alpha[0] == m.alpha);
  curve.sample_rates(frame::body, times, std::vector<quaternion>(), omega, none);
  CHECK(curve.segment_times(3).size() == 5);
  const auto [peak, peak_time, peak_alpha, peak_alpha_time] = curve.peak_rates();
  CHECK(peak <= curve.rate_bounds().first && peak_time <= 3 && peak_alpha > 0 && peak_alpha_time <= 3);
  CHECK(curve.total_angle() > 1 && curve.energy() > 0 && curve.rate_mismatch().first < 1);
  CHECK(curve.jumps(frame::body).first.size() == 3 && curve.least_norm().first == 1 && curve.sign_flips() == 0);
  CHECK(curve.iterations() > 0 && curve.residual() < 1e-10 && curve.least_dot() > 0 &&
        curve.worst_norm_error() < 1e-15);
  const qtraj::trajectory nlerp(method::nlerp, times, keys);
  nlerp.sample_unnormalized(times, q, {}, {});
  CHECK(q[1] == keys[1] && nlerp.iterations() == 0);

  // copies share the curve, and outlive it
  qtraj::trajectory copy = curve;
  {
    const qtraj::trajectory inner(method::slerp, times, keys);
    copy = inner;
  }
  CHECK(copy.method() == method::slerp && std::abs(copy(1.0)[0] - 0.8) < 1e-15);
  std::thread([&] { CHECK(curve(0.5) == m.q); }).join();
}

void settings() {
  qtraj::options options(method::squad);
  const vector3 rate{0.1, 0, 0};
  options.ends(qtraj::end::given, qtraj::end::chord)
      .end_rates(frame::body, &rate, nullptr)
      .tangents(qtraj::tangent::rest);
  options.extrapolation(qtraj::extrapolate::hold, qtraj::extrapolate::error).longest_gap(2.5).closure(0.1).period(0);
  const qtraj::trajectory curve(options, times, keys);
  CHECK(std::abs(curve(0, frame::body).omega[0] - 0.1) < 1e-13 && angle(curve(-5), keys[0]) < 1e-15);
  CHECK(status_of([&] { curve(3.5); }) == QTRAJ_E_TIME_RANGE);
  CHECK(status_of([&] { options.turns(qtraj::turns::from_rates); }) == QTRAJ_E_SETTING);
  qtraj::options log_spline(method::log_spline);
  log_spline.reference(qtraj::reference::mean).reference(keys[1]);
  CHECK(angle(qtraj::trajectory(log_spline, times, keys)(1), keys[1]) < 1e-14);

  const std::vector<vector3> omega(3, vector3{0, 0, 1}), alpha(3, vector3{0, 0, 0});
  const qtraj::trajectory hermite(qtraj::options(method::hermite), frame::world, times, keys, omega, no_rates);
  CHECK(std::abs(hermite(1, frame::world).omega[2] - 1) < 1e-13);
  qtraj::options by_turns(method::slerp);
  by_turns.turns(qtraj::turns::given);
  const qtraj::trajectory wound(by_turns, frame::body, times, keys, no_rates, no_rates, {1, 0});
  CHECK(wound.total_angle() > 6);
  CHECK(status_of([&] { qtraj::trajectory(by_turns, frame::body, times, keys, no_rates, no_rates, {1}); }) ==
        QTRAJ_E_COUNT);
  const auto cubic =
      qtraj::trajectory::with_tangents(qtraj::options(method::quaternion_hermite), times, keys, keys, no_rows);
  CHECK(angle(cubic(1), keys[1]) < 1e-15);

  std::vector<double> memory(qtraj::trajectory::bytes(options, 3) / 8 + 1);
  const auto placed = qtraj::trajectory::in_memory(memory.data(), 8 * memory.size(), options, frame::body, times, keys,
                                                   no_rates, no_rates);
  CHECK(placed(0.7) == curve(0.7));
  const qtraj::options by_tangents(method::quaternion_hermite);
  std::vector<double> more(qtraj::trajectory::bytes(by_tangents, 3) / 8 + 1);
  const auto second =
      qtraj::trajectory::in_memory_with_tangents(more.data(), 8 * more.size(), by_tangents, times, keys, keys, no_rows);
  CHECK(second(0.7) == cubic(0.7));
  qtraj_trajectory* raw = nullptr;
  CHECK(qtraj_create(QTRAJ_SLERP, times.data(), keys[0].data(), 3, &raw, nullptr) == QTRAJ_OK);
  CHECK(qtraj::trajectory(raw).key_count() == 3);
}

void poses() {
  const std::vector<vector3> places{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}};
  const auto path = qtraj::vector_curve::of<3>(qtraj::vector_method::linear, times, places);
  CHECK(path(2)[1] == 1 && path.dim() == 3 && path.key_count() == 3 && path.method() == qtraj::vector_method::linear);
  CHECK(path.times() == times && path.keys()[7] == 2 && path.start_time() == 0 && path.end_time() == 3);
  CHECK(path.sample(times).size() == 9 && path.uniform_count(0, 1) == 4 && path.at<float>(2)[1] == 1);
  std::vector<double> value(12), none;
  path.sample_uniform(0, 1, 4, value, none, none);
  CHECK(value[7] == 1);
  const auto hermite = qtraj::vector_curve::of<3>(qtraj::vector_method::hermite, times, places, places);
  CHECK(std::abs(hermite(1)[0] - 1) < 1e-15);
  std::vector<double> memory(qtraj::vector_curve::bytes(qtraj::options(qtraj::vector_method::linear), 3, 3) / 8 + 1);
  const auto placed = qtraj::vector_curve::in_memory<3>(memory.data(), 8 * memory.size(),
                                                        qtraj::options(qtraj::vector_method::linear), times, places);
  CHECK(placed(2) == path(2));
  const qtraj::trajectory curve(method::slerp, times, keys);
  const auto pose = qtraj::pose_at(curve, path, frame::body, 2);
  CHECK(pose.position[1] == 1 && pose.velocity[1] == 1 && pose.q == curve(2));
  CHECK(qtraj::sample_poses(curve, path, frame::body, times)[1].position[0] == 1);
  std::vector<quaternion> q(6);
  std::vector<vector3> rates;
  qtraj::sample_many({curve, curve}, frame::body, times, qtraj::layout::time_first, q, rates, rates);
  CHECK(q[2] == q[3] && q[2] == curve(1));
}

void batches() {
  const std::vector<std::int64_t> offsets{0, 3, 6}, samples{0, 2, 4};
  const std::vector<double> both{0, 1, 3, 0, 1, 1};
  const std::vector<quaternion> rows{keys[0], keys[1], keys[2], keys[0], keys[1], keys[2]};
  const auto batch = qtraj::batch_sample(qtraj::options(method::slerp), offsets, both, rows, samples);
  CHECK(batch.status[0] == QTRAJ_OK && batch.status[1] == QTRAJ_E_TIME_ORDER && angle(batch.q[1], keys[2]) < 1e-15);
  CHECK(std::isnan(batch.q[2][0]) && batch.omega.empty());
  const auto rates = qtraj::batch_sample_rates(qtraj::options(method::slerp), frame::body, offsets, both, rows,
                                               no_rates, no_rates, samples);
  CHECK(rates.q[1] == batch.q[1] && rates.omega.size() == 4);
  const double step[] = {0.5};
  const auto at = qtraj::batch_step_offsets({0, 3}, times, step);
  CHECK(at[1] == 7 && qtraj::batch_times({0, 3}, times, step, at)[6] == 3);
  CHECK(qtraj::batch_mean_eigen({0, 1, 3}, keys)[0] == keys[0]);
  CHECK(status_of([&] {
          qtraj::batch_sample(qtraj::options(method::slerp), {0, 9}, both, rows, {0, 1});
        }) == QTRAJ_E_COUNT);
  CHECK(status_of([&] {
          qtraj::batch_sample(qtraj::options(method::slerp), {3, 0, 6}, both, rows, samples);
        }) == QTRAJ_E_COUNT);
}

void functions() {
  const quaternion a{1, 0, 0, 0}, b{0.6, 0, 0, 0.8};
  CHECK(std::abs(angle(qtraj::slerp(a, b, 0.5), a) - std::atan2(0.8, 0.6)) < 1e-15);
  CHECK(std::abs(qtraj::slerp(std::array<float, 4>{1, 0, 0, 0}, std::array<float, 4>{0, 0, 0, 1}, 0.5F)[3] -
                 std::sqrt(0.5F)) < 1e-6F);
  CHECK(qtraj::slerp_pairs(a, keys, std::vector<double>{1, 1, 1}).size() == 3 &&
        qtraj::nlerp_pairs(a, keys, std::array<double, 1>{1})[1] == keys[1]);
  CHECK(qtraj::nlerp(a, b, 1.0) == b && qtraj::slerp_between(a, 1, b, 3, std::array<double, 1>{3})[0] == b);
  const double t[] = {1}, u[] = {3}, v[] = {2};
  CHECK(qtraj::slerp_pairs_between(a, t, b, u, v)[0] == qtraj::slerp(a, b, 0.5));
  CHECK(angle(qtraj::nlerp_pairs_between(a, t, b, u, v)[0], qtraj::nlerp(a, b, 0.5)) < 1e-15);
  const vector3 p{1, 0, 0}, r{0, 1, 0};
  CHECK(qtraj::screw_pairs(a, p, b, r, std::array<double, 2>{0, 1}).second[1] == r);
  const auto controls = qtraj::squad_controls(times, keys);
  CHECK(
      angle(qtraj::squad_segment(keys[0], keys[1], controls.first[0], controls.second[1], std::array<double, 1>{1})[0],
            keys[1]) < 1e-15);

  CHECK(angle(qtraj::multiply(b, qtraj::conjugate(b))[0], a) < 1e-15 &&
        angle(qtraj::multiply(b, qtraj::inverse(b))[0], a) < 1e-15);
  CHECK(std::abs(qtraj::norm(keys)[2] - 1) < 1e-15 && std::abs(qtraj::dot(a, keys)[1] - 0.8) < 1e-15 &&
        qtraj::distance(a, a)[0] == 0);
  CHECK(angle(qtraj::exp(qtraj::log(b))[0], b) < 1e-15 &&
        angle(qtraj::q_from_rotation_vector(qtraj::rotation_vector_from_q(b))[0], b) < 1e-15);
  CHECK(angle(qtraj::q_from_matrix(qtraj::matrix_from_q(b))[0], b) < 1e-15 &&
        angle(qtraj::pow(b, std::array<double, 1>{1})[0], b) < 1e-15);
  CHECK(qtraj::wxyz_from_xyzw(qtraj::xyzw_from_wxyz(keys)) == keys &&
        std::abs(qtraj::normalize(quaternion{0, 3, 4, 0})[0][1] - 0.6) < 1e-15);
  std::vector<quaternion> out(3);
  qtraj::multiply(keys, a, out);
  CHECK(out == keys);
  const auto [dq, ddq] = qtraj::derivatives_from_rates(frame::body, b, p, r);
  CHECK(std::abs(qtraj::rates_from_derivatives(frame::body, b, dq, ddq).first[0][0] - 1) < 1e-15);

  std::size_t index = 0;
  std::vector<quaternion> faulty = keys;
  faulty[1] = {0, 0, 0, 0};
  CHECK(status_of([&] { qtraj::normalize(faulty, out); }, &index) == QTRAJ_E_ZERO_NORM && index == 1);
  CHECK(std::isnan(out[1][0]) && angle(out[2], keys[2]) < 1e-15);  // the other rows are there
  CHECK(qtraj::check_keys(times, faulty).report.faults == 1 && qtraj::check_keys(times, keys).status[1] == QTRAJ_OK);
  faulty = {keys[0], {-0.8, 0, 0, -0.6}};
  CHECK(qtraj::make_continuous(faulty) == 1 && faulty[1] == keys[1] && qtraj::make_continuous(faulty, 1, 1, 2, 1) == 0);
  CHECK(qtraj::seconds_from_ns(std::vector<std::int64_t>{5, 1000000005}, 5)[1] == 1);
  CHECK(qtraj::columns_from_rows(qtraj::rows_from_columns<double>({{1, 2}, {3, 4}}), 2)[1][0] == 3);

  CHECK(angle(qtraj::mean_eigen(std::vector<quaternion>{b, b}), b) < 1e-15 &&
        angle(qtraj::mean_karcher(keys, {1, 0, 0}), a) < 1e-14);
  qtraj::moments whole, part;
  part.add(keys);
  whole += part;
  CHECK(angle(whole.mean(), qtraj::mean_eigen(keys)) < 1e-14);
  CHECK(status_of([] { qtraj::mean_eigen(std::vector<quaternion>{{1, 0, 0, 0}, {0, 1, 0, 0}}); }) == QTRAJ_E_AMBIGUOUS);
  CHECK(qtraj::estimate_omega(frame::body, times, keys).second.size() == 2 &&
        qtraj::estimate_energy(frame::body, times, keys) > 0);
  CHECK(qtraj::estimate_jumps(frame::body, times, keys, std::array<double, 1>{1}).size() == 1);
  CHECK(qtraj::keyframe_errors(times, keys, times, keys).second[2] == 2);
  CHECK(qtraj::cubic_spline(times, times, 1, qtraj::end::natural, qtraj::end::natural, std::array<double, 1>{2})[0] ==
        2);
  CHECK(qtraj::even_times(0, 1, 3)[1] == 0.5);
  CHECK(qtraj::version_number() == QTRAJ_VERSION_NUMBER && qtraj::version()[0] == '0' && qtraj::target()[0] != 0);
  CHECK(qtraj::class_of(QTRAJ_E_GAP) == qtraj::status_class::data && qtraj::status_text(0)[0] != 0);
}

void errors() {
  std::size_t index = 0;
  CHECK(status_of(
            [] {
              qtraj::trajectory(method::slerp, std::array<double, 3>{0, 1, 1}, keys);
            },
            &index) == QTRAJ_E_TIME_ORDER &&
        index == 2);
  CHECK(status_of([] { qtraj::trajectory(method::slerp, std::array<double, 2>{0, 1}, keys); }) == QTRAJ_E_COUNT);
  const qtraj::error wrong(QTRAJ_E_GAP, 7);
  CHECK(wrong.what()[0] != 0 && wrong.index() == 7 && wrong.status_class() == qtraj::status_class::data);
#ifdef __cpp_lib_expected
  const auto none = qtraj::try_trajectory(method::slerp, std::array<double, 3>{0, 1, 1}, keys);
  CHECK(!none && none.error().index() == 2);
  const auto curve = qtraj::try_trajectory(method::slerp, times, keys);
  CHECK(curve && !qtraj::try_call([&] { return (*curve)(9); }) &&
        qtraj::try_call([&] { return (*curve)(1); }).has_value());
  std::printf("std::expected: tried\n");
#endif
}

}  // namespace

int main() {
  arrays();
  curves();
  settings();
  poses();
  batches();
  functions();
  errors();
  return failures != 0;
}
