// Functions over rows, in the caches and past them, beside a plain loop (loops.hpp), Eigen where it has the function,
// and the time that memory takes to move the same bytes.
#include <cstdint>

#include "eigen_rows.hpp"
#include "loops.hpp"
#include "support.hpp"

namespace bench {
namespace {

// What a row of an input is.
enum class Kind { orientation, neighbour, turn, vector, number, fraction, matrix, time, stamp };

// Turns of up to half a turn; neighbours up to 0.2 rad apart.
std::vector<double> rows_of(Kind kind, size_t count, uint64_t seed) {
  Random random(seed);
  if (kind == Kind::orientation) return orientations_of(count, seed);
  std::vector<double> rows;
  test::Quaternion q = random.orientation();
  for (size_t i = 0; i < count; ++i) {
    const double time = 0.01 * static_cast<double>(i);
    const auto stamp = static_cast<int64_t>(i) * 10000019;
    double number = random.uniform(0, 1), matrix[9];
    switch (kind) {
      case Kind::neighbour:
        q = test::multiply(q, test::turn_within(random, 0.2));
        rows.insert(rows.end(), q.begin(), q.end());
        break;
      case Kind::turn:
        q = random.orientation();
        rows.resize(rows.size() + 3);
        must_be_ok(qtraj_rotation_vector_from_q(q.data(), 1, &rows[3 * i], nullptr));
        break;
      case Kind::vector:
        for (size_t k = 0; k < 3; ++k) rows.push_back(random.uniform(-2, 2));
        break;
      case Kind::matrix:
        q = random.orientation();
        must_be_ok(qtraj_matrix_from_q(q.data(), 1, matrix, nullptr));
        rows.insert(rows.end(), matrix, matrix + 9);
        break;
      case Kind::stamp:
        std::memcpy(&number, &stamp, sizeof number);
        rows.push_back(number);
        break;
      default:
        rows.push_back(kind == Kind::time ? time : kind == Kind::number ? 2 * number - 1 : number);
    }
  }
  return rows;
}

template <class Real>
struct Function {
  const char* name;
  std::vector<Kind> in;
  std::vector<size_t> out;  // widths
  qtraj_status (*ours)(const Real* const* in, size_t count, Real* const* out);
  RowLoop<Real> eigen;
};

// One row of inputs of a kind each and outputs of a width each; the function of the C API takes them as they are, or
// with counts.
#define QTRAJ_BENCH_ARRAYS(...) [](auto in, size_t n, auto out) -> qtraj_status { return __VA_ARGS__; }
#define QTRAJ_BENCH_ONE(name) QTRAJ_BENCH_ARRAYS(name(in[0], n, out[0], nullptr))
#define QTRAJ_BENCH_TWO(name) QTRAJ_BENCH_ARRAYS(name(in[0], n, in[1], n, n, out[0], nullptr))

const Kind kQ = Kind::orientation, kNear = Kind::neighbour, kV = Kind::vector, kTurn = Kind::turn, kM = Kind::matrix,
           kX = Kind::number, kU = Kind::fraction, kT = Kind::time;

std::vector<Function<double>> functions(double) {
  namespace eigen = peers::rows;
  return {
      {"multiply", {kQ, kQ}, {4}, QTRAJ_BENCH_TWO(qtraj_multiply), eigen::multiply<double>},
      {"conjugate", {kQ}, {4}, QTRAJ_BENCH_ONE(qtraj_conjugate), eigen::conjugate<double>},
      {"inverse", {kQ}, {4}, QTRAJ_BENCH_ONE(qtraj_inverse), eigen::inverse<double>},
      {"norm", {kQ}, {1}, QTRAJ_BENCH_ONE(qtraj_norm), eigen::norm<double>},
      {"dot", {kQ, kQ}, {1}, QTRAJ_BENCH_TWO(qtraj_dot), eigen::dot<double>},
      {"normalize", {kQ}, {4}, QTRAJ_BENCH_ONE(qtraj_normalize), eigen::normalize<double>},
      {"rotate", {kQ, kV}, {3}, QTRAJ_BENCH_TWO(qtraj_rotate), eigen::rotate<double>},
      {"wxyz_from_xyzw", {kQ}, {4}, QTRAJ_BENCH_ARRAYS(qtraj_wxyz_from_xyzw(in[0], n, out[0])), nullptr},
      {"xyzw_from_wxyz", {kQ}, {4}, QTRAJ_BENCH_ARRAYS(qtraj_xyzw_from_wxyz(in[0], n, out[0])), nullptr},
      {"make_continuous",
       {kNear},
       {4},
       QTRAJ_BENCH_ARRAYS(qtraj_make_continuous(in[0], 1, n, out[0], nullptr, nullptr)),
       nullptr},
      {"exp", {kTurn}, {4}, QTRAJ_BENCH_ONE(qtraj_exp), nullptr},
      {"log", {kQ}, {3}, QTRAJ_BENCH_ONE(qtraj_log), nullptr},
      {"pow", {kQ, kX}, {4}, QTRAJ_BENCH_ARRAYS(qtraj_pow(in[0], in[1], n, n, out[0], nullptr)), nullptr},
      {"q_from_rotation_vector",
       {kTurn},
       {4},
       QTRAJ_BENCH_ONE(qtraj_q_from_rotation_vector),
       eigen::q_from_rotation_vector<double>},
      {"rotation_vector_from_q",
       {kQ},
       {3},
       QTRAJ_BENCH_ONE(qtraj_rotation_vector_from_q),
       eigen::rotation_vector_from_q<double>},
      {"distance", {kQ, kQ}, {1}, QTRAJ_BENCH_TWO(qtraj_distance), nullptr},
      {"rotation_angle", {kQ, kQ}, {1}, QTRAJ_BENCH_TWO(qtraj_rotation_angle), eigen::rotation_angle<double>},
      {"matrix_from_q", {kQ}, {9}, QTRAJ_BENCH_ONE(qtraj_matrix_from_q), eigen::matrix_from_q<double>},
      {"q_from_matrix",
       {kM},
       {4},
       QTRAJ_BENCH_ARRAYS(qtraj_q_from_matrix(in[0], n, 0, out[0], nullptr, nullptr)),
       eigen::q_from_matrix<double>},
      {"derivatives_from_rates",
       {kQ, kV, kV},
       {4, 4},
       QTRAJ_BENCH_ARRAYS(
           qtraj_derivatives_from_rates(QTRAJ_FRAME_BODY, in[0], in[1], in[2], n, out[0], out[1], nullptr)),
       nullptr},
      {"rates_from_derivatives",
       {kQ, kNear, kQ},
       {3, 3},
       QTRAJ_BENCH_ARRAYS(
           qtraj_rates_from_derivatives(QTRAJ_FRAME_BODY, in[0], in[1], in[2], n, out[0], out[1], nullptr)),
       nullptr},
      {"estimate_omega",
       {kT, kNear},
       {1, 3},
       QTRAJ_BENCH_ARRAYS(qtraj_estimate_omega(QTRAJ_FRAME_BODY, in[0], in[1], n, out[0], out[1], nullptr)),
       nullptr},
      {"keyframe_errors",
       {kT, kNear, kT, kQ},
       {1},
       QTRAJ_BENCH_ARRAYS(qtraj_keyframe_errors(in[0], in[1], n, in[2], in[3], n, out[0], nullptr, nullptr)),
       nullptr},
      {"slerp_between",
       {kQ, kQ, kU},
       {4},
       QTRAJ_BENCH_ARRAYS(qtraj_slerp_between(in[0], 0, in[1], static_cast<double>(n), in[2], n, QTRAJ_PATH_SHORTEST,
                                              out[0], nullptr)),
       nullptr},
      {"slerp_pairs",
       {kQ, kQ, kU},
       {4},
       QTRAJ_BENCH_ARRAYS(qtraj_slerp_pairs(in[0], n, in[1], n, in[2], n, n, QTRAJ_PATH_SHORTEST, out[0], nullptr)),
       nullptr},
      {"squad_segment",
       {kNear, kU},
       {4},
       QTRAJ_BENCH_ARRAYS(qtraj_squad_segment(in[0], in[0] + 12, in[0] + 4, in[0] + 8, in[1], n, out[0], nullptr)),
       nullptr},
      {"even_times", {}, {1}, QTRAJ_BENCH_ARRAYS(((void)in, qtraj_even_times(0, 10, n, out[0]))), nullptr},
      {"seconds_from_ns",
       {Kind::stamp},
       {1},
       QTRAJ_BENCH_ARRAYS(qtraj_seconds_from_ns(reinterpret_cast<const int64_t*>(in[0]), n, 0, out[0])),
       nullptr},
  };
}

std::vector<Function<float>> functions(float) {
  return {
      {"multiply", {kQ, kQ}, {4}, QTRAJ_BENCH_TWO(qtraj_multiply_f32), peers::rows::multiply<float>},
      {"normalize", {kQ}, {4}, QTRAJ_BENCH_ONE(qtraj_normalize_f32), peers::rows::normalize<float>},
      {"rotate", {kQ, kV}, {3}, QTRAJ_BENCH_TWO(qtraj_rotate_f32), peers::rows::rotate<float>},
      {"wxyz_from_xyzw", {kQ}, {4}, QTRAJ_BENCH_ARRAYS(qtraj_wxyz_from_xyzw_f32(in[0], n, out[0])), nullptr},
      {"xyzw_from_wxyz", {kQ}, {4}, QTRAJ_BENCH_ARRAYS(qtraj_xyzw_from_wxyz_f32(in[0], n, out[0])), nullptr},
      {"make_continuous",
       {kNear},
       {4},
       QTRAJ_BENCH_ARRAYS(qtraj_make_continuous_f32(in[0], 1, n, out[0], nullptr, nullptr)),
       nullptr},
      {"exp", {kTurn}, {4}, QTRAJ_BENCH_ONE(qtraj_exp_f32), nullptr},
      {"log", {kQ}, {3}, QTRAJ_BENCH_ONE(qtraj_log_f32), nullptr},
      {"q_from_rotation_vector",
       {kTurn},
       {4},
       QTRAJ_BENCH_ONE(qtraj_q_from_rotation_vector_f32),
       peers::rows::q_from_rotation_vector<float>},
      {"rotation_vector_from_q",
       {kQ},
       {3},
       QTRAJ_BENCH_ONE(qtraj_rotation_vector_from_q_f32),
       peers::rows::rotation_vector_from_q<float>},
      {"distance", {kQ, kQ}, {1}, QTRAJ_BENCH_TWO(qtraj_distance_f32), nullptr},
      {"matrix_from_q", {kQ}, {9}, QTRAJ_BENCH_ONE(qtraj_matrix_from_q_f32), peers::rows::matrix_from_q<float>},
      {"q_from_matrix",
       {kM},
       {4},
       QTRAJ_BENCH_ARRAYS(qtraj_q_from_matrix_f32(in[0], n, 0, out[0], nullptr, nullptr)),
       peers::rows::q_from_matrix<float>},
  };
}

// ---- Loops for the target in use ----

template <class Real>
struct Loops {
  const NamedLoop<Real>* named;
  void (*move_bytes)(const Bytes<const char>*, size_t, const Bytes<char>*, size_t);
};

#define QTRAJ_RETURN_LOOPS(target, arithmetic, runs_here, unused)       \
  if (std::strncmp(qtraj_target(), #target " ", sizeof #target) == 0) { \
    if constexpr (sizeof(Real) == sizeof(double))                       \
      return {loops_##target::doubles, loops_##target::move_bytes};     \
    else                                                                \
      return {loops_##target::floats, loops_##target::move_bytes};      \
  }
template <class Real>
Loops<Real> loops() {
  QTRAJ_EACH_TARGET(QTRAJ_RETURN_LOOPS, )
  std::fprintf(stderr, "bench: no loops for %s\n", qtraj_target());
  std::exit(1);
}

template <class Real>
RowLoop<Real> loop_of(const char* name) {
  const NamedLoop<Real>* at = loops<Real>().named;
  while (at->name && std::strcmp(at->name, name) != 0) ++at;
  return at->loop;
}

// ---- Rows ----

// The inputs of a call, and its outputs one after the other in one array.
template <class Real>
struct Arrays {
  std::vector<std::vector<Real>> in;
  std::vector<const Real*> inputs;
  std::vector<size_t> widths;
  size_t count;

  Arrays(const Function<Real>& function, size_t rows) : widths(function.out), count(rows) {
    for (size_t k = 0; k < function.in.size(); ++k) in.push_back(converted<Real>(rows_of(function.in[k], rows, 1 + k)));
    for (const std::vector<Real>& each : in) inputs.push_back(each.data());
  }
  Arrays(Arrays&&) = default;

  std::vector<Real*> outputs(Real* out) const {
    std::vector<Real*> pointers;
    for (const size_t width : widths) {
      pointers.push_back(out);
      out += width * count;
    }
    return pointers;
  }
};

template <class Real>
void add_function(const Function<Real>& function, size_t count) {
  size_t components = 0;
  for (const size_t width : function.out) components += width;
  const Case rows = {with_type<Real>((std::string("rows_") + function.name).c_str()), 0, count};
  const auto add_who = [&](const char* who, const auto& call) {
    add<Real>(
        rows, who,
        [=] {
          return [=, arrays = std::make_shared<Arrays<Real>>(function, count)](Real* out) {
            call(*arrays, arrays->outputs(out).data());
          };
        },
        components);
  };
  add_who("ours", [=](const Arrays<Real>& arrays, Real* const* out) {
    must_be_ok(function.ours(arrays.inputs.data(), count, out));
  });
  if (const RowLoop<Real> loop = loop_of<Real>(function.name))
    add_who("loop", [=](const Arrays<Real>& arrays, Real* const* out) { loop(arrays.inputs.data(), count, out); });
  if (function.eigen)
    add_who("eigen",
            [=](const Arrays<Real>& arrays, Real* const* out) { function.eigen(arrays.inputs.data(), count, out); });
  add_who("bytes", [=](const Arrays<Real>& arrays, Real* const* out) {
    std::vector<Bytes<const char>> from;
    std::vector<Bytes<char>> to;
    for (const std::vector<Real>& each : arrays.in)
      from.push_back({reinterpret_cast<const char*>(each.data()), each.size() * sizeof(Real)});
    for (size_t k = 0; k < arrays.widths.size(); ++k)
      to.push_back({reinterpret_cast<char*>(out[k]), arrays.widths[k] * count * sizeof(Real)});
    loops<Real>().move_bytes(from.data(), from.size(), to.data(), to.size());
  });
}

}  // namespace

void add_functions() {
  for (const size_t count : {1000, 1000000}) {
    for (const Function<double>& function : functions(0.0)) add_function(function, count);
    for (const Function<float>& function : functions(0.0f)) add_function(function, count);
  }
}

}  // namespace bench
