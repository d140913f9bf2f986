#include "core/exchange/triangles/read_off.hpp"

#include <algorithm>
#include <optional>

#include "core/exchange/number_text.hpp"
#include "core/exchange/repair/remedies.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {
namespace {

constexpr const char* remedy_line = "Correct the line, or export the file again.";

/// Arrangement of the numbers. `lines`: the counts, each vertex and each face on a line, behind which may
/// stand more. The format itself goes by words, wherever the lines end; `coloured_words`: what stands on the
/// line behind a face's vertices is its colour; `words`: faces have no colours.
enum class OffLayout { lines, coloured_words, words };

bool is_keyword(std::string_view word) {
  if (!word.ends_with("OFF")) return false;
  word.remove_suffix(3);
  return word.find_first_not_of("STCNn4") == std::string_view::npos && word.size() <= 6;
}

/// Keyword at the start of a word, in capitals, empty where there is none; numbers may follow without a
/// blank, as in "OFF8 6 12". Only where OFF is in capitals does the case of the letters before it count.
std::string keyword_of(std::string_view word) {
  std::string capitals(word.substr(0, 16));
  for (char& c : capitals)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  const std::size_t end = capitals.find("OFF");
  if (end == std::string::npos) return {};
  std::string keyword = capitals.substr(0, end + 3);
  const std::string_view rest = word.substr(end + 3);
  if (word.substr(end, 3) == "OFF") keyword = word.substr(0, end + 3);
  if (!is_keyword(keyword) || rest.find_first_not_of("0123456789") != std::string_view::npos) return {};
  return keyword;
}

class OffReader {
 public:
  OffReader(std::string_view bytes, OffLayout layout, const ReadLimits& limits)
      : layout_(layout),
        scanner_(bytes, {.comments = true, .continuation = false}),
        limits_(limits),
        size_(bytes.size()) {}

  Result<ImportedMesh> read();

 private:
  std::optional<Message> read_header();
  std::optional<Message> read_counts(std::string_view first);
  std::optional<Message> read_vertices();
  std::optional<Message> read_vertex();
  std::optional<Message> read_faces();
  std::optional<Message> read_face();
  Message truncated(const char* what, std::size_t done, std::int64_t promised) const;
  Message promises_too_much(const char* what, std::int64_t count) const;

  /// Moves to the next word, where lines do not count.
  void go_on() {
    if (layout_ != OffLayout::lines) static_cast<void>(scanner_.find_content());
  }

  OffLayout layout_;
  TextScanner scanner_;
  const ReadLimits& limits_;
  std::size_t size_;
  ImportedMesh out_;
  std::int64_t vertex_count_ = 0, face_count_ = 0;
  int extras_ = 0;  ///< numbers behind each vertex that the keyword promises
};

Message OffReader::truncated(const char* what, std::size_t done, std::int64_t promised) const {
  return TextScanner::error_at_line(e_truncated, scanner_.line(),
                                    "The file ends after " + std::to_string(done) + " of " +
                                        std::to_string(promised) + " promised " + what + ".",
                                    "The file was cut off: copy or export it again.");
}

Message OffReader::promises_too_much(const char* what, std::int64_t count) const {
  return scanner_.error_here(
      e_limit,
      "The header promises " + std::to_string(count) + " " + what + ", which is more than is accepted.",
      remedy_reduce);
}

std::optional<Message> OffReader::read_header() {
  if (!scanner_.find_content())
    return TextScanner::error_at_line(e_empty, scanner_.line(), "The file is empty.",
                                      "Export the file again.");
  std::string_view first = scanner_.token();
  std::int64_t ignored = 0;
  if (parse_integer(first, ignored) != NumberStatus::malformed)
    return read_counts(first);  // the keyword is optional
  const std::string keyword = keyword_of(first);
  const std::string_view glued = first.substr(keyword.size());
  if (keyword.empty())
    return scanner_.error_here(e_format_unknown,
                               "An OFF file starts with the word OFF, but here is " + quote(first) + ".",
                               "Check that the file is a mesh in OFF format.");
  if (keyword.find_first_of("n4") != std::string_view::npos)
    return scanner_.error_here(e_format_unknown,
                               quote(keyword) + " holds points that are not three-dimensional.",
                               "Export plain OFF.");
  extras_ = (keyword.find('N') != std::string::npos ? 3 : 0) +
            (keyword.find("ST") != std::string::npos ? 2 : 0) +
            (keyword.find('C') != std::string::npos ? 4 : 0);
  first = glued.empty() ? scanner_.token() : glued;
  if (first == "BINARY")
    return scanner_.error_here(e_format_unknown, "Binary OFF is not read.", "Export OFF as text.");
  if (first.empty()) {
    if (!scanner_.find_content())
      return TextScanner::error_at_line(e_truncated, scanner_.line(), "The file ends before the counts.",
                                        "The file was cut off: copy or export it again.");
    first = scanner_.token();
  }
  return read_counts(first);
}

std::optional<Message> OffReader::read_counts(std::string_view first) {
  if (parse_integer(first, vertex_count_) != NumberStatus::ok)
    return scanner_.error_here(
        e_parse, "The number of vertices should stand here, but here is " + quote(first) + ".", remedy_line);
  if (vertex_count_ < 0)
    return scanner_.error_here(e_parse, "The number of vertices is negative.", remedy_line);
  if (vertex_count_ > static_cast<std::int64_t>(limits_.vertices))
    return promises_too_much("vertices", vertex_count_);
  go_on();
  if (auto error = scanner_.read_integer("number of faces", face_count_)) return error;
  if (face_count_ < 0) return scanner_.error_here(e_parse, "The number of faces is negative.", remedy_line);
  if (face_count_ > static_cast<std::int64_t>(limits_.corners))
    return promises_too_much("faces", face_count_);
  // Optional number of edges, ignored: many writers put 0.
  go_on();
  const std::string_view edges = scanner_.token();
  std::int64_t ignored = 0;
  if (!edges.empty() && parse_integer(edges, ignored) != NumberStatus::ok)
    return scanner_.error_here(
        e_parse, "The number of edges should stand here, but here is " + quote(edges) + ".", remedy_line);
  if (layout_ != OffLayout::lines) return {};
  if (!scanner_.token().empty())
    return scanner_.error_here(e_parse, "After the three counts stands something else.", remedy_line);
  scanner_.next_line();
  return {};
}

std::optional<Message> OffReader::read_vertices() {
  // The header may claim too much: a vertex takes at least 6 bytes ("0 0 0" and the line end).
  const std::size_t possible = scanner_.remaining() / 6 + 1;
  out_.mesh.positions.reserve(std::min(static_cast<std::size_t>(vertex_count_), possible));
  for (std::int64_t i = 0; i < vertex_count_; ++i) {
    if (auto error = limits_.row(scanner_.remaining(), size_)) return error;
    if (!scanner_.find_content()) return truncated("vertices", static_cast<std::size_t>(i), vertex_count_);
    if (auto error = read_vertex()) return error;
  }
  return {};
}

std::optional<Message> OffReader::read_vertex() {
  Vector3 point;
  double ignored = 0;
  if (layout_ == OffLayout::lines) {
    if (auto error = scanner_.read_point("coordinate", point)) return error;
    for (std::string_view extra = scanner_.token(); !extra.empty(); extra = scanner_.token())
      if (parse_real(extra, ignored) == NumberStatus::malformed)
        return scanner_.error_here(
            e_parse, "After a vertex come only numbers, but here is " + quote(extra) + ".", remedy_line);
    scanner_.next_line();
  } else {
    for (int k = 0; k < 3 + extras_; ++k) {
      go_on();
      if (auto error = scanner_.read_real("coordinate", k < 3 ? point[k] : ignored)) return error;
    }
  }
  out_.mesh.positions.push_back(point);
  return {};
}

std::optional<Message> OffReader::read_face() {
  std::int64_t corners = 0;
  if (auto error = scanner_.read_integer("number of corners", corners)) return error;
  if (corners < 0) return scanner_.error_here(e_parse, "The number of corners is negative.", remedy_line);
  if (corners < 3 && layout_ != OffLayout::lines)
    return scanner_.error_here(e_parse, "The face has fewer than three corners.", remedy_line);
  for (std::int64_t c = 0; c < corners; ++c) {
    std::int64_t index = 0;
    go_on();
    if (auto error = scanner_.read_integer("vertex of a corner", index)) return error;
    if (index < 0 || index >= vertex_count_)
      return scanner_.error_here(e_index_range,
                                 "The face names vertex " + std::to_string(index) + ", but the file has " +
                                     std::to_string(vertex_count_) + " vertices, counted from 0.",
                                 remedy_line);
    if (out_.mesh.face_vertices.size() == limits_.corners)
      return scanner_.error_here(
          e_limit, "The faces have more than " + std::to_string(limits_.corners) + " corners together.",
          remedy_reduce);
    out_.mesh.face_vertices.push_back(static_cast<Index>(index));
  }
  out_.mesh.face_offsets.push_back(static_cast<Index>(out_.mesh.face_vertices.size()));
  return {};  // a colour may follow on the line, as numbers or as the name of a colour map
}

std::optional<Message> OffReader::read_faces() {
  const std::size_t possible = scanner_.remaining() / 2 + 1;  // "0" and the line end
  out_.mesh.face_offsets.reserve(std::min(static_cast<std::size_t>(face_count_), possible) + 1);
  for (std::int64_t f = 0; f < face_count_; ++f) {
    if (auto error = limits_.row(scanner_.remaining(), size_)) return error;
    if (!scanner_.find_content()) return truncated("faces", static_cast<std::size_t>(f), face_count_);
    if (auto error = read_face()) return error;
    if (layout_ != OffLayout::words) scanner_.next_line();
  }
  return {};
}

Result<ImportedMesh> OffReader::read() {
  if (auto error = read_header()) return *error;
  if (auto error = read_vertices()) return *error;
  if (auto error = read_faces()) return *error;
  if (face_count_ == 0)
    return TextScanner::error_at_line(e_empty, scanner_.line(), "The file has no faces.",
                                      "Export polygons, not points or curves.");
  if (scanner_.find_content() && layout_ != OffLayout::lines)
    return scanner_.error_here(e_parse, "Something follows the last face.", remedy_line);
  if (!scanner_.at_end())
    out_.warnings.push_back(
        make_warning(w_trailing_data,
                     "Line " + std::to_string(scanner_.line()) + ": What follows the last face was ignored.",
                     {}, {Element::Kind::line, scanner_.line()}));
  return std::move(out_);
}

}  // namespace

Result<ImportedMesh> read_off(std::string_view bytes, const ReadLimits& limits) {
  auto by_lines = OffReader(bytes, OffLayout::lines, limits).read();
  if (by_lines) return by_lines;
  const Code code = by_lines.error().code;
  if (code != e_truncated && code != e_parse && code != e_index_range) return by_lines;
  for (const OffLayout layout : {OffLayout::coloured_words, OffLayout::words})
    if (auto by_words = OffReader(bytes, layout, limits).read();
        by_words || by_words.error().code == e_cancelled)
      return by_words;
  return by_lines;
}

bool looks_like_off(std::string_view bytes) {
  TextScanner scanner(bytes, {.comments = true, .continuation = false});
  return scanner.find_content() && !keyword_of(scanner.token()).empty();
}

}  // namespace hariko
