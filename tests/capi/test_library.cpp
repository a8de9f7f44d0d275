// What the library says about itself.
#include <qtraj.h>

#include <cstring>
#include <set>
#include <string>

#include "support/capi_handles.hpp"
#include "support/catch.hpp"

namespace {

constexpr int32_t kLastStatus = QTRAJ_E_INTERNAL;

TEST_CASE("C API: the version that was linked is the version of the header", "[capi][library]") {
  CHECK(std::string(qtraj_version()) == QTRAJ_VERSION_STRING);
  CHECK(qtraj_version_number() == QTRAJ_VERSION_NUMBER);
}

TEST_CASE("C API: version string and number are made of major, minor and patch", "[capi][library]") {
  const std::string from_parts = std::to_string(QTRAJ_VERSION_MAJOR) + "." + std::to_string(QTRAJ_VERSION_MINOR) + "." +
                                 std::to_string(QTRAJ_VERSION_PATCH);
  CHECK(from_parts == QTRAJ_VERSION_STRING);
  CHECK(QTRAJ_VERSION_NUMBER == 1000000 * QTRAJ_VERSION_MAJOR + 1000 * QTRAJ_VERSION_MINOR + QTRAJ_VERSION_PATCH);
}

TEST_CASE("C API: every status has a one-line text of its own", "[capi][library]") {
  std::set<std::string> texts;
  for (int32_t status = QTRAJ_OK; status <= kLastStatus; ++status) {
    CAPTURE(status);
    const char* text = qtraj_status_text(status);
    REQUIRE(text != nullptr);
    CHECK(std::strlen(text) > 0);
    CHECK(std::strchr(text, '\n') == nullptr);
    CHECK(std::string(text) != "unknown status");
    texts.insert(text);
  }
  CHECK(texts.size() == static_cast<size_t>(kLastStatus) + 1);
}

TEST_CASE("C API: numbers that are no status have the text \"unknown status\"", "[capi][library]") {
  const int32_t number = GENERATE(INT32_MIN, INT32_MIN + 1, -1, -17, 1000, INT32_MAX);
  CAPTURE(number);
  CHECK(std::string(qtraj_status_text(number)) == "unknown status");
  CHECK(std::string(qtraj_status_text(QTRAJ_STATUS_INT32)) == "unknown status");
}

TEST_CASE("C API: texts are static, the same pointer from every call", "[capi][library]") {
  CHECK(qtraj_version() == qtraj_version());
  CHECK(qtraj_target() == qtraj_target());
  for (int32_t status = QTRAJ_OK; status <= kLastStatus; ++status)
    CHECK(qtraj_status_text(status) == qtraj_status_text(status));
}

TEST_CASE("C API: the target names an instruction set and one of the two arithmetics", "[capi][library]") {
  const std::string target = qtraj_target();
  CAPTURE(target);
  const size_t space = target.find(' ');
  REQUIRE(space != std::string::npos);
  const std::set<std::string> instruction_sets = {"scalar", "sse2", "sse4", "avx2", "avx512", "neon"};
  CHECK(instruction_sets.count(target.substr(0, space)) == 1);
  const std::string arithmetic = target.substr(space + 1);
  CHECK((arithmetic == "fused" || arithmetic == "plain"));
}

TEST_CASE("C API: destroying NULL does nothing", "[capi][library]") {
  qtraj_destroy(nullptr);
  qtraj_options_destroy(nullptr);
  SUCCEED("no crash");
}

}  // namespace
