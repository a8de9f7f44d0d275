// Readers of the recordings in examples/data.
#ifndef QTRAJ_TESTS_RECORDING_HPP
#define QTRAJ_TESTS_RECORDING_HPP

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/random.hpp"

namespace test {

struct Recording {
  std::string name;
  Keys keys;
};

// Numbers of a line, whatever separates them; words that are no numbers are left out.
inline std::vector<double> numbers(std::string line) {
  std::replace(line.begin(), line.end(), ',', ' ');
  std::istringstream words(line);
  std::vector<double> values;
  std::string word;
  while (words >> word) {
    size_t used = 0;
    try {
      const double value = std::stod(word, &used);
      if (used == word.size()) values.push_back(value);
    } catch (const std::exception&) {
    }
  }
  return values;
}

// Position of the time in a row and of w, x, y, z.
struct Columns {
  size_t time, w, x, y, z;
};
constexpr Columns kTelemetryColumns = {0, 1, 2, 3, 4}, kTumColumns = {0, 7, 4, 5, 6}, kGltfColumns = {0, 4, 1, 2, 3};

inline void add_row(Keys& keys, const std::vector<double>& row, const Columns& at) {
  keys.add(row[at.time], {row[at.w], row[at.x], row[at.y], row[at.z]});
}

inline std::ifstream open_data(const std::string& file) {
  std::ifstream stream(std::string(QTRAJ_DATA_DIR "/") + file);
  INFO("data file " << file);
  REQUIRE(stream.is_open());
  return stream;
}

inline Recording read_recording(const std::string& file, const Columns& columns) {
  Recording recording = {file.substr(0, file.rfind('.')), {}};
  std::ifstream stream = open_data(file);
  std::string line;
  while (std::getline(stream, line)) {
    const std::vector<double> row = numbers(line);
    if (line[0] != '#' && row.size() >= 5) add_row(recording.keys, row, columns);
  }
  REQUIRE(recording.keys.count() >= 2);
  return recording;
}

// The glTF file holds one curve a joint.
inline std::vector<Recording> read_joints(const std::string& file) {
  std::vector<Recording> joints;
  std::ifstream stream = open_data(file);
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    const std::string joint = line.substr(0, line.find(','));
    if (joints.empty() || joints.back().name != joint) joints.push_back({joint, {}});
    add_row(joints.back().keys, numbers(line.substr(joint.size() + 1)), kGltfColumns);
  }
  REQUIRE(joints.size() == 20);
  return joints;
}

inline std::vector<Recording> all_recordings() {
  std::vector<Recording> recordings = read_joints("fox_run_gltf.csv");
  for (const char* file : {"cassini_turn.csv", "juno_spinner.csv", "newhorizons_signflip.csv"})
    recordings.push_back(read_recording(file, kTelemetryColumns));
  for (const char* file : {"tum_fr1_xyz.tum", "tum_fr2_desk_head.tum"})
    recordings.push_back(read_recording(file, kTumColumns));
  return recordings;
}

}  // namespace test

#endif
