// Software prefetch. The hardware prefetcher follows steady reads, but not across a page boundary, nor while a loop
// over a tile reads nothing new; and a store that misses the caches first reads its line, which the prefetcher notices
// late.
#pragma once

#include <cstddef>

#include "math/arithmetic.hpp"

namespace qtraj {
namespace {

constexpr size_t kCacheLine = 64;

QTRAJ_INLINE void prefetch_for_reading(const void* from, size_t bytes) {
  for (size_t at = 0; at < bytes; at += kCacheLine) __builtin_prefetch(static_cast<const char*>(from) + at);
}

QTRAJ_INLINE void prefetch_for_writing(const void* to, size_t bytes) {
#if defined(__PRFCHW__)
  for (size_t at = 0; at < bytes; at += kCacheLine) __builtin_prefetch(static_cast<const char*>(to) + at, 1);
#else
  (void)to, (void)bytes;
#endif
}

// Prefetches the kRows rows that will be written 4 KiB after `row`, if the output has that many.
template <class Real, size_t Width, size_t kRows>
QTRAJ_INLINE void prefetch_output(const Real* to, size_t row, size_t count) {
  constexpr size_t kRowsAhead = 4096 / (Width * sizeof(Real));
  if (count - row < kRowsAhead + kRows) return;
  prefetch_for_writing(to + Width * (row + kRowsAhead), Width * kRows * sizeof(Real));
}

}  // namespace
}  // namespace qtraj
