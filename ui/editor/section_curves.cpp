#include "ui/editor/section_curves.hpp"

#include "core/document/object_box.hpp"
#include "core/document/object_shape.hpp"
#include "render/picture.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

namespace {

/// Largest distance of drawn curves behind the triangles of the screen, of the size of all surfaces.
constexpr double drawn_depth = 2e-3;

/// Collects polylines for the GPU.
class LineCollector {
 public:
  explicit LineCollector(const SectionSet& set) : out_(std::make_shared<FacetLines>()) {
    if (!set.curves.empty()) out_->origin = set.curves.front().points.front();
    out_->depth = drawn_depth * set.size;
  }
  template <class Points>
  void add(const Points& points) {
    auto last = no_index;
    for (const Vector3& p : points) {
      const Vector3 local = p - out_->origin;
      const auto number = static_cast<Index>(out_->points.size());
      out_->points.push_back(
          {static_cast<float>(local.x()), static_cast<float>(local.y()), static_cast<float>(local.z())});
      if (last != no_index) out_->edges.push_back({last, number});
      last = number;
    }
  }
  std::shared_ptr<const FacetLines> take() { return out_->edges.empty() ? nullptr : std::move(out_); }

 private:
  std::shared_ptr<FacetLines> out_;
};

}  // namespace

std::shared_ptr<const FacetLines> drawn_section_lines(const SectionSet& set) {
  LineCollector lines(set);
  for (const SectionCurve& curve : set.curves) lines.add(curve.points);
  return lines.take();
}

std::shared_ptr<const FacetLines> drawn_section_teeth(const SectionSet& set, const SectionCombs& combs) {
  const double length = combs.shown ? tooth_length(set, combs.scale) : 0;
  if (!(length > 0)) return nullptr;
  LineCollector lines(set);
  for (const SectionCurve& curve : set.curves) {
    const CombShape comb = comb_shape(curve, set.size, length);
    for (const auto& tooth : comb.teeth) lines.add(tooth);
    lines.add(comb.tips);
  }
  return lines.take();
}

std::vector<DrawnSurface> surfaces_to_cut(const Editor& editor) {
  std::vector<DrawnSurface> out;
  for (const auto& object : editor.document().objects) {
    const SurfaceView* view =
        object->visible && object->display.surface && editor.views ? editor.view_of(object->id) : nullptr;
    if (!view || view->surface.patch_count() == 0) continue;
    for (const Similarity& place : places_of(*object))
      out.push_back({view->surface, Eigen::Affine3d(matrix_of(place))});
  }
  return out;
}

Box3 box_to_cut(const Editor& editor) {
  Box3 box;
  for (const auto& object : editor.document().objects)
    if (object->visible && has_shape(*object)) box.extend(world_box(*object));
  return box;
}

SectionPlanes spread_over_visible(const Editor& editor, const SectionPlanes& planes) {
  const Box3 box = box_to_cut(editor);
  return box.isEmpty() ? planes : spread_planes(planes.direction, planes.count, box);
}

Result<SectionOrder> order_sections(const Editor& editor, const std::filesystem::path& file) {
  if (!editor.stale_since.empty())
    return make_error(e_surface_pending, "A surface is still being computed.",
                      "Export the curves when it is ready.");
  SectionOrder out;
  out.surfaces = surfaces_to_cut(editor);
  if (out.surfaces.empty())
    return make_error(e_nothing_to_show, "No surface is visible: there is nothing to cut.",
                      "Show the surface of an object, or add one.");
  out.planes = editor.sections.planes;
  out.combs = editor.sections.combs;
  out.millimetres = millimetres_per(editor.document().unit);
  out.file = file;
  return out;
}

}  // namespace hariko
