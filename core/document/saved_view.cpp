#include "core/document/saved_view.hpp"

#include <cmath>

#include "core/document/document.hpp"

namespace hariko {

Result<Done> check_view(const SavedView& view) {
  if (const auto checked = check_name(view.name); !checked) return checked.error();
  const bool placed =
      view.target.allFinite() && view.distance > 0 && view.distance <= SavedView::max_distance;
  // Written so that what is not a number fails, too.
  const bool turned = std::abs(view.orientation.norm() - 1) <= 1e-9;
  if (!placed || !turned)
    return make_error(e_view_invalid, "The view lies infinitely far away, or looks in no direction.",
                      "Frame the model and save the view again.");
  if (!(view.focal_length >= SavedView::least_focal_length &&
        view.focal_length <= SavedView::greatest_focal_length))
    return make_error(e_view_invalid, "The focal length of a view is from 15 to 300 mm.",
                      "Choose a focal length in that range.");
  return Done{};
}

}  // namespace hariko
