#include "core/envelope/network/curve_network.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/geometry/mirror_plane.hpp"

namespace hariko {

namespace {

constexpr double least_cosine = 0.25;  ///< tangents at a larger angle from the chord do not become longer
/// Range of weights of curves. Below the lower one a patch bulges to a point; the natural weight of the
/// largest turn for which tangents become longer is exactly 0.5.
constexpr double weight_low = 0.501, weight_high = 5;

constexpr double waist = 0.5;  ///< length of tangents on inserted parts, relative to those of circular arcs

/// Ends of a curve, by which curves are sorted.
std::pair<Index, Index> curve_ends(const NetworkCurve& curve) {
  return {curve.low, curve.high};
}

/// Primitive edge in the solid's unit frame, where it is planar, with its natural weights (docs/envelope.md).
struct PrimitiveEdge {
  /// Per end: inner control point, length of the tangent, natural weight, depth of the other end's control
  /// point below the tangent plane.
  std::array<Vector3, 2> control;
  std::array<double, 2> alpha, natural, sag;

  PrimitiveEdge(const Vector3& from, const Vector3& to, double roundness) {
    const Vector3 e = to - from;
    const double length = e.norm();
    const std::array<Vector3, 2> unit{from, to};
    std::array<Vector3, 2> n;
    for (std::size_t i = 0; i < 2; ++i) {
      n[i] = unit[i].stableNormalized();
      const Vector3 t = (e - e.dot(n[i]) * n[i]).stableNormalized();
      const double cosine = t.dot(e) / length;
      alpha[i] = roundness * length / (1 + 2 * std::max(cosine, least_cosine));
      natural[i] = std::max((1 + 2 * cosine) / 3, weight_low);
      control[i] = i == 0 ? Vector3(from + alpha[i] * t) : Vector3(to - alpha[i] * t);
    }
    for (std::size_t i = 0; i < 2; ++i) sag[i] = -(control[1 - i] - unit[i]).dot(n[i]);
  }
  bool is_straight() const { return std::min(sag[0], sag[1]) <= 1e-9; }
  double natural_curvature(std::size_t i) const {
    return 2.0 / 3 * natural[1 - i] / (natural[i] * natural[i]) * sag[i] / (alpha[i] * alpha[i]);
  }
};

class NetworkBuilder {
 public:
  NetworkBuilder(NetworkCage cage, std::span<const NetworkSolid> solids) : solids_(solids) {
    out_.cage = std::move(cage);
    for (const NetworkSolid& solid : solids) out_.owners.push_back(solid.owner);
  }

  CurveNetwork build() {
    list_curves();
    make_curves();
    make_patches();
    return std::move(out_);
  }

 private:
  const CageVertex& vertex(Index v) const { return out_.cage.vertices[v]; }
  const NetworkSolid& solid(Index v) const { return solids_[vertex(v).solid]; }

  void list_curves() {
    for (const CageFace& face : out_.cage.faces)
      for (std::size_t i = 0; i < face.loop.size(); ++i) {
        const Index a = face.loop[i], b = face.loop[(i + 1) % face.loop.size()];
        if (a < b) out_.curves.push_back({a, b, vertex(a).solid == vertex(b).solid, false, {}});
      }
    std::ranges::sort(out_.curves, {}, curve_ends);
  }

  void make_curves() {
    // Common curvature of the primitive edges at a vertex: the mean of their own curvatures.
    std::vector<double> sum(out_.cage.vertices.size(), 0), count(sum.size(), 0);
    std::vector<std::optional<PrimitiveEdge>> edges(out_.curves.size());
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const NetworkCurve& curve = out_.curves[k];
      if (!curve.primitive || vertex(curve.low).guarded || vertex(curve.high).guarded) continue;
      edges[k].emplace(vertex(curve.low).unit, vertex(curve.high).unit, solid(curve.low).roundness);
      if (edges[k]->is_straight()) continue;
      sum[curve.low] += edges[k]->natural_curvature(0);
      sum[curve.high] += edges[k]->natural_curvature(1);
      ++count[curve.low];
      ++count[curve.high];
    }
    for (std::size_t k = 0; k < edges.size(); ++k) {
      NetworkCurve& curve = out_.curves[k];
      if (edges[k]) {
        make_primitive(curve, *edges[k], sum[curve.low] / std::max(1.0, count[curve.low]),
                       sum[curve.high] / std::max(1.0, count[curve.high]));
      } else {
        make_inserted(curve);
      }
    }
    for (NetworkCurve& curve : out_.curves) {
      const HomogeneousCubic& c = curve.ribbon.curve;
      const Vector3 p0 = cartesian(c[0]), p1 = cartesian(c[1]), p2 = cartesian(c[2]), p3 = cartesian(c[3]);
      curve.ribbon.across = {vertex(curve.low).normal.cross(p1 - p0).stableNormalized(),
                             vertex(curve.high).normal.cross(p3 - p2).stableNormalized()};
    }
  }

  /// `low`, `high`: common curvatures at the ends.
  void make_primitive(NetworkCurve& curve, const PrimitiveEdge& edge, double low, double high) {
    double w1 = edge.natural[0], w2 = edge.natural[1];
    if (!edge.is_straight()) {
      const double k0 = 1.5 * low * edge.alpha[0] * edge.alpha[0] / edge.sag[0];
      const double k1 = 1.5 * high * edge.alpha[1] * edge.alpha[1] / edge.sag[1];
      const double a = 1 / std::cbrt(k0 * k0 * k1), b = 1 / std::cbrt(k1 * k1 * k0);
      if (a > weight_low && a < weight_high && b > weight_low && b < weight_high)
        w1 = a, w2 = b, curve.matched = true;
    }
    const NetworkSolid& owner = solid(curve.low);
    curve.ribbon.curve = {
        homogeneous(vertex(curve.low).position), homogeneous(owner.world(edge.control[0]), w1),
        homogeneous(owner.world(edge.control[1]), w2), homogeneous(vertex(curve.high).position)};
  }

  void make_inserted(NetworkCurve& curve) {
    const CageVertex &a = vertex(curve.low), &b = vertex(curve.high);
    const Vector3 e = b.position - a.position;
    const double length = e.norm(), f = curve.primitive ? solid(curve.low).roundness : waist;
    const Vector3 ta = a.tangent(e), tb = b.tangent(e);
    const double ca = std::max(ta.dot(e) / length, least_cosine),
                 cb = std::max(tb.dot(e) / length, least_cosine);
    const double w = std::max((1 + ca + cb) / 3, weight_low);
    const double from = f * length / (1 + 2 * ca), to = f * length / (1 + 2 * cb);
    curve.ribbon.curve = {homogeneous(a.position), homogeneous(a.position + from * ta, w),
                          homogeneous(b.position - to * tb, w), homogeneous(b.position)};
  }

  void make_patches() {
    out_.splits.resize(out_.cage.faces.size());
    std::vector<RibbonCurve> loop;
    for (Index f = 0; f < out_.cage.faces.size(); ++f) {
      const CageFace& face = out_.cage.faces[f];
      loop.clear();
      for (std::size_t i = 0; i < face.loop.size(); ++i)
        loop.push_back(out_.ribbon(face.loop[i], face.loop[(i + 1) % face.loop.size()]));
      if (loop.size() == 4) {
        out_.patches.push_back(EnvelopePatch::from_loop({loop[0], loop[1], loop[2], loop[3]}));
        out_.patch_places.push_back({f, 0});
        continue;
      }
      out_.splits[f] = split_face(loop, face.solid == no_index ? nullptr : &solids_[face.solid]);
      const auto sides = split_loops(loop, *out_.splits[f]);
      for (Index k = 0; k < sides.size(); ++k) {
        out_.patches.push_back(EnvelopePatch::from_loop(sides[k]));
        out_.patch_places.push_back({f, k});
      }
    }
  }

  std::span<const NetworkSolid> solids_;
  CurveNetwork out_;
};

}  // namespace

Index CurveNetwork::find(Index a, Index b) const {
  const std::pair<Index, Index> key = std::minmax(a, b);
  const auto found = std::ranges::lower_bound(curves, key, {}, curve_ends);
  return found != curves.end() && curve_ends(*found) == key ? Index(found - curves.begin()) : no_index;
}

RibbonCurve CurveNetwork::ribbon(Index a, Index b) const {
  const NetworkCurve& curve = curves[find(a, b)];
  return a < b ? curve.ribbon : curve.ribbon.reversed();
}

CurveNetwork curve_network(NetworkCage cage, std::span<const NetworkSolid> solids) {
  return NetworkBuilder(std::move(cage), solids).build();
}

bool is_symmetric(const CurveNetwork& network, Eigen::Index axis, double tolerance) {
  const MirrorPlane plane{static_cast<int>(axis), 0};
  const auto are_images = [&](const Vector3& a, const Vector3& b) {
    return (a - plane.image(b)).norm() <= tolerance;
  };
  const std::vector<CageVertex>& vertices = network.cage.vertices;
  std::vector<Index> image;
  for (const CageVertex& vertex : vertices) {
    const auto found = std::ranges::find_if(
        vertices, [&](const CageVertex& other) { return are_images(vertex.position, other.position); });
    if (found == vertices.end()) return false;
    image.push_back(Index(found - vertices.begin()));
  }
  const auto curve_has_image = [&](const NetworkCurve& curve) {
    const Index other = network.find(image[curve.low], image[curve.high]);
    return other != no_index && are_images(curve.ribbon.middle(), network.curves[other].ribbon.middle());
  };
  const auto star_has_image = [&](const std::optional<FaceSplit>& star) {
    return !star || std::ranges::any_of(network.splits, [&](const std::optional<FaceSplit>& other) {
      return other && are_images(star->centre, other->centre);
    });
  };
  return std::ranges::all_of(network.curves, curve_has_image) &&
         std::ranges::all_of(network.splits, star_has_image);
}

}  // namespace hariko
