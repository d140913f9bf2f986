#include "app/export_triangles.hpp"

#include <algorithm>

#include "app/files/export_surfaces.hpp"
#include "app/files/mesh_surfaces.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/modeling/attached.hpp"
#include "render/camera.hpp"

namespace hariko {

namespace {

MeshOptions options_of(const ExportSettings& settings) {
  MeshOptions options;
  options.criteria.distance = settings.distance;
  if (settings.angle > 0) options.criteria.normal_angle = settings.angle;
  options.optimise = settings.optimise;
  return options;
}

/// A mesh of the whole density, without making it.
Result<ExportCount> count_by_density(const Document& document, int density, const CancelToken& cancel) {
  ExportCount count;
  const auto n = static_cast<std::size_t>(density);
  for (const auto& object : document.objects) {
    if (!object->visible || !object->has_surface()) continue;
    const auto built = object_surface(document, *object, cancel);
    if (!built.ok()) return built.error();
    const Surface& surface = built->surface;
    count.triangles += surface.patch_count() * n * n * (surface.domain() == Domain::triangle ? 1 : 2);
  }
  return count;
}

ExportReport report_of(std::span<const NamedTriangles> meshes, double scale,
                       const std::filesystem::path& path) {
  ExportReport report;
  Box3 box;
  for (const NamedTriangles& named : meshes) {
    report.triangles += named.mesh->triangles.size();
    for (const Vector3& position : named.mesh->positions) box.extend(named.mesh->origin + position);
  }
  if (!box.isEmpty()) report.size = scale * box.sizes();
  std::error_code unknown;
  const auto bytes = std::filesystem::file_size(path, unknown);
  if (!unknown) report.bytes = bytes;
  return report;
}

}  // namespace

Result<ExportCount> count_triangles(const Document& document, const ExportSettings& settings,
                                    const CancelToken& cancel) {
  if (settings.by == ExportSettings::By::density) return count_by_density(document, settings.density, cancel);
  MeshOptions options = options_of(settings);
  options.report = MeshReport::all;
  const auto meshed = mesh_surfaces(document, {options}, cancel);
  if (!meshed.ok()) return meshed.error();
  ExportCount count;
  count.certain = true;
  for (const MeshedObject& object : *meshed) {
    const MeshApproximation& made = object.result;
    count.triangles += made.mesh.triangles.size();
    count.certain = count.certain && made.distance.certified;
    count.distance = std::max(count.distance, std::max(made.distance.largest, made.distance.bound));
    count.angle = std::max(count.angle, made.normal_angle.largest);
    count.reached = count.reached && made.reached();
  }
  return count;
}

Result<ExportReport> export_triangles(const Document& document, const std::filesystem::path& path,
                                      const ExportSettings& settings, const CancelToken& cancel,
                                      const Progress& progress) {
  constexpr double writing = 0.75;  // what making the triangles takes of the whole, about
  const Progress making = progress.part(0, writing);
  std::vector<MeshedObject> tolerated;
  std::vector<NamedMesh> meshes;
  std::vector<NamedTriangles> named;
  if (settings.by == ExportSettings::By::density) {
    auto made = density_meshes(document, settings.density, cancel, making);
    if (!made.ok()) return made.error();
    meshes = std::move(made).value();
    for (const NamedMesh& mesh : meshes) named.push_back({mesh.name, &mesh.mesh, mesh.colour});
  } else {
    auto made = mesh_surfaces(document, {options_of(settings)}, cancel, making);
    if (!made.ok()) return made.error();
    tolerated = std::move(made).value();
    for (const MeshedObject& object : tolerated)
      named.push_back({object.name, &object.result.mesh, object.colour});
  }
  progress.report(writing);
  const auto written = write_mesh_file(path, named, write_options(document, settings.choices, cancel));
  if (!written.ok()) return written.error();
  return report_of(named, settings.choices.scale, path);
}

}  // namespace hariko
