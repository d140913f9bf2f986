#pragma once

// Checks and readings of options that several commands have. Internal to this folder.

#include <filesystem>
#include <optional>
#include <string_view>

#include "core/base/vector.hpp"

namespace CLI {
class Validator;
}

namespace hariko {

/// Check that an option is a finite number above 0; it says so without the largest number that there is.
CLI::Validator positive_number();

/// Check that an option is no "nan" and no "inf", which pass every comparison with a limit or none.
CLI::Validator finite_number();

/// The vector of "1,0,2"; nothing for other texts and for zero.
std::optional<Vector3> direction_in(std::string_view text);

/// Throws CLI::ValidationError where a command would overwrite its input.
void check_distinct(const std::filesystem::path& in, const std::filesystem::path& out);

}  // namespace hariko
