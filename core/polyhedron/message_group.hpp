#pragma once

// MessageGroup: messages of one code, of which only the first few are written out.

#include <string>
#include <utility>
#include <vector>

#include "core/base/message.hpp"

namespace hariko {

/// Appends to `out`. When it goes out of scope its last message says how many more there were.
class MessageGroup {
 public:
  MessageGroup(std::vector<Message>& out, Severity severity, Code code, std::string remedy, std::size_t limit)
      : out_(out), severity_(severity), code_(code), remedy_(std::move(remedy)), limit_(limit) {}
  MessageGroup(const MessageGroup&) = delete;
  MessageGroup& operator=(const MessageGroup&) = delete;
  ~MessageGroup() {
    if (count_ > limit_ && limit_ > 0)
      out_.back().text += " (" + std::to_string(count_ - limit_) + " more like this.)";
  }

  /// text() is called only for messages within the limit.
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
