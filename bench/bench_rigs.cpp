// A rig: 20 curves of 25 keys at the same times, like the joints of a skeleton. One call for all of them beside a call
// for each, "calls", and beside one for each and each time that keeps its place, "cursors".
#include "support.hpp"

namespace bench {
namespace {

constexpr size_t kJoints = 20, kKeys = 25, kTimes = 10000;

struct Rig {
  std::vector<const qtraj_trajectory*> joints;
  double first, last;
};

// Steps of at most 0.3 rad. Joints live until the program ends.
const Rig& rig_of(int32_t method) {
  static std::map<std::tuple<int32_t>, std::unique_ptr<Rig>> all;
  const auto make = [=] {
    Random random(kJoints);
    const std::vector<double> times = test::random_walk(random, kKeys, 0.3, 0.03, 0.06).times;
    Rig rig = {{}, times.front(), times.back()};
    for (size_t joint = 0; joint < kJoints; ++joint) {
      const Keys keys = test::random_walk(random, kKeys, 0.3, 0.03, 0.06);
      qtraj_trajectory* made = nullptr;
      must_be_ok(qtraj_create(method, times.data(), keys.q.data(), kKeys, &made, nullptr));
      rig.joints.push_back(made);
    }
    return rig;
  };
  return kept(all, make, method);
}

std::vector<double> even_times(const Rig& rig, size_t count) {
  std::vector<double> times(count);
  must_be_ok(qtraj_even_times(rig.first, rig.last, count, times.data()));
  return times;
}

// What is timed takes the next of these times, over and over.
class NextTime {
 public:
  explicit NextTime(const Rig& rig) : times_(even_times(rig, 1000)) {}
  const double* operator()() const {
    next_ = next_ + 1 < times_.size() ? next_ + 1 : 0;
    return &times_[next_];
  }

 private:
  std::vector<double> times_;
  mutable size_t next_ = 0;
};

// All joints at one time, orientations only.
void add_pose(const std::string& name, int32_t method) {
  const Case posed = {"rig_" + name + "_f64", kKeys, kJoints};
  add<double>(posed, "ours", [=] {
    const Rig& rig = rig_of(method);
    return [&rig, next = NextTime(rig)](double* q) {
      must_be_ok(qtraj_sample_many(rig.joints.data(), kJoints, QTRAJ_FRAME_BODY, next(), 1, QTRAJ_LAYOUT_TIME_FIRST, q,
                                   nullptr, nullptr, nullptr));
    };
  });
  add<double>(posed, "calls", [=] {
    const Rig& rig = rig_of(method);
    return [&rig, next = NextTime(rig)](double* q) {
      const double* const time = next();
      for (size_t joint = 0; joint < kJoints; ++joint)
        must_be_ok(qtraj_sample(rig.joints[joint], time, 1, q + 4 * joint, nullptr));
    };
  });
  add<double>(posed, "cursors", [=] {
    const Rig& rig = rig_of(method);
    return [&rig, next = NextTime(rig), cursors = std::make_shared<std::vector<size_t>>(kJoints)](double* q) {
      const double* const time = next();
      for (size_t joint = 0; joint < kJoints; ++joint)
        must_be_ok(qtraj_sample_at(rig.joints[joint], *time, &(*cursors)[joint], q + 4 * joint));
    };
  });
}

// All joints at one time, with rates.
void add_motion(const std::string& name, int32_t method) {
  const Case moved = {"rig_rates_" + name + "_f64", kKeys, kJoints};
  constexpr size_t kOmega = 4 * kJoints, kAlpha = 7 * kJoints;
  add<double>(
      moved, "ours",
      [=] {
        const Rig& rig = rig_of(method);
        return [&rig, next = NextTime(rig)](double* out) {
          must_be_ok(qtraj_sample_many(rig.joints.data(), kJoints, QTRAJ_FRAME_BODY, next(), 1, QTRAJ_LAYOUT_TIME_FIRST,
                                       out, out + kOmega, out + kAlpha, nullptr));
        };
      },
      10);
  add<double>(
      moved, "cursors",
      [=] {
        const Rig& rig = rig_of(method);
        return [&rig, next = NextTime(rig), cursors = std::make_shared<std::vector<size_t>>(kJoints)](double* out) {
          const double* const time = next();
          for (size_t joint = 0; joint < kJoints; ++joint)
            must_be_ok(qtraj_sample_rates_at(rig.joints[joint], QTRAJ_FRAME_BODY, *time, &(*cursors)[joint],
                                             out + 4 * joint, out + kOmega + 3 * joint, out + kAlpha + 3 * joint));
        };
      },
      10);
}

// All joints at many times, in both layouts; "calls" move their rows where time comes first.
void add_animation(const std::string& name, int32_t method, int32_t layout) {
  const bool is_time_first = layout == QTRAJ_LAYOUT_TIME_FIRST;
  const Case sampled = {(is_time_first ? "rig_by_time_" : "rig_") + name + "_f64", kKeys, kJoints * kTimes};
  add<double>(sampled, "ours", [=] {
    const Rig& rig = rig_of(method);
    return [&rig, layout, times = even_times(rig, kTimes)](double* q) {
      must_be_ok(qtraj_sample_many(rig.joints.data(), kJoints, QTRAJ_FRAME_BODY, times.data(), kTimes, layout, q,
                                   nullptr, nullptr, nullptr));
    };
  });
  add<double>(sampled, "calls", [=] {
    const Rig& rig = rig_of(method);
    return [&rig, is_time_first, times = even_times(rig, kTimes),
            rows = std::make_shared<std::vector<double>>(4 * kTimes)](double* q) {
      for (size_t joint = 0; joint < kJoints; ++joint) {
        double* const to = is_time_first ? rows->data() : q + 4 * kTimes * joint;
        must_be_ok(qtraj_sample(rig.joints[joint], times.data(), kTimes, to, nullptr));
        for (size_t i = 0; is_time_first && i < kTimes; ++i)
          std::memcpy(q + 4 * (kJoints * i + joint), &(*rows)[4 * i], sizeof(double[4]));
      }
    };
  });
}

}  // namespace

void add_rigs() {
  add_pose("slerp", QTRAJ_SLERP);
  add_pose("squad", QTRAJ_SQUAD);
  add_pose("rotation_spline", QTRAJ_ROTATION_SPLINE);
  add_motion("rotation_spline", QTRAJ_ROTATION_SPLINE);
  for (const int32_t layout : {QTRAJ_LAYOUT_SERIES_FIRST, QTRAJ_LAYOUT_TIME_FIRST}) {
    add_animation("slerp", QTRAJ_SLERP, layout);
    add_animation("rotation_spline", QTRAJ_ROTATION_SPLINE, layout);
  }
}

}  // namespace bench
