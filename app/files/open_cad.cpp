#include "app/files/open_cad.hpp"

#include "core/cad/kernel/read_cad_file.hpp"
#include "core/document/edits/edit_objects.hpp"

namespace hariko {

namespace {

DisplaySettings display_of(const CadPart& part) {
  DisplaySettings out;
  if (part.colour) out.colour = {(*part.colour)[0], (*part.colour)[1], (*part.colour)[2]};
  return out;
}

Result<Document> with_object(Document document, const std::string& name, Source source,
                             const DisplaySettings& display, bool visible = true) {
  auto added = add_object(std::move(document), name, std::move(source), {}, display);
  if (!added.ok()) return added.error();
  return visible ? Result<Document>(std::move(added).value().document)
                 : set_visible(added->document, added->id, false);
}

Result<Document> with_patches(Document document, std::vector<BezierPatch> patches, const std::string& name,
                              const DisplaySettings& display, bool visible) {
  auto source = BezierSource::from_patches(std::move(patches));
  if (!source.ok()) return source.error();
  return with_object(std::move(document), name, std::move(source).value(), display, visible);
}

/// Adds the objects of a part: patches, facets, and the exact patches of triangulated spline faces, which are
/// hidden as the facets show the same shape.
Result<Document> with_part(Document document, CadPart part, const std::string& name) {
  const DisplaySettings display = display_of(part);
  const bool both = !part.patches.empty() && part.mesh.face_count() > 0;
  if (!part.patches.empty()) {
    auto next = with_patches(std::move(document), std::move(part.patches), name, display, part.visible);
    if (!next.ok()) return next;
    document = std::move(next).value();
  }
  if (part.mesh.face_count() > 0) {
    auto source = MeshSource::from_mesh(std::move(part.mesh));
    if (!source.ok()) return source.error();
    auto next = with_object(std::move(document), both ? name + " (mesh)" : name, std::move(source).value(),
                            display, part.visible);
    if (!next.ok()) return next;
    document = std::move(next).value();
  }
  if (part.also_exact.empty()) return document;
  return with_patches(std::move(document), std::move(part.also_exact), name + " (patches)", display, false);
}

}  // namespace

Result<OpenedCad> open_cad(const std::filesystem::path& file, const std::string& name,
                           const CancelToken& cancel, const Progress& progress,
                           std::optional<CadFormat> format) {
  CadReadOptions options;
  options.format = format;
  auto scene = read_cad_file(file, options, cancel, progress);
  if (!scene.ok()) return scene.error();
  OpenedCad out{{}, std::move(scene.value().warnings)};
  const bool alone = scene->parts.size() == 1;
  std::size_t number = 0;
  for (CadPart& part : scene.value().parts) {
    ++number;
    std::string own = check_name(part.name).ok() ? part.name
                      : alone                    ? name
                                                 : name + " " + std::to_string(number);
    auto next = with_part(std::move(out.document), std::move(part), own);
    if (!next.ok()) return next.error();
    out.document = std::move(next).value();
  }
  return out;
}

}  // namespace hariko
