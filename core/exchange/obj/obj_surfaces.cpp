#include "core/exchange/obj/obj_surfaces.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>

#include "core/exchange/imported_scene.hpp"
#include "core/exchange/number_text.hpp"
#include "core/exchange/repair/remedies.hpp"

namespace hariko {

namespace {

constexpr std::size_t max_control_points = 20'000'000;
constexpr const char* remedy_other_surfaces = "Export them as Bezier surfaces, as STEP, or as polygons.";
constexpr const char* remedy_trimmed = "Export the surfaces as STEP, or as polygons.";
constexpr std::array<std::string_view, 12> surface_statements{"cstype", "deg", "surf", "curv", "parm", "trim",
                                                              "hole",   "end", "bzp",  "bsp",  "cdp",  "cdc"};

/// Parts of the pieces between knots that lie in a parameter range, as fractions of each piece; nothing for a
/// piece that lies outside. All are kept whole where knots and range do not fit together.
std::vector<std::optional<std::array<double, 2>>> kept_pieces(const std::vector<double>& knots,
                                                              std::size_t count, double low, double high) {
  constexpr std::array<double, 2> whole{0, 1};
  constexpr double smallest = 1e-9;  // fraction of a piece
  std::vector<std::optional<std::array<double, 2>>> out(count, whole);
  const auto rises = [](double a, double b) { return a < b; };
  if (knots.size() < 2 || !(low < high) ||
      std::adjacent_find(knots.begin(), knots.end(), std::not_fn(rises)) != knots.end() ||
      !(std::min(high, knots.back()) - std::max(low, knots.front()) >
        2 * smallest * (knots.back() - knots.front())))
    return out;
  for (std::size_t piece = 0; piece < count; ++piece) {
    const double begin = knots[piece], length = knots[piece + 1] - begin;
    double from = std::clamp((low - begin) / length, 0.0, 1.0),
           to = std::clamp((high - begin) / length, 0.0, 1.0);
    if (from < smallest) from = 0;
    if (to > 1 - smallest) to = 1;
    out[piece].reset();
    if (to - from > smallest) out[piece] = std::array<double, 2>{from, to};
  }
  return out;
}

/// Cuts a Bezier curve to a part by de Casteljau's algorithm; `point(i)` is control point i of `degree` + 1.
template <class Point>
void cut_curve(int degree, const std::array<double, 2>& kept, const Point& point) {
  const auto [from, to] = kept;
  if (to < 1)
    for (int k = 1; k <= degree; ++k)
      for (int i = degree; i >= k; --i) point(i) = (1 - to) * point(i - 1) + to * point(i);
  if (from > 0)
    for (int k = 1; k <= degree; ++k)
      for (int i = 0; i <= degree - k; ++i) point(i) = (1 - from / to) * point(i) + from / to * point(i + 1);
}

/// Cuts a patch to the parts of both parameters, in homogeneous coordinates.
void cut_patch(BezierPatch& patch, const std::array<double, 2>& kept_u, const std::array<double, 2>& kept_v) {
  constexpr std::array<double, 2> whole{0, 1};
  if (kept_u == whole && kept_v == whole) return;
  std::vector<Eigen::Vector4d> points;
  for (std::size_t k = 0; k < patch.points.size(); ++k) {
    const double weight = patch.rational() ? patch.weights[k] : 1;
    points.emplace_back(weight * patch.points[k].x(), weight * patch.points[k].y(),
                        weight * patch.points[k].z(), weight);
  }
  const auto at = [&](int i, int j) -> Eigen::Vector4d& { return points[patch.index(i, j)]; };
  for (int j = 0; j <= patch.degree_t; ++j)
    cut_curve(patch.degree_s, kept_u, [&](int i) -> Eigen::Vector4d& { return at(i, j); });
  for (int i = 0; i <= patch.degree_s; ++i)
    cut_curve(patch.degree_t, kept_v, [&](int j) -> Eigen::Vector4d& { return at(i, j); });
  for (std::size_t k = 0; k < points.size(); ++k) {
    patch.points[k] = points[k].head<3>() / points[k][3];
    if (patch.rational()) patch.weights[k] = points[k][3];
  }
}

}  // namespace

bool ObjSurfaces::knows(std::string_view keyword) {
  return std::find(surface_statements.begin(), surface_statements.end(), keyword) != surface_statements.end();
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
  if (keyword == "bzp") {
    Surface out = surface_here(scanner, object);
    out.degree_u = out.degree_v = 3;
    out.rational = false;
    return read_points(scanner, vertices, std::move(out));
  }
  if (keyword == "bsp" || keyword == "cdp") ++left_out_;
  if (keyword == "curv" || keyword == "cdc") ++curves_;
  if (keyword == "parm" && open_) {
    const std::string_view direction = scanner.token();
    std::vector<double>& knots = direction == "u" ? surfaces_.back().knots_u : surfaces_.back().knots_v;
    knots.clear();
    for (std::string_view token = scanner.token(); !token.empty(); token = scanner.token()) {
      knots.push_back(std::numeric_limits<double>::quiet_NaN());
      static_cast<void>(parse_real(token, knots.back()));
    }
  }
  if ((keyword == "trim" || keyword == "hole") && open_) surfaces_.back().trimmed = true;
  if (keyword == "end" || keyword == "curv") open_ = false;
  return {};
}

ObjSurfaces::Surface ObjSurfaces::surface_here(const TextScanner& scanner, const std::string& object) const {
  Surface out;
  out.object = object;
  out.line = scanner.line();
  out.rational = rational_;
  return out;
}

std::optional<Message> ObjSurfaces::read_surface(TextScanner& scanner, std::size_t vertices,
                                                 const std::string& object) {
  Surface out = surface_here(scanner, object);
  if (degree_u_ < 1 || degree_v_ < 1 || degree_u_ > max_bezier_degree || degree_v_ > max_bezier_degree)
    return scanner.error_here(
        e_patch_degree,
        "The degrees of the surface are not from 1 to " + std::to_string(max_bezier_degree) + ".",
        "Export surfaces of lower degree.");
  out.degree_u = static_cast<int>(degree_u_);
  out.degree_v = static_cast<int>(degree_v_);
  for (double& end : out.range)
    if (auto error = scanner.read_real("parameter", end)) return error;
  return read_points(scanner, vertices, std::move(out));
}

std::optional<Message> ObjSurfaces::read_points(TextScanner& scanner, std::size_t vertices, Surface out) {
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

void ObjSurfaces::add_patches(const Surface& surface, const std::vector<Vector3>& positions,
                              const std::vector<double>& weights, std::vector<BezierPatch>& out) {
  const std::size_t du = std::size_t(surface.degree_u), dv = std::size_t(surface.degree_v);
  const std::size_t width = surface.columns() * du + 1;
  const auto columns = kept_pieces(surface.knots_u, surface.columns(), surface.range[0], surface.range[1]),
             rows = kept_pieces(surface.knots_v, surface.rows(), surface.range[2], surface.range[3]);
  for (std::size_t row = 0; row < surface.rows(); ++row)
    for (std::size_t column = 0; column < surface.columns(); ++column) {
      const auto &kept_u = columns[column], &kept_v = rows[row];
      if (!kept_u || !kept_v) continue;
      BezierPatch patch{surface.degree_u, surface.degree_v, {}, {}};
      for (std::size_t j = 0; j <= dv; ++j)
        for (std::size_t i = 0; i <= du; ++i) {
          const auto v = static_cast<std::size_t>(surface.vertices[(row * dv + j) * width + column * du + i]);
          patch.points.push_back(positions[v]);
          if (surface.rational) patch.weights.push_back(v < weights.size() ? weights[v] : 1);
        }
      out.push_back(std::move(patch));
      cut_patch(out.back(), *kept_u, *kept_v);
    }
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
    const std::size_t width = surface.columns() * std::size_t(surface.degree_u) + 1,
                      height = surface.rows() * std::size_t(surface.degree_v) + 1;
    if (surface.vertices.size() / width != height || surface.vertices.size() % width != 0)
      return wrong(e_parse, "The surface has " + std::to_string(surface.vertices.size()) +
                                " control points, but its degrees and parameters need " +
                                std::to_string(width) + " times " + std::to_string(height) + ".");
    count += surface.columns() * surface.rows();
    if (count > max_patches_of_file) return wrong(e_limit, "The file has too many patches.");
    const auto [at, added] = numbers.try_emplace(surface.object, out.size());
    if (added) out.push_back({surface.object, {}});
    std::vector<BezierPatch>& patches = out[at->second].patches;
    const std::size_t before = patches.size();
    add_patches(surface, positions, weights, patches);
    for (std::size_t k = before; k < patches.size(); ++k)
      if (auto error = check_patch(patches[k], count - 1)) return *error;
  }
  return out;
}

std::optional<Message> ObjSurfaces::left_out() const {
  if (left_out_ == 0) return {};
  return make_warning(
      w_left_out,
      left_out_ == 1
          ? std::string("A free-form surface that is no Bezier surface was left out.")
          : std::to_string(left_out_) + " free-form surfaces that are no Bezier surfaces were left out.",
      remedy_other_surfaces);
}

void ObjSurfaces::warn(std::vector<Message>& warnings) const {
  if (auto warning = left_out()) warnings.push_back(*std::move(warning));
  const auto trimmed = static_cast<std::size_t>(std::count_if(
      surfaces_.begin(), surfaces_.end(), [](const Surface& surface) { return surface.trimmed; }));
  if (trimmed > 0)
    warnings.push_back(make_warning(
        w_left_out,
        trimmed == 1 ? std::string("A surface is there as a whole: the curves that trim it were left out.")
                     : std::to_string(trimmed) +
                           " surfaces are there as a whole: the curves that trim them were left out.",
        remedy_trimmed));
  if (curves_ > 0)
    warnings.push_back(make_warning(
        w_left_out, curves_ == 1 ? std::string("A free-form curve was left out.")
                                 : std::to_string(curves_) + " free-form curves were left out."));
}

}  // namespace hariko
