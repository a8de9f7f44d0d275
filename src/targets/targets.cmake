# The one list of targets: instruction sets that kernels are compiled for beside scalar code, best first: the first that
# the processor can run is used. The last fused one lends its flags to fused scalar code, so it must need no feature that
# another fused one of its processor lacks.
#
# qtraj_target(name processor arithmetic highway FEATURES what the processor must have FLAGS more compiler flags)
#   name        as qtraj_target() reports it, "name arithmetic"; its functions are in the namespace qtraj::name
#   arithmetic  fused where a multiply-add rounds once: all fused targets give the same bits, and all plain ones
#   highway     its name in Highway, which must agree with the flags
#   FEATURES    as __builtin_cpu_supports names them, and the compiler after -m
set(qtraj_known_targets)
macro(qtraj_target name processor arithmetic highway)
  cmake_parse_arguments(row "" "" "FEATURES;FLAGS" ${ARGN})
  list(APPEND qtraj_known_targets ${name})
  set(qtraj_${name}_processor ${processor})
  set(qtraj_${name}_arithmetic ${arithmetic})
  set(qtraj_${name}_highway ${highway})
  set(qtraj_${name}_features ${row_FEATURES})
  set(qtraj_${name}_flags ${row_FLAGS})
  foreach(feature IN LISTS row_FEATURES)
    list(APPEND qtraj_${name}_flags -m${feature})
  endforeach()
endmacro()

# popcnt: compilers take it to come with SSE4.2 and AVX2. Processors without prefetchw (-mprfchw) execute it as a no-op,
# therefore it is a flag and not a feature.
qtraj_target(avx512 x86_64 fused HWY_AVX3
             FEATURES avx512f avx512bw avx512cd avx512dq avx512vl avx2 fma bmi bmi2 popcnt FLAGS -mprfchw)
qtraj_target(avx2 x86_64 fused HWY_AVX2 FEATURES avx2 fma bmi bmi2 popcnt FLAGS -mprfchw)
qtraj_target(sse4 x86_64 plain HWY_SSE4 FEATURES sse4.2 popcnt)
# Highway declares its NEON functions for processors with AES. No instruction of it is used, and compilers emit none.
qtraj_target(neon aarch64 fused HWY_NEON FLAGS -march=armv8-a+crypto)
