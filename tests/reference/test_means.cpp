// Means against values computed at 60 digits.
#include <fstream>
#include <sstream>
#include <string>

#include "support/capi_handles.hpp"
#include "support/capi_means.hpp"
#include "support/catch.hpp"

namespace {

struct MeanSet {
  std::string name;
  capi::Samples<double> samples;
  std::array<double, 4> eigen, karcher;  // first component that is not 0 positive
};

std::vector<MeanSet> read_sets() {
  std::ifstream stream(QTRAJ_REFERENCE_DIR "/means.txt");
  REQUIRE(stream.is_open());
  std::vector<MeanSet> sets;
  std::string line, word;
  const auto next = [&] {
    REQUIRE(std::getline(stream, line));
    return std::istringstream(line);
  };
  while (std::getline(stream, line)) {
    if (line.empty() || line[0] == '#') continue;
    MeanSet set{};
    size_t count = 0;
    REQUIRE((std::istringstream(line) >> word >> set.name >> count && word == "set"));
    for (size_t i = 0; i < count; ++i) {
      double weight = 0;
      test::Quaternion q{};
      REQUIRE(next() >> weight >> q[0] >> q[1] >> q[2] >> q[3]);
      set.samples.add(q, weight);
    }
    for (auto* mean : {&set.eigen, &set.karcher}) {
      auto& m = *mean;
      REQUIRE(next() >> word >> m[0] >> m[1] >> m[2] >> m[3]);
      CHECK(word == (mean == &set.eigen ? "eigen" : "karcher"));
    }
    sets.push_back(set);
  }
  return sets;
}

}  // namespace

TEST_CASE("means agree with 60-digit values", "[vectors][means]") {
  const std::vector<MeanSet> sets = read_sets();
  CHECK(sets.size() == 6);
  for (const MeanSet& set : sets) {
    CAPTURE(set.name);
    const capi::Mean<double> eigen = capi::eigen(set.samples), karcher = capi::karcher(set.samples);
    CHECK((eigen.status == QTRAJ_OK && karcher.status == QTRAJ_OK));
    CHECK(capi::difference(eigen.q, set.eigen) <= 1e-15);
    CHECK(capi::difference(karcher.q, set.karcher) <= 1e-15);

    capi::Samples<float> rounded;
    for (size_t i = 0; i < set.samples.count(); ++i)
      rounded.add({set.samples.q[4 * i], set.samples.q[4 * i + 1], set.samples.q[4 * i + 2], set.samples.q[4 * i + 3]},
                  set.samples.weight(i));
    CHECK(capi::difference(capi::eigen(rounded).q, set.eigen) <= 1e-7);
    CHECK(capi::difference(capi::karcher(rounded).q, set.karcher) <= 1e-7);
  }
}
