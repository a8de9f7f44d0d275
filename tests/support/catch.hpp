// The one include of Catch2, version 2 or 3: TEST_CASE, SECTION, GENERATE, CHECK, CHECK_THAT, CAPTURE and
// Catch::Matchers::WithinRel, WithinAbs. CMake says which version it found.
#ifndef QTRAJ_TESTS_CATCH_HPP
#define QTRAJ_TESTS_CATCH_HPP

#if QTRAJ_CATCH2_MAJOR >= 3
#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#else
#include <catch2/catch.hpp>
#endif

#endif
