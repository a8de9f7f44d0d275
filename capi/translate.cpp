#include "translate.hpp"

#include <cerrno>
#include <cstdlib>

namespace qtraj::capi {

qtraj_status fault_to_c(Status status) {
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

qtraj_status report(const Outcome& outcome, size_t* bad_index) {
  if (bad_index) *bad_index = outcome.index;
  return to_c(outcome.status);
}

bool overlap(const Array& a, const Array& b) {
  if (!a.data || !b.data || a.bytes == 0 || b.bytes == 0) return false;
  const auto a_begin = reinterpret_cast<uintptr_t>(a.data), b_begin = reinterpret_cast<uintptr_t>(b.data);
  return a_begin < b_begin ? b_begin - a_begin < a.bytes : a_begin - b_begin < b.bytes;
}

bool array_bytes(size_t count, size_t element_bytes, size_t& bytes) {
  if (count > static_cast<size_t>(PTRDIFF_MAX) / element_bytes) return false;
  bytes = count * element_bytes;
  return true;
}

bool is_aligned(const void* memory) { return reinterpret_cast<uintptr_t>(memory) % 8 == 0; }

void* allocate(size_t bytes) {
  const int saved = errno;
  void* memory = std::malloc(bytes);
  errno = saved;
  return memory;
}

void release(void* memory) {
  const int saved = errno;
  std::free(memory);
  errno = saved;
}

}  // namespace qtraj::capi
