#pragma once

// Folders and programs that tests use, as the build knows them.

#include <string>

namespace hariko::test {

/// The checkout's folder, without a slash at its end.
std::string source_folder();
/// The path of the program `hariko`; empty in a build without it.
std::string program_path();

}  // namespace hariko::test
