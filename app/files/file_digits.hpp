#pragma once

// The share of a promised tolerance that the digits of a file take.

#include <Eigen/Geometry>
#include <filesystem>
#include <functional>

#include "core/document/document.hpp"
#include "core/exchange/mesh_file.hpp"

namespace hariko {

/// The farthest that the digits of a file move points of a box of the document; empty: they do not.
using FileDigits = std::function<double(const Eigen::AlignedBox3d&)>;

/// For a file of this name and these options that gets all that is visible.
FileDigits file_digits(const Document& document, const std::filesystem::path& path,
                       const WriteOptions& options);

}  // namespace hariko
