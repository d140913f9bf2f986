#include "core/envelope/scene_symmetry.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/rotation.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

namespace {

constexpr double nearly = 1e-9;  ///< of the size: what counts as the same place

/// Changes a scene without images into one where every placed solid has one.
class Mirroring {
 public:
  Mirroring(EnvelopedScene& scene, Eigen::Index axis) : scene_(scene) {
    symmetry_.axis = axis;
    for (const PlacedSolid& solid : scene.placed)
      size_ = std::max(size_, solid.reach + solid.centre.cwiseAbs().maxCoeff());
    symmetry_.solid.assign(scene.placed.size(), no_index);
    symmetry_.vertex.resize(scene.placed.size());
  }

  SceneSymmetry run() {
    const Index authored = Index(scene_.input.solids.size());
    for (Index k = 0; k < authored; ++k)
      if (symmetry_.solid[parts_of(k)[0]] == no_index && !pair_up(k, authored)) add_image(k);
    return std::move(symmetry_);
  }

 private:
  std::vector<PlacedSolid>& placed() { return scene_.placed; }

  std::vector<Index> parts_of(Index authored) const {
    std::vector<Index> out;
    for (Index s = 0; s < scene_.placed.size(); ++s)
      if (scene_.placed[s].owner == authored) out.push_back(s);
    return out;
  }

  bool near(const Vector3& a, const Vector3& b) const { return (a - b).norm() <= nearly * size_; }

  /// Whether the image of a is b: the same set of points with the same roundness.
  bool is_image(const PlacedSolid& a, const PlacedSolid& b) const {
    using Shape = PlacedSolid::Shape;
    if (a.kind != b.kind || a.shape_ != b.shape_ || a.roundness != b.roundness ||
        !near(symmetry_.reflected(a.centre), b.centre))
      return false;
    if (a.shape_ == Shape::half_spaces) return images(a, b).has_value();
    if (std::abs(a.tube_ - b.tube_) > nearly) return false;
    // A body that is round in its unit frame is known by A A^T, and by its axis if it has one.
    const auto reflect = [&](Matrix3 m) {
      m.row(symmetry_.axis) *= -1;
      return m;
    };
    const Matrix3 image = reflect(a.to_world);
    const Matrix3 square = image * image.transpose(), other = b.to_world * b.to_world.transpose();
    if ((square - other).norm() > nearly * other.norm()) return false;
    if (a.shape_ == Shape::ball) return true;
    const Vector3 axis = image.col(2), wanted = b.to_world.col(2);
    return near(axis, wanted) || (a.shape_ != Shape::cone && near(-axis, wanted));
  }

  /// Numbers of b's vertices that are the images of a's; nothing where one has none.
  std::optional<std::vector<Index>> images(const PlacedSolid& a, const PlacedSolid& b) const {
    if (a.unit_vertices.size() != b.unit_vertices.size()) return std::nullopt;
    std::vector<Index> out;
    for (const Vector3& u : a.unit_vertices) {
      const Vector3 wanted = symmetry_.reflected(a.world(u));
      const auto found = std::find_if(b.unit_vertices.begin(), b.unit_vertices.end(),
                                      [&](const Vector3& w) { return near(b.world(w), wanted); });
      if (found == b.unit_vertices.end()) return std::nullopt;
      out.push_back(Index(found - b.unit_vertices.begin()));
    }
    return out;
  }

  /// Turns the vertices of a round body that is its own image so that they are, too.
  void turn(PlacedSolid& solid) const {
    // In the unit frame the body is reflected across this direction.
    Vector3 m = (solid.to_world.transpose() * Vector3::Unit(symmetry_.axis)).stableNormalized();
    if (m.x() < 0) m = -m;
    // All vertices of balls and rings are symmetric in x.
    const Eigen::Quaterniond q = least_rotation(Vector3::UnitX(), m);
    for (Vector3& u : solid.unit_vertices) u = q * u;
  }

  void match(Index a, Index b, std::vector<Index> vertices) {
    symmetry_.solid[a] = b;
    symmetry_.vertex[a] = std::move(vertices);
  }

  /// Finds the image of an authored solid among the authored ones, itself first.
  bool pair_up(Index k, Index authored) {
    const std::vector<Index> own = parts_of(k);
    for (Index j = k; j < authored; ++j) {
      std::vector<Index> others = parts_of(j);
      if (others.size() != own.size() || symmetry_.solid[others[0]] != no_index) continue;
      do {
        if (fits(own, others)) return take(own, others);
      } while (std::next_permutation(others.begin(), others.end()));
    }
    return false;
  }

  bool fits(const std::vector<Index>& own, const std::vector<Index>& others) const {
    for (std::size_t i = 0; i < own.size(); ++i)
      if (!is_image(scene_.placed[own[i]], scene_.placed[others[i]])) return false;
    return true;
  }

  bool take(const std::vector<Index>& own, const std::vector<Index>& others) {
    for (std::size_t i = 0; i < own.size(); ++i) {
      PlacedSolid &a = placed()[own[i]], &b = placed()[others[i]];
      if (own[i] == others[i]) {
        if (!images(a, a)) turn(a);
        auto vertices = images(a, a);
        if (!vertices) return false;  // only where the body is symmetric within the tolerance alone
        match(own[i], own[i], *std::move(vertices));
      } else if (symmetry_.solid[own[i]] == no_index) {
        become_image(a, b);
        match_both(own[i], others[i]);
      }
    }
    return true;
  }

  /// The geometry of `image` becomes that of the other solid, reflected: the vertices have equal numbers.
  void become_image(const PlacedSolid& of, PlacedSolid& image) const {
    PlacedSolid next = of;
    next.owner = image.owner;
    next.id = image.id;
    next.part = image.part;
    next.centre = symmetry_.reflected(of.centre);
    next.to_world.row(symmetry_.axis) *= -1;
    next.to_unit.col(symmetry_.axis) *= -1;
    next.rotation.row(symmetry_.axis) *= -1;
    next.body[symmetry_.axis] *= -1;
    for (Vector3& p : next.test_points) p = symmetry_.reflected(p);
    image = std::move(next);
  }

  void match_both(Index a, Index b) {
    std::vector<Index> same(placed()[a].unit_vertices.size());
    for (Index v = 0; v < same.size(); ++v) same[v] = v;
    match(b, a, same);
    match(a, b, std::move(same));
  }

  void add_image(Index k) {
    const Index owner = Index(scene_.input.solids.size());
    scene_.input.solids.push_back(reflected(scene_.input.solids[k], symmetry_.axis));
    scene_.image_of.push_back(k);
    for (const Index s : parts_of(k)) {
      PlacedSolid image;
      image.owner = owner;
      image.id = placed()[s].id;
      image.part = placed()[s].part + image_part;
      become_image(placed()[s], image);
      placed().push_back(std::move(image));
      symmetry_.solid.push_back(no_index);
      symmetry_.vertex.emplace_back();
      match_both(s, Index(placed().size() - 1));
    }
  }

  EnvelopedScene& scene_;
  SceneSymmetry symmetry_;
  double size_ = 0;
};

}  // namespace

Solid reflected(const Solid& solid, Eigen::Index axis) {
  // All kinds are symmetric in their own y: M R M_y is a rotation, of these angles.
  Solid out = solid;
  out.position[axis] = -out.position[axis];
  const Vector3& r = solid.rotation;
  out.rotation = axis == 0   ? Vector3(-r.x(), r.y(), 180 - r.z())
                 : axis == 1 ? Vector3(-r.x(), r.y(), -r.z())
                             : Vector3(180 - r.x(), -r.y(), r.z());
  for (Vector3& p : out.points) p.y() = -p.y();
  return out;
}

EnvelopedScene enveloped_scene(const EnvelopeInput& input) {
  EnvelopedScene out;
  out.input = input;
  out.placed = place_solids(input);
  for (Index k = 0; k < input.solids.size(); ++k) out.image_of.push_back(k);
  const SymmetryPlane plane = input.settings.symmetry;
  if (plane != SymmetryPlane::none) out.symmetry = Mirroring(out, static_cast<Eigen::Index>(plane) - 1).run();
  std::vector<Vector3> corners;
  for (const PlacedSolid& solid : out.placed)
    for (const Vector3& u : solid.unit_vertices) corners.push_back(solid.world(u));
  out.origin = origin_for(corners);
  if (out.symmetry) out.origin[out.symmetry->axis] = 0;
  for (PlacedSolid& solid : out.placed) {
    solid.centre -= out.origin;
    for (Vector3& p : solid.test_points) p -= out.origin;
  }
  return out;
}

std::vector<Solid> images_of(const EnvelopeInput& input) {
  if (input.settings.symmetry == SymmetryPlane::none) return {};
  std::vector<Solid> all = enveloped_scene(input).input.solids;
  all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(input.solids.size()));
  return all;
}

}  // namespace hariko
