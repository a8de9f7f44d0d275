// Calls in a thread whose stack is ours: how much of it they use, and whether they stay on it.
#ifndef QTRAJ_TESTS_PAINTED_STACK_HPP
#define QTRAJ_TESTS_PAINTED_STACK_HPP

#include <pthread.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstring>
#include <functional>

#include "support/catch.hpp"

namespace test {

using Call = std::function<void()>;

// A thread's stack above a guard page, and below that page memory of a neighbour. Both are painted, the stack before
// each call, so that what was written shows.
class PaintedStack {
 public:
  explicit PaintedStack(size_t bytes) : bytes_(bytes) {
    void* const memory =
        mmap(nullptr, kNeighbour + kGuard + bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    REQUIRE(memory != MAP_FAILED);
    neighbour_ = static_cast<unsigned char*>(memory);
    REQUIRE(mprotect(neighbour_ + kNeighbour, kGuard, PROT_NONE) == 0);
    std::memset(neighbour_, kPaint, kNeighbour);
    const Call nothing = [] {};
    touched(nothing);
    idle_ = touched(nothing);
  }
  ~PaintedStack() { munmap(neighbour_, kNeighbour + kGuard + bytes_); }
  PaintedStack(const PaintedStack&) = delete;
  PaintedStack& operator=(const PaintedStack&) = delete;

  // Bytes of the stack that the call wrote to, beyond what a thread takes that does nothing. The call was made before:
  // the first one of a function goes through the dynamic linker, which has a stack use of its own.
  size_t use_of(const Call& call) {
    call();
    return touched(call) - idle_;
  }

  // Whether a call leaves the neighbour's memory alone. Where it meets the guard page, the process ends.
  bool holds(const Call& call) {
    touched(call);
    return neighbour_[0] == kPaint && std::memcmp(neighbour_, neighbour_ + 1, kNeighbour - 1) == 0;
  }

 private:
  static constexpr size_t kNeighbour = 1 << 16, kGuard = 4096;
  static constexpr unsigned char kPaint = 0x5a;

  unsigned char* stack() const { return neighbour_ + kNeighbour + kGuard; }

  size_t touched(const Call& call) {
    std::memset(stack(), kPaint, bytes_);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    REQUIRE(pthread_attr_setstack(&attributes, stack(), bytes_) == 0);
    pthread_t thread;
    const auto run = [](void* argument) -> void* {
      (*static_cast<const Call*>(argument))();
      return nullptr;
    };
    REQUIRE(pthread_create(&thread, &attributes, run, const_cast<Call*>(&call)) == 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    return static_cast<size_t>(stack() + bytes_ -
                               std::find_if(stack(), stack() + bytes_, [](unsigned char b) { return b != kPaint; }));
  }

  const size_t bytes_;
  unsigned char* neighbour_;
  size_t idle_;  // bytes that a thread touches that does nothing
};

}  // namespace test

#endif
