// Catch2 version 2 is a header: its implementation and main are compiled here, once for all test programs.
// Version 3 brings a library and does not use this file.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
