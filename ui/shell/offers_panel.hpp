#pragma once

// Offers as pictures: unsaved work of earlier sessions, recent files and samples; on the start page and in a
// dialog.

#include "ui/widgets/panels.hpp"

namespace hariko {

/// A card for each work to recover, below the cursor and `width` wide. Nothing when there is none.
void draw_recovery_offers(PanelContext& context, float width);
/// Cards of recent files in rows, below the cursor and `width` wide. `most`: how many. True when one was
/// chosen.
bool draw_recent_files(PanelContext& context, float width, std::size_t most);

/// The same over a document.
class OffersDialog {
 public:
  enum class Kind { recovery, recent, samples };
  void open(Kind kind) {
    kind_ = kind;
    open_ = true;
  }
  bool is_open() const { return open_; }
  void close() { open_ = false; }
  void draw(PanelContext& context);

 private:
  Kind kind_ = Kind::recovery;
  bool open_ = false;
};

/// A card about the crash of an earlier session with its report, below the cursor and `width` wide. Nothing
/// when there was none.
void draw_crash_offer(PanelContext& context, float width);

}  // namespace hariko
