#include "translate.hpp"

#include <cerrno>
#include <cstdlib>

namespace qtraj::capi {

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
