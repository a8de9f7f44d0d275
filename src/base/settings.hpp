// The constants of the C API as enumerations. Their values are those of qtraj.h, so that a caller's number is cast, not
// translated. The setters (methods/options.hpp) and is_known below check that it is a known one.
#pragma once

#include "qtraj.h"

namespace qtraj {

// No enumerators: only the table of methods (methods/method.cpp) tells the methods apart.
enum class Method : int32_t {};

enum class Frame : int32_t { body = QTRAJ_FRAME_BODY, world = QTRAJ_FRAME_WORLD };
enum class End : int32_t {
  standard = QTRAJ_END_DEFAULT,
  chord = QTRAJ_END_CHORD,
  natural = QTRAJ_END_NATURAL,
  not_a_knot = QTRAJ_END_NOT_A_KNOT,
  estimated = QTRAJ_END_ESTIMATED,
  given = QTRAJ_END_GIVEN,
  periodic = QTRAJ_END_PERIODIC
};
enum class Tangent : int32_t {
  standard = QTRAJ_TANGENT_DEFAULT,
  catmull_rom = QTRAJ_TANGENT_CATMULL_ROM,
  mean_velocity = QTRAJ_TANGENT_MEAN_VELOCITY,
  given = QTRAJ_TANGENT_GIVEN
};
enum class Reference : int32_t {
  standard = QTRAJ_REFERENCE_DEFAULT,
  first = QTRAJ_REFERENCE_FIRST,
  mean = QTRAJ_REFERENCE_MEAN,
  given = QTRAJ_REFERENCE_GIVEN
};
enum class Extrapolate : int32_t {
  error = QTRAJ_EXTRAPOLATE_ERROR,
  hold = QTRAJ_EXTRAPOLATE_HOLD,
  constant_rate = QTRAJ_EXTRAPOLATE_CONSTANT_RATE,
  periodic = QTRAJ_EXTRAPOLATE_PERIODIC
};
enum class Path : int32_t { shortest = QTRAJ_PATH_SHORTEST, as_given = QTRAJ_PATH_AS_GIVEN };

static constexpr bool is_known(Frame frame) { return frame == Frame::body || frame == Frame::world; }
static constexpr bool is_known(Path path) { return path == Path::shortest || path == Path::as_given; }

}  // namespace qtraj
