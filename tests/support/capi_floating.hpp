// What a call does to the floating-point environment and to errno.
#ifndef QTRAJ_TESTS_CAPI_FLOATING_HPP
#define QTRAJ_TESTS_CAPI_FLOATING_HPP

#include <cerrno>
#include <cfenv>
#include <cstring>
#include <limits>

namespace capi {

// Runs the call and tells what it did that the contract forbids: flags raised other than FE_INEXACT and FE_UNDERFLOW,
// a changed rounding mode, errno written, flags cleared that were set. Calls that raise nothing run again with traps
// enabled, where the processor has any, which ends the program on a fault that leaves no flag.
template <class Call>
const char* disturbance(Call&& call) {
  constexpr int kForbidden = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW, kErrno = 0x5a5a;
  const int rounding = std::fegetround();
  std::feclearexcept(FE_ALL_EXCEPT);
  errno = kErrno;
  call();
  const int raised = std::fetestexcept(kForbidden);
  const bool errno_kept = errno == kErrno;
  errno = 0;
  if (raised & FE_INVALID) return "raised FE_INVALID";
  if (raised & FE_DIVBYZERO) return "raised FE_DIVBYZERO";
  if (raised & FE_OVERFLOW) return "raised FE_OVERFLOW";
  if (!errno_kept) return "wrote errno";
  if (std::fegetround() != rounding) return "changed the rounding mode";

  std::feraiseexcept(FE_INVALID);
  call();
  if (!std::fetestexcept(FE_INVALID)) return "cleared a flag";
  std::feclearexcept(FE_ALL_EXCEPT);
#ifdef __GLIBC__
  feenableexcept(kForbidden);
  const int enabled = fegetexcept();
  call();
  const int left = fegetexcept();
  fedisableexcept(FE_ALL_EXCEPT);
  if (left != enabled) return "changed the traps";
#endif
  return "nothing";
}

// Signalling NaN: any operation on it, a conversion from float to double included, raises FE_INVALID. By bits, as
// returning one by value may already quieten it.
inline void set_signalling_nan(double& value) {
  const unsigned long long bits = 0x7ff0000000000001u;
  std::memcpy(&value, &bits, sizeof value);
}
inline void set_signalling_nan(float& value) {
  const unsigned bits = 0x7f800001u;
  std::memcpy(&value, &bits, sizeof value);
}

}  // namespace capi

#endif
