// What every translation needs: handles, and the checks of arguments that come before any work.
#pragma once

#include <initializer_list>

#include "base/array.hpp"
#include "base/status.hpp"
#include "curve/trajectory.hpp"
#include "curve/vector_curve.hpp"
#include "methods/options.hpp"
#include "qtraj.h"

struct qtraj_options {
  uint64_t tag;
  qtraj::Options core;
  bool on_heap;
};

struct qtraj_trajectory {
  qtraj::Trajectory core;  // begins with its tag
};

struct qtraj_vector_curve {
  qtraj::VectorCurve core;  // the same
};

namespace qtraj::capi {

// ---- Handles ----

// The first word of options, of methods of trajectories and of vector curves; those of the curves are
// Trajectory::kTag and VectorCurve::kTag. All are cleared on destroy.
constexpr uint64_t kOptionsTag = 0x74706f6a61727471;        // "qtrajopt"
constexpr uint64_t kVectorOptionsTag = 0x74766f6a61727471;  // "qtrajovt"

// To 8 bytes. Inline: a sample of one time asks for it.
inline bool is_aligned(const void* memory) { return reinterpret_cast<uintptr_t>(memory) % 8 == 0; }

// Whether the memory begins with a tag: what else a wrong handle points to is not looked at.
template <class Handle>
Status check_handle(const Handle* handle, uint64_t tag) {
  if (!handle) return Status::null;
  return is_aligned(handle) && *reinterpret_cast<const uint64_t*>(handle) == tag ? Status::ok : Status::handle;
}
inline Status check_handle(const qtraj_trajectory* trajectory) { return check_handle(trajectory, Trajectory::kTag); }
inline Status check_handle(const qtraj_vector_curve* curve) { return check_handle(curve, VectorCurve::kTag); }
inline Status check_handle(const qtraj_options* options) { return check_handle(options, kOptionsTag); }
inline Status check_vector_options(const qtraj_options* options) { return check_handle(options, kVectorOptionsTag); }
inline Status check_any_options(const qtraj_options* options) {
  return check_handle(options) == Status::ok ? Status::ok : check_vector_options(options);
}

// Clears the tag for good: a plain store before free() is one that compilers drop.
inline void clear_tag(void* handle) { *static_cast<volatile uint64_t*>(handle) = 0; }

// The core's statuses are those of qtraj.h.
inline qtraj_status to_c(Status status) { return static_cast<qtraj_status>(status); }

// Writes bad_index, where there is one, and gives the status back.
inline qtraj_status report(const Outcome& outcome, size_t* bad_index) {
  if (bad_index) *bad_index = outcome.index;
  return to_c(outcome.status);
}

// ---- Arrays ----

// An array of the caller as the checks see it: where it is, how long, and what may be done with it.
struct Argument {
  const void* data;
  size_t rows, width, element_bytes;
  bool is_output = false;
  bool is_optional = false;  // may be NULL
  bool is_distinct = false;  // may be no other array, even one of the same rows

  template <size_t Width>
  Argument(const Input<Width>& array)  // NOLINT(google-explicit-constructor)
      : data(array.data), rows(array.rows), width(Width), element_bytes(array.is_float ? 4 : 8) {}
  template <size_t Width>
  Argument(const Output<Width>& array)  // NOLINT(google-explicit-constructor)
      : data(array.data), rows(array.rows), width(Width), element_bytes(array.is_float ? 4 : 8), is_output(true) {}
  Argument(const void* at, size_t row_count, size_t row_width, size_t bytes_each, bool is_written)
      : data(at), rows(row_count), width(row_width), element_bytes(bytes_each), is_output(is_written) {}
};
// `count` results of a type that is none of the core's arrays.
template <class Element>
Argument result(Element* data, size_t count) {
  return {data, count, 1, sizeof(Element), true};
}
inline Argument optional(Argument argument) {
  argument.is_optional = true;
  return argument;
}
inline Argument distinct(Argument argument) {
  argument.is_distinct = true;
  return argument;
}

// Rows of an input that has a count of its own: none where the call has none.
inline size_t rows_of(size_t own_count, size_t count) { return count == 0 ? 0 : own_count; }
inline bool is_one_or(size_t count, size_t own_count) { return own_count == 1 || own_count == count; }

// What a call needs besides its arrays.
struct Conditions {
  bool counts_fit = true;    // else COUNT
  bool values_known = true;  // else VALUE
  bool enough = true;        // else TOO_FEW
};
inline Conditions at_least(size_t least, size_t count, bool values_known = true) {
  return {true, values_known, count >= least};
}

// NULL, TOO_FEW, COUNT, SIZE, VALUE, OVERLAP, in this order. NULL is allowed without rows and where it is optional. An
// output may be an input with the same rows; inputs may overlap.
Status check(std::initializer_list<Argument> arguments, const Conditions& conditions);
// OVERLAP alone, where other statuses come before it.
Status check_overlap(std::initializer_list<Argument> arguments);

// Checks the arguments and, where they are good, calls the core.
template <class Core>
qtraj_status call(std::initializer_list<Argument> arguments, const Conditions& conditions, size_t* bad_index,
                  const Core& core) {
  if (bad_index) *bad_index = kNoIndex;
  const Status status = check(arguments, conditions);
  if (status != Status::ok) return to_c(status);
  return report(core(), bad_index);
}

// ---- Memory ----

struct Bytes {
  const void* data;
  size_t count;
};
bool overlap(const Bytes& a, const Bytes& b);
// Whether any two of them do.
bool overlap_any(std::initializer_list<Bytes> arrays);

// Bytes of count elements; false where they would exceed PTRDIFF_MAX.
bool array_bytes(size_t count, size_t element_bytes, size_t& bytes);

// malloc and free that leave errno alone.
void* allocate(size_t bytes);
void release(void* memory);

}  // namespace qtraj::capi
