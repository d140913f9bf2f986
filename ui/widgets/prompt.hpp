#pragma once

// Prompt: a question in the middle of the window with a few answers. For what cannot be undone only.

#include <functional>
#include <string>
#include <vector>

#include "ui/widgets/card_focus.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

class Prompt {
 public:
  struct Answer {
    std::string label;  ///< already translated
    std::string mark;   ///< "prompt.<mark>"
    std::function<void()> action = {};
  };
  struct Request {
    std::string title, text;             ///< already translated
    std::vector<Answer> answers;         ///< the first is the default (Enter); Esc does nothing but close
    std::function<void()> picture = {};  ///< draws something between text and buttons
    std::function<void(PanelContext&)> fields = {};  ///< likewise: what is asked for beside the answers
  };

  /// Shows a question; one that is open waits behind it.
  void ask(Request request) { requests_.push_back(std::move(request)); }
  bool is_open() const { return !requests_.empty(); }
  const Request* question() const { return is_open() ? &requests_.back() : nullptr; }
  /// Closes the question without an answer.
  void dismiss() {
    if (is_open()) requests_.pop_back();
  }
  /// Arrows and Tab go from answer to answer, Enter and the space bar choose. True when the key had an
  /// effect.
  bool key(const KeyChord& chord) { return is_open() && focus_.key(chord); }
  void draw(PanelContext& context);

 private:
  std::vector<Request> requests_;
  CardFocus focus_;
  std::size_t shown_ = 0;  ///< number that waited when the focus went to the default answer
};

}  // namespace hariko
