#include "core/modeling/surfacing/convert_object.hpp"

#include "core/document/edits/edit_elements.hpp"
#include "core/document/edits/edit_support.hpp"
#include "core/gaussmap/control_points.hpp"
#include "core/gaussmap/outline_polyhedron.hpp"

namespace hariko {
namespace {

Result<PolyhedronSource> converted(const OutlineSource& source, const CancelToken& cancel) {
  const auto points = control_points(*source.outline, gauss_options(source.settings), cancel);
  if (!points) return points.error();
  auto made = outline_polyhedron(*points, source.settings.frames);
  if (!made) return made.error();
  const Mode mode = source.settings.curvature_continuous ? Mode::g2 : Mode::fair;
  PolyhedronSource out{made->origin, made->polyhedron, made->shaping, mode, {}};
  out.frames = source.settings.frames;
  return out;
}

}  // namespace

Result<Document> convert_outline(const Document& document, ObjectId id, const CancelToken& cancel) {
  return detail::change_object(document, id, true, [&](Object& object) -> Result<Done> {
    const OutlineSource* outline = object.outline();
    if (!outline)
      return make_error(e_wrong_kind, "The object \"" + object.name + "\" is no outline.",
                        "Select an outline.", element_of(id));
    auto made = converted(*outline, cancel);
    if (!made) return made.error();
    object.source = std::move(made).value();
    object.display.polyhedron = true;
    object.display.points = false;  // a hundred and more, close to each other
    return Done{};
  });
}

}  // namespace hariko
