#include "core/unfolding/cut_large_faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "core/geometry/polygon.hpp"
#include "core/unfolding/cuts/best_rotation.hpp"
#include "core/unfolding/face_triangles.hpp"
#include "core/unfolding/facet_graph.hpp"
#include "core/unfolding/pages/piece_extent.hpp"

namespace hariko {

namespace {

constexpr int most_halvings = 64;  ///< far more than `most_pages` allows

using Corners = std::vector<Index>;
using Side = std::pair<Index, Index>;

/// Room for a face: that for growing pieces (unfolding.cpp) less a margin for rounding.
PaperSize room_of_faces(const PaperSettings& settings) {
  return {settings.piece_room().width - 0.3, settings.piece_room().height - 0.3};
}

/// Face in the plane, in one of the rotations in which pieces are tried.
struct TurnedFace {
  Vector2 x, y;  ///< axes of the page
  Vector2 low, size;
};

std::vector<Vector2> flat_corners(const std::vector<Vector3>& corners) {
  const Vector3 normal = newell_normal(corners).normalized();
  const Vector3 x = (corners[1] - corners[0]).normalized(), y = normal.cross(x);
  std::vector<Vector2> out;
  for (const Vector3& p : corners) out.emplace_back(x.dot(p - corners[0]), y.dot(p - corners[0]));
  return out;
}

TurnedFace turned(const std::vector<Vector2>& corners, std::size_t direction) {
  const double angle = std::numbers::pi * double(direction) / double(PieceExtent::directions);
  TurnedFace out{{std::cos(angle), std::sin(angle)}, {-std::sin(angle), std::cos(angle)}, {}, {}};
  out.low = Vector2::Constant(1e300);
  Vector2 high = -out.low;
  for (const Vector2& p : corners) {
    const Vector2 at(out.x.dot(p), out.y.dot(p));
    out.low = out.low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  out.size = high - out.low;
  return out;
}

/// Number of pages that a face takes across and up in a rotation.
std::array<double, 2> pages_of(const TurnedFace& face, const PaperSize& room) {
  return {std::max(1.0, std::ceil(face.size.x() / room.width)),
          std::max(1.0, std::ceil(face.size.y() / room.height))};
}

/// Rotation with the fewest pages and, among these, with the least excess.
TurnedFace best_direction(const std::vector<Vector2>& corners, const PaperSize& room) {
  std::optional<TurnedFace> best;
  std::array<double, 2> least{};
  for (std::size_t k = 0; k < PieceExtent::directions; ++k) {
    const TurnedFace next = turned(corners, k);
    const auto [across, up] = pages_of(next, room);
    const std::array score{across * up, next.size.x() * next.size.y()};
    if (!best || score < least) best = next, least = score;
  }
  return *best;
}

class FaceCutter {
 public:
  FaceCutter(const PolygonMesh& mesh, const PaperSize& room) : positions_(mesh.positions), room_(room) {
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      faces_.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
      origin_.push_back(f);
      own_sides(f);
    }
  }

  CutFaces cut() {
    // Parts are appended and examined in their turn.
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (int halvings = 0; halvings < most_halvings && !fits(f); ++halvings) divide(f);
    CutFaces out;
    std::vector<Index> parts;
    for (const std::size_t face : origin_) {
      parts.resize(std::max(parts.size(), face + 1), 0);
      ++parts[face];
    }
    out.cut = std::size_t(std::count_if(parts.begin(), parts.end(), [](Index n) { return n > 1; }));
    out.mesh.positions = std::move(positions_);
    for (const Corners& face : faces_) out.mesh.add_face(face);
    return out;
  }

 private:
  std::vector<Vector3> places(std::size_t f) const {
    std::vector<Vector3> out;
    for (const Index v : faces_[f]) out.push_back(positions_[v]);
    return out;
  }
  void own_sides(std::size_t f) {
    for (std::size_t k = 0; k < faces_[f].size(); ++k)
      owner_[{faces_[f][k], faces_[f][(k + 1) % faces_[f].size()]}] = f;
  }
  bool fits(std::size_t f) const {
    const std::vector<Vector2> flat = flat_corners(places(f));
    const auto [across, up] = pages_of(best_direction(flat, room_), room_);
    return across * up == 1 || best_turn(flat, room_).factor >= 1;
  }

  /// Divides a face in two by a line or, where it is not convex and flat, into triangles.
  void divide(std::size_t f) {
    const std::vector<Vector3> corners = places(f);
    if (corners.size() > 3 && !(convex(corners) && level(corners))) return into_triangles(f, corners);
    const std::vector<Vector2> flat = flat_corners(corners);
    const TurnedFace at = best_direction(flat, room_);
    const auto [across, up] = pages_of(at, room_);
    const bool upright = across >= up;  // direction of the line, which cuts off whole pages
    const double count = upright ? across : up;
    const Vector2& axis = upright ? at.x : at.y;
    const double line = (upright ? at.low.x() : at.low.y()) +
                        (upright ? at.size.x() : at.size.y()) * std::floor(count / 2) / count;
    std::vector<double> height;
    for (const Vector2& p : flat) height.push_back(axis.dot(p) - line);
    cut_along(f, std::move(height), 1e-9 * std::max(at.size.x(), at.size.y()));
  }

  static bool convex(const std::vector<Vector3>& corners) {
    return classify_face(corners) == FaceShape::convex;
  }
  static bool level(const std::vector<Vector3>& corners) {
    const Vector3 normal = newell_normal(corners).normalized();
    double low = 0, high = 0, size = 0;
    for (const Vector3& p : corners) {
      low = std::min(low, normal.dot(p - corners[0]));
      high = std::max(high, normal.dot(p - corners[0]));
      size = std::max(size, (p - corners[0]).norm());
    }
    return high - low <= 0.25 * flat_face_angle * size;
  }

  void into_triangles(std::size_t f, const std::vector<Vector3>& corners) {
    const Corners face = faces_[f];
    bool first = true;
    for (const auto& [i, j, k] : face_triangles(corners)) {
      replace_or_add(first, f, {face[i], face[j], face[k]});
      first = false;
    }
  }
  void replace_or_add(bool replace, std::size_t f, Corners corners) {
    if (replace) {
      faces_[f] = std::move(corners);
      return own_sides(f);
    }
    faces_.push_back(std::move(corners));
    origin_.push_back(origin_[f]);
    own_sides(faces_.size() - 1);
  }

  /// Cuts a face along a line, given the signed distance `height` of each corner; corners nearer than
  /// `touching` lie on it.
  void cut_along(std::size_t f, std::vector<double> height, double touching) {
    for (double& h : height)
      if (std::abs(h) <= touching) h = 0;
    Corners face = faces_[f];
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::size_t next = (k + 1) % face.size();
      if (!(height[k] * height[next] < 0)) continue;
      const Index v = split_side(face[k], face[next], height[k] / (height[k] - height[next]));
      face.insert(face.begin() + std::ptrdiff_t(k) + 1, v);
      height.insert(height.begin() + std::ptrdiff_t(k) + 1, 0.0);
      ++k;
    }
    Corners below, above;
    for (std::size_t k = 0; k < face.size(); ++k) {
      if (height[k] <= 0) below.push_back(face[k]);
      if (height[k] >= 0) above.push_back(face[k]);
    }
    HARIKO_ASSERT(below.size() > 2 && above.size() > 2, "the line runs through the face");
    replace_or_add(true, f, std::move(below));
    replace_or_add(false, f, std::move(above));
  }

  /// Inserts a vertex on a side, also in the face beyond it.
  Index split_side(Index a, Index b, double t) {
    // Interpolates from the lower vertex, so that both sides of a cut agree.
    const Vector3 at = a < b ? Vector3(positions_[a] + t * (positions_[b] - positions_[a]))
                             : Vector3(positions_[b] + (1 - t) * (positions_[a] - positions_[b]));
    const auto v = static_cast<Index>(positions_.size());
    positions_.push_back(at);
    if (const auto beyond = owner_.find({b, a}); beyond != owner_.end()) {
      const std::size_t other = beyond->second;
      Corners& corners = faces_[other];
      const auto found = std::find(corners.begin(), corners.end(), b);
      corners.insert(found + 1, v);
      owner_.erase(beyond);
      owner_[{b, v}] = owner_[{v, a}] = other;
    }
    return v;
  }

  std::vector<Vector3> positions_;
  PaperSize room_;
  std::vector<Corners> faces_;
  std::vector<std::size_t> origin_;    ///< original face of each face
  std::map<Side, std::size_t> owner_;  ///< face with a side in this direction
};

double area_of_faces(const PolygonMesh& mesh) {
  double sum = 0;
  std::vector<Vector3> corners;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    corners.clear();
    for (const Index v : mesh.face(f)) corners.push_back(mesh.positions[v]);
    sum += 0.5 * newell_normal(corners).norm();
  }
  return sum;
}

double longest_side_of(const PolygonMesh& mesh) {
  double longest = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k)
      longest =
          std::max(longest, (mesh.positions[face[(k + 1) % face.size()]] - mesh.positions[face[k]]).norm());
  }
  return longest;
}

}  // namespace

Result<CutFaces> cut_large_faces(const PolygonMesh& mesh, const PaperSettings& settings) {
  if (const auto fine = check_settings(settings, longest_side_of(mesh)); !fine.ok()) return fine.error();
  const PaperSize room = settings.printable_area();
  const double pages = settings.scale * settings.scale * area_of_faces(mesh) / (room.width * room.height);
  if (pages > most_pages)
    return make_error(
        e_paper_setting,
        "The model would take more than " + std::to_string(std::int64_t(most_pages)) + " pages at this size.",
        "Choose a smaller height, width or depth of the model, or a larger page.");
  const PaperSize faces = room_of_faces(settings);
  return FaceCutter(mesh, {faces.width / settings.scale, faces.height / settings.scale}).cut();
}

Message cut_faces_message(std::size_t count) {
  const std::string facets = count == 1 ? "1 facet is" : std::to_string(count) + " facets are";
  return make_warning(w_facet_cut,
                      facets + " larger than the page and " + (count == 1 ? "is" : "are") +
                          " cut into parts that are glued together.",
                      "Choose a smaller size (--fit finds the largest without cuts), or a larger page.");
}

double largest_uncut_scale(const PolygonMesh& mesh, const PaperSettings& settings) {
  const PaperSize room = room_of_faces(settings);
  double scale = std::numeric_limits<double>::infinity();
  std::vector<Vector3> corners;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    corners.clear();
    for (const Index v : mesh.face(f)) corners.push_back(mesh.positions[v]);
    scale = std::min(scale, best_turn(flat_corners(corners), room).factor);
  }
  return scale;
}

}  // namespace hariko
