#pragma once

// Check of options that are numbers above 0. Internal to this folder.

#include <CLI/CLI.hpp>
#include <string>

#include "core/exchange/number_text.hpp"

namespace hariko {

/// Check that an option is a finite number above 0; it says so without the largest number that there is.
inline CLI::Validator positive_number() {
  const auto wrong = [](const std::string& text) {
    double value = 0;
    const bool good = parse_real(text, value) == NumberStatus::ok && value > 0;
    return good ? std::string() : "should be a number above 0, but is " + text;
  };
  return CLI::Validator(wrong, "POSITIVE");
}

}  // namespace hariko
