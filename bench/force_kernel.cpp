#include "force_kernel.hpp"

#include "targets/targets.hpp"

int qtraj_bench_force_kernel(const char* target) { return qtraj::force_target(target) ? 1 : 0; }

const char* qtraj_bench_target(size_t number) {
  return number < qtraj::kTargetCount ? qtraj::target_name(number) : nullptr;
}
