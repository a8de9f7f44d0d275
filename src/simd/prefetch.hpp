// Memory asked for ahead of its use. Processors do so themselves for steady reading, but not beyond a page, nor while a
// loop over a block does not read; and a store outside the caches first reads its line, which they see late.
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

// Of the rows that are written 4 KiB after `row`, where there are as many.
template <class Real, size_t Width, size_t kRows>
QTRAJ_INLINE void prefetch_output(const Real* to, size_t row, size_t count) {
  constexpr size_t kRowsAhead = 4096 / (Width * sizeof(Real));
  if (count - row < kRowsAhead + kRows) return;
  prefetch_for_writing(to + Width * (row + kRowsAhead), Width * kRows * sizeof(Real));
}

}  // namespace
}  // namespace qtraj
