#include "app/files/open_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "app/files/file_kind.hpp"
#include "app/files/open_cad.hpp"
#include "app/files/reading.hpp"
#include "core/base/files/file_ending.hpp"
#include "core/base/files/file_io.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/cad/kernel/cad_file.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "core/document/edits/edit_solids.hpp"
#include "core/document/file.hpp"
#include "core/document/format/folded_origin.hpp"
#include "core/document/format/format.hpp"
#include "core/document/format/read_origin.hpp"
#include "core/document/format/read_outline.hpp"
#include "core/document/format/read_skin.hpp"
#include "core/document/format/read_solids.hpp"
#include "core/document/words.hpp"
#include "core/exchange/detect_json_format.hpp"
#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/exchange/read_patches.hpp"
#include "core/modeling/objects/patch_objects.hpp"
#include "core/polyhedron/validation.hpp"
#include "core/skinning/sections/closing_points.hpp"
#include "core/surface/weld_patches.hpp"

namespace hariko {

namespace {

constexpr Code w_corner_left_out{"W_CORNER_LEFT_OUT"};
constexpr Code w_closing_point{"W_CLOSING_POINT"};

Result<PolyhedronSource> imported(const PolygonMesh& mesh) {
  auto source = PolyhedronSource::from_mesh(mesh);
  if (!source) return source;
  return as_new(*std::move(source));
}

/// Source with editable control points for a single patch that does not close on itself; otherwise one
/// surface of all patches.
Result<Source> source_of(const std::vector<BezierPatch>& patches) {
  if (patches.size() == 1 && is_editable(patches[0])) {
    const auto alone = weld_patches(Vector3::Zero(), patches);
    if (!alone.ok()) return alone.error();
    if (alone->seams().empty()) {
      auto single = PatchSource::from_net(BicubicNet{1, 1, patches[0].points});
      return single.ok() ? Result<Source>(std::move(single).value()) : single.error();
    }
  }
  auto welded = BezierSource::from_patches(patches);
  return welded.ok() ? Result<Source>(std::move(welded).value()) : welded.error();
}

/// The repaired mesh of a part, with the part's creases and corners: a repair keeps positions.
ImportedPart with_marks_of(const ImportedPart& part, PolygonMesh repaired) {
  using Place = std::array<double, 3>;
  const auto place = [](const Vector3& p) { return Place{p.x(), p.y(), p.z()}; };
  const auto place_of = [&](Index v) { return place(part.mesh.positions[v]); };
  std::set<std::pair<Place, Place>> creases;
  std::set<Place> corners;
  for (const auto& [a, b] : part.creases)
    if (std::max(a, b) < part.mesh.positions.size()) creases.insert(std::minmax({place_of(a), place_of(b)}));
  for (const Index v : part.corners)
    if (v < part.mesh.positions.size()) corners.insert(place_of(v));
  ImportedPart out{std::move(repaired), part.name};
  std::set<std::array<Index, 2>> found;
  for (std::size_t f = 0; !creases.empty() && f < out.mesh.face_count(); ++f) {
    const auto face = out.mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Index a = face[k], b = face[(k + 1) % face.size()];
      if (creases.contains(std::minmax({place(out.mesh.positions[a]), place(out.mesh.positions[b])})))
        found.insert({std::min(a, b), std::max(a, b)});
    }
  }
  out.creases.assign(found.begin(), found.end());
  for (Index v = 0; !corners.empty() && v < out.mesh.positions.size(); ++v)
    if (corners.contains(place(out.mesh.positions[v]))) out.corners.push_back(v);
  return out;
}

/// Objects of a mesh file: as they are, repaired, and as reference facets where one makes no polyhedron.
class MeshObjects {
 public:
  explicit MeshObjects(OpenedFile& opened) : opened_(opened) {}

  void add(ImportedPart part, const std::string& name, bool alone) {
    PolygonMesh& mesh = part.mesh;
    auto polyhedron = marked(part);
    if (polyhedron.ok()) {
      for (auto* document : {&whole_, &repaired_, &reference_}) put(*document, name, polyhedron);
      return;
    }
    if (whole_) repaired_ = reference_ = std::exchange(whole_, std::nullopt);
    note_errors(mesh, polyhedron.error(), alone ? "" : "\"" + name + "\": ");
    const auto repaired = make_manifold(mesh);
    if (repaired.ok()) add_counts(opened_.repair, repaired->report);
    put(repaired_, name,
        repaired.ok() ? marked(with_marks_of(part, repaired->mesh))
                      : Result<PolyhedronSource>(repaired.error()));
    put(reference_, name, MeshSource::from_mesh(mesh));
    if (opened_.broken_mesh) return;
    opened_.broken_mesh = std::move(mesh);
    opened_.name = name;
  }

  void add(const NamedPatches& patches, const std::string& name) {
    const auto source = source_of(patches.patches);
    if (!source.ok()) opened_.messages.push_back(source.error());
    for (auto* document : {&whole_, &repaired_, &reference_}) put(*document, name, source);
  }

  /// Completes the documents. `metres_per_unit`: nothing where the file does not give it.
  void finish(const std::optional<double>& metres_per_unit) {
    opened_.says_unit = metres_per_unit.has_value();
    for (const Unit unit : enum_values<Unit>())
      for (auto* document : {&whole_, &repaired_, &reference_})
        if (*document && metres_per_unit &&
            std::abs(millimetres_per(unit) / (1000 * *metres_per_unit) - 1) < 1e-9)
          (*document)->unit = unit;
    if (corners_left_out_ > 0)
      opened_.messages.push_back(make_warning(
          w_corner_left_out,
          std::to_string(corners_left_out_) +
              " corners at which fewer than two creases meet were left out: the surface is smooth there.",
          "Crease two or more of their edges, or give the vertices a tension."));
    opened_.document = std::move(whole_);
    if (!opened_.broken_mesh) return;
    opened_.repaired = std::move(repaired_);
    opened_.reference = std::move(reference_);
  }

 private:
  /// Polyhedron of a part, with its creases and corners.
  Result<PolyhedronSource> marked(const ImportedPart& part) {
    auto out = imported(part.mesh);
    if (out.ok()) out.value().shaping = shaping_of(part, out->polyhedron);
    return out;
  }

  /// Creases and corners of a part that made a polyhedron: its vertices have their numbers as ids. Corners
  /// inside the surface need two creases, and others are left out and counted.
  Shaping shaping_of(const ImportedPart& part, const Polyhedron& polyhedron) {
    std::set<EdgeId> creases;
    std::map<VertexId, int> creases_at;
    for (const auto& [a, b] : part.creases)
      if (const EdgeId edge = EdgeId::of(VertexId{a}, VertexId{b});
          polyhedron.find(edge) != no_index && creases.insert(edge).second)
        ++creases_at[edge.low], ++creases_at[edge.high];
    const std::set<Index> corners(part.corners.begin(), part.corners.end());
    Shaping out;  // in ascending order, which is fast
    for (const EdgeId edge : creases) out.crease.set(edge, true);
    for (const Index corner : corners) {
      const Index v = polyhedron.find(VertexId{corner});
      if (v == no_index) continue;
      if (polyhedron.topology().is_border_vertex(v) || creases_at[VertexId{corner}] >= 2)
        out.tag.set(VertexId{corner}, VertexTag::corner);
      else
        ++corners_left_out_;
    }
    return out;
  }

  template <class Made>
  static void put(std::optional<Document>& document, const std::string& name, const Result<Made>& source) {
    if (!document) return;
    auto added =
        source.ok() ? add_object(*std::move(document), name, *source) : Result<Added>(source.error());
    if (added.ok())
      document = std::move(added).value().document;
    else
      document.reset();
  }

  /// Adds all errors of a mesh: the conversion stops at the first one, but the designer needs all.
  void note_errors(const PolygonMesh& mesh, const Message& first, const std::string& start) {
    const std::size_t before = opened_.messages.size();
    for (Message& message : validate(mesh))
      if (message.severity == Severity::error) opened_.messages.push_back(std::move(message));
    const auto same = [&](const Message& message) { return message.code == first.code; };
    if (std::none_of(opened_.messages.begin() + std::ptrdiff_t(before), opened_.messages.end(), same))
      opened_.messages.push_back(first);
    for (std::size_t k = before; k < opened_.messages.size(); ++k)
      opened_.messages[k].text = start + opened_.messages[k].text;
  }

  OpenedFile& opened_;
  std::optional<Document> whole_{Document{}};     ///< while every mesh makes a polyhedron
  std::optional<Document> repaired_, reference_;  ///< used afterwards, as long as they can be made
  std::size_t corners_left_out_ = 0;
};

void open_mesh(const std::filesystem::path& file, const CancelToken& cancel, const Progress& progress,
               const JoinChoice& join, OpenedFile& opened) {
  ReadLimits limits;
  limits.cancel = cancel;
  limits.progress = progress.part(0, 0.8);
  auto imported = read_scene_file(file, limits);
  if (!imported.ok()) return opened.messages.push_back(imported.error());
  ImportedScene scene = std::move(imported).value();
  opened.messages = std::move(scene.warnings);
  const std::size_t warnings = opened.messages.size();
  const bool alone = scene.parts.size() + scene.patches.size() == 1;
  MeshObjects objects(opened);
  for (ImportedPart& part : scene.parts) {
    if (cancel.cancelled()) return;
    const std::string own = sanitized_utf8(part.name, Object::max_name_length);
    const std::string name = check_name(own).ok() ? own : opened.name;
    if (alone) opened.name = name;
    clean(part, join, opened.cleaned);
    objects.add(std::move(part), name, alone);
  }
  const auto told = opened.cleaned.messages();
  opened.messages.insert(opened.messages.begin() + std::ptrdiff_t(warnings), told.begin(), told.end());
  for (const NamedPatches& patches : scene.patches)
    objects.add(patches, check_name(patches.name).ok() ? patches.name : opened.name);
  objects.finish(scene.metres_per_unit);
  // Beside a broken mesh the repair turns the others, too.
  if (opened.repaired) opened.repair.turned_faces += turn_closed_parts_outwards(*opened.repaired);
}

/// Source of a JSON file of another layout: solids, sections or outlines.
Result<Source> read_layout(JsonKind kind, std::string_view text, std::vector<Message>& warnings) {
  if (kind == JsonKind::scene) {
    auto input = read_scene(text);
    return input.ok() ? Result<Source>(SolidsSource{std::move(input).value(), {}}) : input.error();
  }
  if (kind == JsonKind::skin) {
    auto skin = read_skin_layout(text);
    if (!skin.ok()) return skin.error();
    if (const std::size_t count = drop_closing_points(skin.value()); count > 0)
      warnings.push_back(make_warning(
          w_closing_point,
          count == 1
              ? std::string("A section repeats its first point at its end: the repeated point was left out.")
              : std::to_string(count) +
                    " sections repeat their first point at their end: the repeated points were left out."));
    return Source(SkinSource{std::move(skin).value(), {}});
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
    auto source = read_layout(kind, *text, opened.messages);
    if (!source.ok()) return source.error();
    auto origin = read_origin(*text);
    if (!origin.ok()) return origin.error();
    const Vector3 taken = take_far_origin(source.value());
    const Similarity place = with_origin({}, *origin + taken);
    if (!place.translation.allFinite())
      return make_error(e_nonfinite, "The place of the model is not a finite number.",
                        "Give the file a smaller origin.");
    const DisplaySettings display = kind == JsonKind::scene ? solids_display() : DisplaySettings{};
    return add_object({}, opened.name, std::move(source).value(), place, display);
  }();
  if (made.ok())
    opened.document = made->document;
  else
    opened.messages.push_back(made.error());
}

/// Result for a cancelled import.
OpenedFile cancelled_file() {
  OpenedFile opened;
  opened.messages.push_back(make_error(e_cancelled, "The import was cancelled."));
  return opened;
}

bool has_ending(const std::filesystem::path& file, std::string_view ending) {
  return lower_ending(file) == ending;
}

/// Opens a patch file, one object for each name.
void open_patches(const std::filesystem::path& file, OpenedFile& opened) {
  const auto take = [&](const auto& result) {
    if (!result.ok()) opened.messages.push_back(result.error());
    return result.ok();
  };
  const auto named = read_patch_file(file);
  if (!take(named)) return;
  Document document;
  for (const NamedPatches& group : *named) {
    const auto source = source_of(group.patches);
    if (!take(source)) return;
    const std::string name = check_name(group.name).ok() ? group.name : opened.name;
    auto added = add_object(std::move(document), name, *source);
    if (!take(added)) return;
    document = std::move(added).value().document;
  }
  opened.document = std::move(document);
}

void take(Result<OpenedCad> cad, OpenedFile& opened) {
  if (!cad.ok()) return opened.messages.push_back(cad.error());
  opened.document = std::move(cad.value().document);
  opened.messages = std::move(cad.value().warnings);
  opened.says_unit = true;
}

/// Kinds of files with an unknown ending, by their content.
enum class Looks { document, mesh, step, iges, foreign };

Result<Looks> looks_of(const std::filesystem::path& file) {
  if (has_foreign_ending(file) && std::filesystem::exists(file)) return Looks::foreign;
  const auto bytes = read_file(file);
  if (!bytes.ok()) return bytes.error();
  const auto ending = ending_of_content(*bytes);
  if (!ending) return Looks::foreign;
  if (ending == "json" || ending == "hariko") return Looks::document;
  return ending == "step" ? Looks::step : ending == "iges" ? Looks::iges : Looks::mesh;
}

/// Kind of content of a file that is not a mesh. Errors: those of `read_file` and `json_kind`;
/// E_FORMAT_UNKNOWN.
Result<JsonKind> content_of(const std::filesystem::path& file) {
  if (has_ending(file, ".bpt")) return JsonKind::patches;
  if (has_ending(file, ".hariko")) return JsonKind::document;
  const auto text = read_file(file);
  if (!text.ok()) return text.error();
  const auto kind = json_kind(*text);
  if (!kind.ok() || use_of(*kind).empty()) return kind;
  return make_error(e_format_unknown, "The file holds " + std::string(name_of(*kind)) + ".",
                    std::string(use_of(*kind)));
}

}  // namespace

const Message* OpenedFile::error() const {
  const auto found = std::ranges::find_if(
      messages, [](const Message& message) { return message.severity == Severity::error; });
  return found == messages.end() ? nullptr : &*found;
}

OpenedFile open_file(const std::filesystem::path& file, const CancelToken& cancel, const Progress& progress,
                     const JoinChoice& join) {
  OpenedFile opened;
  opened.name = sanitized_utf8(file.stem().string(), Object::max_name_length);
  if (!check_name(opened.name).ok()) opened.name = "mesh";
  if (format_of_extension(file)) {
    opened.meshes = true;
    open_mesh(file, cancel, progress, join, opened);
    return cancel.cancelled() ? cancelled_file() : std::move(opened);
  }
  if (cad_format_of(file)) {
    take(open_cad(file, opened.name, cancel, progress), opened);
    return cancel.cancelled() ? cancelled_file() : std::move(opened);
  }
  if (!has_ending(file, ".hariko") && !has_ending(file, ".json") && !has_ending(file, ".bpt")) {
    const auto looks = looks_of(file);
    if (looks.ok() && *looks == Looks::mesh) {
      opened.meshes = true;
      open_mesh(file, cancel, progress, join, opened);
      return cancel.cancelled() ? cancelled_file() : std::move(opened);
    }
    if (looks.ok() && (*looks == Looks::step || *looks == Looks::iges)) {
      const CadFormat format = *looks == Looks::step ? CadFormat::step_ap214 : CadFormat::iges;
      take(open_cad(file, opened.name, cancel, progress, format), opened);
      return cancel.cancelled() ? cancelled_file() : std::move(opened);
    }
    if (!looks.ok() || *looks == Looks::foreign) {
      opened.messages.push_back(looks.ok() ? foreign_format(file) : looks.error());
      return opened;
    }
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
  opened.native = opened.says_unit = true;
  auto document = load_document(file);
  if (cancel.cancelled()) return cancelled_file();
  if (document.ok())
    opened.document = std::move(document).value();
  else
    opened.messages.push_back(document.error());
  return opened;
}

}  // namespace hariko
