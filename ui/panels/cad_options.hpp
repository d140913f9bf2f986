#pragma once

// How surfaces are written as STEP and IGES, as rows in the file dialog.

#include <string>

#include "core/document/cad_choices.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/quantity.hpp"

namespace hariko {

class CadOptions {
 public:
  static constexpr int rows = 3;

  /// For the document in the editor: a tolerance in proportion to what is visible, the first time or when the
  /// one chosen before does not suit it.
  void begin(const Editor& editor);
  void draw(const Editor& editor, Marks& marks, const Metrics& metrics);

  const CadChoices& choices() const { return choices_; }

 private:
  void tolerance_row(const Editor& editor, Marks& marks, const Metrics& metrics);
  void unit_row(const Editor& editor, Marks& marks, const Metrics& metrics);

  CadChoices choices_;
  double size_ = 0;  ///< diagonal of what is visible
  std::string tolerance_text_;
};

}  // namespace hariko
