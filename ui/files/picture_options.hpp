#pragma once

// Options of an exported picture, what it shows and how large it is, as rows in the file dialog.

#include "ui/files/picture_order.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// Rows below the cursor; `turntable` adds those of a series. Changes the settings.
void draw_picture_options(PanelContext& context, PictureSettings& settings, bool turntable);

/// The same for line drawings.
class DrawingOptions {
 public:
  void draw(PanelContext& context);
  const DrawingSettings& settings() const { return settings_; }
  void remember(const DrawingSettings& settings);

 private:
  void page_row(PanelContext& context);

  DrawingSettings settings_;
  std::string width_text_;
};

}  // namespace hariko
