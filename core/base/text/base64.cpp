#include "core/base/text/base64.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace hariko {

namespace {

constexpr std::string_view base64_alphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Value of a digit; -1 for other characters.
constexpr std::array<std::int8_t, 256> base64_digits() {
  std::array<std::int8_t, 256> table{};
  table.fill(-1);
  for (std::size_t i = 0; i < base64_alphabet.size(); ++i)
    table[static_cast<unsigned char>(base64_alphabet[i])] = static_cast<std::int8_t>(i);
  table['-'] = 62;
  table['_'] = 63;
  return table;
}

}  // namespace

std::string to_base64(std::string_view bytes) {
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t taken = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = (word << 8) | (k < taken ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out += k <= taken ? base64_alphabet[(word >> (18 - 6 * k)) & 63U] : '=';
  }
  return out;
}

Base64Bytes from_base64(std::string_view text) {
  static constexpr auto digits = base64_digits();
  while (text.ends_with('=')) text.remove_suffix(1);
  Base64Bytes out;
  out.bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t word = 0;
  int bits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::int8_t digit = digits[static_cast<unsigned char>(text[i])];
    if (digit < 0) {
      out.wrong = i;
      return out;
    }
    word = (word << 6) | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    out.bytes += static_cast<char>((word >> bits) & 0xffU);
  }
  return out;
}

}  // namespace hariko
