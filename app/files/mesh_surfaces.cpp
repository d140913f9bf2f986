#include "app/files/mesh_surfaces.hpp"

#include <Eigen/Geometry>

#include "app/files/export_surfaces.hpp"
#include "core/base/printable.hpp"
#include "core/exchange/read_patches.hpp"
#include "core/modeling/attached.hpp"
#include "core/surface/weld_patches.hpp"

namespace hariko {

namespace {

/// Lengths from the document's space to the object's.
MeshOptions in_object_space(MeshOptions options, double scale) {
  for (std::optional<double>* length : {&options.criteria.distance, &options.criteria.max_edge})
    if (*length) **length /= scale;
  return options;
}

/// From object space to the document's.
void place(MeshApproximation& result, const Similarity& transform) {
  if (transform == Similarity{}) return;
  TriangleMesh& mesh = result.mesh;
  mesh.origin = transform.apply(mesh.origin);
  for (Vector3& position : mesh.positions) position = transform.apply_to_vector(position);
  for (Vector3& normal : mesh.normals) normal = transform.rotation * normal;
  result.distance.largest *= transform.scale;
  result.distance.mean *= transform.scale;
  result.distance.bound *= transform.scale;
  for (float& error : result.distance.facets) error *= static_cast<float>(transform.scale);
  result.longest_edge *= transform.scale;
}

Message named(Message error, const std::string& name) {
  if (!name.empty()) error.text = name + ": " + error.text;
  return error;
}

Vector3 centre_of(const std::vector<BezierPatch>& patches) {
  Eigen::AlignedBox3d box;
  for (const BezierPatch& patch : patches)
    for (const Vector3& p : patch.points) box.extend(p);
  return 0.5 * (box.min() + box.max());
}

}  // namespace

Result<std::vector<MeshedObject>> mesh_surfaces(const Document& document, const MeshOptions& options,
                                                const CancelToken& cancel, const Progress& progress) {
  std::vector<MeshedObject> out;
  const auto count = static_cast<double>(document.objects.size());
  double number = 0;
  for (const auto& object : document.objects) {
    const Progress part = progress.part(number / count, (number + 1) / count);
    ++number;
    if (!object->visible || !object->cage()) continue;
    const auto built = object_surface(document, *object, cancel);
    if (cancel.cancelled()) return make_error(e_cancelled, "The meshing was cancelled.");
    if (!built.ok()) return named(built.error(), object->name);
    auto made = approximate(built->surface, in_object_space(options, object->transform.scale), cancel, part);
    if (!made.ok()) return named(made.error(), object->name);
    place(made.value(), object->transform);
    out.push_back({object->name, std::move(made).value()});
  }
  if (out.empty())
    return make_error(e_no_surface, "There is nothing to approximate.", "Show an object or import one.");
  return out;
}

Result<std::vector<MeshedObject>> mesh_patch_file(const std::filesystem::path& file,
                                                  const MeshOptions& options, const CancelToken& cancel,
                                                  const Progress& progress) {
  auto groups = read_patch_file(file);
  if (!groups.ok()) return groups.error();
  std::vector<MeshedObject> out;
  const auto count = static_cast<double>(groups->size());
  for (NamedPatches& group : groups.value()) {
    const std::string name = group.name.empty() ? printable(file.stem().string(), 200) : group.name;
    const Vector3 origin = centre_of(group.patches);
    for (BezierPatch& patch : group.patches)
      for (Vector3& p : patch.points) p -= origin;
    const auto surface = weld_patches(origin, std::move(group.patches));
    if (!surface.ok()) return named(surface.error(), name);
    const double done = double(out.size());
    auto made = approximate(*surface, options, cancel, progress.part(done / count, (done + 1) / count));
    if (!made.ok()) return named(made.error(), name);
    out.push_back({name, std::move(made).value()});
  }
  return out;
}

}  // namespace hariko
