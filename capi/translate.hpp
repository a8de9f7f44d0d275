// What every translation needs: handles, statuses, and the argument checks that come before any work.
#pragma once

#include "qtraj.h"
#include "qtraj/options.hpp"
#include "qtraj/status.hpp"
#include "qtraj/trajectory.hpp"

struct qtraj_options {
  qtraj::Options core;
  bool on_heap;
};

struct qtraj_trajectory {
  qtraj::Trajectory core;
};

namespace qtraj::capi {

inline qtraj_status to_c(Status status) {
  switch (status) {
    case Status::ok:
      return QTRAJ_OK;
    case Status::null:
      return QTRAJ_E_NULL;
    case Status::count:
      return QTRAJ_E_COUNT;
    case Status::size:
      return QTRAJ_E_SIZE;
    case Status::option:
      return QTRAJ_E_OPTION;
    case Status::buffer:
      return QTRAJ_E_BUFFER;
    case Status::overlap:
      return QTRAJ_E_OVERLAP;
    case Status::no_memory:
      return QTRAJ_E_NO_MEMORY;
    case Status::not_finite:
      return QTRAJ_E_NOT_FINITE;
    case Status::zero_norm:
      return QTRAJ_E_ZERO_NORM;
    case Status::time_order:
      return QTRAJ_E_TIME_ORDER;
    case Status::time_range:
      return QTRAJ_E_TIME_RANGE;
    case Status::negative_weight:
      return QTRAJ_E_NEGATIVE_WEIGHT;
    case Status::not_closed:
      return QTRAJ_E_NOT_CLOSED;
    case Status::not_rotation:
      return QTRAJ_E_NOT_ROTATION;
    case Status::ambiguous:
      return QTRAJ_E_AMBIGUOUS;
    case Status::no_convergence:
      return QTRAJ_E_NO_CONVERGENCE;
  }
  return QTRAJ_E_INTERNAL;
}

// Writes bad_index, where there is one, and gives the status back.
qtraj_status report(const Outcome& outcome, size_t* bad_index);

// A caller's array: where it is and how long.
struct Array {
  const void* data;
  size_t bytes;
};
bool overlap(const Array& a, const Array& b);

// Bytes of count elements; false where they would exceed PTRDIFF_MAX.
bool array_bytes(size_t count, size_t element_bytes, size_t& bytes);

bool is_aligned(const void* memory);  // to 8 bytes

// malloc and free that leave errno alone.
void* allocate(size_t bytes);
void release(void* memory);

}  // namespace qtraj::capi
