#pragma once

// Check of options that are numbers above 0. Internal to this folder.

namespace CLI {
class Validator;
}

namespace hariko {

/// Check that an option is a finite number above 0; it says so without the largest number that there is.
CLI::Validator positive_number();

}  // namespace hariko
