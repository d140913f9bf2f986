#pragma once

// The paper model in the views, where it stands in the place of the objects: its facets are lit and chosen
// there as they are on the pages.

#include "ui/view/view_layer.hpp"

namespace hariko {

std::unique_ptr<ViewLayer> make_paper_layer();

}  // namespace hariko
