// The constants of the C API as enumerations. Their values are those of qtraj.h, so that a caller's number is cast, not
// translated; is_known checks that it is one of them.
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
  given = QTRAJ_TANGENT_GIVEN,
  rest = QTRAJ_TANGENT_REST
};
enum class Reference : int32_t {
  standard = QTRAJ_REFERENCE_DEFAULT,
  first = QTRAJ_REFERENCE_FIRST,
  mean = QTRAJ_REFERENCE_MEAN,
  given = QTRAJ_REFERENCE_GIVEN
};
enum class Extrapolate : int32_t {
  standard = QTRAJ_EXTRAPOLATE_DEFAULT,
  error = QTRAJ_EXTRAPOLATE_ERROR,
  hold = QTRAJ_EXTRAPOLATE_HOLD,
  constant_rate = QTRAJ_EXTRAPOLATE_CONSTANT_RATE,
  periodic = QTRAJ_EXTRAPOLATE_PERIODIC
};
enum class Turns : int32_t {
  standard = QTRAJ_TURNS_DEFAULT,
  shortest = QTRAJ_TURNS_SHORTEST,
  as_given = QTRAJ_TURNS_AS_GIVEN,
  from_rates = QTRAJ_TURNS_FROM_RATES,
  given = QTRAJ_TURNS_GIVEN
};
enum class Layout : int32_t { series_first = QTRAJ_LAYOUT_SERIES_FIRST, time_first = QTRAJ_LAYOUT_TIME_FIRST };
enum class Path : int32_t { shortest = QTRAJ_PATH_SHORTEST, as_given = QTRAJ_PATH_AS_GIVEN };

// The values of a family of constants are consecutive.
template <class Constant>
static constexpr bool is_between(Constant value, Constant first, Constant last) {
  return static_cast<int32_t>(value) >= static_cast<int32_t>(first) &&
         static_cast<int32_t>(value) <= static_cast<int32_t>(last);
}
static constexpr bool is_known(Frame frame) { return is_between(frame, Frame::body, Frame::world); }
static constexpr bool is_known(End end) { return end == End::standard || is_between(end, End::chord, End::periodic); }
static constexpr bool is_known(Tangent rule) {
  return rule == Tangent::standard || is_between(rule, Tangent::catmull_rom, Tangent::rest);
}
static constexpr bool is_known(Reference rule) {
  return rule == Reference::standard || is_between(rule, Reference::first, Reference::given);
}
static constexpr bool is_known(Extrapolate rule) {
  return rule == Extrapolate::standard || is_between(rule, Extrapolate::error, Extrapolate::periodic);
}
static constexpr bool is_known(Turns rule) {
  return rule == Turns::standard || is_between(rule, Turns::shortest, Turns::given);
}
static constexpr bool is_known(Layout layout) { return is_between(layout, Layout::series_first, Layout::time_first); }
static constexpr bool is_known(Path path) { return is_between(path, Path::shortest, Path::as_given); }

}  // namespace qtraj
