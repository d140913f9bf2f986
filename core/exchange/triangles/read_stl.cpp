#include "core/exchange/triangles/read_stl.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/exchange/repair/point_welder.hpp"
#include "core/exchange/repair/remedies.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t facet_size = 50;  // 12 floats and 2 bytes of attributes
constexpr int corner_size = 12;         // 3 floats

std::uint32_t little_endian_32(const char* bytes) {
  std::uint32_t value = 0;
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }
  for (int i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  return value;
}

Vector3 point_at(const char* bytes) {
  const auto coordinate = [&](int axis) {
    return double(std::bit_cast<float>(little_endian_32(bytes + 4 * axis)));
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

/// Size of the binary file with this header; 0 where the header is incomplete.
std::uint64_t promised_size(std::string_view bytes) {
  if (bytes.size() < header_size + 4) return 0;
  return header_size + 4 + facet_size * std::uint64_t{little_endian_32(bytes.data() + header_size)};
}

bool equals_lower(std::string_view token, std::string_view lower) {
  return std::equal(token.begin(), token.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

bool starts_with_solid(std::string_view bytes) {
  TextScanner scanner(bytes, {});
  return scanner.find_content() && equals_lower(scanner.token(), "solid");
}

bool is_text(std::string_view bytes) {
  if (promised_size(bytes) == bytes.size() || !starts_with_solid(bytes)) return false;
  // A truncated binary file may start with "solid" as well, but text has no zero bytes.
  return bytes.substr(0, 4096).find('\0') == std::string_view::npos;
}

/// Collects the triangles of one solid after the other, for both forms.
class TriangleCollector {
 public:
  TriangleCollector(std::size_t expected_triangles, const ReadLimits& limits)
      : welder_(expected_triangles / 2), limits_(limits) {
    mesh_.face_offsets.reserve(expected_triangles + 1);
    mesh_.face_vertices.reserve(3 * expected_triangles);
  }
  Index vertex(const Vector3& position) { return welder_.add(position); }
  void expect(const Vector3& position) const { welder_.expect(position); }
  /// Adds a triangle; false where a limit is reached.
  bool add(Index a, Index b, Index c) {
    if (vertices_before_ + welder_.size() > limits_.vertices ||
        corners_before_ + mesh_.face_vertices.size() + 3 > limits_.corners)
      return false;
    if (a == b || b == c || c == a)
      ++degenerate_count_;
    else
      mesh_.add_face({a, b, c});
    return true;
  }
  /// Leaves out a triangle with a corner that is not finite.
  void leave_out() { ++not_finite_count_; }
  bool add(const Vector3 (&corners)[3]) {
    if (!corners[0].allFinite() || !corners[1].allFinite() || !corners[2].allFinite()) {
      leave_out();
      return true;
    }
    const Index a = vertex(corners[0]), b = vertex(corners[1]), c = vertex(corners[2]);
    return add(a, b, c);
  }
  std::string limit_sentence() const {
    return "The file has more than " + std::to_string(limits_.vertices) + " vertices or " +
           std::to_string(limits_.corners) + " corners.";
  }
  /// Completes a solid; one without triangles is left out.
  void end_solid(std::string name) {
    if (first_name_.empty()) first_name_ = name;
    if (mesh_.face_count() == 0) return;
    mesh_.positions = welder_.take_positions();
    vertices_before_ += mesh_.positions.size();
    corners_before_ += mesh_.face_vertices.size();
    out_.parts.push_back({std::exchange(mesh_, {}), std::move(name)});
    welder_ = PointWelder(0);
  }
  Result<ImportedScene> finish() {
    if (out_.parts.empty()) {
      const char* why = "The file has no triangles.";
      if (degenerate_count_ > 0) why = "All triangles of the file have two corners at the same place.";
      if (not_finite_count_ > 0) why = "No triangle of the file has finite coordinates only.";
      return make_error(e_empty, why, "Export the model again.");
    }
    if (not_finite_count_ > 0) warn(not_finite_message(not_finite_count_));
    if (degenerate_count_ > 0)
      warn(make_warning(
          w_degenerate_triangles,
          std::to_string(degenerate_count_) +
              (degenerate_count_ == 1 ? " triangle with two corners at the same place was left out."
                                      : " triangles with two corners at the same place were left out.")));
    if (out_.parts.size() == 1 && out_.parts[0].name.empty()) out_.parts[0].name = first_name_;
    if (out_.parts.size() > ImportedScene::max_parts) {  // as groups of an OBJ file
      warn(objects_joined_message(out_.parts.size()));
      ImportedMesh whole = merged(std::move(out_));
      out_ = {};
      out_.parts.push_back({std::move(whole.mesh), first_name_});
      out_.warnings = std::move(whole.warnings);
    }
    return std::move(out_);
  }
  void warn(Message warning) { out_.warnings.push_back(std::move(warning)); }

 private:
  PointWelder welder_;
  const ReadLimits& limits_;
  PolygonMesh mesh_;  ///< the present solid
  ImportedScene out_;
  std::string first_name_;
  std::size_t degenerate_count_ = 0, not_finite_count_ = 0, vertices_before_ = 0, corners_before_ = 0;
};

Message facet_error(Code code, std::uint64_t facet, const std::string& sentence, const char* remedy) {
  return make_error(code,
                    "Triangle " + std::to_string(facet) + ", byte " +
                        std::to_string(header_size + 4 + facet * facet_size) + ": " + sentence,
                    remedy);
}

/// Error for bytes that are no binary file of this many triangles: text is something else.
Message not_complete(std::string_view bytes, std::uint64_t there, std::uint64_t count) {
  if (bytes.substr(0, 4096).find('\0') == std::string_view::npos)
    return make_error(e_format_unknown, "This is text, but no STL file: it does not begin with \"solid\".",
                      "Check that the file is a mesh in STL format.");
  return make_error(e_truncated,
                    "Byte " + std::to_string(bytes.size()) + ": The file ends after " +
                        std::to_string(there) + " of " + std::to_string(count) + " promised triangles.",
                    remedy_cut);
}

Result<ImportedScene> read_binary(std::string_view bytes, const ReadLimits& limits) {
  if (bytes.empty()) return make_error(e_empty, "The file is empty.", "Export the file again.");
  if (bytes.size() < header_size + 4)
    return make_error(
        e_truncated,
        "Byte " + std::to_string(bytes.size()) + ": The file ends inside the header of a binary STL file.",
        remedy_cut);
  // Programs that write while they compute leave the count out, as 0 or with all bits set.
  const std::uint64_t promised = little_endian_32(bytes.data() + header_size),
                      there = (bytes.size() - header_size - 4) / facet_size;
  const bool unknown = (promised == 0 || promised == 0xffffffffU) && there > 0;
  const std::uint64_t count = unknown ? there : promised;
  const std::uint64_t end = header_size + 4 + facet_size * count;
  if (end > bytes.size()) return not_complete(bytes, there, count);
  TriangleCollector collector(std::min<std::size_t>(count, limits.corners / 3), limits);
  constexpr std::uint64_t row = 256, ahead = 8;  // triangles
  // Reuses the corners that a triangle shares with the one before, as most share two: saves look-ups.
  const char* before = nullptr;
  Index known[3] = {no_index, no_index, no_index};
  for (std::uint64_t facet = 0; facet < count; ++facet) {
    if (facet % row == 0)
      if (auto error = limits.row((count - facet) * facet_size, bytes.size())) return *error;
    const char* corners = bytes.data() + header_size + 4 + facet * facet_size + 12;  // after the normal
    if (count - facet > ahead)
      for (int k = 0; k < 3; ++k) collector.expect(point_at(corners + ahead * facet_size + corner_size * k));
    Index vertices[3];
    Vector3 positions[3];
    bool finite = true;
    for (int k = 0; k < 3; ++k) {
      vertices[k] = no_index;
      for (int j = 0; before && j < 3; ++j)
        if (std::memcmp(corners + corner_size * k, before + corner_size * j, corner_size) == 0)
          vertices[k] = known[j];
      positions[k] = point_at(corners + corner_size * k);
      finite = finite && positions[k].allFinite();
    }
    if (!finite) {
      collector.leave_out();
      before = nullptr;
      continue;
    }
    for (int k = 0; k < 3; ++k)
      if (vertices[k] == no_index) vertices[k] = collector.vertex(positions[k]);
    if (!collector.add(vertices[0], vertices[1], vertices[2]))
      return facet_error(e_limit, facet, collector.limit_sentence(), remedy_reduce);
    before = corners;
    std::copy(vertices, vertices + 3, known);
  }
  if (unknown)
    collector.warn(
        make_warning(w_count_missing, "The header does not say how many triangles there are; all " +
                                          std::to_string(count) + " that the file holds were read."));
  if (end < bytes.size())
    collector.warn(make_warning(w_trailing_data, "The last " + std::to_string(bytes.size() - end) +
                                                     " bytes of the file were ignored."));
  collector.end_solid({});
  return collector.finish();
}

/// Reader of text, in which line ends are blanks like others except behind a name.
class StlTextReader {
 public:
  StlTextReader(std::string_view bytes, const ReadLimits& limits)
      : scanner_(bytes, {}),
        limits_(limits),
        size_(bytes.size()),
        collector_(bytes.size() / 200, limits) {}  // a facet rarely has fewer characters

  Result<ImportedScene> read();

 private:
  /// Next word, on this line or a later one.
  std::string_view next_word() { return scanner_.find_content() ? scanner_.token() : std::string_view{}; }
  std::optional<Message> expect(const char* word);
  std::optional<Message> wrong_word(std::string_view word, const char* expected) const;
  std::string_view read_name();
  void skip_name(std::string_view name);
  std::optional<Message> read_solid();
  std::optional<Message> read_facet();
  std::optional<Message> skip_normal();
  std::optional<Message> read_corner(Vector3& corner);

  TextScanner scanner_;
  const ReadLimits& limits_;
  std::size_t size_;
  TriangleCollector collector_;
  std::size_t facets_ = 0;
};

std::optional<Message> StlTextReader::wrong_word(std::string_view word, const char* expected) const {
  if (word.empty())
    return TextScanner::error_at_line(e_truncated, scanner_.line(),
                                      "The file ends where " + quote(expected) + " should be.", remedy_cut);
  return scanner_.error_here(
      e_parse, "Here should be " + quote(expected) + ", but it is " + quote(word) + ".", remedy_correct);
}

std::optional<Message> StlTextReader::expect(const char* word) {
  const std::string_view found = next_word();
  if (equals_lower(found, word)) return {};
  return wrong_word(found, word);
}

/// Reads the words of a name: the rest of the line, up to "facet normal" or "endsolid" where they follow on
/// it.
std::string_view StlTextReader::read_name() {
  const char *begin = nullptr, *end = nullptr;
  for (;;) {
    const TextScanner before = scanner_;
    const std::string_view word = scanner_.token();
    if (word.empty()) break;
    TextScanner behind = scanner_;
    if ((equals_lower(word, "facet") && equals_lower(behind.token(), "normal")) ||
        equals_lower(word, "endsolid")) {
      scanner_ = before;
      break;
    }
    if (!begin) begin = word.data();
    end = word.data() + word.size();
  }
  return begin ? std::string_view(begin, static_cast<std::size_t>(end - begin)) : std::string_view();
}

/// Skips the name behind "endsolid", and whatever else stands on its line, up to the next solid on it.
void StlTextReader::skip_name(std::string_view name) {
  TextScanner words(name, {}), at = scanner_;
  for (std::string_view word = words.token(); !word.empty(); word = words.token())
    if (at.token() == word)
      scanner_ = at;
    else
      break;
  for (;;) {
    const TextScanner before = scanner_;
    const std::string_view word = scanner_.token();
    if (word.empty()) return;
    if (!equals_lower(word, "solid")) continue;
    TextScanner behind = scanner_;
    std::string_view next = behind.token();
    while (!next.empty() && !equals_lower(next, "facet") && !equals_lower(next, "endsolid"))
      next = behind.token();
    if (next.empty())
      scanner_.rest_of_line();
    else
      scanner_ = before;
    return;
  }
}

/// Skips the normal, up to and with the word "outer". It is ignored, as the corners determine it; degenerate
/// triangles often have one that is not a number.
std::optional<Message> StlTextReader::skip_normal() {
  for (int words = 0;; ++words) {
    std::string_view word = scanner_.token();
    const bool same_line = !word.empty();
    if (!same_line) word = next_word();
    if (equals_lower(word, "outer")) return {};
    if (word.empty() || (!same_line && words >= 3)) return wrong_word(word, "outer");
  }
}

/// Reads three coordinates, not necessarily finite; only numbers are looked for on further lines.
std::optional<Message> StlTextReader::read_corner(Vector3& corner) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view rest(scanner_.position(), scanner_.remaining());
    const std::size_t next = rest.find_first_not_of(" \t");
    if (next == std::string_view::npos || rest[next] < ' ') {  // the line ends here
      TextScanner ahead = scanner_;
      if (ahead.find_content() && ahead.token().find_first_of("0123456789") != std::string_view::npos)
        scanner_.find_content();
    }
    if (auto error = scanner_.read_any_real("coordinate", corner[axis])) return error;
  }
  return {};
}

/// Reads a facet after the word "facet".
std::optional<Message> StlTextReader::read_facet() {
  if (auto error = expect("normal")) return error;
  if (auto error = skip_normal()) return error;
  if (auto error = expect("loop")) return error;
  Vector3 corners[3];
  for (Vector3& corner : corners) {
    if (auto error = expect("vertex")) return error;
    if (auto error = read_corner(corner)) return error;
  }
  if (!collector_.add(corners))
    return scanner_.error_here(e_limit, collector_.limit_sentence(), remedy_reduce);
  for (const char* word : {"endloop", "endfacet"})
    if (auto error = expect(word)) return error;
  return {};
}

/// Reads a solid after the word "solid".
std::optional<Message> StlTextReader::read_solid() {
  std::string_view name = read_name();
  for (;;) {
    const std::string_view word = next_word();
    if (equals_lower(word, "endsolid")) break;
    if (word.empty() && facets_ > 0) {
      collector_.end_solid(sanitized_utf8(name, 200));
      collector_.warn(make_warning(w_end_missing,
                                   "The file ends without \"endsolid\": it may have been cut off.",
                                   "Compare the object with that in the program that wrote the file."));
      return {};
    }
    if (equals_lower(word, "solid")) {  // the solid before has no end
      collector_.end_solid(sanitized_utf8(name, 200));
      name = read_name();
      continue;
    }
    if (!equals_lower(word, "facet")) return wrong_word(word, "facet");
    if (auto error = limits_.row(scanner_.remaining(), size_)) return error;
    if (auto error = read_facet()) return error;
    ++facets_;
  }
  collector_.end_solid(sanitized_utf8(name, 200));
  skip_name(name);
  return {};
}

Result<ImportedScene> StlTextReader::read() {
  do {
    if (auto error = expect("solid")) return *error;
    if (auto error = read_solid()) return *error;
  } while (scanner_.find_content());
  return collector_.finish();
}

}  // namespace

Result<ImportedScene> read_stl_scene(std::string_view bytes, const ReadLimits& limits) {
  if (is_text(bytes)) return StlTextReader(bytes, limits).read();
  return read_binary(bytes, limits);
}

Result<ImportedMesh> read_stl(std::string_view bytes, const ReadLimits& limits) {
  auto scene = read_stl_scene(bytes, limits);
  return scene ? Result<ImportedMesh>(merged(std::move(scene).value())) : scene.error();
}

bool looks_like_stl(std::string_view bytes) {
  return is_text(bytes) || (bytes.size() >= header_size + 4 && promised_size(bytes) == bytes.size());
}

}  // namespace hariko
