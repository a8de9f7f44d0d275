// What the benchmarks' library has beside the functions of qtraj.h.
#pragma once

#include "qtraj.h"

extern "C" {

// From now on the kernel of that name, as qtraj_target reports it; 1, or 0 where this CPU or this build has none.
QTRAJ_API int qtraj_bench_force_kernel(const char* target);

// The targets that were compiled, best first; NULL past the last.
QTRAJ_API const char* qtraj_bench_target(size_t number);
}
