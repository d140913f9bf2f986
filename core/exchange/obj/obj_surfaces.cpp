#include "core/exchange/obj/obj_surfaces.hpp"

#include <algorithm>
#include <map>

#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/number_text.hpp"
#include "core/exchange/repair/remedies.hpp"

namespace hariko {

namespace {

constexpr std::size_t max_control_points = 20'000'000;

}  // namespace

bool ObjSurfaces::knows(std::string_view keyword) {
  return keyword == "cstype" || keyword == "deg" || keyword == "surf" || keyword == "parm" ||
         keyword == "end";
}

std::optional<Message> ObjSurfaces::read(std::string_view keyword, TextScanner& scanner, std::size_t vertices,
                                         const std::string& object) {
  if (keyword == "cstype") {
    std::string_view word = scanner.token();
    rational_ = word == "rat";
    if (rational_) word = scanner.token();
    bezier_ = word == "bezier";
    return {};
  }
  if (keyword == "deg") {
    degree_u_ = degree_v_ = 0;
    if (auto error = scanner.read_integer("degree", degree_u_)) return error;
    const std::string_view second = scanner.token();  // curves have one degree only
    if (!second.empty() && parse_integer(second, degree_v_) != NumberStatus::ok)
      return scanner.error_here(e_parse, "A degree is a whole number, but here is " + quote(second) + ".",
                                remedy_correct);
    return {};
  }
  if (keyword == "surf") {
    open_ = bezier_;
    if (bezier_) return read_surface(scanner, vertices, object);
    ++left_out_;
    return {};
  }
  if (keyword == "parm" && open_) {
    const std::string_view direction = scanner.token();
    std::size_t& knots = direction == "u" ? surfaces_.back().knots_u : surfaces_.back().knots_v;
    for (knots = 0; !scanner.token().empty();) ++knots;
  }
  if (keyword == "end") open_ = false;
  return {};
}

std::optional<Message> ObjSurfaces::read_surface(TextScanner& scanner, std::size_t vertices,
                                                 const std::string& object) {
  Surface out;
  out.object = object;
  out.line = scanner.line();
  out.rational = rational_;
  if (degree_u_ < 1 || degree_v_ < 1 || degree_u_ > max_bezier_degree || degree_v_ > max_bezier_degree)
    return scanner.error_here(
        e_patch_degree,
        "The degrees of the surface are not from 1 to " + std::to_string(max_bezier_degree) + ".",
        "Export surfaces of lower degree.");
  out.degree_u = static_cast<int>(degree_u_);
  out.degree_v = static_cast<int>(degree_v_);
  double ignored = 0;
  for (int k = 0; k < 4; ++k)  // ignores the parameter range: a patch is used as a whole
    if (auto error = scanner.read_real("parameter", ignored)) return error;
  for (std::string_view token = scanner.token(); !token.empty(); token = scanner.token()) {
    std::int64_t index = 0;
    if (parse_integer(token.substr(0, token.find('/')), index) != NumberStatus::ok || index == 0)
      return scanner.error_here(
          e_parse,
          "A control point of a surface is the number of a vertex, but here is " + quote(token) + ".",
          remedy_correct);
    if (++corners_ > max_control_points)
      return scanner.error_here(e_limit, "The surfaces have too many control points.", remedy_reduce);
    out.vertices.push_back(index < 0 ? static_cast<std::int64_t>(vertices) + index : index - 1);
  }
  surfaces_.push_back(std::move(out));
  return {};
}

Result<std::vector<NamedPatches>> ObjSurfaces::patches(const std::vector<Vector3>& positions,
                                                       const std::vector<double>& weights) const {
  std::vector<NamedPatches> out;
  std::map<std::string, std::size_t> numbers;
  std::size_t count = 0;
  for (const Surface& surface : surfaces_) {
    const auto wrong = [&](Code code, const std::string& sentence) {
      return TextScanner::error_at_line(code, surface.line, sentence, remedy_correct);
    };
    for (const std::int64_t v : surface.vertices)
      if (v < 0 || static_cast<std::uint64_t>(v) >= positions.size())
        return wrong(e_index_range, "The surface names vertex " + std::to_string(v + 1) +
                                        ", but the file has " + std::to_string(positions.size()) +
                                        " vertices.");
    // Bezier surfaces of several patches share the control points of common sides.
    const std::size_t du = std::size_t(surface.degree_u), dv = std::size_t(surface.degree_v);
    const std::size_t columns = std::max<std::size_t>(surface.knots_u, 2) - 1,
                      rows = std::max<std::size_t>(surface.knots_v, 2) - 1;
    const std::size_t width = columns * du + 1, height = rows * dv + 1;
    if (surface.vertices.size() / width != height || surface.vertices.size() % width != 0)
      return wrong(e_parse, "The surface has " + std::to_string(surface.vertices.size()) +
                                " control points, but its degrees and parameters need " +
                                std::to_string(width) + " times " + std::to_string(height) + ".");
    count += columns * rows;
    if (count > max_patches_of_file) return wrong(e_limit, "The file has too many patches.");
    const auto [at, added] = numbers.try_emplace(surface.object, out.size());
    if (added) out.push_back({surface.object, {}});
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t column = 0; column < columns; ++column) {
        BezierPatch patch{surface.degree_u, surface.degree_v, {}, {}};
        for (std::size_t j = 0; j <= dv; ++j)
          for (std::size_t i = 0; i <= du; ++i) {
            const auto v =
                static_cast<std::size_t>(surface.vertices[(row * dv + j) * width + column * du + i]);
            patch.points.push_back(positions[v]);
            if (surface.rational) patch.weights.push_back(v < weights.size() ? weights[v] : 1);
          }
        if (auto error = check_patch(patch, count - 1)) return *error;
        out[at->second].patches.push_back(std::move(patch));
      }
  }
  return out;
}

}  // namespace hariko
