#include "core/polyhedron/message_summary.hpp"

#include <algorithm>
#include <string_view>

#include "core/polyhedron/message_group.hpp"

namespace hariko {

namespace {

constexpr std::size_t most_elements = 5;

/// Name of the object at the start of a message about one of several objects, with the quotation mark before
/// it.
std::string_view object_of(std::string_view text) {
  const std::size_t end = text.starts_with('"') ? text.find("\": ") : std::string_view::npos;
  return end == std::string_view::npos ? std::string_view() : text.substr(0, end);
}

/// Whether two messages are of one kind: the same code about elements of the same object, or the same text.
bool same_kind(const Message& a, const Message& b) {
  if (!(a.code == b.code) || a.severity != b.severity) return false;
  if (a.text == b.text) return true;
  const auto on_mesh = [](Element::Kind kind) {
    return kind == Element::Kind::vertex || kind == Element::Kind::edge || kind == Element::Kind::face;
  };
  return a.element.kind == b.element.kind && on_mesh(a.element.kind) &&
         object_of(a.text) == object_of(b.text);
}

}  // namespace

std::string MessageSummary::list() const {
  std::string out;
  for (const Element& element : elements) out += (out.empty() ? "" : ", ") + to_string(element);
  return elements.size() < count && !out.empty() ? out + " ..." : out;
}

std::vector<MessageSummary> summarised(std::span<const Message> messages) {
  std::vector<MessageSummary> out;
  for (const Message& message : messages) {
    const auto known = std::find_if(out.begin(), out.end(), [&](const MessageSummary& summary) {
      return same_kind(summary.first, message);
    });
    const auto [text, more] = without_more(message.text);
    if (known == out.end()) {
      out.push_back({message, {}, 1 + more});
      out.back().first.text = text;
      if (message.element.kind != Element::Kind::none) out.back().elements.push_back(message.element);
      continue;
    }
    known->count += 1 + more;
    if (message.element.kind != Element::Kind::none && known->elements.size() < most_elements)
      known->elements.push_back(message.element);
  }
  return out;
}

Message one_message(const MessageSummary& summary) {
  Message out = summary.first;
  if (summary.count == 1) return out;
  const std::string list = summary.list();
  out.text += " (" + std::to_string(summary.count) + " like this" + (list.empty() ? "" : ": " + list) + ")";
  return out;
}

}  // namespace hariko
