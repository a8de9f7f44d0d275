// Segments, one plain record per interval between two knots: builders write them and kernels sample them.
//
// Four shapes carry all methods; with two of them in two degrees that makes six kinds. A record holds nothing but
// numbers: double as builders write it and handles keep it, or the Number that a kernel computes with, such as vectors
// of the same field of several segments. Kernels include this header: plain data only.
#pragma once

#include <cstddef>

namespace qtraj {

enum class SegmentKind {
  arc,                      // SLERP
  rotation_vector,          // LOG_SPLINE, ROTATION_SPLINE, HERMITE: cubics
  rotation_vector_quintic,  // ROTATION_QUINTIC
  nested_arcs,              // SQUAD
  normalized,               // NLERP
  normalized_quintic,       // QUATERNION_QUINTIC; QUATERNION_HERMITE: a cubic, c[4] = c[5] = 0
};

// Great circle q = m cos x + e sin x, x = (t - t_i) rate - half_angle. m is the middle of the arc and e the direction
// there: unit, orthogonal; e = 0 where the arc is a point.
template <class Value>
struct ArcSegmentOf {
  Value rate;        // d x / d t, rad/s on S^3
  Value half_angle;  // of the arc on S^3, rad
  Value m[4], e[4];
};
using ArcSegment = ArcSegmentOf<double>;

// q = base exp(p(s)), s = (t - t_i) scale - 1 in [-1, 1], p = c[0] + c[1] s + ... the half-angle vector. The polynomial
// is expanded about the middle: monomials in (t - t_i)/h would lose up to 7 times as much to cancellation.
template <size_t Degree, class Value = double>
struct RotationVectorSegment {
  Value scale;  // 2/h
  Value base[4];
  Value c[Degree + 1][3];
};

// q = slerp(outer(u), inner(u); 2u(1 - u)): two arcs over the same interval, between the keys and between the controls.
template <class Value>
struct NestedArcsSegmentOf {
  struct Arc {
    Value half_angle;
    Value m[4], e[4];
  };
  Value scale;  // 2/h
  Value near;   // 1 where the arcs are never more than pi/3 apart and the inner one is at most a quarter turn, else 0
  Arc keys, controls;
  // For the rates: Im(P* C) of points on the two arcs is the sum of these times cos cos, cos sin, sin cos, sin sin of
  // their angles. The first, Im(m_keys* m_controls), is stored because on short arcs it is far below the rounding
  // errors of its factors.
  Value relative[4][3];
};
using NestedArcsSegment = NestedArcsSegmentOf<double>;

// q = p(s)/|p(s)|, p = c[0] + c[1] s + ... in R^4.
template <size_t Degree, class Value = double>
struct NormalizedSegment {
  Value scale;  // 2/h
  Value c[Degree + 1][4];
};

// Largest |p| of rotation-vector segments: how far the kernels must reduce it. `any` also says that coefficients, of
// these and of normalised segments, may be past the range of float: such curves are always evaluated in double.
enum class ExponentRange { quarter_turn, half_turn, full_turn, any };  // |p| <= pi/2, pi, 2 pi

}  // namespace qtraj
