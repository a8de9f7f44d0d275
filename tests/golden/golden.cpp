// qtraj_golden [--target NAME]: samples every method in every way with one kernel (that of this CPU, or the one named),
// calls the functions over rows and prints "NAME hash added", a hash of all bits that came out and one of those of the
// methods and rules that were added since (golden/curves.hpp). Fails where the bits of a
// sample depend on its place in the batch, the split or the function. Exits with 77 where this CPU, or this build, has
// no such kernel.
#include <cstdio>
#include <cstring>
#include <limits>

#include "golden/curves.hpp"
#include "support/forced_kernel.hpp"

namespace {

using golden::Curve;
using golden::Integers;

constexpr int kFailed = 1, kWrongUse = 2, kNotHere = 77;

// FNV-1a over the bytes, lowest first, of 64-bit words. All NaN count as one.
class Hash {
 public:
  void add(uint64_t word) {
    for (int byte = 0; byte < 8; ++byte) value_ = (value_ ^ ((word >> (8 * byte)) & 0xff)) * 0x100000001b3u;
  }
  void add(double value) {
    uint64_t word = 0x7ff8000000000000u;
    if (value == value) std::memcpy(&word, &value, sizeof word);
    add(word);
  }
  void add(float value) { add(static_cast<double>(value)); }
  template <class Number>
  void add(const std::vector<Number>& values) {
    for (const Number& value : values) add(value);
  }
  uint64_t value() const { return value_; }

 private:
  uint64_t value_ = 0xcbf29ce484222325u;
};

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "golden: %s\n", what);
  std::exit(kFailed);
}

template <class Real>
capi::Trajectory build(const Curve& curve) {
  qtraj_options* options = nullptr;
  const capi::Variant& setting = curve.setting;
  require(qtraj_options_create(setting.method, &options) == QTRAJ_OK, "options_create");
  const capi::Options owner(options);
  const double omega[3] = {0.25, -0.5, 0.125}, q_wb[4] = {1.5, 0.25, -0.125, 0.5};
  const bool given = setting.reference == QTRAJ_REFERENCE_GIVEN;
  require(setting.end == QTRAJ_END_DEFAULT || qtraj_options_set_ends(options, setting.end, setting.end) == QTRAJ_OK,
          "set_ends");
  require(setting.end != QTRAJ_END_GIVEN ||
              qtraj_options_set_end_rates(options, QTRAJ_FRAME_WORLD, omega, omega) == QTRAJ_OK,
          "set_end_rates");
  require(
      setting.tangents == QTRAJ_TANGENT_DEFAULT || qtraj_options_set_tangents(options, setting.tangents) == QTRAJ_OK,
      "set_tangents");
  require(setting.reference == QTRAJ_REFERENCE_DEFAULT ||
              qtraj_options_set_reference(options, setting.reference, given ? q_wb : nullptr) == QTRAJ_OK,
          "set_reference");
  // signs alternate: one of both rules each time
  const int32_t turns = curve.keys.times.size() % 2 == 0 ? QTRAJ_TURNS_SHORTEST : QTRAJ_TURNS_AS_GIVEN;
  require(!setting.needs_tangents() || qtraj_options_set_turns(options, turns) == QTRAJ_OK, "set_turns");
  require(qtraj_options_set_extrapolation(options, curve.outside.before, curve.outside.after) == QTRAJ_OK,
          "set_extrapolation");
  const auto& keys = curve.keys;
  const std::vector<Real> q(keys.q.begin(), keys.q.end()), w(keys.omega.begin(), keys.omega.end()),
      a(keys.alpha.begin(), keys.alpha.end()), in(keys.in_tangents.begin(), keys.in_tangents.end()),
      out_of(keys.out_tangents.begin(), keys.out_tangents.end());
  qtraj_trajectory* out = nullptr;
  const size_t count = keys.times.size();
  const qtraj_status status =
      setting.needs_tangents() ? capi::create_with_tangents(options, keys.times.data(), q.data(), in.data(),
                                                            out_of.data(), count, &out, nullptr)
      : setting.needs_rates()
          ? capi::create_with_rates(options, QTRAJ_FRAME_BODY, keys.times.data(), q.data(), w.data(),
                                    setting.needs_alpha() ? a.data() : nullptr, count, &out, nullptr)
          : capi::create_with_options(options, keys.times.data(), q.data(), count, &out, nullptr);
  require(status == QTRAJ_OK, "a curve cannot be built");
  return capi::Trajectory(out);
}

// Runs through each segment, knots included, then times in no order, inside, outside and not finite.
std::vector<double> times_for(const std::vector<double>& knots) {
  constexpr size_t kSorted = 340, kRandom = 60;
  std::vector<double> times;
  const size_t per_segment = kSorted / (knots.size() - 1);
  for (size_t i = 0; i + 1 < knots.size(); ++i)
    for (size_t k = 0; k < per_segment; ++k)
      times.push_back(knots[i] + static_cast<double>(k) / static_cast<double>(per_segment) * (knots[i + 1] - knots[i]));
  times.push_back(knots.back());
  Integers random(8);
  const double span = knots.back() - knots.front();
  for (size_t i = 0; i < kRandom; ++i) times.push_back(knots.front() + (0.5 + 0.75 * random.signed_fraction()) * span);
  const double infinity = std::numeric_limits<double>::infinity();
  times.insert(times.end(), {infinity, -infinity, std::numeric_limits<double>::quiet_NaN(), 1e300, -1e15});
  return times;
}

// What one call writes. Without a frame: orientations only.
constexpr int32_t kNoFrame = 0;
template <class Real>
struct Samples {
  std::vector<Real> q, omega, alpha;
  explicit Samples(size_t count) : q(4 * count), omega(3 * count), alpha(3 * count) {}

  qtraj_status take(const qtraj_trajectory* curve, int32_t frame, const double* times, size_t first, size_t count) {
    if (frame == kNoFrame) return capi::sample(curve, times, count, &q[4 * first], nullptr);
    return capi::sample_rates(curve, frame, times, count, &q[4 * first], &omega[3 * first], &alpha[3 * first], nullptr);
  }
  qtraj_status take_at(const qtraj_trajectory* curve, int32_t frame, double time, size_t row, size_t* cursor) {
    if (frame == kNoFrame) return capi::sample_at(curve, time, cursor, &q[4 * row]);
    return capi::sample_rates_at(curve, frame, time, cursor, &q[4 * row], &omega[3 * row], &alpha[3 * row]);
  }
  // Row i of the result is row order[i] of these.
  Samples back_from(const std::vector<size_t>& order) const {
    Samples rows(order.size());
    for (size_t i = 0; i < order.size(); ++i) {
      std::copy_n(&q[4 * i], 4, &rows.q[4 * order[i]]);
      std::copy_n(&omega[3 * i], 3, &rows.omega[3 * order[i]]);
      std::copy_n(&alpha[3 * i], 3, &rows.alpha[3 * order[i]]);
    }
    return rows;
  }
  uint64_t hash() const {
    Hash hash;
    hash.add(q), hash.add(omega), hash.add(alpha);
    return hash.value();
  }
};

// One by one, in pieces and shuffled: the bits of the whole batch.
template <class Real>
void check_order_and_split(const qtraj_trajectory* curve, int32_t frame, const std::vector<double>& times,
                           uint64_t expected) {
  Samples<Real> samples(times.size());
  size_t cursor = 0;
  for (size_t i = 0; i < times.size(); ++i) samples.take_at(curve, frame, times[i], i, &cursor);
  require(samples.hash() == expected, "one by one, other bits than in a batch");
  for (const size_t length : {3u, 8u, 17u, 64u, 251u}) {
    Samples<Real> pieces(times.size());
    for (size_t first = 0; first < times.size(); first += length)
      pieces.take(curve, frame, &times[first], first, std::min<size_t>(length, times.size() - first));
    require(pieces.hash() == expected, "in pieces, other bits than in a batch");
  }
  std::vector<size_t> order(times.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  Integers random(9);
  for (size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
  std::vector<double> shuffled;
  for (const size_t from : order) shuffled.push_back(times[from]);
  Samples<Real> rows(times.size());
  rows.take(curve, frame, shuffled.data(), 0, times.size());
  require(rows.back_from(order).hash() == expected, "shuffled, other bits than in order");
}

template <class Real>
void add_uniform(const qtraj_trajectory* curve, Hash& hash) {
  constexpr size_t kCount = 300;
  const double first = qtraj_start_time(curve), last = qtraj_end_time(curve);
  const double step = (last - first) / 250.0, start = first - 20.0 * step;
  std::vector<double> times;
  for (size_t i = 0; i < kCount; ++i) times.push_back(start + static_cast<double>(i) * step);
  Samples<Real> uniform(kCount), listed(kCount);
  capi::sample_uniform(curve, start, step, kCount, uniform.q.data(), nullptr);
  listed.take(curve, kNoFrame, times.data(), 0, kCount);
  require(uniform.hash() == listed.hash(), "uniform times, other bits than the same times in an array");
  hash.add(uniform.hash());
}

template <class Real>
void add_samples(const qtraj_trajectory* curve, const std::vector<double>& times, Hash& hash) {
  for (const int32_t frame : {kNoFrame, int32_t{QTRAJ_FRAME_BODY}, int32_t{QTRAJ_FRAME_WORLD}}) {
    Samples<Real> whole(times.size());
    // the last times are not finite: a row at fault each
    require(whole.take(curve, frame, times.data(), 0, times.size()) != QTRAJ_OK, "faulty times went unnoticed");
    check_order_and_split<Real>(curve, frame, times, whole.hash());
    hash.add(whole.hash());
  }
  add_uniform<Real>(curve, hash);
}

// Some components 0, some of any sign and a size about 1.
std::vector<double> numbers(Integers& random, size_t count) {
  std::vector<double> all(count);
  for (double& number : all) number = random.signed_fraction();
  return all;
}

// Functions over rows that kernels have a part in, and means.
void add_rows(Hash& hash) {
  constexpr size_t kCount = 203;
  Integers random(10);
  const std::vector<double> a = numbers(random, 4 * kCount), b = numbers(random, 4 * kCount),
                            v = numbers(random, 3 * kCount), fractions = numbers(random, kCount);
  std::vector<double> q(4 * kCount), v_world(3 * kCount);
  for (const auto interpolate : {qtraj_slerp_pairs, qtraj_nlerp_pairs})
    for (const int32_t path : {QTRAJ_PATH_SHORTEST, QTRAJ_PATH_AS_GIVEN}) {
      interpolate(a.data(), kCount, b.data(), kCount, fractions.data(), kCount, kCount, path, q.data(), nullptr);
      hash.add(q);
    }
  qtraj_rotate(a.data(), kCount, v.data(), kCount, kCount, v_world.data(), nullptr);
  hash.add(v_world);
  qtraj_normalize(a.data(), kCount, q.data(), nullptr);
  hash.add(q);
  qtraj_make_continuous(q.data(), 1, kCount, q.data(), nullptr, nullptr);
  hash.add(q);
  std::vector<double> mean(4), weights = numbers(random, kCount);
  for (double& weight : weights) weight *= weight;
  qtraj_mean_eigen(a.data(), weights.data(), kCount, mean.data(), nullptr, nullptr);
  hash.add(mean);
  qtraj_mean_karcher(a.data(), weights.data(), kCount, 0, 100, mean.data(), nullptr, nullptr, nullptr);
  hash.add(mean);
}

Hash hash_of_curves(golden::Set set) {
  Hash hash;
  for (const Curve& curve : golden::curves(set)) {
    const std::vector<double> times = times_for(curve.keys.times);
    const capi::Trajectory from_double = build<double>(curve), from_float = build<float>(curve);
    add_samples<double>(from_double.get(), times, hash);
    add_samples<float>(from_double.get(), times, hash);
    Samples<double> of_float_keys(times.size());
    of_float_keys.take(from_float.get(), QTRAJ_FRAME_WORLD, times.data(), 0, times.size());
    hash.add(of_float_keys.hash());
  }
  return hash;
}

uint64_t golden_hash() {
  Hash hash = hash_of_curves(golden::Set::first);
  add_rows(hash);
  return hash.value();
}

bool is_known(const char* target) {
  for (const char* known : test::target_names())
    if (std::strcmp(known, target) == 0) return true;
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::strcmp(argv[1], "--target") == 0 && is_known(argv[2])) {
    if (!qtraj::force_target(argv[2])) {
      std::printf("NOT RUN: this CPU, or this build, has no kernel \"%s\"\n", argv[2]);
      return kNotHere;
    }
    require(std::strcmp(qtraj_target(), argv[2]) == 0, "forced one kernel, got another");
  } else if (argc != 1) {
    std::fprintf(stderr, "usage: qtraj_golden [--target NAME], such as \"scalar plain\"\n");
    return kWrongUse;
  }
  std::printf("%s %016llx %016llx\n", qtraj_target(), static_cast<unsigned long long>(golden_hash()),
              static_cast<unsigned long long>(hash_of_curves(golden::Set::added).value()));
  return 0;
}
