#include "core/exchange/triangles/read_ply.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "core/exchange/imported_scene.hpp"
#include "core/exchange/number_text.hpp"
#include "core/exchange/repair/remedies.hpp"
#include "core/exchange/text_scanner.hpp"
#include "core/exchange/triangles/ply_header.hpp"

namespace hariko {
namespace {

/// Elements that have no shape.
constexpr std::array<std::string_view, 6> shapeless_elements{
    "camera", "material", "texture", "user", "multi_texture_vertex", "multi_texture_face"};

/// Sequential reader of a binary file's numbers.
class BinarySource {
 public:
  BinarySource(std::string_view bytes, std::size_t begin, bool big_endian)
      : bytes_(bytes), position_(begin), swap_(big_endian != (std::endian::native == std::endian::big)) {}

  std::size_t position() const { return position_; }
  std::size_t remaining() const { return bytes_.size() - position_; }
  void skip(std::size_t count) { position_ += count; }

  /// Next number; the caller has checked that it is there.
  double real(PlyType type) {
    if (type == PlyType::float32) return std::bit_cast<float>(take<std::uint32_t>());
    if (type == PlyType::float64) return std::bit_cast<double>(take<std::uint64_t>());
    return static_cast<double>(integer(type));
  }
  std::int64_t integer(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return static_cast<std::int8_t>(take<std::uint8_t>());
      case PlyType::uint8:
        return take<std::uint8_t>();
      case PlyType::int16:
        return static_cast<std::int16_t>(take<std::uint16_t>());
      case PlyType::uint16:
        return take<std::uint16_t>();
      case PlyType::int32:
        return static_cast<std::int32_t>(take<std::uint32_t>());
      default:
        return take<std::uint32_t>();
    }
  }

 private:
  template <class Unsigned>
  Unsigned take() {
    Unsigned value;
    std::memcpy(&value, bytes_.data() + position_, sizeof value);
    position_ += sizeof value;
    if (!swap_ || sizeof value == 1) return value;
    Unsigned swapped = 0;
    for (std::size_t i = 0; i < sizeof value; ++i)
      swapped = static_cast<Unsigned>(swapped | ((value >> (8 * i)) & 0xffU) << (8 * (sizeof value - 1 - i)));
    return swapped;
  }

  std::string_view bytes_;
  std::size_t position_;
  bool swap_;
};

/// Assigns numbers to the mesh and checks them, for text and binary alike.
class PlyReader {
 public:
  PlyReader(std::string_view bytes, PlyHeader header, const ReadLimits& limits)
      : bytes_(bytes), header_(std::move(header)), limits_(limits) {}

  Result<ImportedMesh> read();

 private:
  enum class Role { skipped, x, y, z, index_list, strip_list };
  /// Role of each property of an element.
  std::vector<Role> roles_of(const PlyElement& element) const;
  std::optional<Message> check_counts() const;
  void drop_what_is_not_finite();
  void tell_what_is_left_out();

  std::optional<Message> read_text();
  std::optional<Message> read_text_row(TextScanner& scanner, const PlyElement& element,
                                       const std::vector<Role>& roles);
  std::optional<Message> read_text_list(TextScanner& scanner, Role role);

  std::optional<Message> read_binary();
  std::optional<Message> read_binary_element(BinarySource& source, const PlyElement& element);
  std::optional<Message> read_binary_row(BinarySource& source, const PlyElement& element,
                                         const std::vector<Role>& roles, std::uint64_t row);
  std::optional<Message> read_binary_list(BinarySource& source, const PlyProperty& property, Role role,
                                          const PlyElement& element, std::uint64_t row);
  static Message binary_error(Code code, std::size_t position, const std::string& sentence,
                              const char* remedy) {
    return make_error(code, "Byte " + std::to_string(position) + ": " + sentence, remedy);
  }
  static Message binary_end(std::size_t size, const PlyElement& element, std::uint64_t row) {
    return binary_error(e_truncated, size,
                        "The file ends inside element " + quote(element.name) + ", after " +
                            std::to_string(row) + " of " + std::to_string(element.count) + ".",
                        remedy_cut);
  }
  std::string range_sentence(std::int64_t index) const {
    return "The face names vertex " + std::to_string(index) + ", but the file has " +
           std::to_string(vertex_count_) + " vertices, counted from 0.";
  }
  std::string corner_sentence() const {
    return "The faces have more than " + std::to_string(limits_.corners) + " corners together.";
  }
  /// Whether an index is valid; in strips also -1, which begins a new strip.
  bool in_range(Role role, std::int64_t index) const {
    if (role == Role::strip_list && index == -1) return true;
    return index >= 0 && static_cast<std::uint64_t>(index) < vertex_count_;
  }
  /// Adds a corner; false above the limit.
  bool add_corner(Role role, std::int64_t index) {
    if (role == Role::strip_list) return add_to_strip(index);
    if (out_.mesh.face_vertices.size() == limits_.corners) return false;
    out_.mesh.face_vertices.push_back(static_cast<Index>(index));
    return true;
  }
  bool add_to_strip(std::int64_t index);
  void end_list(Role role) {
    if (role == Role::index_list) end_face();
    strip_.clear();
  }
  void end_face() { out_.mesh.face_offsets.push_back(static_cast<Index>(out_.mesh.face_vertices.size())); }

  std::string_view bytes_;
  PlyHeader header_;
  const ReadLimits& limits_;
  ImportedMesh out_;
  std::uint64_t vertex_count_ = 0;
  Vector3 point_ = Vector3::Zero();
  std::vector<Index> strip_;  ///< corners of the present strip since its beginning or the last -1
};

/// Adds a corner of a strip. Every second triangle of a strip has the opposite orientation; degenerate
/// triangles only alternate it.
bool PlyReader::add_to_strip(std::int64_t index) {
  if (index == -1) {
    strip_.clear();
    return true;
  }
  strip_.push_back(static_cast<Index>(index));
  if (strip_.size() < 3) return true;
  Index a = strip_[strip_.size() - 3], b = strip_[strip_.size() - 2];
  const Index c = strip_.back();
  if (strip_.size() % 2 == 0) std::swap(a, b);
  if (a == b || b == c || c == a) return true;
  if (out_.mesh.face_vertices.size() + 3 > limits_.corners) return false;
  out_.mesh.add_face({a, b, c});
  return true;
}

std::vector<PlyReader::Role> PlyReader::roles_of(const PlyElement& element) const {
  std::vector<Role> roles(element.properties.size(), Role::skipped);
  if (element.count == 0) return roles;
  if (element.name == "vertex") {
    roles[element.find("x")] = Role::x;
    roles[element.find("y")] = Role::y;
    roles[element.find("z")] = Role::z;
  }
  if (element.name == "face") roles[ply_index_list(element)] = Role::index_list;
  if (element.name == "tristrips") roles[ply_index_list(element)] = Role::strip_list;
  return roles;
}

std::optional<Message> PlyReader::check_counts() const {
  for (const PlyElement& element : header_.elements) {
    const bool is_vertex = element.name == "vertex";  // strips are bounded by their corners
    const std::size_t limit = is_vertex ? limits_.vertices : limits_.corners;
    if ((is_vertex || element.name == "face") && element.count > limit)
      return TextScanner::error_at_line(e_limit, element.line,
                                        "The header promises " + std::to_string(element.count) +
                                            " of element " + quote(element.name) +
                                            ", which is more than is accepted.",
                                        remedy_reduce);
  }
  return {};
}

std::optional<Message> PlyReader::read_text_list(TextScanner& scanner, Role role) {
  std::int64_t count = 0;
  if (auto error = scanner.read_integer("length of a list", count)) return error;
  if (count < 0) return scanner.error_here(e_parse, "The length of the list is negative.", remedy_correct);
  for (std::int64_t i = 0; i < count; ++i) {
    if (role == Role::skipped) {
      if (scanner.token().empty()) {
        if (scanner.at_end()) return scanner.file_ends("number of a list");
        return scanner.error_here(e_parse, "The list is shorter than its length says.", remedy_correct);
      }
      continue;
    }
    std::int64_t index = 0;
    if (auto error = scanner.read_integer("vertex of a corner", index)) return error;
    if (!in_range(role, index))
      return scanner.error_here(e_index_range, range_sentence(index), remedy_correct);
    if (!add_corner(role, index)) return scanner.error_here(e_limit, corner_sentence(), remedy_reduce);
  }
  end_list(role);
  return {};
}

std::optional<Message> PlyReader::read_text_row(TextScanner& scanner, const PlyElement& element,
                                                const std::vector<Role>& roles) {
  for (std::size_t p = 0; p < roles.size(); ++p) {
    std::optional<Message> error;
    if (element.properties[p].is_list) {
      error = read_text_list(scanner, roles[p]);
    } else if (roles[p] != Role::skipped) {
      error =
          scanner.read_any_real("coordinate", point_[static_cast<int>(roles[p]) - static_cast<int>(Role::x)]);
    } else if (scanner.token().empty()) {
      if (scanner.at_end()) return scanner.file_ends("rest of the element");
      return scanner.error_here(e_parse, "The line has fewer numbers than the header says.", remedy_correct);
    }
    if (error) return error;
  }
  if (const std::string_view extra = scanner.token(); !extra.empty())
    return scanner.error_here(
        e_parse, "The line has more numbers than the header says: " + quote(extra) + ".", remedy_correct);
  if (element.name == "vertex") out_.mesh.positions.push_back(point_);
  return {};
}

std::optional<Message> PlyReader::read_text() {
  TextScanner scanner(bytes_, {.comments = false, .continuation = false});
  while (scanner.line() < header_.line_count && scanner.next_line()) {
  }
  scanner.next_line();
  for (const PlyElement& element : header_.elements) {
    const std::vector<Role> roles = roles_of(element);
    // The header may claim too much: every row takes at least a digit and a separator for each property.
    const auto possible = std::min<std::uint64_t>(
        element.count, scanner.remaining() / (2 * std::max<std::size_t>(roles.size(), 1)) + 1);
    if (element.name == "vertex") out_.mesh.positions.reserve(possible);
    if (element.name == "face") out_.mesh.face_offsets.reserve(possible + 1);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      if (auto error = limits_.row(scanner.remaining(), bytes_.size())) return error;
      if (!scanner.find_content())
        return TextScanner::error_at_line(e_truncated, scanner.line(),
                                          "The file ends after " + std::to_string(row) + " of " +
                                              std::to_string(element.count) + " of element " +
                                              quote(element.name) + ".",
                                          remedy_cut);
      if (auto error = read_text_row(scanner, element, roles)) return error;
      scanner.next_line();
    }
  }
  if (scanner.find_content())
    out_.warnings.push_back(make_warning(
        w_trailing_data,
        "Line " + std::to_string(scanner.line()) + ": What follows the last element was ignored.", {},
        {Element::Kind::line, scanner.line()}));
  return {};
}

std::optional<Message> PlyReader::read_binary_list(BinarySource& source, const PlyProperty& property,
                                                   Role role, const PlyElement& element, std::uint64_t row) {
  const std::size_t begin = source.position();
  if (source.remaining() < ply_size(property.count_type)) return binary_end(bytes_.size(), element, row);
  const std::int64_t count = source.integer(property.count_type);
  if (count < 0) return binary_error(e_parse, begin, "The length of the list is negative.", remedy_correct);
  const std::size_t size = ply_size(property.type);
  if (static_cast<std::uint64_t>(count) > source.remaining() / size)
    return binary_end(bytes_.size(), element, row);
  if (role == Role::skipped) {
    source.skip(static_cast<std::size_t>(count) * size);
    return {};
  }
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t index = source.integer(property.type);
    if (!in_range(role, index))
      return binary_error(e_index_range, source.position() - size,
                          (role == Role::strip_list ? "In strip " : "In face ") + std::to_string(row) + ": " +
                              range_sentence(index),
                          remedy_correct);
    if (!add_corner(role, index)) return binary_error(e_limit, begin, corner_sentence(), remedy_reduce);
  }
  end_list(role);
  return {};
}

std::optional<Message> PlyReader::read_binary_row(BinarySource& source, const PlyElement& element,
                                                  const std::vector<Role>& roles, std::uint64_t row) {
  for (std::size_t p = 0; p < roles.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    if (property.is_list) {
      if (auto error = read_binary_list(source, property, roles[p], element, row)) return error;
      continue;
    }
    if (source.remaining() < ply_size(property.type)) return binary_end(bytes_.size(), element, row);
    if (roles[p] == Role::skipped) {
      source.skip(ply_size(property.type));
      continue;
    }
    point_[static_cast<int>(roles[p]) - static_cast<int>(Role::x)] = source.real(property.type);
  }
  if (element.name == "vertex") out_.mesh.positions.push_back(point_);
  return {};
}

std::optional<Message> PlyReader::read_binary_element(BinarySource& source, const PlyElement& element) {
  std::size_t smallest_row = 0;
  bool has_list = false;
  for (const PlyProperty& property : element.properties) {
    smallest_row += ply_size(property.is_list ? property.count_type : property.type);
    has_list = has_list || property.is_list;
  }
  // The header may claim too much: a row has at least one byte, so no more rows fit than bytes are left.
  if (element.count > 0 && element.count > source.remaining() / smallest_row)
    return binary_error(e_truncated, bytes_.size(),
                        "The header promises " + std::to_string(element.count) + " of element " +
                            quote(element.name) + ", but only " + std::to_string(source.remaining()) +
                            " bytes are left for them.",
                        remedy_cut);
  const std::vector<Role> roles = roles_of(element);
  if (!has_list && element.name != "vertex") {
    source.skip(element.count * smallest_row);
    return {};
  }
  if (element.name == "vertex") out_.mesh.positions.reserve(element.count);
  if (element.name == "face") out_.mesh.face_offsets.reserve(element.count + 1);
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (auto error = limits_.row(source.remaining(), bytes_.size())) return error;
    if (auto error = read_binary_row(source, element, roles, row)) return error;
  }
  return {};
}

std::optional<Message> PlyReader::read_binary() {
  BinarySource source(bytes_, header_.size, header_.format == PlyFormat::big_endian);
  for (const PlyElement& element : header_.elements)
    if (auto error = read_binary_element(source, element)) return error;
  if (source.remaining() > 0)
    out_.warnings.push_back(make_warning(w_trailing_data, "The last " + std::to_string(source.remaining()) +
                                                              " bytes of the file were ignored."));
  return {};
}

/// Drops vertices that are not finite, which programs write where a scan sees nothing, and the faces that use
/// them.
void PlyReader::drop_what_is_not_finite() {
  const PolygonMesh& mesh = out_.mesh;
  const auto finite = [](const Vector3& p) { return p.allFinite(); };
  if (std::all_of(mesh.positions.begin(), mesh.positions.end(), finite)) return;
  PolygonMesh kept;
  std::vector<Index> number(mesh.positions.size(), no_index);
  for (Index v = 0; v < number.size(); ++v) {
    if (!finite(mesh.positions[v])) continue;
    number[v] = static_cast<Index>(kept.positions.size());
    kept.positions.push_back(mesh.positions[v]);
  }
  std::vector<Index> corners;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    corners.clear();
    for (const Index v : mesh.face(f)) corners.push_back(number[v]);
    if (std::find(corners.begin(), corners.end(), no_index) == corners.end()) kept.add_face(corners);
  }
  if (const std::size_t left_out = mesh.face_count() - kept.face_count(); left_out > 0)
    out_.warnings.push_back(not_finite_message(left_out));
  out_.mesh = std::move(kept);
}

void PlyReader::tell_what_is_left_out() {
  for (const PlyElement& element : header_.elements) {
    const auto is = [&](std::string_view name) { return element.name == name; };
    if (element.count == 0 || is("vertex") || is("face") || is("tristrips") ||
        std::any_of(shapeless_elements.begin(), shapeless_elements.end(), is))
      continue;
    out_.warnings.push_back(make_warning(w_left_out,
                                         "The element " + quote(element.name) + " with " +
                                             std::to_string(element.count) +
                                             " entries is not read and was left out.",
                                         "Export what it holds as polygons."));
  }
}

Result<ImportedMesh> PlyReader::read() {
  if (auto error = check_counts()) return *error;
  for (const PlyElement& element : header_.elements)
    if (element.name == "vertex") vertex_count_ = element.count;
  if (auto error = header_.format == PlyFormat::ascii ? read_text() : read_binary()) return *error;
  if (out_.mesh.face_count() == 0)
    return make_error(e_empty, "The file has " + std::to_string(vertex_count_) + " vertices and no faces.",
                      "Export polygons, not a cloud of points.");
  drop_what_is_not_finite();
  if (out_.mesh.face_count() == 0)
    return make_error(e_empty, "No face of the file has finite coordinates only.", "Export the model again.");
  tell_what_is_left_out();
  return std::move(out_);
}

}  // namespace

Result<ImportedMesh> read_ply(std::string_view bytes, const ReadLimits& limits) {
  Result<PlyHeader> header = read_ply_header(bytes);
  if (!header) return header.error();
  return PlyReader(bytes, std::move(header).value(), limits).read();
}

}  // namespace hariko
