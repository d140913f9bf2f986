#pragma once

// Effect of a file's number of digits on promised tolerances.

#include <Eigen/Geometry>
#include <filesystem>
#include <functional>

#include "core/document/document.hpp"
#include "core/exchange/mesh_file.hpp"

namespace hariko {

/// Largest displacement of points in a box of the document by a file's rounding; empty where there is none.
using FileDigits = std::function<double(const Eigen::AlignedBox3d&)>;

/// Rounding of a file of this name and these options that gets all visible objects.
FileDigits file_digits(const Document& document, const std::filesystem::path& path,
                       const WriteOptions& options);

}  // namespace hariko
