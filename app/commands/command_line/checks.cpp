#include "app/commands/command_line/checks.hpp"

#include <CLI/CLI.hpp>
#include <string>
#include <system_error>

#include "core/exchange/number_text.hpp"
#include "ui/base/text_number.hpp"

namespace hariko {

CLI::Validator positive_number() {
  const auto wrong = [](const std::string& text) {
    double value = 0;
    const bool good = parse_real(text, value) == NumberStatus::ok && value > 0;
    return good ? std::string() : "should be a number above 0, but is " + text;
  };
  return CLI::Validator(wrong, "POSITIVE");
}

CLI::Validator finite_number() {
  return CLI::Validator(
      [](const std::string& text) {
        // Both words have an n, and no number has one.
        const bool good = text.find_first_of("nN") == std::string::npos;
        return good ? std::string() : "should be a number, but is " + text;
      },
      "");
}

std::optional<Vector3> direction_in(std::string_view text) {
  const auto parts = numbers_in<double, 3>(text, ',');
  if (!parts || *parts == std::array<double, 3>{}) return std::nullopt;
  return Vector3((*parts)[0], (*parts)[1], (*parts)[2]);
}

void check_distinct(const std::filesystem::path& in, const std::filesystem::path& out) {
  std::error_code ignored;
  if (in == out || std::filesystem::equivalent(in, out, ignored))
    throw CLI::ValidationError("OUT", "must be another file than FILE");
}

}  // namespace hariko
