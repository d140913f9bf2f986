#pragma once

// Many messages of one kind as one, for lists that people read.

#include <span>
#include <string>
#include <vector>

#include "core/base/message.hpp"

namespace hariko {

/// Messages with the same code about elements of one kind, or with the same text: the first of them, the
/// elements of the first few, and how many there are, those included that `validate` only counts.
struct MessageSummary {
  Message first;
  std::vector<Element> elements;
  std::size_t count = 1;

  /// "edge 3-7, edge 5-9, edge 6-8"; "..." behind it where there are more. Empty where none is named.
  std::string list() const;
};

/// One for each kind, in the order in which they come first.
std::vector<MessageSummary> summarised(std::span<const Message> messages);

/// The first message, which says how many more there are, and names some.
Message one_message(const MessageSummary& summary);

}  // namespace hariko
