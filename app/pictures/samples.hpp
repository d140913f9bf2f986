#pragma once

// Samples: documents that come with the program.

#include <filesystem>
#include <vector>

#include "ui/base/samples.hpp"

namespace hariko {

/// Documents in the samples folder, in display order; unknown ones come last, with titles made from their
/// names.
std::vector<Sample> find_samples(const std::filesystem::path& assets);

}  // namespace hariko
