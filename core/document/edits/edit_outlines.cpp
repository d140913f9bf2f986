#include "core/document/edits/edit_outlines.hpp"

#include <cmath>

#include "core/document/edits/edit_elements.hpp"
#include "core/document/edits/edit_support.hpp"
#include "core/document/format/read_outline.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {
namespace {

/// Calls change(OutlineSource&) -> Result<Done> on a copy of the object's outline.
template <class Change>
Result<Document> change_source(const Document& document, ObjectId id, Change&& change) {
  return detail::change_object(document, id, true, [&](Object& object) -> Result<Done> {
    auto* source = std::get_if<OutlineSource>(&object.source);
    if (!source)
      return make_error(e_wrong_kind, "The object \"" + object.name + "\" is not an outline.",
                        "Select an outline.", element_of(id));
    return change(*source);
  });
}

bool all_finite(const Outline& outline) {
  for (const OutlineLoop& loop : outline.loops) {
    for (std::size_t i = 0; i < loop.points.size(); ++i)
      if (!loop.points[i].allFinite() || !loop.normals[i].allFinite()) return false;
    for (const double value : loop.curvature)
      if (!std::isfinite(value)) return false;
  }
  return true;
}

}  // namespace

Result<Document> edit_outline(const Document& document, ObjectId id,
                              const std::function<Result<Outline>(const Outline&)>& change) {
  return change_source(document, id, [&](OutlineSource& source) -> Result<Done> {
    Result<Outline> made = change(*source.outline);
    if (!made) return made.error();
    if (!all_finite(*made))
      return make_error(e_nonfinite, "A point of the outline would lie infinitely far away.",
                        "Give it finite numbers.", element_of(id));
    if (made->point_count() > max_outline_points)
      return make_error(e_outline_limit,
                        "An outline has at most " + std::to_string(max_outline_points) + " points.",
                        "Use fewer points.", element_of(id));
    if (!(*made == *source.outline)) source.outline = std::move(made).value();
    return Done{};
  });
}

Result<Document> set_outline_settings(const Document& document, ObjectId id,
                                      const OutlineSettings& settings) {
  return change_source(document, id, [&](OutlineSource& source) -> Result<Done> {
    const bool radius = settings.radius >= OutlineSettings::smallest_radius &&
                        settings.radius <= OutlineSettings::largest_radius;
    const bool gap = !settings.gap || (std::isfinite(*settings.gap) && *settings.gap > 0);
    if (!radius || !gap || settings.most_points > OutlineSettings::point_limit)
      return make_error(
          e_outline_settings, "The spacing, the gap or the number of points is out of its range.",
          "Give a spacing from 0.01 to 100, a gap above zero, and at most 20000 points.", element_of(id));
    source.settings = settings;
    return Done{};
  });
}

}  // namespace hariko
