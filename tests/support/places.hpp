#pragma once

// Folders and programs for tests, as the build knows them.

#include <string>

namespace hariko::test {

/// Folder of the checkout, without a slash at its end.
std::string source_folder();
/// Path of the program `hariko`; empty in a build without it.
std::string program_path();

}  // namespace hariko::test
