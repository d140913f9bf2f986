#include "core/base/text/decoded_text.hpp"

#include <iconv.h>
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/base/text/utf8.hpp"

namespace hariko {

namespace {

/// Windows-1252 from 0x80 to 0x9f; undefined bytes become '?'.
constexpr std::array<std::uint16_t, 32> windows_1252{
    0x20ac, '?',    0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021, 0x02c6, 0x2030, 0x0160,
    0x2039, 0x0152, '?',    0x017d, '?',    '?',    0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
    0x2013, 0x2014, 0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, '?',    0x017e, 0x0178};

void append_utf8(std::string& out, std::uint32_t code) {
  const auto tail = [&](int shift) { out += char(0x80 | ((code >> shift) & 0x3f)); };
  if (code < 0x80) {
    out += char(code);
  } else if (code < 0x800) {
    out += char(0xc0 | (code >> 6));
    tail(0);
  } else if (code < 0x10000) {
    out += char(0xe0 | (code >> 12));
    tail(6), tail(0);
  } else {
    out += char(0xf0 | (code >> 18));
    tail(12), tail(6), tail(0);
  }
}

std::string of_utf16(std::string_view bytes, bool big_endian) {
  const auto unit = [&](std::size_t at) {
    const auto first = static_cast<unsigned char>(bytes[at]),
               second = static_cast<unsigned char>(bytes[at + 1]);
    return std::uint32_t(big_endian ? first << 8 | second : second << 8 | first);
  };
  std::string out;
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    std::uint32_t code = unit(at);
    const bool high = code >= 0xd800 && code < 0xdc00;
    if (high && at + 3 < bytes.size() && unit(at + 2) >= 0xdc00 && unit(at + 2) < 0xe000) {
      code = 0x10000 + ((code - 0xd800) << 10) + (unit(at + 2) - 0xdc00);
      at += 2;
    }
    append_utf8(out, code >= 0xd800 && code < 0xe000 ? '?' : code);
  }
  return out;
}

/// Whether a text begins with a double byte in the ranges of Shift-JIS.
bool begins_shift_jis(std::string_view text) {
  if (text.size() < 2) return false;
  const auto first = static_cast<unsigned char>(text[0]), second = static_cast<unsigned char>(text[1]);
  return ((first >= 0x81 && first <= 0x9f) || (first >= 0xe0 && first <= 0xfc)) && second >= 0x40 &&
         second != 0x7f && second <= 0xfc;
}

/// Text decoded as Shift-JIS, or nothing where it seems to be in another encoding. Kana and common kanji
/// begin with 0x81 to 0x9f, where Windows-1252 has quotation marks and no letters of words.
std::optional<std::string> of_shift_jis(std::string_view bytes) {
  std::size_t common = 0, rare = 0;
  for (std::string_view left = bytes; !left.empty();) {
    const auto byte = static_cast<unsigned char>(left[0]);
    const bool pair = byte >= 0x80 && begins_shift_jis(left), half_width = byte >= 0xa1 && byte <= 0xdf;
    if (byte >= 0x80 && !pair && !half_width) return {};
    if (byte >= 0x80) ++(pair && byte <= 0x9f ? common : rare);
    left.remove_prefix(pair ? 2 : 1);
  }
  if (common <= rare) return {};
  const iconv_t converter = ::iconv_open("UTF-8", "CP932");
  if (converter == iconv_t(-1)) return {};  // the system has no such table
  std::string in(bytes), out(3 * bytes.size(), '\0');
  char *from = in.data(), *to = out.data();
  std::size_t in_left = in.size(), out_left = out.size();
  const bool whole = ::iconv(converter, &from, &in_left, &to, &out_left) != std::size_t(-1);
  ::iconv_close(converter);
  if (!whole) return {};
  out.resize(out.size() - out_left);
  return out;
}

bool is_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// Number of bytes that belong to no UTF-8 sequence.
std::size_t stray_count(std::string_view text) {
  std::size_t out = 0;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    out += length == 0;
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

}  // namespace

DecodedText decoded(std::string bytes, StrayBytes stray) {
  DecodedText out;
  for (const bool big_endian : {true, false})
    if (bytes.starts_with(big_endian ? "\xfe\xff" : "\xff\xfe")) {
      out.marked = true;
      out.text = of_utf16(std::string_view(bytes).substr(2), big_endian);
      return out;
    }
  constexpr std::string_view mark = "\xef\xbb\xbf";
  if (bytes.starts_with(mark)) {
    out.marked = true;
    bytes.erase(0, mark.size());
  }
  if (is_ascii(bytes)) {
    out.text = std::move(bytes);
    return out;
  }
  if (stray == StrayBytes::letters && stray_count(bytes) > 0)
    if (auto text = of_shift_jis(bytes)) {
      out.guessed = stray_count(bytes);
      out.japanese = true;
      out.text = std::move(*text);
      return out;
    }
  for (std::string_view left = bytes; !left.empty();) {
    if (const std::size_t length = utf8_length(left); length > 0) {
      out.text += left.substr(0, length);
      left.remove_prefix(length);
      continue;
    }
    const auto byte = static_cast<unsigned char>(left[0]);
    append_utf8(out.text, stray == StrayBytes::question_mark ? '?'
                          : byte < 0xa0                      ? windows_1252[byte - 0x80U]
                                                             : byte);
    ++out.guessed;
    left.remove_prefix(1);
  }
  return out;
}

}  // namespace hariko
