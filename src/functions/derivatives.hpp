// Derivatives q', q'' of a unit quaternion from the rates omega, rad/s, and alpha, rad/s^2, and back, row by row.
//
// eps is DBL_EPSILON; bounds are of the absolute error of each component, to which a subnormal result adds its rounding
// error. Faults of a row, which then is NaN in both outputs: not_finite where the input is not finite or a result
// overflows, zero_norm where q is 0.
#pragma once

#include "functions/for_each_row.hpp"
#include "rows/arguments.hpp"

namespace qtraj {

// Of u = q_wb / |q_wb|: u' = u (0, omega/2) and u'' = u (-|omega|^2/4, alpha/2) in the body frame, the factors
// exchanged in the world frame (differentiate omega_body = 2 u^-1 u'). Within 1.5 eps |omega| and eps (|omega|^2 + 2
// |alpha|). Where alpha and u'' have no data, u' alone.
Outcome derivatives_from_rates(const RatesToDerivatives& rows, size_t count);

// Rates of the orientation, the curve q / |q|, from derivatives of a curve q of any norm, which need not be constant:
// with p = q' q^-1 (world) or q^-1 q' (body), omega = 2 Im p and, as p' = q'' q^-1 - p^2,
//   alpha = 2 Im(q'' q^-1 - p^2),  in the body frame 2 Im(q^-1 q'' - p^2).
// Re p = |q|'/|q| is the relative rate of the norm, the part of q' along q. It must not change the rates, which is why
// alpha is 2 Im(q'' q^-1) only where the norm is constant. Within 6 eps r and 6 eps (s + 2 r^2), r = |q'| / |q|,
// s = |q''| / |q|. Where ddq and alpha have no data, omega alone.
Outcome rates_from_derivatives(const DerivativesToRates& rows, size_t count);

}  // namespace qtraj
