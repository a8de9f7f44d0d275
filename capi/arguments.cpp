#include "arguments.hpp"

#include <cerrno>
#include <cstdlib>

namespace qtraj::capi {
namespace {

bool is_missing(const Argument& argument) { return !argument.data && argument.rows > 0 && !argument.is_optional; }

bool fits_memory(const Argument& argument) {
  size_t bytes;
  return array_bytes(argument.rows, argument.width * argument.element_bytes, bytes);
}

Bytes bytes_of(const Argument& argument) {
  return {argument.data, argument.rows * argument.width * argument.element_bytes};
}

// Two arrays whose overlap is an error: one of them is written, and they are not the same rows.
bool clash(const Argument& a, const Argument& b) {
  if (!a.is_output && !b.is_output) return false;
  const bool same_rows = a.data == b.data && a.rows == b.rows && a.width == b.width &&
                         a.element_bytes == b.element_bytes && !a.is_distinct && !b.is_distinct;
  if (same_rows && a.is_output != b.is_output) return false;
  return overlap(bytes_of(a), bytes_of(b));
}

}  // namespace

Status check(std::initializer_list<Argument> arguments, const Conditions& conditions) {
  for (const Argument& argument : arguments)
    if (is_missing(argument)) return Status::null;
  if (!conditions.enough) return Status::too_few;
  if (!conditions.counts_fit) return Status::count;
  for (const Argument& argument : arguments)
    if (!fits_memory(argument)) return Status::size;
  if (!conditions.values_known) return Status::value;
  return check_overlap(arguments);
}

Status check_overlap(std::initializer_list<Argument> arguments) {
  for (const Argument* a = arguments.begin(); a != arguments.end(); ++a)
    for (const Argument* b = a + 1; b != arguments.end(); ++b)
      if (clash(*a, *b)) return Status::overlap;
  return Status::ok;
}

bool overlap(const Bytes& a, const Bytes& b) {
  if (!a.data || !b.data || a.count == 0 || b.count == 0) return false;
  const auto a_begin = reinterpret_cast<uintptr_t>(a.data), b_begin = reinterpret_cast<uintptr_t>(b.data);
  return a_begin < b_begin ? b_begin - a_begin < a.count : a_begin - b_begin < b.count;
}

bool overlap_any(std::initializer_list<Bytes> arrays) {
  for (const Bytes* a = arrays.begin(); a != arrays.end(); ++a)
    for (const Bytes* b = a + 1; a->data && b != arrays.end(); ++b)
      if (b->data && overlap(*a, *b)) return true;
  return false;
}

bool array_bytes(size_t count, size_t element_bytes, size_t& bytes) {
  // not by a division, which would be the most expensive part of a sample of one time
  size_t product;
  if (__builtin_mul_overflow(count, element_bytes, &product) || product > PTRDIFF_MAX) return false;
  bytes = product;
  return true;
}

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
