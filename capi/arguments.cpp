#include "arguments.hpp"

namespace qtraj::capi {
namespace {

bool is_missing(const Argument& argument) { return !argument.data && argument.rows > 0 && !argument.is_optional; }

bool fits_memory(const Argument& argument) {
  size_t bytes;
  return array_bytes(argument.rows, argument.width * argument.element_bytes, bytes);
}

// Two arrays whose overlap is an error: one of them is written, and they are not the same rows.
bool clash(const Argument& a, const Argument& b) {
  if (!a.is_output && !b.is_output) return false;
  const bool same_rows =
      a.data == b.data && a.rows == b.rows && a.width == b.width && a.element_bytes == b.element_bytes;
  if (same_rows && a.is_output != b.is_output) return false;
  return overlap({a.data, a.rows * a.width * a.element_bytes}, {b.data, b.rows * b.width * b.element_bytes});
}

}  // namespace

Status check(std::initializer_list<Argument> arguments, const Conditions& conditions) {
  for (const Argument& argument : arguments)
    if (is_missing(argument)) return Status::null;
  if (!conditions.counts_fit) return Status::count;
  for (const Argument& argument : arguments)
    if (!fits_memory(argument)) return Status::size;
  if (!conditions.options_known) return Status::option;
  for (const Argument* a = arguments.begin(); a != arguments.end(); ++a)
    for (const Argument* b = a + 1; b != arguments.end(); ++b)
      if (clash(*a, *b)) return Status::overlap;
  return Status::ok;
}

}  // namespace qtraj::capi
