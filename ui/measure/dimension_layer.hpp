#pragma once

// DimensionLayer: the dimensions of the document over the pictures.

#include <memory>

#include "ui/view/view_layer.hpp"

namespace hariko {

/// Draws dimensions with their values in all views. A click on the label of one chooses it, a drag
/// moves the label (one step).
std::unique_ptr<ViewLayer> make_dimension_layer();

/// Whether dimensions are drawn now.
bool shows_dimensions(const Editor& editor);

}  // namespace hariko
