#include "core/exchange/obj/read_obj.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "core/exchange/number_text.hpp"
#include "core/exchange/obj/obj_parts.hpp"
#include "core/exchange/obj/obj_surfaces.hpp"
#include "core/exchange/obj/obj_tags.hpp"
#include "core/exchange/repair/remedies.hpp"
#include "core/exchange/text_encoding.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {
namespace {

constexpr const char* remedy_called = "Open the other files, too.";
/// Statements of the OBJ specification that do not affect polygons or patches.
constexpr std::array<std::string_view, 25> ignored_statements{
    "bevel",  "bmat", "c_interp", "con", "csh",    "ctech",      "curv2",    "d_interp", "lod",
    "maplib", "mg",   "mtllib",   "res", "s",      "scrv",       "sp",       "stech",    "step",
    "usemap", "vn",   "vp",       "vt",  "usemtl", "shadow_obj", "trace_obj"};

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const ReadLimits& limits)
      : scanner_(bytes, {.comments = true, .continuation = true}), limits_(limits) {}

  /// Reads all statements; returns the first error, or nothing.
  std::optional<Message> read() {
    const std::size_t size = scanner_.remaining();
    while (scanner_.find_content()) {
      if (auto error = limits_.row(scanner_.remaining(), size)) return error;
      if (auto error = read_statement()) return error;
      scanner_.next_line();
    }
    return check();
  }
  Result<ImportedMesh> mesh();
  Result<ImportedScene> scene();

 private:
  std::optional<Message> read_statement();
  std::optional<Message> read_vertex();
  std::optional<Message> read_face();
  std::optional<Message> add_corner(std::string_view token);
  std::optional<Message> add_index(std::string_view token, std::int64_t index);
  std::optional<Message> check() const;
  std::optional<Message> no_faces() const;
  std::string called_files() const;
  void warn();

  TextScanner scanner_;
  const ReadLimits& limits_;
  ImportedMesh out_;
  std::vector<double> weights_;  ///< weights of the vertices, from the first one other than 1 on
  ObjParts parts_;
  ObjTags tags_;
  ObjSurfaces surfaces_;
  // Largest index of a vertex that a face refers to before it is read: if that one exists in the end, all do.
  std::uint64_t largest_forward_ = 0;
  std::size_t largest_forward_line_ = 0;
  std::size_t unknown_count_ = 0, unknown_line_ = 0, points_and_lines_ = 0, calls_ = 0;
  std::string unknown_, called_;
};

std::optional<Message> ObjReader::read_statement() {
  const std::string_view keyword = scanner_.token();
  if (keyword == "v") return read_vertex();
  if (keyword == "f" || keyword == "fo") return read_face();  // fo is the older spelling
  if (keyword == "o") {
    parts_.begin_object(scanner_.rest_of_line(), out_.mesh.face_count());
    return {};
  }
  if (keyword == "g") {
    parts_.begin_group(scanner_.rest_of_line(), out_.mesh.face_count());
    return {};
  }
  if (keyword == "t") {
    tags_.read(scanner_);
    return {};
  }
  if (keyword == "l" || keyword == "p") {
    ++points_and_lines_;
    return {};
  }
  if (keyword == "call") {
    const std::string_view file = scanner_.token();
    if (calls_++ == 0) called_ = quote(file);
    return {};
  }
  if (ObjSurfaces::knows(keyword))
    return surfaces_.read(keyword, scanner_, out_.mesh.positions.size(), parts_.current_name());
  if (std::find(ignored_statements.begin(), ignored_statements.end(), keyword) == ignored_statements.end()) {
    if (unknown_count_++ == 0) {
      unknown_ = quote(keyword);
      unknown_line_ = scanner_.line();
    }
  }
  return {};
}

std::optional<Message> ObjReader::read_vertex() {
  Vector3 point;
  if (auto error = scanner_.read_point("coordinate", point)) return error;
  // Optional weight or colour.
  std::size_t extras = 0;
  double weight = 1;
  for (std::string_view extra = scanner_.token(); !extra.empty(); extra = scanner_.token()) {
    double number = 0;
    const NumberStatus status = parse_real(extra, number);
    if (status == NumberStatus::ok && extras == 0) weight = number;
    ++extras;
    if (status == NumberStatus::malformed)
      return scanner_.error_here(e_parse,
                                 "After a vertex come only numbers, but here is " + quote(extra) + ".",
                                 "Correct the line, or export the file again.");
  }
  if (out_.mesh.positions.size() == limits_.vertices)
    return scanner_.error_here(e_limit,
                               "The file has more than " + std::to_string(limits_.vertices) + " vertices.",
                               "Reduce the model before importing it.");
  out_.mesh.positions.push_back(point);
  if (extras == 1 && weight != 1) weights_.resize(out_.mesh.positions.size() - 1, 1.0);
  if (extras == 1 && (weight != 1 || !weights_.empty())) weights_.push_back(weight);
  return {};
}

std::optional<Message> ObjReader::read_face() {
  const std::size_t corners_before = out_.mesh.face_vertices.size();
  for (std::string_view corner = scanner_.token(); !corner.empty(); corner = scanner_.token())
    if (auto error = add_corner(corner)) return error;
  if (out_.mesh.face_vertices.size() == corners_before)
    return scanner_.error_here(e_parse, "The face has no corners.", "Delete the line or add its corners.");
  out_.mesh.face_offsets.push_back(static_cast<Index>(out_.mesh.face_vertices.size()));
  return {};
}

/// Adds a corner: "v", "v/vt", "v//vn" or "v/vt/vn". Only v is used, but the others must be integers.
std::optional<Message> ObjReader::add_corner(std::string_view token) {
  const std::size_t slash = token.find('/');
  const std::string_view vertex = token.substr(0, slash);
  std::int64_t index = 0;
  const NumberStatus status = parse_integer(vertex, index);
  bool good = status != NumberStatus::malformed;
  if (status == NumberStatus::too_large) index = std::numeric_limits<std::int64_t>::max();
  if (slash != std::string_view::npos) {
    const std::string_view rest = token.substr(slash + 1);
    const std::size_t second = rest.find('/');
    const std::string_view parts[] = {rest.substr(0, second),
                                      second == std::string_view::npos ? "" : rest.substr(second + 1)};
    std::int64_t ignored = 0;
    for (const std::string_view part : parts)
      good = good && (part.empty() || parse_integer(part, ignored) == NumberStatus::ok);
  }
  if (!good)
    return scanner_.error_here(
        e_parse, "A corner of a face is written v, v/vt, v//vn or v/vt/vn, but here is " + quote(token) + ".",
        "Correct the line, or export the file again.");
  return add_index(token, index);
}

std::optional<Message> ObjReader::add_index(std::string_view token, std::int64_t index) {
  const auto count = static_cast<std::int64_t>(out_.mesh.positions.size());
  const std::int64_t from_zero = index < 0 ? count + index : index - 1;
  if (index == 0)
    return scanner_.error_here(e_index_range, "The face names vertex 0, but vertices count from 1.",
                               "Correct the line, or export the file again.");
  if (from_zero < 0 || from_zero >= static_cast<std::int64_t>(limits_.vertices))
    return scanner_.error_here(e_index_range,
                               "The face names vertex " + quote(token) + ", but there are " +
                                   std::to_string(count) + " vertices so far.",
                               "Correct the line, or export the file again.");
  if (from_zero >= count && static_cast<std::uint64_t>(index) > largest_forward_) {
    largest_forward_ = static_cast<std::uint64_t>(index);
    largest_forward_line_ = scanner_.line();
  }
  if (out_.mesh.face_vertices.size() == limits_.corners)
    return scanner_.error_here(
        e_limit, "The faces have more than " + std::to_string(limits_.corners) + " corners together.",
        "Reduce the model before importing it.");
  out_.mesh.face_vertices.push_back(static_cast<Index>(from_zero));
  return {};
}

std::optional<Message> ObjReader::check() const {
  const std::size_t vertex_count = out_.mesh.positions.size();
  if (largest_forward_ > vertex_count)
    return TextScanner::error_at_line(e_index_range, largest_forward_line_,
                                      "The face names vertex " + std::to_string(largest_forward_) +
                                          ", but the file has " + std::to_string(vertex_count) + " vertices.",
                                      remedy_correct);
  if (out_.mesh.face_count() == 0 && vertex_count == 0 && unknown_count_ > 0)
    return TextScanner::error_at_line(e_format_unknown, unknown_line_,
                                      unknown_ + " is not a statement of an OBJ file, and no vertex follows.",
                                      "Check that the file is a mesh in OBJ format.");
  return {};
}

std::optional<Message> ObjReader::no_faces() const {
  if (out_.mesh.face_count() > 0) return {};
  if (const auto left_out = surfaces_.left_out())
    return TextScanner::error_at_line(e_empty, scanner_.line(), left_out->text, left_out->remedy);
  if (calls_ > 0) return TextScanner::error_at_line(e_empty, scanner_.line(), called_files(), remedy_called);
  return TextScanner::error_at_line(e_empty, scanner_.line(),
                                    "The file ends with " + std::to_string(out_.mesh.positions.size()) +
                                        " vertices and without a single face.",
                                    "Export polygons, not points or curves.");
}

std::string ObjReader::called_files() const {
  if (calls_ == 1) return "The file takes in " + called_ + ", which is not read.";
  return "The file takes in " + std::to_string(calls_) + " other files, first " + called_ +
         ", which are not read.";
}

void ObjReader::warn() {
  if (unknown_count_ > 0)
    out_.warnings.push_back(make_warning(
        w_unknown_statement,
        "Line " + std::to_string(unknown_line_) + ": " + unknown_ + " is not a statement of an OBJ file; " +
            (unknown_count_ == 1
                 ? "it was ignored."
                 : "it and " + std::to_string(unknown_count_ - 1) + " more unknown statements were ignored."),
        {}, {Element::Kind::line, unknown_line_}));
  if (points_and_lines_ > 0)
    out_.warnings.push_back(make_warning(
        w_left_out, points_and_lines_ == 1
                        ? std::string("A set of points or lines was left out.")
                        : std::to_string(points_and_lines_) + " sets of points or lines were left out."));
  if (calls_ > 0) out_.warnings.push_back(make_warning(w_left_out, called_files(), remedy_called));
  surfaces_.warn(out_.warnings);
  parts_.warn(out_.warnings);
  tags_.warn(out_.mesh.positions.size(), out_.warnings);
}

Result<ImportedMesh> ObjReader::mesh() {
  if (auto error = no_faces()) return *error;
  warn();
  out_.name = parts_.first_name();
  return std::move(out_);
}

Result<ImportedScene> ObjReader::scene() {
  if (surfaces_.empty())
    if (auto error = no_faces()) return *error;
  auto patches = surfaces_.patches(out_.mesh.positions, weights_);
  if (!patches) return patches.error();
  warn();
  ImportedScene out;
  out.patches = std::move(patches).value();
  if (out_.mesh.face_count() > 0) {
    const std::size_t vertices = out_.mesh.positions.size();
    std::size_t joined = 0;
    // Control points of surfaces are no vertices of the mesh.
    out.parts = parts_.split(std::move(out_.mesh), tags_.creases(vertices), tags_.corners(vertices),
                             !surfaces_.empty(), joined);
    if (joined > 0) out_.warnings.push_back(objects_joined_message(joined));
  }
  out.warnings = std::move(out_.warnings);
  return out;
}

}  // namespace

Result<ImportedMesh> read_obj(std::string_view bytes, const ReadLimits& limits) {
  const auto text = from_utf16(bytes);
  ObjReader reader(text ? std::string_view(*text) : bytes, limits);
  if (auto error = reader.read()) return *error;
  return reader.mesh();
}

Result<ImportedScene> read_obj_scene(std::string_view bytes, const ReadLimits& limits) {
  const auto text = from_utf16(bytes);
  ObjReader reader(text ? std::string_view(*text) : bytes, limits);
  if (auto error = reader.read()) return *error;
  return reader.scene();
}

}  // namespace hariko
