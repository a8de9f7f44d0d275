#include "peers.hpp"
#include "support.hpp"

namespace bench {
namespace {

void slerp_pairs(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& fraction,
                 double* out) {
  must_be_ok(qtraj_slerp_pairs(a.data(), fraction.size(), b.data(), fraction.size(), fraction.data(), fraction.size(),
                               fraction.size(), QTRAJ_PATH_SHORTEST, out, nullptr));
}
void slerp_pairs(const std::vector<float>& a, const std::vector<float>& b, const std::vector<float>& fraction,
                 float* out) {
  must_be_ok(qtraj_slerp_pairs_f32(a.data(), fraction.size(), b.data(), fraction.size(), fraction.data(),
                                   fraction.size(), fraction.size(), QTRAJ_PATH_SHORTEST, out, nullptr));
}

template <class Real>
std::vector<Real> fractions(size_t count) {
  Random random(3);
  std::vector<Real> fraction(count);
  for (Real& each : fraction) each = static_cast<Real>(random.uniform(0.0, 1.0));
  return fraction;
}

template <class Real>
void add_type(size_t count) {
  const Case pairs = {with_type<Real>("slerp_pairs"), 0, count};
  add<Real>(pairs, "ours", [=] {
    return [a = converted<Real>(orientations_of(count, 1)), b = converted<Real>(orientations_of(count, 2)),
            fraction = fractions<Real>(count)](Real* out) { slerp_pairs(a, b, fraction, out); };
  });
  add<Real>(pairs, "eigen", [=] {
    return [a = peers::rows_from(orientations_of(count, 1), peers::eigen_from<Real>),
            b = peers::rows_from(orientations_of(count, 2), peers::eigen_from<Real>),
            fraction = fractions<Real>(count)](Real* out) {
      peers::eigen_slerp_pairs(a, b, fraction.data(), fraction.size(), out);
    };
  });
}

}  // namespace

void add_pairs() {
  for (const size_t count : {10000, 100000, 1000000}) {
    add_type<double>(count);
    add_type<float>(count);
  }
}

}  // namespace bench
