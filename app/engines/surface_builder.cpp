#include "app/engines/surface_builder.hpp"

#include <algorithm>
#include <chrono>
#include <exception>

#include "app/files/walled_surface.hpp"
#include "core/analysis/combs.hpp"
#include "core/analysis/continuity.hpp"
#include "core/document/object_shape.hpp"
#include "core/modeling/surfacing/merged_faces.hpp"
#include "core/polyhedron/validation.hpp"
#include "ui/editor/view_map.hpp"

namespace hariko {

namespace {

constexpr Code e_rebuild_failed{"E_REBUILD_FAILED"};
constexpr int histogram_bins = 48;

/// Map that is shown for an object: reference meshes have no curvature.
SurfaceMap possible_map(const Object& object) {
  const SurfaceMap map = object.display.map;
  return can_show(object, map) ? map : SurfaceMap::shaded;
}

Message without_reference(ReferenceState state) {
  constexpr const char* remedy = "Choose another object in the properties, or show it.";
  switch (state) {
    case ReferenceState::itself:
      return make_error(e_map_reference, "This object is the reference that the others deviate from.",
                        remedy);
    case ReferenceState::hidden:
      return make_error(e_map_reference, "The reference is hidden.", remedy);
    case ReferenceState::waiting:
      return make_error(e_map_reference, "The surface of the reference is not ready.", remedy);
    default:
      return make_error(e_map_reference, "There is no reference to deviate from.", remedy);
  }
}

bool same_shape(const Object& a, const Object& b) {
  return a.source == b.source;
}

// Sources without faces of the designer's own.
void add_face_shapes(const MeshSource&, std::vector<Message>&) {}
void add_face_shapes(const PatchSource&, std::vector<Message>&) {}
void add_face_shapes(const BezierSource&, std::vector<Message>&) {}
void add_face_shapes(const SolidsSource&, std::vector<Message>&) {}
void add_face_shapes(const SkinSource&, std::vector<Message>&) {}
void add_face_shapes(const OutlineSource&, std::vector<Message>&) {}
void add_face_shapes(const PictureSource&, std::vector<Message>&) {}
void add_face_shapes(const UnknownSource&, std::vector<Message>&) {}

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
/// the whole would exceed what a screen can use. Stripes show the corners of triangles most: there are more
/// of them as soon as no gesture runs.
int density_of(const Object& object, const Surface& surface, SurfaceMap map, Quality quality) {
  if (is_faceted(object)) return facet_density(map, surface.patch_count());
  const bool stripes =
      quality == Quality::final && (map == SurfaceMap::zebra || map == SurfaceMap::isophotes);
  constexpr double largest_budget = 2'000'000;  // triangles
  const double smooth_budget = stripes ? 200'000 : 30'000;
  const int smooth_density = stripes ? 32 : 24;
  const auto within = [&](double budget) {
    return display_density(surface.patch_count(), surface.domain(), budget);
  };
  const int wanted = std::max(object.display.density, std::min(smooth_density, within(smooth_budget)));
  return std::min(wanted, std::max(3, within(largest_budget)));
}

}  // namespace

SurfaceView SurfaceBuilder::build(const std::shared_ptr<const Object>& object,
                                  const ObjectPointers& neighbours, const MapSurroundings& surroundings,
                                  Quality quality, const CancelToken& cancel) {
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
      const auto* envelope = std::get_if<std::shared_ptr<const EnvelopeSurface>>(&last_.details);
      sticks_out_ = envelope ? (*envelope)->sticks_out : std::nullopt;
      last_.details = {};
      made_from_ = object;
      made_beside_ = neighbours;
      last_quality_ = quality;
      combs_.reset();
    }
    take_mesh(*object, surroundings, fresh, view, cancel);
    if (!view.mesh) return view;  // cancelled
    view.surface = last_.surface;
    view.provisional = last_.provisional;
    if (const CombSettings& combs = object->display.combs; combs.shown) {
      if (!combs_ || combs_->density != combs.density)
        combs_ = comb_lines(curvature_combs(last_.surface, combs.density, cancel), last_.surface.origin());
      view.combs = combs_;
    }
    view.warnings = last_.warnings;
    view.sticks_out = sticks_out_;
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

Result<ObjectSurface> SurfaceBuilder::surface_of(const Object& object, const ObjectPointers& neighbours,
                                                 Quality quality, const CancelToken& cancel) {
  if (is_faceted(object)) {
    ObjectSurface out;
    out.surface = facets_of(*object.mesh());
    out.revision = ++facet_revision_;
    return out;
  }
  auto made = surfacer_.surface(object, neighbours, quality, cancel);
  if (made.ok() && quality == Quality::final)
    std::visit([&](const auto& source) { add_face_shapes(source, made.value().warnings); }, object.source);
  return made;
}

MapPlace SurfaceBuilder::place_of(const Object& object, const MapSurroundings& surroundings) {
  MapPlace place;
  place.transform = surroundings.transform;
  place.facets = is_faceted(object);
  place.pull = surroundings.pull;
  place.reference_transform = surroundings.reference_transform;
  if (surroundings.state != ReferenceState::ready) {
    reference_.reset();
    place.no_reference = without_reference(surroundings.state);
    return place;
  }
  // A reference that was only moved is searched as before.
  const Surface& surface = surroundings.reference;
  const bool known = reference_ && &reference_->surface().patches() == &surface.patches() &&
                     reference_->surface().origin() == surface.origin();
  if (!known)
    reference_ = std::make_shared<const DeviationReference>(surface, surroundings.reference_facets
                                                                         ? DeviationReference::Kind::facets
                                                                         : DeviationReference::Kind::smooth);
  place.reference = reference_;
  return place;
}

/// Makes the mesh of the last surface with the values of the object's map; none where cancelled. A map that
/// the object cannot have leaves the mesh without values, and says why.
void SurfaceBuilder::take_mesh(const Object& object, const MapSurroundings& surroundings, bool fresh,
                               SurfaceView& view, const CancelToken& cancel) {
  const SurfaceMap map = possible_map(object);
  const int density = density_of(object, last_.surface, map, view.quality);
  const bool same_look = base_mesh_ && map == map_ && base_mesh_->options().density == density &&
                         same_values(surroundings, surroundings_) &&
                         (!rough_ || view.quality == Quality::drag);
  if (!fresh && view.quality == Quality::drag && last_.changed && same_look && is_local(map) &&
      last_.base_revision == base_revision_) {
    view.mesh = base_mesh_->refreshed(last_.surface, *last_.changed);
  } else if (fresh && same_look && last_.revision == base_revision_) {
    view.mesh = base_mesh_;
  } else {
    MapPlace place = place_of(object, surroundings);
    place.rough = view.quality == Quality::drag;
    const auto options = map_options(last_.surface, map, density, place);
    view.mesh = DisplayMesh::build(last_.surface,
                                   options ? *options : map_options(SurfaceMap::shaded, density), cancel);
    if (!view.mesh) return;
    map_error_ = options ? std::nullopt : std::optional(options.error());
    base_mesh_ = view.mesh;
    base_revision_ = last_.revision;
    surroundings_ = surroundings;
    rough_ = place.rough && !is_local(map);
  }
  view.map_error = map_error_;
  if (has_values(map) && !map_error_) take_range(object, surroundings.limit, view);
  map_ = map;
}

/// Sets the map's range. During a drag it stays fixed, so that colours remain comparable.
void SurfaceBuilder::take_range(const Object& object, double limit, SurfaceView& view) {
  const SurfaceMap map = object.display.map;
  const MapRange& settings = range_of(object.display, map);
  if (view.quality == Quality::final || map != map_ || !(settings == range_settings_) ||
      (has_limit(map) && range_.centre != limit)) {
    const auto values = values_of(*view.mesh, map);
    range_ = value_range(map, settings, values, limit);
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
