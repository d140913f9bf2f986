#include "core/exchange/triangles/read_stl.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

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

/// Collects triangles, for both forms.
class TriangleCollector {
 public:
  TriangleCollector(std::size_t expected_triangles, const ReadLimits& limits)
      : welder_(expected_triangles / 2), limits_(limits) {
    out_.mesh.face_offsets.reserve(expected_triangles + 1);
    out_.mesh.face_vertices.reserve(3 * expected_triangles);
  }
  Index vertex(const Vector3& position) { return welder_.add(position); }
  void expect(const Vector3& position) const { welder_.expect(position); }
  /// Adds a triangle; false where a limit is reached.
  bool add(Index a, Index b, Index c) {
    if (welder_.size() > limits_.vertices || out_.mesh.face_vertices.size() + 3 > limits_.corners)
      return false;
    if (a == b || b == c || c == a)
      ++degenerate_count_;
    else
      out_.mesh.add_face({a, b, c});
    return true;
  }
  bool add(const Vector3 (&corners)[3]) {
    const Index a = vertex(corners[0]), b = vertex(corners[1]), c = vertex(corners[2]);
    return add(a, b, c);
  }
  std::string limit_sentence() const {
    return "The file has more than " + std::to_string(limits_.vertices) + " vertices or " +
           std::to_string(limits_.corners) + " corners.";
  }
  Result<ImportedMesh> finish(std::string name) {
    if (out_.mesh.face_count() == 0)
      return make_error(e_empty,
                        degenerate_count_ == 0
                            ? "The file has no triangles."
                            : "All triangles of the file have two corners at the same place.",
                        "Export the model again.");
    if (degenerate_count_ > 0)
      out_.warnings.push_back(make_warning(
          w_degenerate_triangles,
          std::to_string(degenerate_count_) +
              (degenerate_count_ == 1 ? " triangle with two corners at the same place was left out."
                                      : " triangles with two corners at the same place were left out.")));
    out_.mesh.positions = welder_.take_positions();
    out_.name = std::move(name);
    return std::move(out_);
  }
  ImportedMesh& out() { return out_; }

 private:
  PointWelder welder_;
  const ReadLimits& limits_;
  ImportedMesh out_;
  std::size_t degenerate_count_ = 0;
};

Message facet_error(Code code, std::uint64_t facet, const std::string& sentence, const char* remedy) {
  return make_error(code,
                    "Triangle " + std::to_string(facet) + ", byte " +
                        std::to_string(header_size + 4 + facet * facet_size) + ": " + sentence,
                    remedy);
}

Result<ImportedMesh> read_binary(std::string_view bytes, const ReadLimits& limits) {
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
  if (end > bytes.size())
    return make_error(e_truncated,
                      "Byte " + std::to_string(bytes.size()) + ": The file ends after " +
                          std::to_string(there) + " of " + std::to_string(count) + " promised triangles.",
                      remedy_cut);
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
    for (int k = 0; k < 3; ++k) {
      vertices[k] = no_index;
      for (int j = 0; before && j < 3; ++j)
        if (std::memcmp(corners + corner_size * k, before + corner_size * j, corner_size) == 0)
          vertices[k] = known[j];
      if (vertices[k] != no_index) continue;
      const Vector3 position = point_at(corners + corner_size * k);
      if (!position.allFinite())
        return facet_error(e_parse, facet, "A coordinate is not finite.", remedy_correct);
      vertices[k] = collector.vertex(position);
    }
    if (!collector.add(vertices[0], vertices[1], vertices[2]))
      return facet_error(e_limit, facet, collector.limit_sentence(), remedy_reduce);
    before = corners;
    std::copy(vertices, vertices + 3, known);
  }
  if (unknown)
    collector.out().warnings.push_back(
        make_warning(w_count_missing, "The header does not say how many triangles there are; all " +
                                          std::to_string(count) + " that the file holds were read."));
  if (end < bytes.size())
    collector.out().warnings.push_back(
        make_warning(w_trailing_data,
                     "The last " + std::to_string(bytes.size() - end) + " bytes of the file were ignored."));
  return collector.finish({});
}

class StlTextReader {
 public:
  StlTextReader(std::string_view bytes, const ReadLimits& limits)
      : scanner_(bytes, {}),
        limits_(limits),
        size_(bytes.size()),
        collector_(bytes.size() / 200, limits) {}  // a facet rarely has fewer characters

  Result<ImportedMesh> read();

 private:
  /// Next word, on this line or a later one.
  std::string_view next_word() { return scanner_.find_content() ? scanner_.token() : std::string_view{}; }
  std::optional<Message> expect(const char* word);
  std::optional<Message> wrong_word(std::string_view word, const char* expected) const;
  std::optional<Message> read_solid();
  std::optional<Message> read_facet();

  TextScanner scanner_;
  const ReadLimits& limits_;
  std::size_t size_;
  TriangleCollector collector_;
  std::size_t facets_ = 0;
  std::string name_;
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

/// Reads a facet after the word "facet".
std::optional<Message> StlTextReader::read_facet() {
  // The normal is ignored, as the corners determine it; degenerate triangles often have one that is not a
  // number.
  if (auto error = expect("normal")) return error;
  scanner_.next_line();
  for (const char* word : {"outer", "loop"})
    if (auto error = expect(word)) return error;
  Vector3 corners[3];
  for (Vector3& corner : corners) {
    if (auto error = expect("vertex")) return error;
    if (auto error = scanner_.read_point("coordinate", corner)) return error;
  }
  if (!collector_.add(corners))
    return scanner_.error_here(e_limit, collector_.limit_sentence(), remedy_reduce);
  for (const char* word : {"endloop", "endfacet"})
    if (auto error = expect(word)) return error;
  return {};
}

/// Reads a solid after the word "solid".
std::optional<Message> StlTextReader::read_solid() {
  const std::string_view name = scanner_.rest_of_line();
  if (name_.empty()) name_ = sanitized_utf8(name, 200);
  for (;;) {
    const std::string_view word = next_word();
    if (equals_lower(word, "endsolid")) break;
    if (word.empty() && facets_ > 0) {
      collector_.out().warnings.push_back(
          make_warning(w_end_missing, "The file ends without \"endsolid\": it may have been cut off.",
                       "Compare the object with that in the program that wrote the file."));
      return {};
    }
    if (equals_lower(word, "solid")) {  // the solid before has no end
      scanner_.next_line();
      continue;
    }
    if (!equals_lower(word, "facet")) return wrong_word(word, "facet");
    if (auto error = limits_.row(scanner_.remaining(), size_)) return error;
    if (auto error = read_facet()) return error;
    ++facets_;
  }
  scanner_.next_line();  // the name may be repeated here
  return {};
}

Result<ImportedMesh> StlTextReader::read() {
  do {
    if (auto error = expect("solid")) return *error;
    if (auto error = read_solid()) return *error;
  } while (scanner_.find_content());
  return collector_.finish(name_);
}

}  // namespace

Result<ImportedMesh> read_stl(std::string_view bytes, const ReadLimits& limits) {
  if (is_text(bytes)) return StlTextReader(bytes, limits).read();
  return read_binary(bytes, limits);
}

bool looks_like_stl(std::string_view bytes) {
  return is_text(bytes) || (bytes.size() >= header_size + 4 && promised_size(bytes) == bytes.size());
}

}  // namespace hariko
