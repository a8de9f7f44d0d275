#include "targets/targets.hpp"

#include <cstring>

namespace qtraj {
namespace {

struct Row {
  const char* name;
  bool (*runs_here)();
};
#define QTRAJ_ROW(name, arithmetic, runs_here, unused) {#name " " #arithmetic, [] { return runs_here; }},
constexpr Row kRows[] = {QTRAJ_EACH_TARGET(QTRAJ_ROW, )};
#undef QTRAJ_ROW

}  // namespace

std::atomic<size_t> target_in_use{kTargetCount};

const char* target_name(size_t target) { return kRows[target].name; }

namespace {

// Without it __builtin_cpu_supports says no to everything until a constructor of the compiler's library has run, which
// those of a program, and what it has in .preinit_array, may come before. Repeated calls do nothing.
void look_at_processor() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_cpu_init();
#endif
}

}  // namespace

size_t choose_target() {
  look_at_processor();
  size_t best = 0;
  while (!kRows[best].runs_here()) ++best;  // ends: the last one, scalar, always runs
  target_in_use.store(best, std::memory_order_relaxed);
  return best;
}

bool force_target(const char* name) {
  look_at_processor();
  for (size_t k = 0; k < kTargetCount; ++k) {
    if ((name && std::strcmp(kRows[k].name, name) != 0) || !kRows[k].runs_here()) continue;
    target_in_use.store(k, std::memory_order_relaxed);
    return true;
  }
  return false;
}

}  // namespace qtraj
