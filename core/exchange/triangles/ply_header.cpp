#include "core/exchange/triangles/ply_header.hpp"

#include <algorithm>
#include <optional>

#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {
namespace {

constexpr const char* remedy_header = "Correct the header, or export the file again.";

std::optional<PlyType> type_of(std::string_view name) {
  struct Entry {
    std::string_view name;
    PlyType type;
  };
  static constexpr Entry entries[] = {
      {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
      {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
      {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
      {"float64", PlyType::float64}};
  for (const Entry& entry : entries)
    if (entry.name == name) return entry.type;
  return {};
}

class HeaderReader {
 public:
  explicit HeaderReader(std::string_view bytes)
      : bytes_(bytes), scanner_(bytes, {.comments = false, .continuation = false}) {}

  Result<PlyHeader> read();

 private:
  std::optional<Message> read_statement(std::string_view keyword);
  std::optional<Message> read_format();
  std::optional<Message> read_element();
  std::optional<Message> read_property();
  std::optional<Message> read_type(PlyType& type, bool must_be_integer);
  std::optional<Message> check() const;
  void finish_header_line();
  Message wrong(const std::string& sentence) const {
    return scanner_.error_here(e_parse, sentence, remedy_header);
  }

  std::string_view bytes_;
  TextScanner scanner_;
  PlyHeader out_;
  bool has_format_ = false;
};

std::optional<Message> HeaderReader::read_format() {
  const std::string_view name = scanner_.token();
  if (name == "ascii")
    out_.format = PlyFormat::ascii;
  else if (name == "binary_little_endian")
    out_.format = PlyFormat::little_endian;
  else if (name == "binary_big_endian")
    out_.format = PlyFormat::big_endian;
  else
    return scanner_.error_here(e_format_unknown, "The PLY format " + quote(name) + " is not known.",
                               "Export PLY as ascii, binary_little_endian or binary_big_endian.");
  const std::string_view version = scanner_.token();
  if (version != "1.0")
    return scanner_.error_here(e_format_unknown,
                               "The PLY version should be 1.0, but is " + quote(version) + ".",
                               "Export PLY of version 1.0.");
  has_format_ = true;
  return {};
}

std::optional<Message> HeaderReader::read_element() {
  PlyElement element;
  element.name = scanner_.token();
  element.line = scanner_.line();
  if (element.name.empty()) return wrong("The element has no name.");
  for (const PlyElement& other : out_.elements)
    if (other.name == element.name)
      return wrong("The element " + quote(element.name) + " is declared twice.");
  // Limits the number of elements, as reading a header takes quadratic time in it.
  if (out_.elements.size() == 1000)
    return scanner_.error_here(e_limit, "The header declares more than 1000 elements.", remedy_header);
  std::int64_t count = 0;
  if (auto error = scanner_.read_integer("number of elements", count)) return error;
  if (count < 0) return wrong("The number of elements is negative.");
  element.count = static_cast<std::uint64_t>(count);
  out_.elements.push_back(std::move(element));
  return {};
}

std::optional<Message> HeaderReader::read_type(PlyType& type, bool must_be_integer) {
  const std::string_view name = scanner_.token();
  const std::optional<PlyType> found = type_of(name);
  if (!found) return wrong(quote(name) + " is not a number type of PLY.");
  if (must_be_integer && !is_integer(*found))
    return wrong("The type " + quote(name) + " should be an integer type.");
  type = *found;
  return {};
}

std::optional<Message> HeaderReader::read_property() {
  if (out_.elements.empty()) return wrong("A property stands before the first element.");
  PlyElement& element = out_.elements.back();
  PlyProperty property;
  const std::string_view first = scanner_.token();
  if (first == "list") {
    property.is_list = true;
    if (auto error = read_type(property.count_type, true)) return error;
    if (auto error = read_type(property.type, false)) return error;
  } else {
    const std::optional<PlyType> type = type_of(first);
    if (!type) return wrong(quote(first) + " is not a number type of PLY.");
    property.type = *type;
  }
  property.name = scanner_.token();
  if (property.name.empty()) return wrong("The property has no name.");
  if (element.properties.size() == 1000)
    return scanner_.error_here(e_limit, "The element has more than 1000 properties.", remedy_header);
  if (element.find(property.name) != element.properties.size())
    return wrong("The property " + quote(property.name) + " is declared twice.");
  element.properties.push_back(std::move(property));
  return {};
}

std::optional<Message> HeaderReader::read_statement(std::string_view keyword) {
  if (keyword == "comment" || keyword == "obj_info") {
    scanner_.rest_of_line();
    return {};
  }
  std::optional<Message> error;
  if (keyword == "format")
    error = read_format();
  else if (keyword == "element")
    error = read_element();
  else if (keyword == "property")
    error = read_property();
  else
    error = wrong(quote(keyword) + " is not a statement of a PLY header.");
  if (error) return error;
  if (const std::string_view extra = scanner_.token(); !extra.empty())
    return wrong(quote(extra) + " does not belong on this line.");
  return {};
}

/// Skips the line end of "end_header". Where the whole header ends its lines in CR alone, a following LF is
/// the first byte of the data.
void HeaderReader::finish_header_line() {
  const std::size_t first_end = bytes_.find_first_of("\r\n");
  const bool only_cr =
      bytes_[first_end] == '\r' && first_end + 1 < bytes_.size() && bytes_[first_end + 1] != '\n';
  std::size_t end = bytes_.size() - scanner_.remaining();
  if (end < bytes_.size() && bytes_[end] == '\r') {
    ++end;
    if (!only_cr && end < bytes_.size() && bytes_[end] == '\n') ++end;
  } else if (end < bytes_.size()) {
    ++end;
  }
  out_.size = end;
  out_.line_count = scanner_.line();
}

std::optional<Message> HeaderReader::check() const {
  for (const PlyElement& element : out_.elements) {
    const auto wrong_element = [&](const std::string& sentence) {
      return TextScanner::error_at_line(e_parse, element.line, sentence, remedy_header);
    };
    if (element.properties.empty() && element.count > 0)
      return wrong_element("The element " + quote(element.name) + " has no properties.");
    if (element.name == "vertex" && element.count > 0) {
      for (const char* axis : {"x", "y", "z"}) {
        const std::size_t at = element.find(axis);
        if (at == element.properties.size() || element.properties[at].is_list)
          return wrong_element("The vertices have no number named " + std::string(axis) + ".");
      }
    }
    if ((element.name == "face" || element.name == "tristrips") && element.count > 0) {
      const std::size_t at = ply_index_list(element);
      if (at == element.properties.size() || !element.properties[at].is_list ||
          !is_integer(element.properties[at].type))
        return wrong_element((element.name == "face" ? "The faces" : "The strips") +
                             std::string(" have no integer list named vertex_indices or vertex_index."));
    }
  }
  return {};
}

Result<PlyHeader> HeaderReader::read() {
  if (scanner_.token() != "ply" || !scanner_.token().empty())
    return scanner_.error_here(e_format_unknown, "A PLY file starts with the line \"ply\".",
                               "Check that the file is a mesh in PLY format.");
  while (scanner_.next_line()) {
    const std::string_view keyword = scanner_.token();
    if (keyword.empty()) continue;
    if (keyword == "end_header") {
      if (!has_format_)
        return scanner_.error_here(e_format_unknown, "The header does not tell its format.", remedy_header);
      scanner_.rest_of_line();
      finish_header_line();
      if (auto error = check()) return *error;
      return std::move(out_);
    }
    if (auto error = read_statement(keyword)) return *error;
  }
  return TextScanner::error_at_line(e_truncated, scanner_.line(), "The file ends inside its header.",
                                    "The file was cut off: copy or export it again.");
}

}  // namespace

std::size_t ply_size(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      return 8;
  }
  return 0;
}

bool is_integer(PlyType type) {
  return type != PlyType::float32 && type != PlyType::float64;
}

std::size_t PlyElement::find(std::string_view property) const {
  const auto it = std::find_if(properties.begin(), properties.end(),
                               [&](const PlyProperty& p) { return p.name == property; });
  return static_cast<std::size_t>(it - properties.begin());
}

std::size_t ply_index_list(const PlyElement& face) {
  const std::size_t at = face.find("vertex_indices");
  return at != face.properties.size() ? at : face.find("vertex_index");
}

Result<PlyHeader> read_ply_header(std::string_view bytes) {
  return HeaderReader(bytes).read();
}

}  // namespace hariko
