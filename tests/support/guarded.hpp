// Arrays between pages that may not be touched: a single byte read or written outside ends the program.
#ifndef QTRAJ_TESTS_GUARDED_HPP
#define QTRAJ_TESTS_GUARDED_HPP

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>

#include "support/catch.hpp"

namespace test {

// Room for `capacity` numbers, of which an array of any length takes the first or the last.
template <class Number>
class Guarded {
 public:
  explicit Guarded(size_t capacity) : page_(static_cast<size_t>(sysconf(_SC_PAGESIZE))) {
    bytes_ = (capacity * sizeof(Number) + page_ - 1) / page_ * page_;
    void* mapped = mmap(nullptr, bytes_ + 2 * page_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    REQUIRE(mapped != MAP_FAILED);
    mapped_ = static_cast<char*>(mapped);
    protect(PROT_READ | PROT_WRITE);
  }
  ~Guarded() { munmap(mapped_, bytes_ + 2 * page_); }
  Guarded(const Guarded&) = delete;
  Guarded& operator=(const Guarded&) = delete;

  // The array of `count` numbers against the guard page before it or, no better aligned than a number, behind it.
  Number* array(size_t count, bool at_end) {
    REQUIRE(count * sizeof(Number) <= bytes_);
    char* begin = mapped_ + page_;
    return reinterpret_cast<Number*>(at_end ? begin + bytes_ - count * sizeof(Number) : begin);
  }
  void fill(int byte) { std::memset(mapped_ + page_, byte, bytes_); }
  // Whether all of the room but that array still holds the byte.
  bool holds_around(const Number* array, size_t count, int byte) const {
    const auto* first = reinterpret_cast<const char*>(array);
    const char *begin = mapped_ + page_, *last = first + count * sizeof(Number);
    return holds(begin, first, byte) && holds(last, begin + bytes_, byte);
  }
  void protect(int access) { REQUIRE(mprotect(mapped_ + page_, bytes_, access) == 0); }

 private:
  // each byte equal to the next, and the first to the filling
  static bool holds(const char* from, const char* to, int byte) {
    return from == to ||
           (*from == static_cast<char>(byte) && std::memcmp(from, from + 1, static_cast<size_t>(to - from) - 1) == 0);
  }

  size_t page_, bytes_;
  char* mapped_;
};

}  // namespace test

#endif
