#include "functions/squad.hpp"

#include "base/times.hpp"
#include "functions/pairs.hpp"
#include "math/so3.hpp"
#include "math/trigonometry.hpp"
#include "rows/squad_segment.hpp"
#include "targets/kernels.hpp"

namespace qtraj {

// ---- Controls ----

Vector3 rule_half_rate(Tangent rule, const SquadChord& before, const SquadChord& after) {
  double v_before[3], v_after[3], s[3];
  store(Vector3(before.log / before.h), v_before);
  store(Vector3(after.log / after.h), v_after);
  rule_half_rate_of(rule, v_before, before.h, v_after, after.h, s);
  return load(s);
}

Vector3 limited_half_rate(const Vector3& s, const SquadChord& chord) {
  // x = h s, or, where that is far past any limit, the vector along it whose largest component is 8
  const double largest = largest_component(s);
  const bool far = largest > 8.0 / chord.h;
  const Vector3 x = far ? Vector3((8.0 / largest) * s) : Vector3(chord.h * s);
  const double xx = dot(x, x), xl = dot(x, chord.log), room = kPi * kPi - dot(chord.log, chord.log);
  if (!(xx - 2.0 * xl > room)) return s;
  const double factor = (xl + std::sqrt(xl * xl + xx * room)) / xx;
  return (factor / chord.h) * x;
}

namespace {

Quaternion control_offset(const Quaternion& key, const Vector3& half_rate, const SquadChord& chord, bool after) {
  double q[4], s[3], log[3], offset[4];
  store(key, q), store(half_rate, s), store(chord.log, log);
  control_offset(q, s, log, chord.h, after, sin_cos_of<double>, offset);
  return load(offset);
}

// A key as it was given.
struct SquadKey {
  Quaternion q;
  double time;
  Status status;
};

// The segment between two keys, which is unknown where one of them is at fault.
struct SquadSide {
  SquadChord chord = {Vector3::Zero(), 0.0};
  bool is_known = false, is_ambiguous = false;
};

SquadSide side_between(const SquadKey& from, const SquadKey& to) {
  if (from.status != Status::ok || to.status != Status::ok) return {};
  const Slerp arc(make_pair(from.q, to.q, Path::as_given));
  return {{arc.log(), to.time - from.time}, true, arc.is_ambiguous()};
}

class SquadKeyReader {
 public:
  explicit SquadKeyReader(const SquadKeyRows& rows) : rows_(rows) {}

  SquadKey operator()(size_t key) const {
    if (!has_finite_time(key) || !is_finite(rows_.q_wb, key)) return {{}, 0.0, Status::not_finite};
    const Quaternion q_wb = row_of(rows_.q_wb, key);
    if (largest_component(q_wb) == 0) return {{}, 0.0, Status::zero_norm};
    return {q_wb, time(key), check_time(key)};
  }

 private:
  bool has_finite_time(size_t key) const { return !rows_.times.data || is_finite(rows_.times, key); }
  double time(size_t key) const { return rows_.times.data ? number_of(rows_.times, key) : static_cast<double>(key); }

  // Checks a time against the one before it and the first one, unless those are themselves at fault.
  Status check_time(size_t key) const {
    if (key == 0 || !has_finite_time(key - 1)) return Status::ok;
    const double previous = time(key - 1), first = has_finite_time(0) ? time(0) : previous;
    const double knots[] = {std::min(first, previous), previous, time(key)};
    return check_knot(knots, 2);
  }

  const SquadKeyRows& rows_;
};

struct SquadControls {
  Quaternion a, b;
};

SquadControls inner_controls(const Quaternion& key, const SquadChord& before, const SquadChord& after) {
  const Vector3 by_rule = rule_half_rate(Tangent::catmull_rom, before, after);
  const Vector3 half_rate = limited_half_rate(limited_half_rate(by_rule, before), after);
  return {key + control_offset(key, half_rate, after, true), key + control_offset(key, half_rate, before, false)};
}

}  // namespace

Outcome squad_controls(const SquadKeyRows& keys, size_t count) {
  if (count == 0) return {};
  Outcome outcome;
  const SquadKeyReader read(keys);
  SquadKey key = read(0);
  SquadSide before;
  for (size_t i = 0; i < count; ++i) {
    // the next key is read before this row is written: an output may be the keys' array
    const bool is_end = i == 0 || i + 1 == count;
    const SquadKey next = i + 1 == count ? key : read(i + 1);
    const SquadSide after = i + 1 == count ? SquadSide{} : side_between(key, next);

    Status status = key.status;
    if (status == Status::ok && (is_end || (before.is_known && after.is_known))) {
      const Quaternion q = normalize(key.q).unit.value;
      const SquadControls controls = is_end ? SquadControls{q, q} : inner_controls(q, before.chord, after.chord);
      if (!is_end && (before.is_ambiguous || after.is_ambiguous)) status = Status::ambiguous;
      write_row(keys.a, i, controls.a);
      write_row(keys.b, i, controls.b);
    } else {
      write_nan(keys.a, i);
      write_nan(keys.b, i);
    }
    if (status != Status::ok && outcome.status == Status::ok) outcome = {status, i};
    key = next;
    before = after;
  }
  return outcome;
}

// ---- One segment ----

namespace {

struct SquadCurve {
  Slerp keys, controls;

  Status at(double u, Quaternion& q) const {
    Quaternion p, c;
    keys.at(u, p);
    controls.at(u, c);
    const Slerp between(make_pair(p, c, Path::as_given));
    // clamped against overflow, far beyond where the rounding errors of p and c leave the third arc any meaning
    constexpr double kFar = 0x1p500;
    const double near_u = std::min(std::max(u, -kFar), kFar);
    between.at(2.0 * near_u * (1.0 - near_u), q);
    const bool is_ambiguous = keys.is_ambiguous() || controls.is_ambiguous() || between.is_ambiguous();
    return is_ambiguous ? Status::ambiguous : Status::ok;
  }
};

Status read_curve(const SquadSegmentRows& segment, SquadCurve& curve) {
  Pair keys, controls;
  const Status of_keys = read_pair(segment.q0, segment.q1, 0, Path::as_given, keys);
  const Status of_controls = read_pair(segment.a, segment.b, 0, Path::as_given, controls);
  // not_finite before zero_norm, wherever they are
  if (of_keys == Status::not_finite || of_controls == Status::not_finite) return Status::not_finite;
  if (of_keys != Status::ok || of_controls != Status::ok) return Status::zero_norm;
  curve = {Slerp(keys), Slerp(controls)};
  return Status::ok;
}

constexpr RowKernel<PairRows> kSlerpKernels[] = QTRAJ_OF_EACH_TARGET(slerp);

// The kernel of one segment: that of pairs, three times over chunks of rows. It leaves to the core what that leaves.
class SquadInVectors {
 public:
  SquadInVectors(const SquadSegmentRows& segment, size_t count)
      : slerp_(kSlerpKernels[target()]), segment_(segment), count_(count) {}

  // Does rows from `first` on and returns how many.
  size_t operator()(size_t first) {
    size_t row = first;
    while (arcs_are_ordinary_ && row < count_) {
      const size_t rows = std::min(kChunk, count_ - row), done = blend(row, rows);
      row += done;
      if (done < rows) break;
    }
    return row - first;
  }

 private:
  static constexpr size_t kChunk = 32;

  size_t blend(size_t first, size_t rows) {
    double p[kChunk][4], c[kChunk][4], f[kChunk];
    const Input<1> u = chunk_of(segment_.fraction, first, rows);
    const size_t of_keys = slerp_({segment_.q0, segment_.q1, u, Path::as_given, output<4>(p[0], rows)}, 0, rows);
    const size_t of_both = slerp_({segment_.a, segment_.b, u, Path::as_given, output<4>(c[0], of_keys)}, 0, of_keys);
    arcs_are_ordinary_ = of_both == of_keys;  // the fractions are: the first call did them
    for (size_t row = 0; row < of_both; ++row) {
      const double at = number_of(u, row);
      f[row] = 2.0 * at * (1.0 - at);
    }
    return slerp_({input<4>(p[0], rows), input<4>(c[0], rows), input<1>(f, rows), Path::as_given,
                   rows_from(segment_.q, first, rows)},
                  0, of_both);
  }

  const RowKernel<PairRows> slerp_;
  const SquadSegmentRows& segment_;
  const size_t count_;
  bool arcs_are_ordinary_ = true;
};

}  // namespace

Outcome squad_segment(const SquadSegmentRows& segment, size_t count) {
  if (count == 0) return {};
  SquadCurve curve;
  const Status status = read_curve(segment, curve);
  SquadInVectors in_vectors(segment, count);
  const auto kernel = [&](size_t row) { return in_vectors(row); };
  return for_each_row(count, segment.q, kernel, [&](size_t row, Quaternion& q) {
    if (!is_finite(segment.fraction, row)) return Status::not_finite;
    if (status != Status::ok) return status;
    return curve.at(number_of(segment.fraction, row), q);
  });
}

}  // namespace qtraj
