#include "core/base/text/phrase.hpp"

namespace hariko {

std::optional<std::size_t> placeholder_at(std::string_view text, std::size_t i) {
  if (i + 2 >= text.size() || text[i] != '{' || text[i + 2] != '}') return {};
  if (text[i + 1] < '0' || text[i + 1] > '9') return {};
  return static_cast<std::size_t>(text[i + 1] - '0');
}

std::string fill(std::string_view pattern, std::span<const std::string> arguments) {
  std::string out;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const auto number = placeholder_at(pattern, i);
    if (!number || *number >= arguments.size()) {
      out += pattern[i];
      continue;
    }
    out += arguments[*number];
    i += 2;
  }
  return out;
}

std::string fill(std::string_view pattern, std::initializer_list<std::string> arguments) {
  return fill(pattern, std::span(arguments.begin(), arguments.size()));
}

}  // namespace hariko
