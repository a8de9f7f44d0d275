// More rows than an int counts, of more numbers than 32 bits do: arrays of tens of gigabytes that are one small piece
// of memory mapped again and again, but for the last piece, which has memory of its own.
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>

#include "support/capi_variants.hpp"

using namespace capi;

namespace {

constexpr size_t kPiece = size_t{1} << 26;  // bytes

class Repeated {
 public:
  explicit Repeated(size_t bytes) : pieces_((bytes + kPiece - 1) / kPiece) {
    void* mapped = mmap(nullptr, pieces_ * kPiece, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    REQUIRE(mapped != MAP_FAILED);
    begin_ = static_cast<char*>(mapped);
    const int repeated = memfd_create("repeated", 0), last = memfd_create("last", 0);
    REQUIRE((repeated >= 0 && last >= 0 && ftruncate(repeated, kPiece) == 0 && ftruncate(last, kPiece) == 0));
    for (size_t piece = 0; piece < pieces_; ++piece)
      REQUIRE(mmap(begin_ + piece * kPiece, kPiece, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED,
                   piece + 1 < pieces_ ? repeated : last, 0) != MAP_FAILED);
    close(repeated);
    close(last);
  }
  ~Repeated() { munmap(begin_, pieces_ * kPiece); }
  Repeated(const Repeated&) = delete;
  Repeated& operator=(const Repeated&) = delete;

  float* numbers() { return reinterpret_cast<float*>(begin_); }
  float* last_piece() { return reinterpret_cast<float*>(begin_ + (pieces_ - 1) * kPiece); }

 private:
  size_t pieces_;
  char* begin_;
};

constexpr size_t kCount = (size_t{1} << 31) + 1000;  // 2^33 numbers and more

TEST_CASE("C API: a fault past 2^31 rows is found at its index, and the last row is right", "[robust][huge]") {
  if (sizeof(void*) < 8) return;
  Repeated in(16 * kCount), out(16 * kCount);
  for (size_t k = 0; k < kPiece / sizeof(float); ++k) in.numbers()[k] = in.last_piece()[k] = 2.0F;
  const size_t zero = kCount - 5;
  std::fill_n(in.numbers() + 4 * zero, 4, 0.0F);
  size_t bad_index = 0;
  CHECK(qtraj_normalize_f32(in.numbers(), kCount, out.numbers(), &bad_index) == QTRAJ_E_ZERO_NORM);
  CHECK(bad_index == zero);
  CHECK(std::isnan(out.numbers()[4 * zero]));
  CHECK(out.numbers()[4 * kCount - 1] == 0.5F);
}

TEST_CASE("C API: past 2^31 samples a time is still the start and so many steps", "[robust][huge]") {
  if (sizeof(void*) < 8) return;
  const Keyframes<double> keys = closed_tour<double>(8);
  const Trajectory curve = must_build(make_options({"", QTRAJ_SLERP}).get(), keys);
  Repeated out(16 * kCount);
  const double step = (keys.times.back() - keys.times.front()) / static_cast<double>(kCount);
  size_t bad_index = 0;
  CHECK(qtraj_sample_uniform_f32(curve.get(), keys.times.front(), step, kCount, out.numbers(), &bad_index) == QTRAJ_OK);
  CHECK(bad_index == SIZE_MAX);
  float last[4];
  const double time = keys.times.front() + static_cast<double>(kCount - 1) * step;
  REQUIRE(qtraj_sample_at_f32(curve.get(), time, nullptr, last) == QTRAJ_OK);
  CHECK(std::memcmp(last, out.numbers() + 4 * (kCount - 1), sizeof last) == 0);
}

}  // namespace
