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

qtraj_status fault_to_c(Status status);
inline qtraj_status to_c(Status status) { return status == Status::ok ? QTRAJ_OK : fault_to_c(status); }

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
