// fuzz [seconds [first case]]: random calls of all functions of the C API with arguments that are ordinary, extreme or
// faulty, the same on every kernel that runs here. A case is its number: a fault is told with it, and
// "fuzz 0 NUMBER" runs that case alone. Exits with 1 where there was a fault.
#include "fuzz.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "support/forced_kernel.hpp"

namespace fuzz {
namespace {

uint64_t current_case = 0;
const char* current_target = "";
int faults = 0;

}  // namespace

void report_fault(const char* function, const std::string& what) {
  if (++faults <= 20)
    std::printf("case %llu, %s, %s: %s\n", static_cast<unsigned long long>(current_case), current_target, function,
                what.c_str());
}

Rooms& Rooms::all() {
  static Rooms rooms;
  return rooms;
}

unsigned char* Rooms::take(size_t bytes, bool at_end) {
  const auto page = static_cast<size_t>(sysconf(_SC_PAGESIZE));
  if (bytes > kBytes) std::abort();
  if (used_ == rooms_.size()) {
    void* mapped = mmap(nullptr, kBytes + 2 * page, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED) std::abort();
    unsigned char* const begin = static_cast<unsigned char*>(mapped) + page;
    if (mprotect(begin, kBytes, PROT_READ | PROT_WRITE) != 0) std::abort();
    std::memset(begin, kPattern, kBytes);
    rooms_.push_back({begin, 0, 0});
  }
  Room& room = rooms_[used_++];
  std::memset(room.begin + room.offset, kPattern, room.bytes);  // what it held before
  room.offset = at_end ? kBytes - bytes : 0;
  room.bytes = bytes;
  return room.begin + room.offset;
}

bool Rooms::are_intact() const {
  const auto holds = [](const unsigned char* begin, size_t bytes) {
    return bytes == 0 || (*begin == kPattern && std::memcmp(begin, begin + 1, bytes - 1) == 0);
  };
  // as far as a vector reaches; further off there are pages that may not be touched
  constexpr size_t kZone = 512;
  for (size_t i = 0; i < used_; ++i) {
    const Room& room = rooms_[i];
    const size_t end = room.offset + room.bytes, before = room.offset < kZone ? room.offset : kZone,
                 after = kBytes - end < kZone ? kBytes - end : kZone;
    if (!holds(room.begin + room.offset - before, before) || !holds(room.begin + end, after)) return false;
  }
  return true;
}

namespace {

void run_case(uint64_t number) {
  current_case = number;
  uint64_t everywhere = 0, of_kind[2] = {0, 0};
  for (const char* name : test::target_names()) {
    const test::ForcedKernel kernel(name);
    if (!kernel.runs_here()) continue;
    current_target = name;
    Source source(number * 0xd1342543de82ef95u);
    Rooms::all().clear();
    Digests digests;
    if (source.one_in(10))
      fuzz_batch(source, digests);
    else if (source.one_in(3))
      fuzz_vectors(source, digests);
    else
      source.one_in(2) ? fuzz_curve(source, digests) : fuzz_arrays(source, digests);
    uint64_t& kind = of_kind[kernel.is_fused() ? 1 : 0];
    check(everywhere == 0 || everywhere == digests.everywhere.value(), "kernels",
          "differ in what is the same everywhere");
    check(kind == 0 || kind == digests.of_kind.value(), "kernels", "of one kind differ");
    everywhere = digests.everywhere.value();
    kind = digests.of_kind.value();
  }
}

}  // namespace
}  // namespace fuzz

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 2.0;
  const uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  uint64_t number = first;
  const std::clock_t start = std::clock();
  do fuzz::run_case(number++);
  while (static_cast<double>(std::clock() - start) < seconds * CLOCKS_PER_SEC);
  std::printf("cases %llu to %llu, %d faults\n", static_cast<unsigned long long>(first),
              static_cast<unsigned long long>(number - 1), fuzz::faults);
  return fuzz::faults == 0 ? 0 : 1;
}
