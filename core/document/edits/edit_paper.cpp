#include "core/document/edits/edit_paper.hpp"

#include <algorithm>
#include <cmath>

#include "core/document/object_box.hpp"
#include "core/document/object_shape.hpp"

namespace hariko {

namespace {

/// Distance between surface and facets where nothing has a size, in millimetres: one fiftieth of the side of
/// a new box.
constexpr double usual_distance = 0.5;

}  // namespace

Document set_paper(const Document& document, PaperModel paper) {
  if (document.paper && *document.paper == paper) return document;
  Document out = document;
  out.paper = std::make_shared<const PaperModel>(std::move(paper));
  return out;
}

Document remove_paper(const Document& document) {
  Document out = document;
  out.paper.reset();
  return out;
}

std::vector<ObjectId> unfoldable_objects(const Document& document) {
  std::vector<ObjectId> out;
  for (const auto& object : document.objects)
    if (object->visible && has_shape(*object)) out.push_back(object->id);
  std::sort(out.begin(), out.end());
  return out;
}

double proposed_distance(const Document& document, std::span<const ObjectId> objects) {
  Eigen::AlignedBox3d box;
  for (const ObjectId id : objects)
    if (const Object* object = document.find(id)) box.extend(box_at_own_place(*object));
  const double distance = box.isEmpty() ? 0 : 0.01 * box.diagonal().norm();
  if (!(distance > 1e-290) || !std::isfinite(distance))
    return usual_distance / millimetres_per(document.unit);
  const double digit = std::pow(10, std::floor(std::log10(distance)));
  return std::max(1.0, std::round(distance / digit)) * digit;
}

}  // namespace hariko
