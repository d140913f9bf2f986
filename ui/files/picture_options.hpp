#pragma once

// What an exported picture shows and how large it is, as rows in the file dialog.

#include "ui/files/drawing_order.hpp"
#include "ui/files/picture_order.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// Rows below the cursor; `turntable` adds those of a series. Changes the settings.
void draw_picture_options(const Editor& editor, Marks& marks, const Metrics& metrics,
                          PictureSettings& settings, bool turntable);

/// The same for line drawings.
class DrawingOptions {
 public:
  void draw(const Editor& editor, Marks& marks, const Metrics& metrics);
  const DrawingSettings& settings() const { return settings_; }
  void remember(const DrawingSettings& settings);

 private:
  void page_row(const Editor& editor, Marks& marks, const Metrics& metrics);

  DrawingSettings settings_;
  std::string width_text_;
};

}  // namespace hariko
