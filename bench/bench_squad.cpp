#include "peers.hpp"
#include "support.hpp"

namespace bench {
namespace {

// glm::squad with the controls of the same curve.
template <class Real>
void add_glm(const Case& sampled) {
  add<Real>(sampled, "glm", [=] {
    const Keys& keys = keys_of(sampled.keys);
    const std::vector<double>& times = times_of(sampled);
    std::vector<double> q(keys.q.size()), a(q.size()), b(q.size());
    must_be_ok(qtraj_make_continuous(keys.q.data(), 1, keys.count(), q.data(), nullptr, nullptr));
    must_be_ok(qtraj_squad_controls(keys.times.data(), q.data(), keys.count(), a.data(), b.data(), nullptr));
    const bool sorted = sampled.order == Order::sorted;
    return [=, &keys, &times, q_glm = peers::rows_from(q, peers::glm_from<Real>),
            a_glm = peers::rows_from(a, peers::glm_from<Real>),
            b_glm = peers::rows_from(b, peers::glm_from<Real>)](Real* out) {
      (sorted ? peers::glm_squad_sorted<Real>
              : peers::glm_squad_any_order<Real>)(keys.times, q_glm, a_glm, b_glm, times.data(), times.size(),
                                                  reinterpret_cast<glm::qua<Real>*>(out));
    };
  });
}

template <class Real>
void add_type() {
  const std::string work = with_type<Real>("squad");
  const Case cases[] = {{work, 1000, 100000},
                        {work, 1000, 1000000},
                        {work, 1000, 1000000, Order::random},
                        {work, 10, 1000000},
                        {work, 1000000, 1000000}};
  for (const Case& sampled : cases) {
    add_ours<Real>(sampled, QTRAJ_SQUAD);
    add_glm<Real>(sampled);
  }
}

}  // namespace

void add_squad() {
  add_type<double>();
  add_type<float>();
}

}  // namespace bench
