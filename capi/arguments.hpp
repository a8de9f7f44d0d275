// Functions over arrays: their arguments, checked in the order of the contract, then the core's loop.
#pragma once

#include <initializer_list>

#include "qtraj/rows.hpp"
#include "translate.hpp"

namespace qtraj::capi {

// An array of `rows` rows; NULL is allowed without rows and where it is optional.
struct Argument {
  const void* data;
  size_t rows, width, element_bytes;
  bool is_output, is_optional;
};

template <class Element>
Argument input(const Element* data, size_t rows, size_t width) {
  return {data, rows, width, sizeof(Element), false, false};
}
template <class Element>
Argument output(Element* data, size_t rows, size_t width) {
  return {data, rows, width, sizeof(Element), true, false};
}
inline Argument optional(Argument argument) {
  argument.is_optional = true;
  return argument;
}

// An array that no other may be, even one of as many rows: as bytes it has no other's type.
inline Argument apart(Argument argument) {
  argument.width *= argument.element_bytes;
  argument.element_bytes = 1;
  return argument;
}

// Rows of an input that has a count of its own: none where the call has none.
inline size_t rows_of(size_t own_count, size_t count) { return count == 0 ? 0 : own_count; }
inline bool serves(size_t own_count, size_t count) { return own_count == 1 || own_count == count; }

// What a call needs besides its arrays.
struct Conditions {
  bool counts_fit = true;     // else COUNT
  bool options_known = true;  // else OPTION
};

// NULL, COUNT, SIZE, OPTION, OVERLAP, in this order. An output may be an input with the same rows; inputs may overlap.
Status check(std::initializer_list<Argument> arguments, const Conditions& conditions);

template <int Width, class Real>
Rows<Width> rows(const Real* data) {
  return {data, sizeof(Real) == sizeof(float)};
}
// The same where one row may serve all.
template <int Width, class Real>
Rows<Width> rows(const Real* data, size_t own_count) {
  return {data, sizeof(Real) == sizeof(float), own_count == 1};
}
template <int Width, class Real>
OutputRows<Width> output_rows(Real* data) {
  return {data, sizeof(Real) == sizeof(float)};
}

// Checks the arguments and, where they are good, calls the core.
template <class Core>
qtraj_status call(std::initializer_list<Argument> arguments, const Conditions& conditions, size_t* bad_index,
                  const Core& core) {
  if (bad_index) *bad_index = kNoIndex;
  const Status status = check(arguments, conditions);
  if (status != Status::ok) return to_c(status);
  return report(core(), bad_index);
}

}  // namespace qtraj::capi
