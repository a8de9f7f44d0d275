#include "force_kernel.hpp"

#include "kernel/kernel.hpp"

int qtraj_bench_force_kernel(const char* target) { return qtraj::force_kernel(target) ? 1 : 0; }
