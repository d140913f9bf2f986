#include "core/exchange/read_obj.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "core/base/printable.hpp"
#include "core/exchange/number_text.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {
namespace {

/// Statements of the OBJ specification, and the tags of subdivision surfaces (t), that say nothing about
/// polygons.
constexpr std::array<std::string_view, 43> ignored_statements{
    "bevel",     "bmat",   "bsp",    "bzp",        "c_interp", "call",     "cdc",  "cdp",  "con",
    "csh",       "cstype", "ctech",  "curv",       "curv2",    "d_interp", "deg",  "end",  "g",
    "hole",      "l",      "lod",    "maplib",     "mg",       "mtllib",   "o",    "p",    "parm",
    "res",       "s",      "scrv",   "shadow_obj", "sp",       "stech",    "step", "surf", "t",
    "trace_obj", "trim",   "usemap", "usemtl",     "vn",       "vp",       "vt"};

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const ReadLimits& limits)
      : scanner_(bytes, {.comments = true, .continuation = true}), limits_(limits) {}

  Result<ImportedMesh> read() {
    const std::size_t size = scanner_.remaining();
    while (scanner_.find_content()) {
      if (auto error = limits_.row(scanner_.remaining(), size)) return *error;
      if (auto error = read_statement()) return *error;
      scanner_.next_line();
    }
    return finish();
  }

 private:
  std::optional<Message> read_statement();
  std::optional<Message> read_vertex();
  std::optional<Message> read_face();
  std::optional<Message> add_corner(std::string_view token);
  std::optional<Message> add_index(std::string_view token, std::int64_t index);
  void read_name(std::string& name);
  Result<ImportedMesh> finish();

  TextScanner scanner_;
  const ReadLimits& limits_;
  ImportedMesh out_;
  std::string object_name_, group_name_;
  // A face may name a vertex that comes later. The largest such index stands for all of them.
  std::uint64_t largest_forward_ = 0;
  std::size_t largest_forward_line_ = 0;
  std::size_t unknown_count_ = 0, unknown_line_ = 0;
  std::string unknown_;
};

std::optional<Message> ObjReader::read_statement() {
  const std::string_view keyword = scanner_.token();
  if (keyword == "v") return read_vertex();
  if (keyword == "f" || keyword == "fo") return read_face();  // fo is the older spelling
  if (keyword == "o") read_name(object_name_);
  if (keyword == "g") read_name(group_name_);
  if (std::find(ignored_statements.begin(), ignored_statements.end(), keyword) == ignored_statements.end()) {
    if (unknown_count_++ == 0) {
      unknown_ = quote(keyword);
      unknown_line_ = scanner_.line();
    }
  }
  return {};
}

void ObjReader::read_name(std::string& name) {
  if (name.empty()) name = printable(scanner_.rest_of_line(), 200);
}

std::optional<Message> ObjReader::read_vertex() {
  Vector3 point;
  if (auto error = scanner_.read_point("coordinate", point)) return error;
  // A weight or a colour may follow.
  for (std::string_view extra = scanner_.token(); !extra.empty(); extra = scanner_.token()) {
    double ignored = 0;
    if (parse_real(extra, ignored) == NumberStatus::malformed)
      return scanner_.error_here(e_parse,
                                 "After a vertex come only numbers, but here is " + quote(extra) + ".",
                                 "Correct the line, or export the file again.");
  }
  if (out_.mesh.positions.size() == limits_.vertices)
    return scanner_.error_here(e_limit,
                               "The file has more than " + std::to_string(limits_.vertices) + " vertices.",
                               "Reduce the model before importing it.");
  out_.mesh.positions.push_back(point);
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

/// "v", "v/vt", "v//vn" or "v/vt/vn"; only v counts, but the rest must be integers.
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

Result<ImportedMesh> ObjReader::finish() {
  const std::size_t vertex_count = out_.mesh.positions.size();
  if (largest_forward_ > vertex_count)
    return TextScanner::error_at_line(e_index_range, largest_forward_line_,
                                      "The face names vertex " + std::to_string(largest_forward_) +
                                          ", but the file has " + std::to_string(vertex_count) + " vertices.",
                                      "Correct the line, or export the file again.");
  if (out_.mesh.face_count() == 0 && vertex_count == 0 && unknown_count_ > 0)
    return TextScanner::error_at_line(e_format_unknown, unknown_line_,
                                      unknown_ + " is not a statement of an OBJ file, and no vertex follows.",
                                      "Check that the file is a mesh in OBJ format.");
  if (out_.mesh.face_count() == 0)
    return TextScanner::error_at_line(
        e_empty, scanner_.line(),
        "The file ends with " + std::to_string(vertex_count) + " vertices and without a single face.",
        "Export polygons, not points or curves.");
  if (unknown_count_ > 0)
    out_.warnings.push_back(make_warning(
        w_unknown_statement,
        "Line " + std::to_string(unknown_line_) + ": " + unknown_ + " is not a statement of an OBJ file; " +
            (unknown_count_ == 1
                 ? "it was ignored."
                 : "it and " + std::to_string(unknown_count_ - 1) + " more unknown statements were ignored."),
        {}, {Element::Kind::line, unknown_line_}));
  out_.name = object_name_.empty() ? group_name_ : object_name_;
  return std::move(out_);
}

}  // namespace

Result<ImportedMesh> read_obj(std::string_view bytes, const ReadLimits& limits) {
  return ObjReader(bytes, limits).read();
}

}  // namespace hariko
