// Reader of the reference vectors; the format is in reference/vectors/README.md.
#ifndef QTRAJ_TESTS_VECTOR_FILE_HPP
#define QTRAJ_TESTS_VECTOR_FILE_HPP

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/random.hpp"

namespace test {

struct VectorFile {
  std::string name, method;
  std::map<std::string, std::vector<std::string>> options;
  Keys keys;
  std::vector<double> omega_world, alpha_world;  // given at the keys
  struct Sample {
    double time;
    Quaternion q;
    Vector omega_world, alpha_world;
  };
  std::vector<Sample> samples;

  std::vector<double> sample_times() const {
    std::vector<double> times;
    for (const Sample& sample : samples) times.push_back(sample.time);
    return times;
  }
};

inline VectorFile read_vector_file(const std::string& name) {
  std::ifstream stream(QTRAJ_REFERENCE_DIR "/" + name + ".txt");
  INFO("reference file " << name);
  REQUIRE(stream.is_open());
  VectorFile file;
  file.name = name;
  std::string line;
  const auto row = [&] {
    REQUIRE(std::getline(stream, line));
    return std::istringstream(line);
  };
  while (std::getline(stream, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::string word, option;
    size_t count = 0;
    words >> word;
    if (word == "method") words >> file.method;
    if (word == "option" && words >> option)
      while (words >> word) file.options[option].push_back(word);
    if (word == "keys" && words >> count) {
      for (size_t key = 0; key < count; ++key) {
        auto fields = row();
        double time = 0;
        Quaternion q{};
        REQUIRE(fields >> time >> q[0] >> q[1] >> q[2] >> q[3]);
        file.keys.add(time, q);
        double rate = 0;
        for (size_t k = 0; k < 6 && fields >> rate; ++k) (k < 3 ? file.omega_world : file.alpha_world).push_back(rate);
      }
    }
    if (word == "samples" && words >> count) {
      for (size_t i = 0; i < count; ++i) {
        auto fields = row();
        VectorFile::Sample s{};
        REQUIRE(fields >> s.time >> s.q[0] >> s.q[1] >> s.q[2] >> s.q[3]);
        REQUIRE(fields >> s.omega_world[0] >> s.omega_world[1] >> s.omega_world[2]);
        REQUIRE(fields >> s.alpha_world[0] >> s.alpha_world[1] >> s.alpha_world[2]);
        file.samples.push_back(s);
      }
    }
  }
  REQUIRE(file.keys.count() >= 2);
  REQUIRE(!file.samples.empty());
  return file;
}

// Names of all files, listed by hand: a file that is missing from the folder fails its test.
inline std::vector<std::string> vector_files() {
  std::vector<std::string> names = {"squad_mean_velocity",   "logspline_spin",         "logspline_turns",
                                    "spline_chord",          "spline_chord_long",      "spline_estimated",
                                    "spline_estimated_fast", "spline_estimated_three", "spline_given"};
  for (const char* method : {"slerp", "nlerp", "squad", "logspline", "spline"})
    for (const char* set : {"halfturn", "ragged", "repeated", "three", "tiny0.001", "tiny1e-08", "tiny1e-12", "two",
                            "uniform", "unix", "unnormalised", "wild"})
      if (std::string(method) != "spline" || std::string(set) != "halfturn")
        names.push_back(std::string(method) + "_" + set);
  for (const char* method : {"hermite", "rotquintic", "quintic"})
    for (const char* set : {"many", "two", "two_fast"}) names.push_back(std::string(method) + "_" + set);
  return names;
}

}  // namespace test

#endif
