// The constants of the API. Their values are those of qtraj.h (capi/constants.cpp holds the two together); a caller's
// number becomes one of these types unchecked and is judged by the setters of options.hpp.
#pragma once

#include <cstdint>

namespace qtraj {

enum class Method : int32_t {
  slerp = 1,
  nlerp = 2,
  squad = 3,
  log_spline = 4,
  rotation_spline = 5,
  hermite = 6,
  rotation_quintic = 7,
  quaternion_quintic = 8
};
enum class Frame : int32_t { body = 1, world = 2 };
enum class End : int32_t {
  standard = 0,
  chord = 1,
  natural = 2,
  not_a_knot = 3,
  estimated = 4,
  given = 5,
  periodic = 6
};
enum class Tangent : int32_t { standard = 0, catmull_rom = 1, mean_velocity = 2, given = 3 };
enum class Reference : int32_t { standard = 0, first = 1, mean = 2, given = 3 };
enum class Extrapolate : int32_t { error = 0, hold = 1, constant_rate = 2, periodic = 3 };
enum class Path : int32_t { shortest = 1, as_given = 2 };

}  // namespace qtraj
