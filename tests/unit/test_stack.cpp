// How much stack the functions of the C API take, on every kernel: what docs/guarantees.md says of threads with small
// stacks.
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "support/painted_stack.hpp"
#include "unit/stack_calls.hpp"

using stack_calls::AllCalls;
using stack_calls::NamedCall;

namespace {

// Of builds with assertions or sanitizers nothing is promised: they inline less, and guard every array.
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
constexpr bool kIsRelease = true;
#else
constexpr bool kIsRelease = false;
#endif

TEST_CASE("one sample takes 1 kB of stack at most, all other functions 8 kB", "[stack]") {
  if (!kIsRelease) return;
  const AllCalls all;
  test::PaintedStack stack(1 << 15);
  test::for_every_kernel([&](const char* target) {
    std::map<std::string, std::pair<size_t, std::string>> worst;
    for (const NamedCall& call : all.calls) {
      const size_t use = stack.use_of(call.call);
      auto& largest = worst[call.group];
      if (use > largest.first) largest = {use, call.name};
      const size_t limit = std::strcmp(call.group, "one sample") == 0 ? 1024 : 8192;
      if (use > limit) FAIL_CHECK(call.group << ", " << call.name << ": " << use << " bytes");
    }
    if (std::getenv("QTRAJ_TEST_STACK_TABLE"))
      for (const auto& group : worst)
        std::printf("%-14s %-20s %6zu  %s\n", target, group.first.c_str(), group.second.first,
                    group.second.second.c_str());
  });
}

TEST_CASE("threads with the smallest stack there is run every function and leave their neighbour's memory alone",
          "[stack]") {
  if (!kIsRelease) return;
  const AllCalls all;
  test::PaintedStack stack(static_cast<size_t>(PTHREAD_STACK_MIN));
  test::for_every_kernel([&](const char*) {
    for (const NamedCall& call : all.calls) {
      if (!stack.holds(call.call)) FAIL_CHECK(call.group << ", " << call.name);
    }
  });
}

}  // namespace
