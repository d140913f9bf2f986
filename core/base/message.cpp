#include "core/base/message.hpp"

#include <array>
#include <charconv>

#include "core/base/ids.hpp"

namespace hariko {

std::string to_string(const Element& element) {
  switch (element.kind) {
    case Element::Kind::none:
      return {};
    case Element::Kind::vertex:
      return "vertex " + std::to_string(element.id);
    case Element::Kind::edge:
      return "edge " + to_string(EdgeId::from_packed(element.id));
    case Element::Kind::face:
      return "face " + std::to_string(element.id);
    case Element::Kind::object:
      return "object " + std::to_string(element.id);
    case Element::Kind::line:
      return "line " + std::to_string(element.id);
  }
  return {};
}

std::string to_string(const Message& message) {
  std::string out(message.code.name);
  if (message.element.kind != Element::Kind::none) out += " (" + to_string(message.element) + ")";
  out += ": " + message.text;
  if (!message.remedy.empty()) out += " " + message.remedy;
  return out;
}

Message make_error(Code code, std::string text, std::string remedy, Element element) {
  return {Severity::error, code, element, std::move(text), std::move(remedy)};
}

Message make_warning(Code code, std::string text, std::string remedy, Element element) {
  return {Severity::warning, code, element, std::move(text), std::move(remedy)};
}

std::string counted(std::size_t count, std::string_view one, std::string_view several) {
  std::string out = std::to_string(count);
  out += count == 1 ? one : several;
  return out;
}

std::string rounded_text(double value, int digits) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
  return {text.data(), end.ptr};
}

}  // namespace hariko
