#pragma once

// The guided first model: six steps, each recognised by what happened to the document. Pure, no ImGui.

#include "core/document/document.hpp"

namespace hariko {

enum class GuideStep { box, pull, tension, crease, zebra, export_file, done };
inline constexpr int guide_step_count = 6;

/// Facts that a step is recognised by.
struct GuideFacts {
  Document document;   ///< the committed one
  int exports = 0;     ///< files exported since the program began
  bool zebra = false;  ///< a surface shows zebra stripes, by its own map or by the view's
};

/// Whether what the step asks for has happened between the two.
bool fulfilled(GuideStep step, const GuideFacts& before, const GuideFacts& now);

class Guide {
 public:
  bool shown() const { return shown_; }
  GuideStep step() const { return step_; }
  /// Left in the middle, to be taken up again.
  bool paused() const { return !shown_ && step_ != GuideStep::box && step_ != GuideStep::done; }

  /// Begins, or goes on where it was left; after the end it begins anew.
  void start(const GuideFacts& now);
  void leave() { shown_ = false; }
  /// Goes on to the next step when the present one is fulfilled. True when it did. Call when something
  /// changed.
  bool look(const GuideFacts& now);

 private:
  bool shown_ = false;
  GuideStep step_ = GuideStep::box;
  GuideFacts before_;  ///< facts when the step began
};

/// English title and text of a step; in the text {0} is the key of the command that helps.
struct GuideText {
  const char* title;
  const char* text;
  const char* command;  ///< id of the command whose key is named; "" for none
};
const GuideText& text_of(GuideStep step);

}  // namespace hariko
