#include "arguments.hpp"
#include "targets/targets.hpp"

extern "C" {

const char* qtraj_version(void) { return QTRAJ_VERSION_STRING; }

int32_t qtraj_version_number(void) { return QTRAJ_VERSION_NUMBER; }

const char* qtraj_target(void) { return qtraj::target_name(qtraj::target()); }

const char* qtraj_status_text(int32_t status) {
  switch (status) {
    case QTRAJ_OK:
      return "success";
    case QTRAJ_E_NULL:
      return "a required pointer is NULL";
    case QTRAJ_E_COUNT:
      return "too few elements, or counts that do not belong together";
    case QTRAJ_E_SIZE:
      return "an array would be larger than the address space allows";
    case QTRAJ_E_OPTION:
      return "unknown constant, or a setting, rates or limit that does not fit";
    case QTRAJ_E_BUFFER:
      return "memory is too small or not aligned to 8 bytes";
    case QTRAJ_E_OVERLAP:
      return "an output overlaps another array";
    case QTRAJ_E_NO_MEMORY:
      return "out of memory";
    case QTRAJ_E_NOT_FINITE:
      return "NaN or infinity in the input, or a result that overflows";
    case QTRAJ_E_ZERO_NORM:
      return "quaternion of norm 0, or weights that are all 0";
    case QTRAJ_E_TIME_ORDER:
      return "times do not increase strictly, or by too small a step";
    case QTRAJ_E_TIME_RANGE:
      return "time outside the knots, or a span of knots that overflows";
    case QTRAJ_E_NEGATIVE_WEIGHT:
      return "weight below 0";
    case QTRAJ_E_NOT_CLOSED:
      return "periodic, but the last key does not return to the first";
    case QTRAJ_E_NOT_ROTATION:
      return "matrix is not a rotation";
    case QTRAJ_E_AMBIGUOUS:
      return "more than one answer is equally right";
    case QTRAJ_E_NO_CONVERGENCE:
      return "no curve found, iteration limit reached, or too many pieces";
    case QTRAJ_E_INTERNAL:
      return "defect of the library, please report";
    default:
      return "unknown status";
  }
}

}  // extern "C"
