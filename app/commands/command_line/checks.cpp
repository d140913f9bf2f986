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
