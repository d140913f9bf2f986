#include "core/envelope/network/curve_network.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/envelope/network/split_face.hpp"
#include "core/geometry/mirror_plane.hpp"

namespace hariko {

namespace {

constexpr double least_cosine = 0.25;  ///< tangents at a larger angle from the chord do not become longer
/// Range of weights of curves. Below the lower one a patch bulges to a point; the natural weight of the
/// largest turn for which tangents become longer is exactly 0.5.
constexpr double weight_low = 0.501, weight_high = 5;

constexpr double waist = 0.5;  ///< length of tangents on inserted parts, relative to those of circular arcs

/// One end of a primitive edge in the solid's unit frame.
struct PrimitiveEnd {
  Vector3 unit, n, t;
  double cosine, alpha;
};

/// Primitive edge: planar in the unit frame, with its natural weights (docs/envelope.md).
struct PrimitiveEdge {
  PrimitiveEnd a, b;
  double natural[2], sag[2];

  PrimitiveEdge(const Vector3& from, const Vector3& to, double roundness) {
    const Vector3 e = to - from;
    const double length = e.norm();
    a = end(from, e, length, roundness);
    b = end(to, e, length, roundness);
    const Vector3 p1 = from + a.alpha * a.t, p2 = to - b.alpha * b.t;
    natural[0] = std::max((1 + 2 * a.cosine) / 3, weight_low);
    natural[1] = std::max((1 + 2 * b.cosine) / 3, weight_low);
    sag[0] = -(p2 - from).dot(a.n);
    sag[1] = -(p1 - to).dot(b.n);
  }
  double natural_curvature(int e) const {
    const double alpha = e == 0 ? a.alpha : b.alpha;
    return 2.0 / 3 * natural[1 - e] / (natural[e] * natural[e]) * sag[e] / (alpha * alpha);
  }

 private:
  static PrimitiveEnd end(const Vector3& u, const Vector3& e, double length, double roundness) {
    PrimitiveEnd out;
    out.unit = u;
    out.n = u.stableNormalized();
    out.t = (e - e.dot(out.n) * out.n).stableNormalized();
    out.cosine = out.t.dot(e) / length;
    out.alpha = roundness * length / (1 + 2 * std::max(out.cosine, least_cosine));
    return out;
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
    std::sort(out_.curves.begin(), out_.curves.end(), [](const NetworkCurve& x, const NetworkCurve& y) {
      return std::pair(x.low, x.high) < std::pair(y.low, y.high);
    });
  }

  void make_curves() {
    // Common curvature of the primitive edges at a vertex: the mean of their own curvatures.
    std::vector<double> sum(out_.cage.vertices.size(), 0), count(sum.size(), 0);
    std::vector<std::optional<PrimitiveEdge>> edges(out_.curves.size());
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const NetworkCurve& curve = out_.curves[k];
      if (!curve.primitive || vertex(curve.low).guarded || vertex(curve.high).guarded) continue;
      edges[k].emplace(vertex(curve.low).unit, vertex(curve.high).unit, solid(curve.low).roundness);
      if (std::min(edges[k]->sag[0], edges[k]->sag[1]) <= 1e-9) continue;
      sum[curve.low] += edges[k]->natural_curvature(0);
      sum[curve.high] += edges[k]->natural_curvature(1);
      ++count[curve.low];
      ++count[curve.high];
    }
    for (std::size_t k = 0; k < edges.size(); ++k) {
      NetworkCurve& curve = out_.curves[k];
      if (edges[k]) {
        const double kappa[2] = {sum[curve.low] / std::max(1.0, count[curve.low]),
                                 sum[curve.high] / std::max(1.0, count[curve.high])};
        make_primitive(curve, *edges[k], kappa);
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

  void make_primitive(NetworkCurve& curve, const PrimitiveEdge& edge, const double kappa[2]) {
    double w1 = edge.natural[0], w2 = edge.natural[1];
    if (std::min(edge.sag[0], edge.sag[1]) > 1e-9) {
      const double k0 = 1.5 * kappa[0] * edge.a.alpha * edge.a.alpha / edge.sag[0];
      const double k1 = 1.5 * kappa[1] * edge.b.alpha * edge.b.alpha / edge.sag[1];
      const double a = 1 / std::cbrt(k0 * k0 * k1), b = 1 / std::cbrt(k1 * k1 * k0);
      if (a > weight_low && a < weight_high && b > weight_low && b < weight_high)
        w1 = a, w2 = b, curve.matched = true;
    }
    const NetworkSolid& owner = solid(curve.low);
    curve.ribbon.curve = {homogeneous(vertex(curve.low).position),
                          homogeneous(owner.world(edge.a.unit + edge.a.alpha * edge.a.t), w1),
                          homogeneous(owner.world(edge.b.unit - edge.b.alpha * edge.b.t), w2),
                          homogeneous(vertex(curve.high).position)};
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
  const auto found = std::lower_bound(
      curves.begin(), curves.end(), key,
      [](const NetworkCurve& c, const std::pair<Index, Index>& k) { return std::pair(c.low, c.high) < k; });
  if (found == curves.end() || found->low != key.first || found->high != key.second) return no_index;
  return Index(found - curves.begin());
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
