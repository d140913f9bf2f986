#include "app/files/open_file.hpp"

#include <algorithm>

#include "core/base/file_io.hpp"
#include "core/base/printable.hpp"
#include "core/document/edit_objects.hpp"
#include "core/document/file.hpp"
#include "core/document/format.hpp"
#include "core/document/read_outline.hpp"
#include "core/document/read_skin.hpp"
#include "core/document/read_solids.hpp"
#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/exchange/read_bpt.hpp"
#include "core/exchange/read_patches.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {

namespace {

void open_mesh(const std::filesystem::path& file, const CancelToken& cancel, const Progress& progress,
               OpenedFile& opened) {
  ReadLimits limits;
  limits.cancel = cancel;
  limits.progress = progress.part(0, 0.8);
  auto imported = read_mesh_file(file, limits);
  if (!imported.ok()) {
    opened.messages.push_back(imported.error());
    return;
  }
  opened.messages = imported->warnings;
  if (const std::string own = printable(imported->name, Object::max_name_length); check_name(own).ok())
    opened.name = own;
  PolygonMesh mesh = std::move(imported).value().mesh;
  auto document = document_from_mesh(mesh, opened.name);
  if (document.ok()) {
    opened.document = std::move(document).value();
    return;
  }
  // The first error stopped the conversion; the designer wants to know all of them.
  for (Message& message : validate(mesh))
    if (message.severity == Severity::error) opened.messages.push_back(std::move(message));
  const auto same = [&](const Message& message) { return message.code == document.error().code; };
  if (std::none_of(opened.messages.begin(), opened.messages.end(), same))
    opened.messages.push_back(document.error());
  if (const auto repaired = make_manifold(mesh); repaired.ok()) {
    if (auto made = document_from_mesh(repaired->mesh, opened.name); made.ok()) {
      opened.repaired = std::move(made).value();
      opened.repair = repaired->report;
    }
  }
  if (auto facets = MeshSource::from_mesh(mesh); facets.ok())
    if (auto made = add_object({}, opened.name, std::move(facets).value()); made.ok())
      opened.reference = std::move(made).value().document;
  opened.broken_mesh = std::move(mesh);
}

/// What a layout of its own becomes: solids, sections or outlines.
Result<Source> read_layout(JsonKind kind, std::string_view text) {
  if (kind == JsonKind::scene) {
    auto input = read_scene(text);
    return input.ok() ? Result<Source>(SolidsSource{std::move(input).value(), {}}) : input.error();
  }
  if (kind == JsonKind::skin) {
    auto skin = read_skin_layout(text);
    return skin.ok() ? Result<Source>(SkinSource{std::move(skin).value(), {}}) : skin.error();
  }
  HARIKO_ASSERT(kind == JsonKind::outline, "not a layout of its own");
  auto outline = read_outline(text);
  if (!outline.ok()) return outline.error();
  const OutlineSettings settings = usual_settings(*outline);
  return Source(OutlineSource{std::move(outline).value(), settings, {}});
}

void open_layout(const std::filesystem::path& file, JsonKind kind, OpenedFile& opened) {
  const auto made = [&]() -> Result<Added> {
    const auto text = read_file(file, max_document_bytes);
    if (!text.ok()) return text.error();
    auto source = read_layout(kind, *text);
    if (!source.ok()) return source.error();
    return add_object({}, opened.name, std::move(source).value());
  }();
  if (made.ok())
    opened.document = made->document;
  else
    opened.messages.push_back(made.error());
}

/// What was read of a file that the user does not want any more.
OpenedFile cancelled() {
  OpenedFile opened;
  opened.messages.push_back(make_error(e_cancelled, "The import was cancelled."));
  return opened;
}

bool has_ending(const std::filesystem::path& file, std::string_view ending) {
  std::string own = file.extension().native();
  for (char& c : own)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return own == ending;
}

/// One object for each patch.
void open_patches(const std::filesystem::path& file, OpenedFile& opened) {
  const auto take = [&](const auto& result) {
    if (!result.ok()) opened.messages.push_back(result.error());
    return result.ok();
  };
  const auto named = read_patch_file(file);
  if (!take(named)) return;
  Document document;
  for (const NamedPatches& group : *named) {
    const auto nets = bicubic_nets(group.patches);
    if (!take(nets)) return;
    const std::string name = check_name(group.name).ok() ? group.name : opened.name;
    for (std::size_t k = 0; k < nets->size(); ++k) {
      const auto source = PatchSource::from_net((*nets)[k]);
      if (!take(source)) return;
      const std::string number = nets->size() == 1 ? "" : " " + std::to_string(k + 1);
      const auto added = add_object(document, name + number, *source);
      if (!take(added)) return;
      document = added->document;
    }
  }
  opened.document = std::move(document);
}

}  // namespace

const Message* OpenedFile::error() const {
  const auto found = std::find_if(messages.begin(), messages.end(),
                                  [](const Message& message) { return message.severity == Severity::error; });
  return found == messages.end() ? nullptr : &*found;
}

Result<JsonKind> content_of(const std::filesystem::path& file) {
  if (has_ending(file, ".bpt")) return JsonKind::patches;
  if (!has_ending(file, ".json")) return JsonKind::document;
  const auto text = read_file(file);
  if (!text.ok()) return text.error();
  const auto kind = json_kind(*text);
  if (!kind.ok() || use_of(*kind).empty()) return kind;
  return make_error(e_format_unknown, "The file holds " + std::string(name_of(*kind)) + ".",
                    std::string(use_of(*kind)));
}

OpenedFile open_file(const std::filesystem::path& file, const CancelToken& cancel, const Progress& progress) {
  OpenedFile opened;
  opened.name = printable(file.stem().string(), Object::max_name_length);
  if (!check_name(opened.name).ok()) opened.name = "mesh";
  if (format_of_extension(file)) {
    open_mesh(file, cancel, progress, opened);
    return cancel.cancelled() ? cancelled() : std::move(opened);
  }
  const auto holds = content_of(file);
  if (!holds.ok()) {
    opened.messages.push_back(holds.error());
    return opened;
  }
  if (*holds == JsonKind::patches) {
    open_patches(file, opened);
    return opened;
  }
  if (*holds != JsonKind::document) {
    open_layout(file, *holds, opened);
    return opened;
  }
  opened.native = true;
  auto document = load_document(file);
  if (cancel.cancelled()) return cancelled();
  if (document.ok())
    opened.document = std::move(document).value();
  else
    opened.messages.push_back(document.error());
  return opened;
}

}  // namespace hariko
