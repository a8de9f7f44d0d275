// qtraj_bench [--target=NAME] [--large] [--list-targets] and the options of Google Benchmark.
//
// --target        forces a kernel, "avx2 fused"; without it the one for this CPU is measured
// --large         M = 1e8 too; needs 4 GB
// --list-targets  prints the kernels that run here, best first, and ends
#include <cstdio>
#include <cstring>

#include "force_kernel.hpp"
#include "support.hpp"

namespace {

// Takes our own options out of argv; false where the program shall end, with that exit code.
bool take_options(int& argc, char** argv, bench::Settings& settings, int& exit_code) {
  int left = 1;
  for (int i = 1; i < argc; ++i) {
    const char* const option = argv[i];
    if (std::strcmp(option, "--large") == 0) {
      settings.large = true;
    } else if (std::strcmp(option, "--list-targets") == 0) {
      for (size_t k = 0; const char* const target = qtraj_bench_target(k); ++k)
        if (qtraj_bench_force_kernel(target)) std::puts(target);
      return false;
    } else if (std::strncmp(option, "--target=", 9) == 0) {
      if (!qtraj_bench_force_kernel(option + 9)) {
        std::fprintf(stderr, "bench: this CPU or this build has no kernel \"%s\"\n", option + 9);
        exit_code = 1;
        return false;
      }
    } else {
      argv[left++] = argv[i];
    }
  }
  argc = left;
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  bench::Settings settings = {false};
  int exit_code = 0;
  if (!take_options(argc, argv, settings, exit_code)) return exit_code;

  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::AddCustomContext("qtraj_target", qtraj_target());
  benchmark::AddCustomContext("qtraj_version", qtraj_version());

  bench::add_slerp(settings);
  bench::add_squad();
  bench::add_splines();
  bench::add_pairs();
  bench::add_means();
  bench::add_single();
  bench::add_rigs();
  bench::add_tables();
  bench::add_construction();
  bench::add_vectors();
  bench::add_batches();
  bench::add_few_keys();
  bench::add_functions();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
