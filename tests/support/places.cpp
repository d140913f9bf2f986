#include "tests/support/places.hpp"

std::string hariko::test::source_folder() {
  return HARIKO_SOURCE_FOLDER;
}

std::string hariko::test::program_path() {
  return HARIKO_PROGRAM;
}
