#pragma once

// DimensionLayer: the dimensions of the document over the pictures.

#include <memory>

#include "ui/view/view_layer.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// Draws dimensions with their values in all views. A click on the label of one chooses it, a drag
/// moves the label (one step).
std::unique_ptr<ViewLayer> make_dimension_layer();

/// Whether dimensions are drawn now.
bool shows_dimensions(const Editor& editor);

/// A row for each dimension: its kind, its value, and buttons that copy the value and delete it. A click on
/// the value chooses the dimension. Draws nothing where there are none.
void dimension_section(PanelContext& context);

}  // namespace hariko
