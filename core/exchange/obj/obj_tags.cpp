#include "core/exchange/obj/obj_tags.hpp"

#include <algorithm>
#include <array>

#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/number_text.hpp"
#include "core/exchange/obj/read_obj.hpp"
#include "core/subdivision/control_mesh.hpp"

namespace hariko {

namespace {

/// Parses "2/1/0": the numbers of integers, of reals and of words that follow.
bool read_counts(std::string_view token, std::array<std::int64_t, 3>& counts) {
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const std::size_t slash = token.find('/');
    if ((slash == std::string_view::npos) != (k + 1 == counts.size())) return false;
    if (parse_integer(token.substr(0, slash), counts[k]) != NumberStatus::ok || counts[k] < 0) return false;
    token.remove_prefix(slash == std::string_view::npos ? token.size() : slash + 1);
  }
  return true;
}

}  // namespace

bool ObjTags::read_numbers(TextScanner& scanner, std::vector<std::int64_t>& vertices,
                           std::vector<double>& sharpness) const {
  std::array<std::int64_t, 3> counts{};
  if (!read_counts(scanner.token(), counts)) return false;
  for (std::int64_t k = 0; k < counts[0]; ++k) {
    vertices.push_back(0);
    if (parse_integer(scanner.token(), vertices.back()) != NumberStatus::ok) return false;
    if (vertices.back() < 0 || vertices.back() >= std::int64_t{no_index}) return false;
  }
  for (std::int64_t k = 0; k < counts[1]; ++k) {
    sharpness.push_back(0);
    if (parse_real(scanner.token(), sharpness.back()) != NumberStatus::ok) return false;
  }
  return !vertices.empty() && !sharpness.empty();
}

void ObjTags::read(TextScanner& scanner) {
  const std::string_view name = scanner.token();
  if (std::array<std::int64_t, 3> counts{}; name == "hole") {  // numbers of faces
    if (!read_counts(scanner.token(), counts)) ++unread_;
    for (; counts[0] > 0 && !scanner.token().empty(); --counts[0]) ++holes_;
  }
  if (name != "crease" && name != "corner") return;  // other tags: boundary and texture rules
  std::vector<std::int64_t> vertices;
  std::vector<double> sharpness;
  const bool edges = name == "crease";
  if (!read_numbers(scanner, vertices, sharpness) || (edges && vertices.size() < 2)) {
    ++unread_;
    return;
  }
  // One sharpness for all vertices, or one for each.
  const std::size_t count = edges ? vertices.size() - 1 : vertices.size();
  for (std::size_t k = 0; k < count; ++k) {
    const double sharp = sharpness[std::min(k, sharpness.size() - 1)];
    if (!(sharp > 0)) continue;
    if (sharp < infinitely_sharp) ++soft_;
    if (edges)
      creases_.push_back({static_cast<Index>(vertices[k]), static_cast<Index>(vertices[k + 1])});
    else
      corners_.push_back(static_cast<Index>(vertices[k]));
  }
}

std::vector<std::array<Index, 2>> ObjTags::creases(std::size_t vertices) const {
  std::vector<std::array<Index, 2>> out;
  for (const auto& [a, b] : creases_)
    if (a < vertices && b < vertices && a != b) out.push_back({std::min(a, b), std::max(a, b)});
  return out;
}

std::vector<Index> ObjTags::corners(std::size_t vertices) const {
  std::vector<Index> out;
  for (const Index v : corners_)
    if (v < vertices) out.push_back(v);
  return out;
}

void ObjTags::warn(std::size_t vertices, std::vector<Message>& warnings) const {
  const std::size_t strange =
      unread_ + creases_.size() - creases(vertices).size() + corners_.size() - corners(vertices).size();
  if (strange > 0)
    warnings.push_back(make_warning(w_unknown_statement,
                                    std::to_string(strange) +
                                        " tags of creases or corners cannot be read or name vertices that "
                                        "are not there; they were ignored."));
  if (holes_ > 0)
    warnings.push_back(make_warning(
        w_left_out,
        holes_ == 1 ? std::string("A face that the file marks as a hole is closed here.")
                    : std::to_string(holes_) + " faces that the file marks as holes are closed here.",
        "Delete the faces where the surface should be open."));
  if (soft_ > 0)
    warnings.push_back(make_warning(
        w_soft_creases,
        std::to_string(soft_) + " creases or corners are only partly sharp in the file, and sharp here.",
        "Give their edges a tension instead where they should be soft."));
}

}  // namespace hariko
