#include "app/engines/surface_builder.hpp"

#include <algorithm>
#include <chrono>
#include <exception>

#include "app/files/reference_facets.hpp"
#include "core/analysis/combs.hpp"
#include "core/analysis/continuity.hpp"
#include "core/modeling/surfacing/merged_faces.hpp"
#include "core/polyhedron/validation.hpp"
#include "render/surface_maps.hpp"

namespace hariko {

namespace {

constexpr Code e_rebuild_failed{"E_REBUILD_FAILED"};
constexpr int histogram_bins = 48;

/// Map that is shown for an object: reference meshes have no curvature.
SurfaceMap shown_map(const Object& object) {
  const SurfaceMap map = object.display.map;
  return object.mesh() && has_values(map) ? SurfaceMap::shaded : map;
}

bool same_shape(const Object& a, const Object& b) {
  return a.source == b.source;
}

/// Prepends warnings about the shape of the designer's faces to the surface's own, which follow from them.
void add_face_shapes(const PolyhedronSource& source, std::vector<Message>& warnings) {
  std::vector<Message> all = face_shape_warnings_of(source.polyhedron);
  if (source.preparation.split_concave)
    std::erase_if(all, [](const Message& warning) { return warning.code == w_concave_face; });
  std::vector<Message> merged = merge_warnings_of(source);
  all.insert(all.end(), std::make_move_iterator(merged.begin()), std::make_move_iterator(merged.end()));
  all.insert(all.end(), std::make_move_iterator(warnings.begin()), std::make_move_iterator(warnings.end()));
  warnings = std::move(all);
}

/// Display density: as requested; higher on small models, whose outlines would show corners, and lower where
/// the whole would exceed what a screen can use.
int density_of(const Object& object, const Surface& surface) {
  if (object.mesh()) return 1;
  constexpr double smooth_budget = 30'000, largest_budget = 2'000'000;  // triangles
  constexpr int smooth_density = 24;
  const auto within = [&](double budget) {
    return display_density(surface.patch_count(), surface.domain(), budget);
  };
  const int wanted = std::max(object.display.density, std::min(smooth_density, within(smooth_budget)));
  return std::min(wanted, std::max(3, within(largest_budget)));
}

}  // namespace

SurfaceView SurfaceBuilder::build(const std::shared_ptr<const Object>& object,
                                  const ObjectPointers& neighbours, Quality quality,
                                  const CancelToken& cancel) {
  const auto start = std::chrono::steady_clock::now();
  SurfaceView view;
  view.object = object;
  view.quality = quality;
  try {
    const bool fresh = made_from_ && last_quality_ == Quality::final && same_shape(*made_from_, *object) &&
                       made_beside_ == neighbours &&
                       (neighbours.empty() || made_from_->transform == object->transform);
    if (!fresh) {
      auto made = surface_of(*object, neighbours, quality, cancel);
      if (!made.ok()) {
        view.error = made.error();
        return view;
      }
      last_ = std::move(made).value();
      made_from_ = object;
      made_beside_ = neighbours;
      last_quality_ = quality;
      combs_.reset();
    }
    const int density = density_of(*object, last_.surface);
    const SurfaceMap map = shown_map(*object);
    const bool same_look = base_mesh_ && map == map_ && base_mesh_->options().density == density;
    if (!fresh && quality == Quality::drag && last_.changed && same_look &&
        last_.base_revision == base_revision_) {
      view.mesh = base_mesh_->refreshed(last_.surface, *last_.changed);
    } else if (fresh && same_look && last_.revision == base_revision_) {
      view.mesh = base_mesh_;
    } else {
      view.mesh = DisplayMesh::build(last_.surface, map_options(map, density), cancel);
      if (!view.mesh) return view;  // cancelled
      base_mesh_ = view.mesh;
      base_revision_ = last_.revision;
    }
    if (has_values(map)) take_range(*object, view);
    map_ = map;
    view.surface = last_.surface;
    if (const CombSettings& combs = object->display.combs; combs.shown) {
      if (!combs_ || combs_->density != combs.density)
        combs_ = comb_lines(curvature_combs(last_.surface, combs.density, cancel), last_.surface.origin());
      view.combs = combs_;
    }
    view.warnings = last_.warnings;
    view.sticks_out = last_.sticks_out;
  } catch (const std::exception& failure) {
    // Mostly out of memory: the document is untouched, and the object shows the error.
    made_from_.reset();
    base_mesh_.reset();
    view = SurfaceView{};
    view.object = object;
    view.quality = quality;
    view.error = make_error(e_rebuild_failed,
                            std::string("The surface could not be computed: ") + failure.what() + ".",
                            "Lower the display density or simplify the object.");
  }
  view.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return view;
}

Result<PolyhedronSurface> SurfaceBuilder::surface_of(const Object& object, const ObjectPointers& neighbours,
                                                     Quality quality, const CancelToken& cancel) {
  if (const MeshSource* mesh = object.mesh()) {
    PolyhedronSurface out;
    out.surface = facets_of(*mesh);
    out.revision = ++facet_revision_;
    return out;
  }
  auto made = surfacer_.surface(object, neighbours, quality, cancel);
  if (made.ok() && object.polyhedron() && quality == Quality::final)
    add_face_shapes(*object.polyhedron(), made.value().warnings);
  return made;
}

/// Sets the map's range. During a drag it stays fixed, so that colours remain comparable.
void SurfaceBuilder::take_range(const Object& object, SurfaceView& view) {
  const SurfaceMap map = object.display.map;
  const MapRange& settings = range_of(object.display, map);
  if (view.quality == Quality::final || map != map_ || !(settings == range_settings_)) {
    const auto values = values_of(*view.mesh, map);
    range_ = value_range(map, settings, values);
    histogram_ = histogram(values, range_, histogram_bins);
    range_settings_ = settings;
  }
  view.range = range_;
  view.histogram = histogram_;
}

ContinuityReport SurfaceBuilder::measure(const Surface& surface, const CancelToken& cancel) {
  return continuity(surface, cancel);
}

}  // namespace hariko
