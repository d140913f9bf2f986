#pragma once

// Samples: the documents that come with the program.

#include <filesystem>
#include <vector>

#include "ui/base/samples.hpp"

namespace hariko {

/// Documents in the samples folder, in the order in which they are shown; those that nothing is known of come
/// last, with titles made from their names.
std::vector<Sample> find_samples(const std::filesystem::path& assets);

}  // namespace hariko
