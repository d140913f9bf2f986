#include "app/files/mesh_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/files/export_surfaces.hpp"
#include "app/files/walled_surface.hpp"
#include "core/approximation/decimation/decimate.hpp"
#include "core/document/object_box.hpp"
#include "core/document/object_shape.hpp"

namespace hariko {

namespace {

/// Options with lengths converted from the document's space to the object's.
MeshOptions in_object_space(MeshOptions options, double scale) {
  for (std::optional<double>* length : {&options.criteria.distance, &options.criteria.max_edge})
    if (*length) **length /= scale;
  return options;
}

/// Part of a promised distance that is reserved for the file's rounding: all of it where facets stay
/// unchanged.
std::optional<double> share_of_digits(const Object& object, const MeshRequest& request) {
  const std::optional<double>& distance = request.options.criteria.distance;
  if (!distance || (is_faceted(object) && !request.decimate)) return distance;
  if (!request.digits) return 0.0;
  Eigen::AlignedBox3d box = world_box(object);
  const double wall = std::abs(request.wall.offset) + request.wall.thickness;
  if (!box.isEmpty() && wall > 0) {
    box.min().array() -= wall;
    box.max().array() += wall;
  }
  return std::min(request.digits(box), 0.5 * *distance);
}

/// Fraction of a promised angle that is reserved for the file's rounding.
constexpr double share_of_turns = 0.01;

/// Part of promised angles that the mesh leaves for the file's rounding. A fold rotates with both facets.
std::optional<double> left_for_turns(const MeshCriteria& promised, const MeshApproximation& made) {
  std::optional<double> out;
  const auto leave = [&](const std::optional<double>& angle, const CriterionErrors& errors, double facets) {
    if (!angle || !errors.measured || errors.largest > *angle) return;
    const double left = (*angle - errors.largest) / facets;
    out = std::min(out.value_or(left), left);
  };
  leave(promised.normal_angle, made.normal_angle, 1);
  leave(promised.fold_angle, made.fold_angle, 2);
  return out;
}

void scale(ErrorField& field, double factor) {
  for (std::vector<float>* values : {&field.points, &field.facets})
    for (float& value : *values) value *= static_cast<float>(factor);
  field.largest *= factor;
  field.mean *= factor;
}

void place(MeshErrorMap& map, const Similarity& transform) {
  for (SurfaceSample& sample : map.samples) sample.position = transform.apply_to_vector(sample.position);
  for (ErrorField* field : {&map.distance, &map.normal_angle, &map.mesh_distance, &map.fold_angle})
    field->place = transform.apply_to_vector(field->place);
  scale(map.distance, transform.length_scale());
  scale(map.mesh_distance, transform.length_scale());
}

/// Turns a facet round, as its triangle is.
void turn_round(ParameterFacet& facet) {
  std::swap(facet.vertex[1], facet.vertex[2]);
  std::swap(facet.parameter[1], facet.parameter[2]);
  if (facet.pole < 0) return;
  if (facet.pole > 0) facet.pole = 3 - facet.pole;
  std::swap(facet.parameter[std::size_t(facet.pole)], facet.pole_parameter);
}

/// Moves a mesh from object space to the document's.
void place(MeshedObject& object, const Similarity& transform) {
  if (transform == Similarity{}) return;
  object.surface_origin = transform.apply(object.surface_origin);
  if (object.errors) place(*object.errors, transform);
  MeshApproximation& result = object.result;
  place(result.mesh, transform);
  if (transform.mirrors()) std::ranges::for_each(result.parts, turn_round);
  const double lengths = transform.length_scale();
  result.distance.largest *= lengths;
  result.distance.mean *= lengths;
  result.distance.bound *= lengths;
  for (float& error : result.distance.facets) error *= static_cast<float>(lengths);
  result.longest_edge *= lengths;
}

Message named(Message error, const std::string& name) {
  if (!name.empty()) error.text = name + ": " + error.text;
  return error;
}

/// Mesh of one surface, in its own space.
Result<MeshedObject> mesh_of(const Surface& surface, const std::string& name, const MeshRequest& request,
                             const CancelToken& cancel, const Progress& progress) {
  const double meshing = request.errors ? 0.7 : 1;
  auto made = approximate(surface, request.options, cancel, progress.part(0, meshing));
  if (!made.ok()) return named(made.error(), name);
  MeshedObject out{name, std::move(made).value(), {}, surface.origin()};
  if (!request.errors) return out;
  auto map =
      mesh_error_map(surface, out.result.mesh, out.result.parts, {}, cancel, progress.part(meshing, 1));
  if (!map.ok()) return named(map.error(), name);
  out.errors = std::move(map).value();
  return out;
}

/// Reference mesh with fewer facets, in its own space; deviations are measured from the original facets.
Result<MeshedObject> decimated(const MeshSource& source, const std::string& name, const MeshRequest& request,
                               const CancelToken& cancel, const Progress& progress) {
  auto made =
      decimate(triangles_of(source), request.options, cancel, progress.part(0, request.errors ? 0.7 : 1));
  if (!made.ok()) return named(made.error(), name);
  MeshedObject out{name, std::move(made).value(), {}, source.origin};
  if (!request.errors) return out;
  auto map = mesh_error_map(facets_of(source), out.result.mesh, {}, {}, cancel, progress.part(0.7, 1));
  if (!map.ok()) return named(map.error(), name);
  out.errors = std::move(map).value();
  return out;
}

/// Unchanged reference facets, without deviation.
MeshedObject as_it_is(const MeshSource& source, const std::string& name) {
  MeshedObject out{name, {}, {}, source.origin};
  out.result.mesh = triangles_of(source);
  for (CriterionErrors* errors : {&out.result.distance, &out.result.normal_angle})
    errors->measured = errors->certified = true;
  return out;
}

/// Mesh of an object, in its own space.
Result<MeshedObject> mesh_object(const Document& document, const Object& object, const MeshRequest& request,
                                 const CancelToken& cancel, const Progress& progress) {
  if (is_faceted(object))
    return request.decimate ? decimated(*object.mesh(), object.name, request, cancel, progress)
                            : as_it_is(*object.mesh(), object.name);
  const auto built = walled_surface(document, object, request.wall, FoldedWalls::refuse, cancel);
  if (!built.ok()) return built.error();
  auto made = mesh_of(built->surface, object.name, request, cancel, progress);
  if (made.ok()) made.value().warnings = built->warnings;
  return made;
}

}  // namespace

void MeshedObject::add(const FileRounding& rounding) {
  result.distance.largest += rounding.distance;
  result.distance.bound += rounding.distance;
  result.normal_angle.largest += rounding.turn;
  result.normal_angle.bound += rounding.turn;
  result.fold_angle.largest += 2 * rounding.turn;
}

Result<std::vector<MeshedObject>> mesh_surfaces(const Document& document, const MeshRequest& request,
                                                const CancelToken& cancel, const Progress& progress) {
  if (auto wrong = why_no_wall(document, request.wall)) return *wrong;
  std::vector<MeshedObject> out;
  const auto count = static_cast<double>(document.objects.size());
  double number = 0;
  for (const auto& object : document.objects) {
    const Progress part = progress.part(number / count, (number + 1) / count);
    ++number;
    if (!object->visible || !has_shape(*object)) continue;
    MeshRequest own = request;
    const std::optional<double> digits = share_of_digits(*object, request);
    if (digits) *own.options.criteria.distance -= *digits;
    if (request.digits)
      for (std::optional<double>* angle :
           {&own.options.criteria.normal_angle, &own.options.criteria.fold_angle})
        if (*angle) **angle *= 1 - share_of_turns;
    own.options = in_object_space(own.options, object->transform.scale);
    auto made = mesh_object(document, *object, own, cancel, part);
    if (!made.ok()) return made.error();
    made.value().colour = colour_of(*object);
    made.value().most_rounding = digits;
    made.value().most_turn = left_for_turns(request.options.criteria, made->result);
    const std::vector<Similarity> places = places_of(*object);
    for (std::size_t k = 0; k < places.size(); ++k) {
      out.push_back(*made);
      out.back().name = name_of_place(*object, k);
      if (k > 0) out.back().warnings.clear(), out.back().result.warnings.clear();
      place(out.back(), places[k]);
    }
  }
  if (out.empty())
    return make_error(e_no_surface, "There is nothing to approximate.", "Show an object or import one.");
  return out;
}

namespace {

/// Enlarged box, as surfaces may extend beyond their sources.
Eigen::AlignedBox3d enlarged(const Eigen::AlignedBox3d& box) {
  const Vector3 more = Vector3::Constant(box.diagonal().norm());
  return {box.min() - more, box.max() + more};
}

}  // namespace

FileDigits file_digits(const Document& document, const std::filesystem::path& path,
                       const WriteOptions& options) {
  const FileNumbers numbers = file_numbers(path, options);
  if (numbers.kind == FileNumbers::Kind::exact) return {};
  Eigen::AlignedBox3d whole;
  for (const auto& object : document.objects)
    if (object->visible && has_shape(*object)) whole.extend(world_box(*object));
  const Vector3 zero =
      options.to_zero && !whole.isEmpty() ? Vector3(whole.center()) : Vector3(Vector3::Zero());
  return [numbers, zero](const Eigen::AlignedBox3d& box) {
    return box.isEmpty() ? 0 : largest_rounding(enlarged(box).translated(-zero), numbers);
  };
}

}  // namespace hariko
