#include "core/cad/kernel/read_cad_file.hpp"

#include <sys/mman.h>
#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <Message_ProgressIndicator.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <new>
#include <sstream>

#include "core/base/files/file_io.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/cad/kernel/cad_file.hpp"
#include "core/cad/kernel/cad_text.hpp"
#include "core/cad/kernel/opencascade/cad_parts.hpp"
#include "core/cad/kernel/opencascade/isolated.hpp"
#include "core/cad/kernel/opencascade/kernel.hpp"
#include "core/cad/kernel/opencascade/kernel_session.hpp"
#include "core/cad/kernel/opencascade/mapped_items.hpp"
#include "core/cad/kernel/opencascade/mixed_shells.hpp"
#include "core/cad/kernel/opencascade/scene_bytes.hpp"
#include "core/cad/kernel/opencascade/sew_faces.hpp"
#include "core/cad/kernel/opencascade/step_model.hpp"
#include "core/cad/kernel/opencascade/triangulated.hpp"
#include "core/cad/kernel/opencascade/whole_splines.hpp"
#include "core/surface/weld_patches.hpp"

namespace hariko {

namespace {

/// Limit of processor time, seconds: some damaged files are read for ever.
constexpr double least_patience = 20, patience_a_megabyte = 60;
/// Length below which a side of a patch is a point, millimetres: the kernel's own equality.
constexpr double least_side = 1e-7;

Message failed(std::string what) {
  return make_error(e_cad_read, std::move(what), "Export the model again, or as STL or OBJ.");
}

Message cancelled() {
  return make_error(e_cancelled, "The import was cancelled.");
}

/// Forwards the kernel's progress.
class Indicator : public Message_ProgressIndicator {
 public:
  explicit Indicator(const std::function<void(double)>& report) : report_(report) {}
  void Show(const Message_ProgressScope&, const Standard_Boolean) override { report_(GetPosition()); }

 private:
  std::function<void(double)> report_;
};

double diagonal_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  if (box.IsVoid() || box.IsOpen()) return 0;
  return std::sqrt(box.SquareExtent());
}

/// Whether all control points of a side of a patch are in one place.
bool ends_in_a_point(const BezierPatch& patch) {
  const auto columns = std::size_t(patch.degree_s) + 1, rows = std::size_t(patch.degree_t) + 1;
  const auto shrunk = [&](std::size_t first, std::size_t step, std::size_t count) {
    for (std::size_t k = 1; k < count; ++k)
      if ((patch.points[first + k * step] - patch.points[first]).norm() > least_side) return false;
    return true;
  };
  return shrunk(0, 1, columns) || shrunk((rows - 1) * columns, 1, columns) || shrunk(0, columns, rows) ||
         shrunk(columns - 1, columns, rows);
}

class SceneMaker {
 public:
  explicit SceneMaker(const CadReadOptions& options) : options_(options) {}

  Result<CadScene> run(const std::vector<CadLeaf>& leaves, const Message_ProgressRange& range) {
    if (options_.patches) find_splines(leaves);
    Message_ProgressScope scope(range, nullptr, double(std::max<std::size_t>(leaves.size(), 1)));
    for (const CadLeaf& leaf : leaves) {
      add(leaf, scope.Next());
      if (triangles_ > max_cad_triangles)
        return make_error(
            e_limit, "The shapes would have more than " + std::to_string(max_cad_triangles) + " triangles.",
            "Export fewer parts.");
    }
    if (failed_ > 0)
      out_.warnings.push_back(make_warning(
          w_cad_faces, std::to_string(failed_) + " faces could not be made into triangles and are missing.",
          "Repair the model in the program that it comes from."));
    if (mixed_ > 0) out_.warnings.push_back(mixed_warning());
    if (out_.parts.empty()) return failed("The file holds no faces.");
    return std::move(out_);
  }

 private:
  Message mixed_warning() const {
    return make_warning(
        w_cad_mixed,
        "Spline faces became facets, so that shapes stay closed (beside faces of other kinds: " +
            std::to_string(mixed_ - at_poles_ - at_gaps_) + ", with a pole: " + std::to_string(at_poles_) +
            ", beside other parameters: " + std::to_string(at_gaps_) +
            "). Their exact patches are in hidden objects.",
        "Show the objects called \"(patches)\" to analyse them, or to export them for CAD.");
  }

  /// Finds the spline faces, in the order of the faces. With too many patches for one object everything
  /// becomes triangles.
  void find_splines(const std::vector<CadLeaf>& leaves) {
    std::size_t count = 0;
    for (const CadLeaf& leaf : leaves)
      for (TopExp_Explorer face(leaf.shape, TopAbs_FACE); face.More(); face.Next()) {
        splines_.push_back(whole_spline(TopoDS::Face(face.Current())));
        count += splines_.back().size();
        if (count <= max_cad_patches) continue;
        splines_.clear();
        out_.warnings.push_back(make_warning(w_cad_patches,
                                             "The file has more than " + std::to_string(max_cad_patches) +
                                                 " spline patches: all of it is triangles.",
                                             "Export parts of it to have patches."));
        return;
      }
  }

  void add(const CadLeaf& leaf, const Message_ProgressRange& range) {
    CadPart part{leaf.name, leaf.colour, {}, {}};
    part.visible = leaf.visible;
    TopoDS_Compound others;
    BRep_Builder builder;
    builder.MakeCompound(others);
    std::vector<Index> bodies;
    const ConnectedFaces connected = connected_faces(leaf.shape);
    std::vector<bool> mixed = beside_others(connected, whole_faces(connected.set_of_face.size()));
    mark_gaps(connected, mixed);
    std::size_t own = 0;
    for (TopExp_Explorer face(leaf.shape, TopAbs_FACE); face.More(); face.Next(), ++face_, ++own) {
      if (face_ < splines_.size() && !splines_[face_].empty()) {
        std::move(splines_[face_].begin(), splines_[face_].end(),
                  std::back_inserter(mixed[own] ? part.also_exact : part.patches));
        if (!mixed[own]) continue;
        ++mixed_;
      }
      builder.Add(others, face.Current());
      bodies.push_back(connected.solid_of_face[own]);
    }
    if (const double size = diagonal_of(leaf.shape); !bodies.empty() && size > 0) {
      BRepTools::Clean(others);  // removes triangles that the file brought along
      const double tolerance = options_.tolerance > 0 ? options_.tolerance : usual_cad_mesh_tolerance * size;
      Triangulated made = triangulated(others, bodies, tolerance, options_.angle, range);
      part.mesh = std::move(made.mesh);
      failed_ += made.failed;
      triangles_ += part.mesh.face_count();
    }
    if (!part.patches.empty() || part.mesh.face_count() > 0) out_.parts.push_back(std::move(part));
  }

  /// Marks faces of the next leaf whose bodies are closed, but not by the patches of their splines alone:
  /// along some edge these have different parameters, or a side of one is a point.
  void mark_gaps(const ConnectedFaces& faces, std::vector<bool>& mixed) {
    if (face_ + mixed.size() > splines_.size()) return;
    std::vector<std::vector<std::size_t>> sets(faces.closed.size());
    for (std::size_t k = 0; k < mixed.size(); ++k)
      if (!mixed[k] && faces.closed[faces.set_of_face[k]]) sets[faces.set_of_face[k]].push_back(k);
    for (const auto& set : sets) {
      std::vector<BezierPatch> patches;
      for (const std::size_t k : set)
        patches.insert(patches.end(), splines_[face_ + k].begin(), splines_[face_ + k].end());
      if (patches.empty()) continue;
      const bool pole = std::any_of(patches.begin(), patches.end(), ends_in_a_point);
      const auto welded = weld_patches(Vector3::Zero(), std::move(patches));
      if (welded.ok() && welded->boundary_sides().empty()) continue;
      (pole ? at_poles_ : at_gaps_) += set.size();
      for (const std::size_t k : set) mixed[k] = true;
    }
  }

  /// Flags, one for each face of the next leaf, that tell whether it is a whole spline.
  std::vector<bool> whole_faces(std::size_t count) const {
    std::vector<bool> out;
    for (std::size_t k = face_; k < face_ + count; ++k)
      out.push_back(k < splines_.size() && !splines_[k].empty());
    return out;
  }

  const CadReadOptions& options_;
  CadScene out_;
  std::vector<std::vector<BezierPatch>> splines_;  ///< by face of the file
  std::size_t face_ = 0, failed_ = 0, triangles_ = 0;
  std::size_t mixed_ = 0, at_poles_ = 0, at_gaps_ = 0;  ///< the last two are among the first
};

/// Modes common to the kernel's readers, which share names but no base class.
template <class Reader>
void set_modes(Reader& reader) {
  reader.SetColorMode(true);
  reader.SetNameMode(true);
}

Message unreadable() {
  return failed("OpenCASCADE cannot read this file.");
}

Message no_shapes(const ModelFacts& facts) {
  if (facts.tessellated == 0) return failed("OpenCASCADE finds no shapes in this file.");
  const Message& why = facts.warnings.front();
  return make_error(e_cad_read, "The file holds no exact bodies. " + why.text, why.remedy);
}

/// Path of a file that exists in memory only, for readers that need a path. It vanishes with this process.
std::optional<std::string> path_in_memory(std::string_view bytes) {
  const int descriptor = ::memfd_create("hariko", MFD_CLOEXEC);
  if (descriptor < 0 || !write_all(descriptor, bytes)) return {};
  return "/proc/self/fd/" + std::to_string(descriptor);
}

Result<ModelFacts> load_iges(const std::filesystem::path& path, const CadText& text, KernelDocument& document,
                             const Message_ProgressRange& range) {
  const std::optional<std::string> from = text.changed ? path_in_memory(text.text) : path.string();
  if (!from)
    return make_error(e_file_read, "There is no room for a copy of the file in memory.", "Try again.");
  IGESCAFControl_Reader reader;
  set_modes(reader);
  if (reader.ReadFile(from->c_str()) != IFSelect_RetDone) return unreadable();
  if (!reader.Transfer(document.handle(), range)) return no_shapes({});
  return facts_of_iges(reader);
}

Result<ModelFacts> load_step(CadText text, KernelDocument& document, const Message_ProgressRange& range) {
  STEPCAFControl_Reader reader;
  set_modes(reader);
  std::istringstream stream(std::move(text.text));
  // Without a folder in its name the reader looks for no other files.
  if (reader.ChangeReader().ReadStream("file", stream) != IFSelect_RetDone) return unreadable();
  const std::vector<Message> not_placed = transform_mapped_items(reader);
  const bool found = reader.Transfer(document.handle(), range);
  ModelFacts out = facts_of_step(reader);
  if (!found) return no_shapes(out);
  out.warnings.insert(out.warnings.end(), not_placed.begin(), not_placed.end());
  return out;
}

/// Facts about a file that last once the kernel has read it.
struct LoadedFile {
  std::vector<Message> warnings;
  TopTools_MapOfShape hidden;  ///< see `ModelFacts`
  bool own = false;            ///< written by this program
};

/// Whether this program wrote the file: it says so within its first lines.
bool is_own(std::string_view text) {
  const std::string_view head = text.substr(0, 4096);
  return head.find("6Hhariko,") != std::string_view::npos || head.find("'Hariko'") != std::string_view::npos;
}

/// Loads a file into the document.
Result<LoadedFile> load(const std::filesystem::path& path, CadFormat format, KernelDocument& document,
                        const Message_ProgressRange& range) {
  auto bytes = read_file(path, max_cad_file_bytes);
  if (!bytes.ok()) return bytes.error();
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  // Otherwise nameless shapes are called FACE, SOLID or "=>[0:1:1:2]".
  XCAFDoc_ShapeTool::SetAutoNaming(false);
  const bool iges = format == CadFormat::iges;
  auto text = iges ? iges_text_of(std::move(bytes).value()) : step_text_of(std::move(bytes).value());
  if (!text.ok()) return text.error();
  LoadedFile out{text->warnings, {}, is_own(text->text)};
  const auto facts =
      iges ? load_iges(path, *text, document, range) : load_step(std::move(text).value(), document, range);
  if (!facts.ok()) return facts.error();
  out.hidden = facts->hidden;
  out.warnings.insert(out.warnings.end(), facts->warnings.begin(), facts->warnings.end());
  return out;
}

Result<CadScene> read(const std::filesystem::path& path, CadFormat format, const CadReadOptions& options,
                      const std::function<void(double)>& report) {
  try {
    const Handle(Indicator) indicator = new Indicator(report);
    Message_ProgressScope scope(indicator->Start(), nullptr, 2);
    KernelDocument document;
    const auto loaded = load(path, format, document, scope.Next());
    if (!loaded.ok()) return loaded.error();
    const auto parts = cad_parts(document.handle(), loaded->hidden);
    if (!parts.ok()) return parts.error();
    // Files of this program already share their edges.
    const std::vector<CadLeaf> whole =
        loaded->own ? parts->leaves : sewn(parts->leaves, format == CadFormat::iges);
    auto made = SceneMaker(options).run(whole, scope.Next());
    const std::size_t curves = parts->curves, points = parts->points;
    if (!made.ok()) {
      if (made.error().code != e_cad_read || curves + points == 0) return made;
      return failed("The file holds no faces, only curves (" + std::to_string(curves) + ") and points (" +
                    std::to_string(points) + ").");
    }
    auto& all = made.value().warnings;
    all.insert(all.begin(), loaded->warnings.begin(), loaded->warnings.end());
    if (curves + points > 0)
      all.push_back(make_warning(w_cad_left_out,
                                 "What has no faces was left out (curves: " + std::to_string(curves) +
                                     ", points: " + std::to_string(points) + ").",
                                 "Export it as surfaces where it is needed."));
    return made;
  } catch (const Standard_Failure& failure) {
    return failed("OpenCASCADE cannot read this file: " + sanitized_utf8(failure.GetMessageString(), 200) +
                  ".");
  } catch (const std::bad_alloc&) {
    return make_error(e_limit, "There is not enough memory for this file.", "Export fewer parts.");
  } catch (const std::exception& failure) {
    return failed("OpenCASCADE cannot read this file: " + sanitized_utf8(failure.what(), 200) + ".");
  }
}

}  // namespace

Result<CadScene> by_opencascade::read_cad_file(const std::filesystem::path& path,
                                               const CadReadOptions& options, const CancelToken& cancel,
                                               const Progress& progress) {
  const auto format = options.format ? options.format : cad_format_of(path);
  HARIKO_ASSERT(format, "the ending tells the format");
  const KernelSession session;
  std::error_code unknown;
  const auto size = std::filesystem::file_size(path, unknown);
  const double megabytes = unknown ? 0 : double(size) / 1e6;
  const auto bytes = isolated(
      [&](const std::function<void(double)>& report) {
        return bytes_of(read(path, *format, options, report));
      },
      Patience{.working = least_patience + patience_a_megabyte * megabytes}, cancel, progress);
  if (cancel.cancelled()) return cancelled();
  if (!bytes) return failed("OpenCASCADE cannot read this file: it broke off, or came to no end.");
  return scene_of(*bytes);
}

}  // namespace hariko
