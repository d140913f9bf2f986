#pragma once

// Summaries of messages: many messages of one kind as one, for lists that people read.

#include <span>
#include <string>
#include <vector>

#include "core/base/message.hpp"

namespace hariko {

/// Summary of messages with the same code about elements of one kind, or with the same text: the first
/// message, the elements of the first few, and their number, including those that `validate` only counts.
struct MessageSummary {
  Message first;
  std::vector<Element> elements;
  std::size_t count = 1;

  /// Elements as text: "edge 3-7, edge 5-9, edge 6-8", followed by "..." where there are more. Empty where no
  /// element is named.
  std::string list() const;
};

/// Summaries of the messages, one per kind, in the order of their first messages.
std::vector<MessageSummary> summarised(std::span<const Message> messages);

/// Single message for a summary: the first one, with the number of further ones and some of their elements.
Message one_message(const MessageSummary& summary);

}  // namespace hariko
