#include "core/cad/kernel/read_cad_file.hpp"

#include <sys/mman.h>
#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
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
#include "core/cad/kernel/opencascade/isolated.hpp"
#include "core/cad/kernel/opencascade/kernel.hpp"
#include "core/cad/kernel/opencascade/kernel_session.hpp"
#include "core/cad/kernel/opencascade/mixed_shells.hpp"
#include "core/cad/kernel/opencascade/scene_bytes.hpp"
#include "core/cad/kernel/opencascade/sew_faces.hpp"
#include "core/cad/kernel/opencascade/triangulated.hpp"
#include "core/cad/kernel/opencascade/whole_splines.hpp"
#include "core/surface/weld_patches.hpp"

namespace hariko {

namespace {

/// Limit of processor time, seconds: some damaged files are read for ever.
constexpr double least_patience = 20, patience_a_megabyte = 60;

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

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
  std::string out(std::size_t(name->Get().LengthOfCString()) + 1, '\0');
  Standard_PCharacter at = out.data();
  name->Get().ToUTF8CString(at);
  out.resize(out.size() - 1);
  return sanitized_utf8(out, 200);
}

class Collector {
 public:
  explicit Collector(const Handle(TDocStd_Document) & document)
      : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
        colours_(XCAFDoc_DocumentTool::ColorTool(document->Main())) {}

  /// Shapes of all parts in their places; E_LIMIT where there are too many.
  Result<std::vector<CadLeaf>> run() {
    TDF_LabelSequence labels;
    shapes_->GetFreeShapes(labels);
    for (int i = 1; i <= labels.Length(); ++i) add(labels.Value(i), TopLoc_Location(), {}, {}, 0);
    if (too_many_)
      return make_error(e_limit, "The file has more than " + std::to_string(max_cad_parts) + " parts.",
                        "Export the assembly in several files.");
    return std::move(leaves_);
  }

 private:
  static constexpr int deepest = 100;

  CadColour colour_of(const TDF_Label& label) const {
    for (const XCAFDoc_ColorType kind : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen, XCAFDoc_ColorCurv})
      if (Quantity_Color colour; colours_->GetColor(label, kind, colour)) return as_bytes(colour);
    return {};
  }
  CadColour colour_of(const TopoDS_Shape& shape) const {
    for (const XCAFDoc_ColorType kind : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen})
      if (Quantity_Color colour; colours_->GetColor(shape, kind, colour)) return as_bytes(colour);
    return {};
  }
  static CadColour as_bytes(const Quantity_Color& colour) {
    double r = 0, g = 0, b = 0;
    colour.Values(r, g, b, Quantity_TOC_sRGB);
    const auto byte = [](double x) { return std::uint8_t(std::lround(255 * std::clamp(x, 0.0, 1.0))); };
    return std::array{byte(r), byte(g), byte(b)};
  }
  /// Colour of the shape, else of its first solid, of its first shell, or of its first face, if one has any.
  CadColour inner_colour(const TopoDS_Shape& shape) const {
    if (const CadColour own = colour_of(shape)) return own;
    for (const TopAbs_ShapeEnum kind : {TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE})
      if (TopExp_Explorer at(shape, kind); at.More())
        if (const CadColour colour = colour_of(at.Current())) return colour;
    return {};
  }
  /// Parts of a shape without a colour of its own, by the colours of its solids, in the order in which these
  /// appear; what is in no solid is a part, too. One part where all have one colour.
  std::vector<std::pair<TopoDS_Shape, CadColour>> parts_by_colour(const TopoDS_Shape& shape) const {
    std::vector<std::pair<CadColour, std::vector<TopoDS_Shape>>> groups;
    const auto add_to_group = [&](const TopoDS_Shape& part, const CadColour& colour) {
      const auto known = std::find_if(groups.begin(), groups.end(),
                                      [&](const auto& group) { return group.first == colour; });
      if (known != groups.end()) return known->second.push_back(part);
      groups.push_back({colour, {part}});
    };
    for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
      add_to_group(solid.Current(), inner_colour(solid.Current()));
    if (groups.size() < 2) return {{shape, inner_colour(shape)}};
    std::vector<std::pair<TopoDS_Shape, CadColour>> out;
    for (const auto& [colour, shapes] : groups) out.emplace_back(together(shapes), colour);
    std::vector<TopoDS_Shape> rest;
    for (TopExp_Explorer shell(shape, TopAbs_SHELL, TopAbs_SOLID); shell.More(); shell.Next())
      rest.push_back(shell.Current());
    for (TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SHELL); face.More(); face.Next())
      rest.push_back(face.Current());
    if (!rest.empty()) out.emplace_back(together(rest), inner_colour(rest.front()));
    return out;
  }
  static TopoDS_Shape together(const std::vector<TopoDS_Shape>& shapes) {
    if (shapes.size() == 1) return shapes.front();
    TopoDS_Compound out;
    BRep_Builder builder;
    builder.MakeCompound(out);
    for (const TopoDS_Shape& shape : shapes) builder.Add(out, shape);
    return out;
  }

  /// Whether the name of a component's usage is meaningful: often it is empty, a number, or the STEP entity
  /// that places the component (NEXT_ASSEMBLY_USAGE_OCCURRENCE).
  static bool names_something(const std::string& usage) {
    std::string_view left = usage;
    for (const std::string_view kind : {"NAUO", "NEXT_ASSEMBLY_USAGE_OCCURRENCE"})
      if (left.starts_with(kind)) left.remove_prefix(kind.size());
    return left.find_first_not_of(" _-#.0123456789") != std::string_view::npos;
  }

  void add(const TDF_Label& label, const TopLoc_Location& place, const std::string& given_name,
           const CadColour& given_colour, int depth) {
    if (depth > deepest || too_many_) return;
    const std::string own_name = name_of(label);
    const std::string& name = given_name.empty() ? own_name : given_name;
    const CadColour colour = given_colour ? given_colour : colour_of(label);
    TDF_Label referred;
    if (XCAFDoc_ShapeTool::IsReference(label) && XCAFDoc_ShapeTool::GetReferredShape(label, referred)) {
      return add(referred, place * XCAFDoc_ShapeTool::GetLocation(label),
                 names_something(name) ? name : std::string(), colour, depth + 1);
    }
    if (XCAFDoc_ShapeTool::IsAssembly(label)) {
      TDF_LabelSequence components;
      XCAFDoc_ShapeTool::GetComponents(label, components);
      const bool alone = components.Length() == 1;
      for (int i = 1; i <= components.Length(); ++i)
        add(components.Value(i), place, alone ? name : std::string(), colour, depth + 1);
      return;
    }
    if (leaves_.size() >= max_cad_parts) {
      too_many_ = true;
      return;
    }
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    if (shape.IsNull()) return;
    if (colour) {
      leaves_.push_back({shape.Moved(place), name, colour});
      return;
    }
    const auto parts = parts_by_colour(shape);
    if (leaves_.size() + parts.size() > max_cad_parts) {
      too_many_ = true;
      return;
    }
    for (const auto& [part, own] : parts) leaves_.push_back({part.Moved(place), name, own});
  }

  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colours_;
  std::vector<CadLeaf> leaves_;
  bool too_many_ = false;
};

double diagonal_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  if (box.IsVoid() || box.IsOpen()) return 0;
  return std::sqrt(box.SquareExtent());
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
    if (mixed_ > 0)
      out_.warnings.push_back(
          make_warning(w_cad_mixed,
                       "Spline faces that share edges with faces of other kinds, or meet others with other "
                       "parameters, became facets, so that shapes stay closed (faces: " +
                           std::to_string(mixed_) + "). Their exact patches are in hidden objects.",
                       "Show the objects called \"(patches)\" to analyse them, or to export them for CAD."));
    if (out_.parts.empty()) return failed("The file holds no faces.");
    return std::move(out_);
  }

 private:
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
    TopoDS_Compound others;
    BRep_Builder builder;
    builder.MakeCompound(others);
    bool empty = true;
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
      empty = false;
    }
    if (const double size = diagonal_of(leaf.shape); !empty && size > 0) {
      BRepTools::Clean(others);  // removes triangles that the file brought along
      Triangulated made =
          triangulated(others, options_.tolerance > 0 ? options_.tolerance : usual_cad_mesh_tolerance * size,
                       options_.angle, range);
      part.mesh = std::move(made.mesh);
      failed_ += made.failed;
      triangles_ += part.mesh.face_count();
    }
    if (!part.patches.empty() || part.mesh.face_count() > 0) out_.parts.push_back(std::move(part));
  }

  /// Marks faces of the next leaf whose bodies are closed, but not by the patches of their splines alone:
  /// along some edge these have different parameters.
  void mark_gaps(const ConnectedFaces& faces, std::vector<bool>& mixed) const {
    if (face_ + mixed.size() > splines_.size()) return;
    std::vector<std::vector<std::size_t>> sets(faces.closed.size());
    for (std::size_t k = 0; k < mixed.size(); ++k)
      if (!mixed[k] && faces.closed[faces.set_of_face[k]]) sets[faces.set_of_face[k]].push_back(k);
    for (const auto& set : sets) {
      std::vector<BezierPatch> patches;
      for (const std::size_t k : set)
        patches.insert(patches.end(), splines_[face_ + k].begin(), splines_[face_ + k].end());
      if (patches.empty()) continue;
      const auto welded = weld_patches(Vector3::Zero(), std::move(patches));
      if (welded.ok() && welded->boundary_sides().empty()) continue;
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
  std::size_t face_ = 0, failed_ = 0, triangles_ = 0, mixed_ = 0;
};

/// Steps common to the kernel's readers, which share names but no base class.
template <class Reader, class Read>
std::optional<Message> transfer(Reader& reader, const Read& read, KernelDocument& document,
                                const Message_ProgressRange& range) {
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  if (read(reader) != IFSelect_RetDone) return failed("OpenCASCADE cannot read this file.");
  if (!reader.Transfer(document.handle(), range)) return failed("OpenCASCADE finds no shapes in this file.");
  return {};
}

/// Path of a file that exists in memory only, for readers that need a path. It vanishes with this process.
std::optional<std::string> path_in_memory(std::string_view bytes) {
  const int descriptor = ::memfd_create("hariko", MFD_CLOEXEC);
  if (descriptor < 0 || !write_all(descriptor, bytes)) return {};
  return "/proc/self/fd/" + std::to_string(descriptor);
}

std::optional<Message> load_iges(const std::filesystem::path& path, const CadText& text,
                                 KernelDocument& document, const Message_ProgressRange& range) {
  const std::optional<std::string> from = text.changed ? path_in_memory(text.text) : path.string();
  if (!from)
    return make_error(e_file_read, "There is no room for a copy of the file in memory.", "Try again.");
  IGESCAFControl_Reader reader;
  return transfer(
      reader, [&](auto& r) { return r.ReadFile(from->c_str()); }, document, range);
}

std::optional<Message> load_step(CadText text, KernelDocument& document, const Message_ProgressRange& range) {
  STEPCAFControl_Reader reader;
  std::istringstream stream(std::move(text.text));
  // Without a folder in its name the reader looks for no other files.
  return transfer(
      reader, [&](auto& r) { return r.ChangeReader().ReadStream("file", stream); }, document, range);
}

/// Facts about a file's text that last once the kernel has read it.
struct LoadedText {
  std::vector<Message> warnings;
  bool own = false;  ///< written by this program
};

/// Whether this program wrote the file: it says so within its first lines.
bool is_own(std::string_view text) {
  const std::string_view head = text.substr(0, 4096);
  return head.find("6Hhariko,") != std::string_view::npos || head.find("'Hariko'") != std::string_view::npos;
}

/// Loads a file into the document.
Result<LoadedText> load(const std::filesystem::path& path, CadFormat format, KernelDocument& document,
                        const Message_ProgressRange& range) {
  auto bytes = read_file(path, max_cad_file_bytes);
  if (!bytes.ok()) return bytes.error();
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  // Otherwise nameless shapes are called FACE, SOLID or "=>[0:1:1:2]".
  XCAFDoc_ShapeTool::SetAutoNaming(false);
  const bool iges = format == CadFormat::iges;
  auto text = iges ? iges_text_of(std::move(bytes).value()) : step_text_of(std::move(bytes).value());
  if (!text.ok()) return text.error();
  LoadedText out{text->warnings, is_own(text->text)};
  const auto wrong =
      iges ? load_iges(path, *text, document, range) : load_step(std::move(text).value(), document, range);
  if (wrong) return *wrong;
  return out;
}

Result<CadScene> read(const std::filesystem::path& path, CadFormat format, const CadReadOptions& options,
                      const std::function<void(double)>& report) {
  try {
    const Handle(Indicator) indicator = new Indicator(report);
    Message_ProgressScope scope(indicator->Start(), nullptr, 2);
    KernelDocument document;
    const auto text = load(path, format, document, scope.Next());
    if (!text.ok()) return text.error();
    const auto leaves = Collector(document.handle()).run();
    if (!leaves.ok()) return leaves.error();
    // Files of this program already share their edges.
    const std::vector<CadLeaf> whole = text->own ? *leaves : sewn(*leaves, format == CadFormat::iges);
    auto made = SceneMaker(options).run(whole, scope.Next());
    if (made.ok()) {
      auto& all = made.value().warnings;
      all.insert(all.begin(), text->warnings.begin(), text->warnings.end());
    }
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
  const auto format = cad_format_of(path);
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
