#include "app/commands/command_line/positive_number.hpp"

#include <CLI/CLI.hpp>
#include <string>

#include "core/exchange/number_text.hpp"

namespace hariko {

CLI::Validator positive_number() {
  const auto wrong = [](const std::string& text) {
    double value = 0;
    const bool good = parse_real(text, value) == NumberStatus::ok && value > 0;
    return good ? std::string() : "should be a number above 0, but is " + text;
  };
  return CLI::Validator(wrong, "POSITIVE");
}

}  // namespace hariko
