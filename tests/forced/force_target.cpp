// In a second libqtraj.so, of the same objects: while it is loaded it forces the kernel of QTRAJ_TEST_TARGET and says
// so, so that programs linked to the library can be run once for every kernel.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "targets/targets.hpp"

namespace {

__attribute__((constructor)) void force_target() {
  const char* target = std::getenv("QTRAJ_TEST_TARGET");
  if (!target) {
    std::fprintf(stderr, "QTRAJ_TEST_TARGET is not set\n");
    std::abort();
  }
  if (!qtraj::force_target(target) || std::strcmp(qtraj::target_name(qtraj::target()), target) != 0) {
    std::fprintf(stderr, "cannot run: %s\n", target);
    std::abort();
  }
  std::fprintf(stderr, "forced: %s\n", target);
}

}  // namespace
