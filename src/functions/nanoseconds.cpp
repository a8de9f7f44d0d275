#include "functions/nanoseconds.hpp"

#include "targets/kernels.hpp"

namespace qtraj {
namespace {

constexpr uint64_t kPerSecond = 1000000000;

// ns / 10^9 for 2^53 <= ns, where ns itself is no double: by whole numbers.
double rounded_quotient(uint64_t ns) {
  // 54 bits of the quotient: those of its integer part, 24 to 35, and as many behind the point as are missing. The
  // remainder, below 2^30, shifted by up to 30 bits stays below 2^60.
  const uint64_t whole = ns / kPerSecond, remainder = ns % kPerSecond;
  int shift = 19;  // of 35 bits
  while (whole >> (53 - shift) == 0) ++shift;
  const uint64_t shifted = remainder << shift;
  const uint64_t bits = (whole << shift) + shifted / kPerSecond;
  // The last bit is half a unit of the 53 that stay. It is no tie: behind the point a quotient by 2^9 5^9 either ends
  // within 9 bits, before this one, or never.
  const uint64_t rounded = (bits >> 1) + (bits & 1);
  return static_cast<double>(rounded) / static_cast<double>(uint64_t{1} << (shift - 1));
}

constexpr RowKernel<NanosecondRows> kNanosecondKernels[] = QTRAJ_OF_EACH_TARGET(seconds_from_ns);

double seconds_of(uint64_t ns) {
  // both exact, so that the division rounds once
  if (ns <= uint64_t{1} << 53) return static_cast<double>(ns) / static_cast<double>(kPerSecond);
  return rounded_quotient(ns);
}

}  // namespace

void seconds_from_ns(const int64_t* ns, size_t count, int64_t origin, double* seconds) {
  // differences of unsigned numbers are exact modulo 2^64, and the magnitude is below that
  const auto from = static_cast<uint64_t>(origin);
  const NanosecondRows rows = {ns, origin, seconds};
  for (size_t i = 0; i < count; ++i) {
    i += kNanosecondKernels[target()](rows, i, count);
    if (i == count) break;
    const int64_t stamp = ns[i];
    const auto to = static_cast<uint64_t>(stamp);
    seconds[i] = stamp < origin ? -seconds_of(from - to) : seconds_of(to - from);
  }
}

}  // namespace qtraj
