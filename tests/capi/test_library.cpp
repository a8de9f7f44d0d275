// What the library says about itself.
#include <qtraj.h>

#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "support/capi_handles.hpp"
#include "support/catch.hpp"

namespace {

// Every status there is, by class.
struct Class {
  int32_t value, first, last;
};
constexpr Class kClasses[] = {{QTRAJ_CLASS_DONE, QTRAJ_OK, QTRAJ_OK},
                              {QTRAJ_CLASS_REFUSED, QTRAJ_E_NULL, QTRAJ_E_NO_MEMORY},
                              {QTRAJ_CLASS_DATA, QTRAJ_E_NOT_FINITE, QTRAJ_E_NO_CONVERGENCE},
                              {QTRAJ_CLASS_ONE_OF_SEVERAL, QTRAJ_E_AMBIGUOUS, QTRAJ_E_AMBIGUOUS},
                              {QTRAJ_CLASS_DEFECT, QTRAJ_E_INTERNAL, QTRAJ_E_INTERNAL}};
std::vector<int32_t> all_statuses() {
  std::vector<int32_t> statuses;
  for (const Class& row : kClasses)
    for (int32_t status = row.first; status <= row.last; ++status) statuses.push_back(status);
  return statuses;
}

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
  for (const int32_t status : all_statuses()) {
    CAPTURE(status);
    const char* text = qtraj_status_text(status);
    REQUIRE(text != nullptr);
    CHECK(std::strlen(text) > 0);
    CHECK(std::strchr(text, '\n') == nullptr);
    CHECK(std::string(text) != "unknown status");
    texts.insert(text);
  }
  CHECK(texts.size() == all_statuses().size());
}

TEST_CASE("C API: numbers that are no status have the text \"unknown status\"", "[capi][library]") {
  const int32_t number = GENERATE(INT32_MIN, INT32_MIN + 1, -1, -17, 13, 20, 32, 40, 42, 50, 52, 1000, INT32_MAX);
  CAPTURE(number);
  CHECK(std::string(qtraj_status_text(number)) == "unknown status");
  CHECK(std::string(qtraj_status_text(QTRAJ_STATUS_INT32)) == "unknown status");
}

TEST_CASE("C API: the class of a status", "[capi][library]") {
  for (const Class& row : kClasses)
    for (int32_t status = row.first; status <= row.last; ++status) {
      CAPTURE(status);
      CHECK(qtraj_status_class(status) == row.value);
    }
  for (const int32_t none : {INT32_MIN, -1, 13, 20, 32, 40, 42, 50, 52, 1000, INT32_MAX}) {
    CAPTURE(none);
    CHECK(qtraj_status_class(none) == QTRAJ_CLASS_DEFECT);
  }
}

TEST_CASE("C API: texts are static, the same pointer from every call", "[capi][library]") {
  CHECK(qtraj_version() == qtraj_version());
  CHECK(qtraj_target() == qtraj_target());
  for (const int32_t status : all_statuses()) CHECK(qtraj_status_text(status) == qtraj_status_text(status));
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
