#include "core/cad/kernel/cad_letters.hpp"

#include <algorithm>
#include <cstdint>

#include "core/base/assert.hpp"
#include "core/base/text/utf8.hpp"

namespace hariko {

namespace {

/// Code point of a well-formed UTF-8 sequence.
std::uint32_t code_point(std::string_view sequence) {
  HARIKO_ASSERT(!sequence.empty() && sequence.size() <= 4, "a sequence has one to four bytes");
  const auto byte = [&](std::size_t i) { return std::uint32_t(static_cast<unsigned char>(sequence[i])); };
  if (sequence.size() == 1) return byte(0);
  std::uint32_t code = byte(0) & (0xffU >> (sequence.size() + 1));
  for (std::size_t i = 1; i < sequence.size(); ++i) code = (code << 6) | (byte(i) & 0x3f);
  return code;
}

std::string hexadecimal(std::uint32_t value, int digits) {
  std::string out;
  for (int k = digits - 1; k >= 0; --k) out += "0123456789ABCDEF"[(value >> (4 * k)) & 0xf];
  return out;
}

}  // namespace

std::string with_step_directives(std::string_view text) {
  std::string out;
  int open = 0;  // digits of a character in the directive that is still open
  while (!text.empty()) {
    const std::size_t length = std::max<std::size_t>(utf8_length(text), 1);
    const std::uint32_t code =
        length == 1 && static_cast<unsigned char>(text[0]) >= 0x80 ? '?' : code_point(text.substr(0, length));
    const int digits = code < 0x80 ? 0 : code < 0x10000 ? 4 : 8;
    if (open != digits) {
      if (open > 0) out += "\\X0\\";
      if (digits > 0) out += digits == 4 ? "\\X2\\" : "\\X4\\";
      open = digits;
    }
    if (digits == 0)
      out += char(code);
    else
      out += hexadecimal(code, digits);
    text.remove_prefix(length);
  }
  if (open > 0) out += "\\X0\\";
  return out;
}

std::string ascii_name(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const bool ascii = static_cast<unsigned char>(text[0]) < 0x80;
    out += ascii ? text[0] : '_';
    text.remove_prefix(ascii ? 1 : std::max<std::size_t>(utf8_length(text), 1));
  }
  return out;
}

}  // namespace hariko
