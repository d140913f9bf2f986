#pragma once

// MessageGroup: messages of one code, of which only the first few are written out and the rest counted.

#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/message.hpp"

namespace hariko {

inline constexpr const char* more_begins = " (";
inline constexpr std::string_view more_ends = " more like this.)";

/// Text of the last message of a group without its count of omitted messages, and that count.
inline std::pair<std::string, std::size_t> without_more(const std::string& text) {
  const std::size_t begin = text.rfind(more_begins);
  if (!text.ends_with(more_ends) || begin == std::string::npos) return {text, 0};
  return {text.substr(0, begin), std::strtoull(text.c_str() + begin + 2, nullptr, 10)};
}

/// Collector of messages of one code, appended to `out`. When it goes out of scope, its last message gets the
/// number of omitted ones.
class MessageGroup {
 public:
  MessageGroup(std::vector<Message>& out, Severity severity, Code code, std::string remedy, std::size_t limit)
      : out_(out), severity_(severity), code_(code), remedy_(std::move(remedy)), limit_(limit) {}
  MessageGroup(const MessageGroup&) = delete;
  MessageGroup& operator=(const MessageGroup&) = delete;
  ~MessageGroup() {
    if (count_ > limit_ && limit_ > 0)
      out_.back().text += more_begins + std::to_string(count_ - limit_) + std::string(more_ends);
  }

  /// Adds a message; text() is called only within the limit.
  template <class Text>
  void add(Element element, Text&& text) {
    if (++count_ <= limit_) out_.push_back({severity_, code_, element, text(), remedy_});
  }

 private:
  std::vector<Message>& out_;
  Severity severity_;
  Code code_;
  std::string remedy_;
  std::size_t limit_, count_ = 0;
};

}  // namespace hariko
