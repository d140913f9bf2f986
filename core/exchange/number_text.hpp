#pragma once

// Conversion between numbers and text, independent of the locale.

#include <cstdint>
#include <string>
#include <string_view>

namespace hariko {

/// Outcome of parsing a number.
enum class NumberStatus { ok, malformed, not_finite, too_large };

/// Parses the whole of `text` as a decimal number, correctly rounded. A leading + is allowed, and so is the
/// exponent letter D of Fortran programs; nan and inf are `not_finite`, magnitudes above the largest double
/// `too_large`; those below the smallest become 0. `value` is set only when ok. O(size).
NumberStatus parse_real(std::string_view text, double& value);

/// Parses the whole of `text` as a decimal integer; a leading + is allowed. `value` is set only when ok.
NumberStatus parse_integer(std::string_view text, std::int64_t& value);

/// Appends the shortest text that reads back as the same number.
void append_real(std::string& out, double value);
void append_real(std::string& out, float value);
/// Appends a non-negative integer.
void append_integer(std::string& out, std::uint64_t value);

}  // namespace hariko
