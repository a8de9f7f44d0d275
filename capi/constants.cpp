// The core's constants and those of qtraj.h are one: numbers pass between them without translation.
#include "qtraj.h"
#include "qtraj/settings.hpp"

namespace qtraj {
namespace {

template <class Core>
constexpr bool same(Core core, int value) {
  return static_cast<int>(core) == value;
}

static_assert(same(Method::slerp, QTRAJ_SLERP) && same(Method::nlerp, QTRAJ_NLERP) &&
              same(Method::squad, QTRAJ_SQUAD) && same(Method::log_spline, QTRAJ_LOG_SPLINE) &&
              same(Method::rotation_spline, QTRAJ_ROTATION_SPLINE) && same(Method::hermite, QTRAJ_HERMITE) &&
              same(Method::rotation_quintic, QTRAJ_ROTATION_QUINTIC) &&
              same(Method::quaternion_quintic, QTRAJ_QUATERNION_QUINTIC));
static_assert(same(Frame::body, QTRAJ_FRAME_BODY) && same(Frame::world, QTRAJ_FRAME_WORLD));
static_assert(same(End::standard, QTRAJ_END_DEFAULT) && same(End::chord, QTRAJ_END_CHORD) &&
              same(End::natural, QTRAJ_END_NATURAL) && same(End::not_a_knot, QTRAJ_END_NOT_A_KNOT) &&
              same(End::estimated, QTRAJ_END_ESTIMATED) && same(End::given, QTRAJ_END_GIVEN) &&
              same(End::periodic, QTRAJ_END_PERIODIC));
static_assert(same(Tangent::standard, QTRAJ_TANGENT_DEFAULT) && same(Tangent::catmull_rom, QTRAJ_TANGENT_CATMULL_ROM) &&
              same(Tangent::mean_velocity, QTRAJ_TANGENT_MEAN_VELOCITY) && same(Tangent::given, QTRAJ_TANGENT_GIVEN));
static_assert(same(Reference::standard, QTRAJ_REFERENCE_DEFAULT) && same(Reference::first, QTRAJ_REFERENCE_FIRST) &&
              same(Reference::mean, QTRAJ_REFERENCE_MEAN) && same(Reference::given, QTRAJ_REFERENCE_GIVEN));
static_assert(same(Extrapolate::error, QTRAJ_EXTRAPOLATE_ERROR) && same(Extrapolate::hold, QTRAJ_EXTRAPOLATE_HOLD) &&
              same(Extrapolate::constant_rate, QTRAJ_EXTRAPOLATE_CONSTANT_RATE) &&
              same(Extrapolate::periodic, QTRAJ_EXTRAPOLATE_PERIODIC));
static_assert(same(Path::shortest, QTRAJ_PATH_SHORTEST) && same(Path::as_given, QTRAJ_PATH_AS_GIVEN));

}  // namespace
}  // namespace qtraj
