#include "core/base/text/sanitized_utf8.hpp"

#include "core/base/text/utf8.hpp"

namespace hariko {

std::string sanitized_utf8(std::string_view text, std::size_t limit) {
  std::string out;
  while (!text.empty()) {
    const auto byte = static_cast<unsigned char>(text[0]);
    const std::size_t length = byte < 0x20 || byte == 0x7f ? 0 : utf8_length(text);
    if (out.size() + (length == 0 ? 1 : length) > limit) return out + "...";
    if (length == 0)
      out += '?';
    else
      out += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out;
}

std::string shortened(std::string_view text, std::size_t limit) {
  if (text.size() <= limit) return sanitized_utf8(text, limit);
  // A character that the cut would divide goes with the removed middle.
  const auto inside = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xc0U) == 0x80U; };
  std::size_t first = limit / 2, second = text.size() - (limit - first);
  while (first > 0 && inside(first)) --first;
  while (second < text.size() && inside(second)) ++second;
  return sanitized_utf8(text.substr(0, first), limit) + "..." + sanitized_utf8(text.substr(second), limit);
}

}  // namespace hariko
