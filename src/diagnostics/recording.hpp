// All faults of a recording at once, and what is suspicious in it without being a fault.
#pragma once

#include "diagnostics/samples.hpp"

namespace qtraj {

// Which keys are at fault. not_finite, zero_norm: by the key alone, as in constructors. The others by the times of the
// keys that are left:
//   - time_order: all but the longest series of keys whose times increase as constructors want it; of several such
//     series the one whose keys come first. One wild time, ahead or back, is then one fault; of a time that is repeated
//     the first stays; where a clock was set back the longer of the two parts stays.
//   - time_span: of that series, what is too far after its first key.
// Keys without fault are what constructors take.
//
// The series is found from the last key back. chain[k] is the number of keys of the longest series that begins with key
// k; for each length, latest[length - 1] is the latest time at which one of that length begins, which decreases with
// the length, so that a search finds what can follow a key. (The classic longest increasing subsequence: C. Schensted,
// "Longest increasing and decreasing subsequences", Canad. J. Math. 13 (1961); D. Knuth, TAOCP 3, 5.1.4.) The search
// begins at the longest series: keys in order take one step each, a key at fault at most 2 log2 of the number of keys.
struct ChainMemory {
  size_t* chain;   // [count]
  double* latest;  // [count]
};

// Whether all keys that are finite and not 0 have times in order: check_keys then needs no memory.
bool times_are_in_order(const Samples& keys);

// Writes the status of every key ([count], may be null) and the report. The outcome is that of the lowest index at
// fault. memory: arrays may be null where times_are_in_order. Angles are to 0.75 eps, norms and intervals to 0.51 ulp,
// norm errors to an eps; of equal values the report has the first.
Outcome check_keys(const Samples& keys, const ChainMemory& memory, int32_t* statuses, qtraj_key_report& report);

}  // namespace qtraj
