#pragma once

// Cards: pictures with a title and a few words below, in rows; and the samples as such cards, on the start
// page and in a dialog.

#include <functional>
#include <string>

#include "ui/widgets/panels.hpp"

namespace hariko {

struct Card {
  std::string id, title, text, help;  ///< translated, but for the id, which is its mark, too
  Sample* pictured = nullptr;         ///< sample whose picture it has, asked for when the card is first seen
  std::function<void(ImVec2 low, ImVec2 high)> paint = {};  ///< in the picture's place
};

/// Cards of equal size in rows below the cursor, from `left` (window coordinates) and `width` wide.
class CardGrid {
 public:
  CardGrid(PanelContext& context, float left, float width, int columns)
      : context_(context), left_(left), width_(width), columns_(columns) {}
  void add(Card card) { cards_.push_back(std::move(card)); }
  /// Draws all and leaves the cursor below. Texts have as many lines as the longest one wants, at most
  /// `lines`. Gives the number of the card that was chosen, or -1.
  int draw(std::size_t lines) const;

 private:
  PanelContext& context_;
  float left_, width_;
  int columns_;
  std::vector<Card> cards_;
};

/// The samples by the ways in which they were made, each way with a heading. True when one was chosen, which
/// then opens.
bool draw_samples(PanelContext& context, float left, float width, int columns);

/// The heading of what is begun so.
const char* heading_of(Beginning beginning);

}  // namespace hariko
