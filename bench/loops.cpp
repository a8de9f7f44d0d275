// The loops of loops.hpp for one target, QTRAJ_LOOPS. Nothing is checked and nothing is singular but by chance.
#include "loops.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace bench {
namespace QTRAJ_LOOPS {
namespace {

template <class Real>
void multiply_one(const Real* a, const Real* b, Real* q) {
  const Real w = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
  const Real x = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
  const Real y = a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1];
  const Real z = a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0];
  q[0] = w, q[1] = x, q[2] = y, q[3] = z;
}
template <class Real>
Real dot_one(const Real* a, const Real* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}
template <class Real>
void conjugate_one(const Real* q, Real* out) {
  out[0] = q[0], out[1] = -q[1], out[2] = -q[2], out[3] = -q[3];
}
template <class Real>
void normalize_one(const Real* q, Real* unit) {
  const Real scale = 1 / std::sqrt(dot_one(q, q));
  for (size_t k = 0; k < 4; ++k) unit[k] = scale * q[k];
}
// exp of `half` times a vector.
template <class Real>
void exp_one(const Real* v, Real half, Real* q) {
  const Real angle = half * std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  const Real factor = angle > 0 ? half * std::sin(angle) / angle : half;
  q[0] = std::cos(angle), q[1] = factor * v[0], q[2] = factor * v[1], q[3] = factor * v[2];
}
template <class Real>
void log_one(const Real* q, Real* v) {
  const Real sine = std::sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const Real factor = sine > 0 ? std::atan2(sine, q[0]) / sine : 1;
  for (size_t k = 0; k < 3; ++k) v[k] = factor * q[k + 1];
}
template <class Real>
Real distance_one(const Real* a, const Real* b) {
  Real difference = 0, sum = 0;
  for (size_t k = 0; k < 4; ++k) {
    difference += (a[k] - b[k]) * (a[k] - b[k]);
    sum += (a[k] + b[k]) * (a[k] + b[k]);
  }
  return 2 * std::atan2(std::sqrt(difference), std::sqrt(sum));
}
template <class Real>
void slerp_one(const Real* a, const Real* b, Real u, Real* q) {
  const Real dot = dot_one(a, b), sign = dot < 0 ? Real(-1) : Real(1);
  const Real angle = std::acos(std::min(sign * dot, Real(1))), sine = sign * std::sin(angle);
  const Real from_a = angle > 0 ? sign * std::sin((1 - u) * angle) / sine : 1 - u;
  const Real from_b = angle > 0 ? std::sin(u * angle) / sine : sign * u;
  for (size_t k = 0; k < 4; ++k) q[k] = from_a * a[k] + from_b * b[k];
}

// ---- Algebra ----

template <class Real>
void multiply(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) multiply_one(in[0] + 4 * i, in[1] + 4 * i, out[0] + 4 * i);
}
template <class Real>
void conjugate(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) conjugate_one(in[0] + 4 * i, out[0] + 4 * i);
}
template <class Real>
void inverse(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) {
    const Real *const q = in[0] + 4 * i, scale = 1 / dot_one(q, q);
    conjugate_one(q, out[0] + 4 * i);
    for (size_t k = 0; k < 4; ++k) out[0][4 * i + k] *= scale;
  }
}
template <class Real>
void norm(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) out[0][i] = std::sqrt(dot_one(in[0] + 4 * i, in[0] + 4 * i));
}
template <class Real>
void dot(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) out[0][i] = dot_one(in[0] + 4 * i, in[1] + 4 * i);
}
template <class Real>
void normalize(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) normalize_one(in[0] + 4 * i, out[0] + 4 * i);
}
template <class Real>
void rotate(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) {
    const Real *const q = in[0] + 4 * i, *const v = in[1] + 3 * i;
    const Real x = 2 * (q[2] * v[2] - q[3] * v[1]), y = 2 * (q[3] * v[0] - q[1] * v[2]),
               z = 2 * (q[1] * v[1] - q[2] * v[0]);
    Real* const world = out[0] + 3 * i;
    world[0] = v[0] + q[0] * x + q[2] * z - q[3] * y;
    world[1] = v[1] + q[0] * y + q[3] * x - q[1] * z;
    world[2] = v[2] + q[0] * z + q[1] * y - q[2] * x;
  }
}
template <class Real>
void last_to_front(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i)
    for (size_t k = 0; k < 4; ++k) out[0][4 * i + k] = in[0][4 * i + (k + 3) % 4];
}
template <class Real>
void front_to_last(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i)
    for (size_t k = 0; k < 4; ++k) out[0][4 * i + k] = in[0][4 * i + (k + 1) % 4];
}
template <class Real>
void make_continuous(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) {
    const Real* const q = in[0] + 4 * i;
    const Real sign = i > 0 && dot_one(out[0] + 4 * (i - 1), q) < 0 ? Real(-1) : Real(1);
    for (size_t k = 0; k < 4; ++k) out[0][4 * i + k] = sign * q[k];
  }
}

// ---- Exponential, angles ----

template <class Real>
void exp(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) exp_one(in[0] + 3 * i, Real(1), out[0] + 4 * i);
}
template <class Real>
void q_from_rotation_vector(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) exp_one(in[0] + 3 * i, Real(0.5), out[0] + 4 * i);
}
template <class Real>
void log(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) log_one(in[0] + 4 * i, out[0] + 3 * i);
}
template <class Real>
void rotation_vector_from_q(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) {
    const Real *const q = in[0] + 4 * i, turns = q[0] < 0 ? Real(-2) : Real(2);
    const Real half[] = {std::abs(q[0]), q[1], q[2], q[3]};
    log_one(half, out[0] + 3 * i);
    for (size_t k = 0; k < 3; ++k) out[0][3 * i + k] *= turns;
  }
}
template <class Real>
void pow(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) {
    Real v[3];
    log_one(in[0] + 4 * i, v);
    for (Real& component : v) component *= in[1][i];
    exp_one(v, Real(1), out[0] + 4 * i);
  }
}
template <class Real>
void distance(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) out[0][i] = distance_one(in[0] + 4 * i, in[1] + 4 * i);
}
template <class Real>
void rotation_angle(const Real* const* in, size_t count, Real* const* out) {
  constexpr Real kPi = Real(3.14159265358979323846);
  for (size_t i = 0; i < count; ++i) {
    const Real angle = distance_one(in[0] + 4 * i, in[1] + 4 * i);
    out[0][i] = 2 * std::min(angle, kPi - angle);
  }
}

// ---- Matrices ----

template <class Real>
void matrix_from_q(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) {
    const Real *const q = in[0] + 4 * i, w = q[0], x = q[1], y = q[2], z = q[3];
    Real* const m = out[0] + 9 * i;
    m[0] = 1 - 2 * (y * y + z * z), m[1] = 2 * (x * y - w * z), m[2] = 2 * (x * z + w * y);
    m[3] = 2 * (x * y + w * z), m[4] = 1 - 2 * (x * x + z * z), m[5] = 2 * (y * z - w * x);
    m[6] = 2 * (x * z - w * y), m[7] = 2 * (y * z + w * x), m[8] = 1 - 2 * (x * x + y * y);
  }
}
// By the largest of the four (S. W. Shepperd, "Quaternion from rotation matrix", J. Guidance and Control 1, 1978).
template <class Real>
void q_from_matrix(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) {
    const Real *const m = in[0] + 9 * i, trace = m[0] + m[4] + m[8];
    Real* const q = out[0] + 4 * i;
    if (trace > 0) {
      const Real root = std::sqrt(trace + 1), scale = Real(0.5) / root;
      q[0] = Real(0.5) * root, q[1] = (m[7] - m[5]) * scale, q[2] = (m[2] - m[6]) * scale, q[3] = (m[3] - m[1]) * scale;
    } else {
      const size_t j = m[4] > m[0] ? (m[8] > m[4] ? 2 : 1) : (m[8] > m[0] ? 2 : 0), k = (j + 1) % 3, l = (k + 1) % 3;
      const Real root = std::sqrt(m[4 * j] - m[4 * k] - m[4 * l] + 1), scale = Real(0.5) / root;
      q[1 + j] = Real(0.5) * root;
      q[0] = (m[3 * l + k] - m[3 * k + l]) * scale;
      q[1 + k] = (m[3 * k + j] + m[3 * j + k]) * scale;
      q[1 + l] = (m[3 * l + j] + m[3 * j + l]) * scale;
    }
  }
}

// ---- Rates: in the body frame ----

void derivatives_from_rates(const double* const* in, size_t count, double* const* out) {
  for (size_t i = 0; i < count; ++i) {
    const double *const q = in[0] + 4 * i, *const omega = in[1] + 3 * i, *const alpha = in[2] + 3 * i;
    const double once[] = {0, 0.5 * omega[0], 0.5 * omega[1], 0.5 * omega[2]};
    const double square = omega[0] * omega[0] + omega[1] * omega[1] + omega[2] * omega[2];
    const double twice[] = {-0.25 * square, 0.5 * alpha[0], 0.5 * alpha[1], 0.5 * alpha[2]};
    multiply_one(q, once, out[0] + 4 * i);
    multiply_one(q, twice, out[1] + 4 * i);
  }
}
void rates_from_derivatives(const double* const* in, size_t count, double* const* out) {
  for (size_t i = 0; i < count; ++i) {
    double back[4], p[4], second[4];
    conjugate_one(in[0] + 4 * i, back);
    multiply_one(back, in[1] + 4 * i, p);
    multiply_one(back, in[2] + 4 * i, second);
    for (size_t k = 0; k < 3; ++k) {
      out[0][3 * i + k] = 2 * p[k + 1];
      out[1][3 * i + k] = 2 * (second[k + 1] - 2 * p[0] * p[k + 1]);
    }
  }
}
// out: middles [count - 1], rates [count - 1][3].
void estimate_omega(const double* const* in, size_t count, double* const* out) {
  for (size_t i = 0; i + 1 < count; ++i) {
    const double *const times = in[0] + i, *const q = in[1] + 4 * i;
    double back[4], turn[4], log[3];
    conjugate_one(q, back);
    multiply_one(back, q + 4, turn);
    if (turn[0] < 0)
      for (double& component : turn) component = -component;
    log_one(turn, log);
    out[0][i] = 0.5 * (times[0] + times[1]);
    for (size_t k = 0; k < 3; ++k) out[1][3 * i + k] = 2 * log[k] / (times[1] - times[0]);
  }
}
// Of keys [count] and samples [count], both in order.
void keyframe_errors(const double* const* in, size_t count, double* const* out) {
  size_t later = 0;
  for (size_t i = 0; i < count; ++i) {
    const double time = in[0][i];
    while (later < count && in[2][later] < time) ++later;
    const bool is_earlier = later == count || (later > 0 && time - in[2][later - 1] <= in[2][later] - time);
    const double angle = distance_one(in[1] + 4 * i, in[3] + 4 * (is_earlier ? later - 1 : later));
    out[0][i] = 2 * std::min(angle, 3.14159265358979323846 - angle);
  }
}

// ---- Pairs ----

// From the first a to the first b, at times from 0 to 1.
void slerp_between(const double* const* in, size_t count, double* const* out) {
  for (size_t i = 0; i < count; ++i) slerp_one(in[0], in[1], (in[2][i] - 0.0) / (1.0 - 0.0), out[0] + 4 * i);
}
void slerp_pairs(const double* const* in, size_t count, double* const* out) {
  for (size_t i = 0; i < count; ++i) slerp_one(in[0] + 4 * i, in[1] + 4 * i, in[2][i], out[0] + 4 * i);
}
// From the first row to the fourth, with the two between as controls.
void squad_segment(const double* const* in, size_t count, double* const* out) {
  for (size_t i = 0; i < count; ++i) {
    const double u = in[1][i];
    double p[4], c[4];
    slerp_one(in[0], in[0] + 12, u, p);
    slerp_one(in[0] + 4, in[0] + 8, u, c);
    slerp_one(p, c, 2 * u * (1 - u), out[0] + 4 * i);
  }
}

// ---- Times ----

void even_times(const double* const*, size_t count, double* const* out) {
  for (size_t i = 0; i < count; ++i) out[0][i] = static_cast<double>(i) * 10.0 / static_cast<double>(count - 1);
}
void seconds_from_ns(const double* const* in, size_t count, double* const* out) {
  for (size_t i = 0; i < count; ++i) {
    int64_t stamp;
    std::memcpy(&stamp, in[0] + i, sizeof stamp);
    out[0][i] = static_cast<double>(stamp) / 1e9;
  }
}

}  // namespace

#define QTRAJ_BOTH_TYPES(Real)                                                                                    \
  {"multiply", multiply<Real>}, {"conjugate", conjugate<Real>}, {"inverse", inverse<Real>}, {"norm", norm<Real>}, \
      {"dot", dot<Real>}, {"normalize", normalize<Real>}, {"rotate", rotate<Real>},                               \
      {"wxyz_from_xyzw", last_to_front<Real>}, {"xyzw_from_wxyz", front_to_last<Real>},                           \
      {"make_continuous", make_continuous<Real>}, {"exp", exp<Real>}, {"log", log<Real>}, {"pow", pow<Real>},     \
      {"q_from_rotation_vector", q_from_rotation_vector<Real>},                                                   \
      {"rotation_vector_from_q", rotation_vector_from_q<Real>}, {"distance", distance<Real>},                     \
      {"rotation_angle", rotation_angle<Real>}, {"matrix_from_q", matrix_from_q<Real>}, {                         \
    "q_from_matrix", q_from_matrix<Real>                                                                          \
  }

const NamedLoop<double> doubles[] = {QTRAJ_BOTH_TYPES(double),
                                     {"derivatives_from_rates", derivatives_from_rates},
                                     {"rates_from_derivatives", rates_from_derivatives},
                                     {"estimate_omega", estimate_omega},
                                     {"keyframe_errors", keyframe_errors},
                                     {"slerp_between", slerp_between},
                                     {"slerp_pairs", slerp_pairs},
                                     {"squad_segment", squad_segment},
                                     {"even_times", even_times},
                                     {"seconds_from_ns", seconds_from_ns},
                                     {nullptr, nullptr}};
const NamedLoop<float> floats[] = {QTRAJ_BOTH_TYPES(float), {nullptr, nullptr}};

void move_bytes(const Bytes<const char>* in, size_t inputs, const Bytes<char>* out, size_t outputs) {
  size_t written = 0;  // bytes of the first output left
  for (size_t k = 0; k < inputs; ++k) {
    size_t read = 0;
    while (read < in[k].count && outputs > 0) {
      const size_t bytes = std::min(in[k].count - read, out->count - written);
      std::memcpy(out->data + written, in[k].data + read, bytes);
      read += bytes, written += bytes;
      if (written == out->count) ++out, --outputs, written = 0;
    }
    int64_t sum = 0;  // what is only read
    for (size_t i = 0; i < (in[k].count - read) / sizeof sum; ++i) {
      int64_t number;
      std::memcpy(&number, in[k].data + read + i * sizeof number, sizeof number);
      sum += number;
    }
    __asm__ volatile("" : : "r"(sum));
  }
  for (; outputs > 0; ++out, --outputs, written = 0) std::memset(out->data + written, 0, out->count - written);
}

}  // namespace QTRAJ_LOOPS
}  // namespace bench
