#include "app/jobs/export_triangles.hpp"

#include <algorithm>

#include "app/files/export_surfaces.hpp"
#include "app/files/left_out.hpp"
#include "app/files/mesh_surfaces.hpp"
#include "app/files/walled_surface.hpp"
#include "core/document/object_shape.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
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

/// All triangles of an export; `meshes` borrows from `tolerated`.
struct ExportMeshes {
  std::vector<MeshedObject> tolerated;
  std::vector<NamedMesh> meshes;

  std::vector<NamedTriangles> named() const {
    std::vector<NamedTriangles> out;
    for (const MeshedObject& object : tolerated) out.push_back(object.named());
    for (const NamedMesh& mesh : meshes) out.push_back({mesh.name, &mesh.mesh, mesh.colour});
    return out;
  }
  /// Warnings of the meshing, such as tolerances that were not reached.
  std::vector<Message> warnings() const {
    std::vector<Message> out;
    const auto add = [&](const std::vector<Message>& own) { out.insert(out.end(), own.begin(), own.end()); };
    for (const MeshedObject& object : tolerated) {
      add(object.warnings);
      add(object.result.warnings);
    }
    for (const NamedMesh& mesh : meshes) add(mesh.warnings);
    return out;
  }
};

Result<ExportMeshes> export_meshes(const Document& document, const std::filesystem::path& path,
                                   const ExportSettings& settings, MeshReport report,
                                   const CancelToken& cancel, const Progress& progress) {
  ExportMeshes out;
  if (settings.by == ExportSettings::By::density) {
    auto made = density_meshes(document, settings.density, cancel, progress, settings.wall);
    if (!made.ok()) return made.error();
    out.meshes = std::move(made).value();
    return out;
  }
  MeshRequest request{options_of(settings)};
  request.options.report = report;
  request.digits = file_digits(document, path, write_options(document, settings.choices));
  request.wall = settings.wall;
  auto made = mesh_surfaces(document, request, cancel, progress);
  if (!made.ok()) return made.error();
  out.tolerated = std::move(made).value();
  return out;
}

/// Number of triangles at a density, without making them.
Result<ExportCount> count_by_density(const Document& document, int density, const CancelToken& cancel) {
  ExportCount count;
  const auto n = static_cast<std::size_t>(density);
  for (const auto& object : document.objects) {
    if (!object->visible || !has_shape(*object)) continue;
    if (is_faceted(*object)) {
      count.triangles += triangles_of(*object->mesh()).triangles.size() * place_count(*object);
      continue;
    }
    const auto built = object_surface(document, *object, cancel);
    if (!built.ok()) return built.error();
    const Surface& surface = built->surface;
    const std::size_t own = surface.patch_count() * n * n * (surface.domain() == Domain::triangle ? 1 : 2);
    count.triangles += own * place_count(*object);
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

Result<ExportCount> count_triangles(const Document& document, const std::filesystem::path& path,
                                    const ExportSettings& settings, const CancelToken& cancel) {
  const bool exact = file_numbers(path, {}).kind == FileNumbers::Kind::exact;
  if (exact && settings.by == ExportSettings::By::density && settings.wall.none())
    return count_by_density(document, settings.density, cancel);
  auto made = export_meshes(document, path, settings, MeshReport::all, cancel, {});
  if (!made.ok()) return made.error();
  const auto named = made->named();
  const auto checked = check_mesh_file(path, named, write_options(document, settings.choices));
  if (!checked.ok()) return checked.error();
  ExportCount count;
  for (std::size_t i = 0; i < named.size(); ++i) {
    count.triangles += named[i].mesh->triangles.size() - checked->rounding[i].left_out;
    count.rounding = std::max(count.rounding, checked->rounding[i].distance);
  }
  count.certain = true;
  std::size_t i = 0;
  for (MeshedObject& object : made.value().tolerated) {
    object.add(checked->rounding[i++]);
    const MeshApproximation& result = object.result;
    count.certain = count.certain && result.distance.certified;
    count.distance = std::max(count.distance, std::max(result.distance.largest, result.distance.bound));
    count.angle = std::max(count.angle, result.normal_angle.largest);
    count.reached = count.reached && result.reached();
  }
  return count;
}

Result<ExportReport> export_triangles(const Document& document, const std::filesystem::path& path,
                                      const ExportSettings& settings, const CancelToken& cancel,
                                      const Progress& progress) {
  constexpr double writing = 0.75;  // fraction of the time for making the triangles, roughly
  const auto made =
      export_meshes(document, path, settings, MeshReport::asked, cancel, progress.part(0, writing));
  if (!made.ok()) return made.error();
  progress.report(writing);
  const auto named = made->named();
  auto written = write_mesh_file(path, named, write_options(document, settings.choices, cancel));
  if (!written.ok()) return written.error();
  ExportReport report = report_of(named, settings.choices.scale, path);
  for (const FileRounding& rounding : written->rounding) report.triangles -= rounding.left_out;
  report.moved = written->moved;
  report.warnings = left_out_of_triangles(document);
  for (const std::vector<Message>& own : {written->warnings, made->warnings()})
    report.warnings.insert(report.warnings.end(), own.begin(), own.end());
  return report;
}

}  // namespace hariko
