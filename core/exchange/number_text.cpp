#include "core/exchange/number_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/text/utf8.hpp"

namespace hariko {
namespace {

constexpr double powers_of_ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// Parses plain decimals such as -12.345: both the digits (up to 15) and the power of ten are exact doubles,
/// so one division rounds correctly (Clinger 1990). False where that does not apply.
bool parse_short_decimal(std::string_view text, double& value) {
  std::size_t i = 0;
  const bool negative = text[0] == '-';
  if (negative) ++i;
  std::uint64_t digits = 0;
  std::size_t digit_count = 0, decimals = 0;
  for (; i < text.size() && is_digit(text[i]); ++i, ++digit_count)
    digits = digits * 10 + static_cast<std::uint64_t>(text[i] - '0');
  if (i < text.size() && text[i] == '.') {
    ++i;
    for (; i < text.size() && is_digit(text[i]); ++i, ++digit_count, ++decimals)
      digits = digits * 10 + static_cast<std::uint64_t>(text[i] - '0');
  }
  if (i != text.size() || digit_count == 0) return false;
  // Up to 19 digits cannot overflow `digits`; above 2^53 they would not be exact.
  if (digit_count > 19 || digits > (std::uint64_t{1} << 53)) return false;
  const double magnitude = static_cast<double>(digits) / powers_of_ten[decimals];
  value = negative ? -magnitude : magnitude;
  return true;
}

/// Whether a well-formed number outside the range of doubles is above it (true) or below (false). The sign of
/// its decimal exponent in scientific notation decides, because both ends of the range are far from 1.
bool is_huge(std::string_view text) {
  std::int64_t leading_power = 0;  // power of ten of the first digit that is not 0
  bool found = false, after_point = false;
  std::size_t i = 0;
  for (; i < text.size() && text[i] != 'e' && text[i] != 'E'; ++i) {
    if (text[i] == '.') after_point = true;
    if (!is_digit(text[i])) continue;
    if (!found && after_point) --leading_power;
    if (found && !after_point) ++leading_power;
    found = found || text[i] != '0';
  }
  std::int64_t exponent = 0;
  if (i < text.size()) {
    std::string_view rest = text.substr(i + 1);
    const bool negative = !rest.empty() && rest[0] == '-';
    if (parse_integer(rest, exponent) != NumberStatus::ok)
      return !negative;  // an exponent that long decides alone
  }
  constexpr std::int64_t far = std::int64_t{1} << 50;  // no text is that long
  return leading_power + std::clamp(exponent, -far, far) > 0;
}

/// Removes one leading +, which from_chars does not know; false where a second sign follows.
bool strip_plus(std::string_view& text) {
  if (text.empty()) return false;
  if (text[0] != '+') return true;
  text.remove_prefix(1);
  return !text.empty() && text[0] != '-' && text[0] != '+';
}

/// Number with the exponent letter of Fortran's double precision, D, as E has it; empty for other texts.
std::string with_letter_e(std::string_view text) {
  const std::size_t letter = text.find_first_of("Dd");
  if (letter == std::string_view::npos || text.find_first_not_of("0123456789.+-Dd") != std::string_view::npos)
    return {};
  std::string out(text);
  out[letter] = 'e';
  return out;
}

template <class Number>
void append_number(std::string& out, Number value) {
  char buffer[40];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  static_cast<void>(error);  // the longest double has 24 characters
  out.append(buffer, end);
}

}  // namespace

NumberStatus parse_real(std::string_view text, double& value) {
  if (!strip_plus(text)) return NumberStatus::malformed;
  if (parse_short_decimal(text, value)) return NumberStatus::ok;
  double parsed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), parsed);
  if (error == std::errc::invalid_argument || end != text.data() + text.size()) {
    const std::string usual = with_letter_e(text);
    return usual.empty() ? NumberStatus::malformed : parse_real(usual, value);
  }
  if (error == std::errc::result_out_of_range) {
    if (is_huge(text)) return NumberStatus::too_large;
    parsed = 0;
  }
  if (!std::isfinite(parsed)) return NumberStatus::not_finite;
  value = parsed;
  return NumberStatus::ok;
}

NumberStatus parse_integer(std::string_view text, std::int64_t& value) {
  if (!strip_plus(text)) return NumberStatus::malformed;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || end != text.data() + text.size())
    return NumberStatus::malformed;
  return error == std::errc::result_out_of_range ? NumberStatus::too_large : NumberStatus::ok;
}

void append_real(std::string& out, double value) {
  append_number(out, value);
}
void append_real(std::string& out, float value) {
  append_number(out, value);
}
void append_integer(std::string& out, std::uint64_t value) {
  append_number(out, value);
}

}  // namespace hariko
