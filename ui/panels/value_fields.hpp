#pragma once

// Fields that edit the document: a slider previews while it is dragged and makes one step on release; a typed
// number makes one step when it is entered.

#include <functional>
#include <optional>

#include "ui/panels/panels.hpp"

namespace hariko {

/// The document with a new value.
using EditValue = std::function<Result<Document>(const Document&, double)>;

struct SliderSpec {
  const char* id;     ///< also the mark: "slider.<id>" and "field.<id>"
  const char* label;  ///< shown before the slider
  const char* help;
  std::string step;  ///< label of the step in the history
  double low, high;
  bool logarithmic = false;
  bool whole = false;  ///< whole numbers only
};

/// `value` is nothing when the selected elements differ.
void value_slider(PanelContext& context, const SliderSpec& spec, std::optional<double> value,
                  const EditValue& edit);

/// A number typed into a field of the given width. `label` stands inside, before the number.
void number_field(PanelContext& context, const char* id, std::optional<double> value, const char* format,
                  float width, const std::string& step, const EditValue& edit);

/// The left column of a row: a dim label; the next item starts at a common column.
void row_label(const PanelContext& context, const char* label, const char* help);

}  // namespace hariko
