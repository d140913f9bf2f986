#include "app/commands/dimension_info.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "app/files/walled_surface.hpp"
#include "core/document/object_shape.hpp"
#include "core/document/words.hpp"
#include "core/modeling/measuring/measured_dimension.hpp"

namespace hariko {

namespace {

std::string six_digits(double value) {
  return rounded_text(value, 6);
}

std::string point_text(const Vector3& point) {
  return "(" + six_digits(point.x()) + ", " + six_digits(point.y()) + ", " + six_digits(point.z()) + ")";
}

/// Words for what an anchor holds on to, without its object.
struct HeldText {
  std::string operator()(const SpaceAnchor& anchor) const { return point_text(anchor.point); }
  std::string operator()(const ObjectAnchor& anchor) const {
    const std::string solid = anchor.solid ? " of solid " + std::to_string(*anchor.solid) : "";
    return point_text(anchor.point) + solid;
  }
  std::string operator()(const VertexAnchor& anchor) const {
    return (anchor.image ? "image of vertex " : "vertex ") + std::to_string(anchor.vertex.value);
  }
  std::string operator()(const EdgeAnchor& anchor) const {
    return "edge " + to_string(anchor.edge) + " at " + six_digits(anchor.share);
  }
  std::string operator()(const PatchAnchor& anchor) const {
    const std::string element = to_string(anchor.element);
    return element.empty() ? "surface" : element;
  }
  std::string operator()(const NearestAnchor& anchor) const {
    return "surface nearest to " + point_text(anchor.point);
  }
};

std::string anchor_text(const Document& document, const Anchor& anchor) {
  const std::string held = std::visit(HeldText(), anchor);
  const ObjectId* id = object_of(anchor);
  const Object* object = id ? document.find(*id) : nullptr;
  if (!id) return held;
  return held + " of " + (object ? object->name : "object " + std::to_string(id->value));
}

/// Surfaces at full quality, each made when it is first asked for.
class FinalSurfaces {
 public:
  explicit FinalSurfaces(const Document& document) : document_(document) {}

  const Surface* of(ObjectId id) {
    const auto known = made_.find(id);
    if (known != made_.end()) return pointer(known->second);
    const Object* object = document_.find(id);
    Surface surface;
    if (object && has_shape(*object))
      if (auto made = surface_or_facets(document_, *object)) surface = std::move(made).value();
    return pointer(made_.emplace(id, std::move(surface)).first->second);
  }

 private:
  static const Surface* pointer(const Surface& surface) {
    return surface.patch_count() > 0 ? &surface : nullptr;
  }
  const Document& document_;
  std::map<ObjectId, Surface> made_;
};

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

DimensionInfo inspect_dimension(const Document& document, const Dimension& dimension,
                                const SurfaceOf& surfaces) {
  DimensionInfo info;
  info.kind = enum_word(dimension.kind);
  for (const Anchor& anchor : dimension.anchors) info.anchors.push_back(anchor_text(document, anchor));
  const auto value = measured(document, dimension, surfaces);
  if (!value) return info;
  info.points = value->points;
  info.value =
      dimension.kind == DimensionKind::angle ? value->value * 180 / std::numbers::pi : finite(value->value);
  if (dimension.kind == DimensionKind::radius)
    info.radii = {finite(value->first_radius), finite(value->second_radius)};
  return info;
}

std::string value_text(const DimensionInfo& info, Unit unit) {
  const std::string length = " " + std::string(to_string(unit));
  if (info.kind == "radius" && !info.radii.empty()) {
    std::string text;
    for (const auto& radius : info.radii)
      text += (text.empty() ? "" : ", ") + (radius ? six_digits(*radius) + length : std::string("flat"));
    return text;
  }
  if (!info.value) return "-";
  return info.kind == "angle" ? six_digits(*info.value) + " degrees" : six_digits(*info.value) + length;
}

}  // namespace

std::string info_line(std::string label, const std::string& text) {
  label.resize(std::max<std::size_t>(label.size() + 2, 22), ' ');
  return label + text + "\n";
}

std::vector<DimensionInfo> inspect_dimensions(const Document& document) {
  FinalSurfaces surfaces(document);
  std::vector<DimensionInfo> out;
  for (const Dimension& dimension : *document.dimensions)
    out.push_back(
        inspect_dimension(document, dimension, [&surfaces](ObjectId id) { return surfaces.of(id); }));
  return out;
}

std::string dimensions_text(const std::vector<DimensionInfo>& dimensions, Unit unit) {
  if (dimensions.empty()) return {};
  std::string out = info_line("dimensions", std::to_string(dimensions.size()));
  for (const DimensionInfo& info : dimensions) {
    std::string anchors;
    for (const std::string& anchor : info.anchors) anchors += (anchors.empty() ? "" : " - ") + anchor;
    out += info_line(info.kind, value_text(info, unit) + "  (" + anchors + ")");
  }
  return out;
}

}  // namespace hariko
