#include "ui/editor/meshing.hpp"

#include "core/document/object_shape.hpp"
#include "ui/base/quantity.hpp"

#include <numbers>

namespace hariko {

MeshOptions MeshingSettings::options(double scale) const {
  const auto length = [&](MeshCriterion criterion) {
    const Tolerance& own = of(criterion);
    return own.on ? std::optional(own.value / scale) : std::nullopt;
  };
  const auto radians = [&](MeshCriterion criterion) {
    const Tolerance& own = of(criterion);
    return own.on ? std::optional(own.value * std::numbers::pi / 180) : std::nullopt;
  };
  MeshOptions out;
  out.criteria.distance = length(MeshCriterion::distance);
  out.criteria.normal_angle = radians(MeshCriterion::normal);
  out.criteria.fold_angle = radians(MeshCriterion::fold);
  if (of(MeshCriterion::luminance).on) out.criteria.luminance = of(MeshCriterion::luminance).value;
  out.criteria.max_edge = length(MeshCriterion::edge);
  out.criteria.min_angle = radians(MeshCriterion::angle);
  out.start = start;
  out.split = split;
  out.optimise = optimise;
  out.balanced = balanced;
  out.report = MeshReport::all;
  return out;
}

std::string short_text(MeshShown shown, double value, Unit unit) {
  if (shown != MeshShown::distance) return format_quantity(angle_quantity(), value);
  return format_number(value, 3) + " " + std::string(to_string(unit));
}

std::shared_ptr<const Object> meshed_object(const Document& document, ObjectId active) {
  std::shared_ptr<const Object> first;
  for (const auto& object : document.objects) {
    if (!object->visible || !has_shape(*object)) continue;
    if (object->id == active) return object;
    if (!first) first = object;
  }
  return first;
}

ComparedPicture compared_picture(std::size_t place) {
  return {place / 2, place % 2 == 0 ? MeshShown::distance : MeshShown::normal};
}

}  // namespace hariko
