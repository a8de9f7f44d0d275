// Written by generate_coefficients.py: do not edit.
//
// Polynomials c0 + c1 x + ..., c0 first. The errors are those of the rounded coefficients in exact arithmetic.
#pragma once

namespace qtraj {
// in each translation unit its own: no symbol compiled for one CPU may be shared with code for another
namespace {

// cos(sqrt y), 0 <= y <= 0.617: relative error 5.7e-20 (float 1.2e-10)
struct CosArc {
  static constexpr double kDouble[] = {
      0x1.0000000000000p+0,  -0x1.0000000000000p-1,  0x1.555555555554bp-5,  -0x1.6c16c16c15013p-10,
      0x1.a01a019c8ed07p-16, -0x1.27e4f7f141083p-22, 0x1.1ee9db8e24cbdp-29, -0x1.8fa65e87ba8d4p-37,
  };
  static constexpr float kFloat[] = {
      0x1.000000p+0f, -0x1.000000p-1f, 0x1.55554ap-5f, -0x1.6c0c28p-10f, 0x1.99e80cp-16f,
  };
};

// sin(sqrt y) / sqrt y, 0 <= y <= 0.617: relative error 3.7e-18 (float 4.0e-09)
struct SincArc {
  static constexpr double kDouble[] = {
      0x1.0000000000000p+0,  -0x1.5555555555548p-3,  0x1.111111110f730p-7,  -0x1.a01a019be9212p-13,
      0x1.71de35552aa69p-19, -0x1.ae5e4b8305162p-26, 0x1.5d8b553b0d547p-33,
  };
  static constexpr float kFloat[] = {0x1.000000p+0f, -0x1.555546p-3f, 0x1.110778p-7f, -0x1.9953fep-13f};
};

// C = cos(sqrt y), 0 <= y <= 2.468: absolute error 4.3e-18 (float 4.3e-10)
struct CosHalf {
  static constexpr double kDouble[] = {
      0x1.0000000000000p+0,   -0x1.ffffffffffffdp-2,  0x1.5555555555413p-5,
      -0x1.6c16c16c0b51cp-10, 0x1.a01a0199d97a3p-16,  -0x1.27e4f9946eb64p-22,
      0x1.1eece52e50c5bp-29,  -0x1.93520536b1269p-37, 0x1.9f455d516f8dbp-45,
  };
  static constexpr float kFloat[] = {
      0x1.000000p+0f, -0x1.000000p-1f, 0x1.555550p-5f, -0x1.6c14b8p-10f, 0x1.9f931cp-16f, -0x1.196acep-22f,
  };
};

// K = sin(sqrt y) / sqrt y, 0 <= y <= 2.468: relative error 3.0e-19 (float 6.2e-09)
struct SincHalf {
  static constexpr double kDouble[] = {
      0x1.0000000000000p+0,   -0x1.5555555555555p-3,  0x1.11111111110c8p-7,
      -0x1.a01a01a014d6fp-13, 0x1.71de3a52a0b16p-19,  -0x1.ae6454d4746f5p-26,
      0x1.6123cd0751f6cp-33,  -0x1.ae43847c4c758p-41, 0x1.8832aa914f92cp-49,
  };
  static constexpr float kFloat[] = {
      0x1.000000p+0f, -0x1.55554cp-3f, 0x1.110edap-7f, -0x1.9f70eep-13f, 0x1.5dc8c4p-19f,
  };
};

// C = cos(sqrt(6.197265625 + t)), -3.73 <= t <= 3.73: absolute error 5.8e-18 (float 2.8e-08)
struct CosFar {
  static constexpr double kDouble[] = {
      -0x1.96ec90e04da5ap-1, -0x1.f349ca7b9752cp-4,  0x1.5736a132b7742p-6,  -0x1.c86b0367670eep-11,
      0x1.237ed47d3b844p-16, -0x1.bba53349f9459p-23, 0x1.c26093653f593p-30, -0x1.476b40a5a042cp-37,
      0x1.661fa24f9c3aap-45, -0x1.319409242e503p-53, 0x1.a1a3fc0eb5444p-62, -0x1.72b4d1a73cdf8p-71,
  };
  static constexpr float kFloat[] = {
      -0x1.96ec90p-1f, -0x1.f349ccp-4f,  0x1.57369ep-6f,  -0x1.c86aaap-11f,
      0x1.237ea8p-16f, -0x1.bc4602p-23f, 0x1.c4e9b6p-30f,
  };
};

// K = sin(sqrt(6.197265625 + t)) / sqrt(6.197265625 + t), -3.73 <= t <= 3.73: absolute error 3.1e-18 (float 5.4e-09)
struct SincFar {
  static constexpr double kDouble[] = {
      0x1.f349ca7b9752cp-3,  -0x1.5736a132b7742p-4,  0x1.5650428d8d4bep-8,  -0x1.237ed47d3b7acp-13,
      0x1.1547400e37f49p-19, -0x1.51c86e8c45353p-26, 0x1.1e7dd8c68967ap-33, -0x1.661fa02f94e2bp-41,
      0x1.57c1dd1ad69cdp-49, -0x1.04c5690cdfc01p-57, 0x1.472a8ea258745p-66, -0x1.29b53c3e661a6p-71,
  };
  static constexpr float kFloat[] = {
      0x1.f349cap-3f,  -0x1.5736a2p-4f,  0x1.565044p-8f,  -0x1.237e52p-13f,
      0x1.1547c0p-19f, -0x1.52e5b8p-26f, 0x1.1b6044p-33f,
  };
};

// D = (K - C) / y, 0 <= y <= 2.468: relative error 5.5e-17 (float 3.0e-08)
struct DHalf {
  static constexpr double kDouble[] = {
      0x1.5555555555555p-2,   -0x1.111111111110fp-5,  0x1.3813813813819p-10,
      -0x1.71de3a556ce18p-16, 0x1.0cfeb60f73e0fp-22,  -0x1.08db48ae97b62p-29,
      0x1.78af152443a39p-37,  -0x1.950a852cd8d10p-45, 0x1.4c751adb4e5a4p-53,
  };
  static constexpr float kFloat[] = {
      0x1.555556p-2f, -0x1.111112p-5f, 0x1.381212p-10f, -0x1.716d12p-16f, 0x1.0018a8p-22f,
  };
};

// E = (3 D - K) / y, 0 <= y <= 2.468: relative error 1.6e-17 (float 5.2e-08)
struct EHalf {
  static constexpr double kDouble[] = {
      0x1.1111111111111p-4,  -0x1.3813813813806p-8,  0x1.1566abc010549p-13, -0x1.0cfeb60eb62f9p-19,
      0x1.4b121a701a77dp-26, -0x1.1a8330858b0a7p-33, 0x1.625fe2c721ce3p-41, -0x1.4b5bbb1f37cdep-49,
  };
  static constexpr float kFloat[] = {
      0x1.111112p-4f, -0x1.38138cp-8f, 0x1.15664ep-13f, -0x1.0cc946p-19f, 0x1.3e0e2ap-26f,
  };
};

// acos(1 - z) / sqrt(z (2 - z)), 0 <= z <= 1: relative error 5.2e-18 (float 1.2e-08)
struct AcosRatio {
  static constexpr double kDouble[] = {
      0x1.0000000000000p+0,   0x1.555555555558fp-2,  0x1.111111110b9ccp-3,   0x1.d41d41d9ee4f9p-5,
      0x1.a01a000a731dap-6,   0x1.7a46729e1e775p-7,  0x1.5d25dbf7bd6b0p-8,   0x1.4673557ca069bp-9,
      0x1.2ad06ed4e3cb2p-10,  0x1.77eab8f06dcf6p-11, -0x1.ae934b608c869p-12, 0x1.2e2247d7fbf24p-9,
      -0x1.66a8fff265a0ep-8,  0x1.6c7c2c822a616p-7,  -0x1.1f65be7a87ba0p-6,  0x1.6576fbe33f83bp-6,
      -0x1.589c5960e49c0p-6,  0x1.fa1b7c0f50735p-7,  -0x1.119a52daa8c48p-7,  0x1.9bee38abd805fp-9,
      -0x1.82c49596c862bp-11, 0x1.588aa66909052p-14,
  };
  static constexpr float kFloat[] = {
      0x1.000000p+0f, 0x1.5555bap-2f,  0x1.10f258p-3f, 0x1.da839ap-5f,  0x1.4d68f6p-6f,
      0x1.e67f82p-6f, -0x1.0f806ap-5f, 0x1.9f8db0p-5f, -0x1.0a719ep-5f, 0x1.6dafc2p-7f,
  };
};

// acos(1 - z) / sqrt(z (2 - z)), 0 <= z <= 0.5: relative error 2.6e-20 (float 1.1e-10)
struct AcosRatioNear {
  static constexpr double kDouble[] = {
      0x1.0000000000000p+0,  0x1.5555555555555p-2,   0x1.11111111111a8p-3,  0x1.d41d41d411910p-5,
      0x1.a01a01a3c6232p-6,  0x1.7a462f55db88ap-7,   0x1.5d2d2e25ca7eap-8,  0x1.45e4029d6b755p-9,
      0x1.32d623eb3303fp-10, 0x1.215a980ff6fa8p-11,  0x1.1efb418d098c5p-12, 0x1.934c733191bfap-14,
      0x1.0dc1286a199e1p-13, -0x1.55d2e32ef9280p-14, 0x1.2184de380fff9p-13, -0x1.53512c70da056p-14,
      0x1.2557b23a2c9f6p-15,
  };
  static constexpr float kFloat[] = {
      0x1.000000p+0f, 0x1.555554p-2f, 0x1.1111a8p-3f,  0x1.d3eff2p-5f, 0x1.a35c04p-6f,
      0x1.599444p-7f, 0x1.0be6b2p-7f, -0x1.07bd10p-9f, 0x1.2b09d2p-8f,
  };
};

// atan(sqrt a) / sqrt a, 0 <= a <= 0.1716: relative error 1.3e-18 (float 7.0e-10)
struct AtanRatio {
  static constexpr double kDouble[] = {
      0x1.0000000000000p+0, -0x1.555555555553dp-2, 0x1.999999999585fp-3, -0x1.24924922aced4p-3,
      0x1.c71c70e5d7553p-4, -0x1.745cf8d54132ep-4, 0x1.3b1118928baa9p-4, -0x1.10ebb1d97fad6p-4,
      0x1.df0eea83bca51p-5, -0x1.9cd0fec676002p-5, 0x1.37d122a8ce8cfp-5, -0x1.25605634fadd8p-6,
  };
  static constexpr float kFloat[] = {
      0x1.000000p+0f, -0x1.55554ap-2f, 0x1.9991e2p-3f, -0x1.23b9a0p-3f, 0x1.b22416p-4f, -0x1.f2e3b8p-5f,
  };
};

}  // namespace
}  // namespace qtraj
