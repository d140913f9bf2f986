#pragma once

// PaperPanel: the paper view. Pages beside the model; edges are joined and split by a click, tabs change
// sides by a click, pieces are dragged and turned, and all is linked with the model in space.

#include <memory>
#include <optional>

#include "ui/paper/paper_drawing.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

class PaperPanel {
 public:
  void draw(PanelContext& context, const PanelRect& rect);
  /// A piece is being moved or turned: keys wait, Esc lets it go.
  bool dragging() const { return drag_.has_value() && drag_->moved; }
  /// Puts the piece back. False when none was in the hand.
  bool cancel_drag(Editor& editor);
  /// Hint of what a click would do here; empty where the pointer is elsewhere.
  const std::string& hint() const { return hint_; }

 private:
  enum class Grip { piece, handle, paper };
  struct Drag {
    Grip grip = Grip::paper;
    Index piece = no_index;
    Vector2 from = Vector2::Zero();    ///< pixels
    Vector2 corner = Vector2::Zero();  ///< corner of the table, at the press
    Index page = 0;                    ///< page of the piece, at the press
    PaperHover under;
    std::shared_ptr<const PaperLayout> layout;  ///< pages that the numbers above are of
    bool moved = false;
  };

  void toolbar(PanelContext& context);
  void pages(PanelContext& context, const PanelRect& rect);
  void empty_page(PanelContext& context, const PanelRect& rect);
  void fold_bar(PanelContext& context);
  void frame(const PaperLayout& layout, const PanelRect& rect, const Metrics& metrics);
  /// Frames the pages where that is asked for, and again when the view changes its size; pages that were
  /// zoomed or moved stay about the middle.
  void follow_room(PaperState& state, const PanelRect& rect, const Metrics& metrics);
  PaperHover under(const PaperLayout& layout, const Vector2& pixel, double reach) const;
  std::optional<Vector2> handle(const PaperState& state, const Metrics& metrics) const;
  void zoom(const Vector2& pixel, float steps);
  void press(Editor& editor, const Metrics& metrics, const Vector2& pixel);
  void drag(Editor& editor, const Metrics& metrics, const Vector2& pixel);
  void release(Editor& editor);
  /// A search or a change of the model may end with other pages while the pointer holds something.
  void end_stale_drag(PaperState& state);
  void click(Editor& editor, const PaperHover& on);
  void menu(PanelContext& context);
  void say(PanelContext& context, const PaperLayout& layout, const PanelRect& rect) const;
  void mark(Marks& marks, const PaperLayout& layout, const PanelRect& rect) const;

  PageTable table_;
  PanelRect room_{};     ///< area of the pages in the last frame
  bool framed_ = false;  ///< all pages, and nothing was zoomed or moved since
  std::optional<Drag> drag_;
  PaperHover menu_on_;
  Vector2 dragged_to_ = Vector2::Constant(-1);
  std::string hint_;
  bool pointer_here_ = false;  ///< the hovered part is hovered here
};

/// Rows of the properties panel: numbers, size, page, folds; what is wrong, with what can be done.
void draw_paper_properties(PanelContext& context);

}  // namespace hariko
