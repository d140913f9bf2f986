#include "core/patching/quartic/rings.hpp"

#include "core/base/parallel.hpp"

namespace hariko {

namespace {

/// Edge of a refined ring. Looking outward from the ring's point, `left` and `right` are the inner points of
/// the two patches beside the edge that serve it; the condition is a1 left + a2 right = r (relative to the
/// point).
struct RingEdge {
  Vector3 r = Vector3::Zero();
  double a1 = 0, a2 = 0;
  Vector3* left = nullptr;
  Vector3* right = nullptr;
  bool given = false;  ///< border edge whose point is known, not solved for
};

/// Ring around a point. Edges are counter-clockwise; patch i lies between edge i and edge i + 1, with weight
/// x[i] (its area in the chart) and target[i]. Closed: as many patches as edges. Open: one fewer, and the
/// first and last edge have no condition.
struct Ring {
  Vector3 point = Vector3::Zero();
  bool closed = true;
  std::vector<RingEdge> edges;
  std::vector<double> x;
  std::vector<Vector3> target;

  void clear() {
    edges.clear();
    x.clear();
    target.clear();
  }
};

/// Target of kuriyama.md section 4.4: the quartic that reproduces quadratics, seen from one corner of a
/// patch.
Vector3 target_at(const QuarticPatch& patch, int corner) {
  using namespace quartic;
  const auto& d = patch.control;
  // Inner cubic points from the elevated quartic: V1 = (4 d1 - V0) / 3.
  const auto cubic = [&](Control quartic_point, Control corner_point) -> Vector3 {
    return (4 * d[quartic_point] - d[corner_point]) / 3;
  };
  const Vector3 oa = cubic(d310, d400), ao = cubic(d130, d040), ab = cubic(d031, d040),
                ba = cubic(d013, d004), bo = cubic(d103, d004), ob = cubic(d301, d400);
  const Vector3 b111 = (oa + ao + ab + ba + bo + ob) / 4 - (d[d400] + d[d040] + d[d004]) / 6;
  switch (corner) {
    case 0:
      return (2 * b111 + oa + ob) / 4;
    case 1:
      return (2 * b111 + ao + ab) / 4;
    default:
      return (2 * b111 + ba + bo) / 4;
  }
}

void write_pair(RingEdge& edge, const Vector3& left, const Vector3& right, const Vector3& point) {
  const Vector3 residual = edge.r - edge.a1 * left - edge.a2 * right;
  const double square = edge.a1 * edge.a1 + edge.a2 * edge.a2;
  *edge.left = point + left + edge.a1 / square * residual;
  *edge.right = point + right + edge.a2 / square * residual;
}

void solve_closed(Ring& ring, Mode mode) {
  const std::size_t n = ring.edges.size();
  const auto before = [n](std::size_t i) { return (i + n - 1) % n; };
  std::vector<Vector3> g(n, Vector3::Zero());
  std::vector<Vector3> r(n);
  for (std::size_t i = 0; i < n; ++i) r[i] = ring.edges[i].r;
  if (n % 2 == 0) {  // the conditions are dependent: take the nearest right-hand side that has a solution
    Vector3 defect = Vector3::Zero();
    double square = 0;
    const auto y = [&](std::size_t i) {
      return (i % 2 ? -1.0 : 1.0) * (1 / ring.x[before(i)] + 1 / ring.x[i]);
    };
    for (std::size_t i = 0; i < n; ++i) {
      defect += y(i) * r[i];
      square += y(i) * y(i);
    }
    for (std::size_t i = 0; i < n; ++i) r[i] -= y(i) / square * defect;
  }
  // Particular solution by substitution, from g[n - 1] = 0: a1 and a2 are ratios of neighbouring x, so their
  // products telescope.
  Vector3 last = Vector3::Zero();
  for (std::size_t i = 0; i < n; ++i) last = g[i] = (r[i] - ring.edges[i].a2 * last) / ring.edges[i].a1;
  // Null direction of the substitution: (-1)^i x_i; with it, g[n - 1] must end as it started.
  const auto null = [&](std::size_t i) { return (i % 2 ? -1.0 : 1.0) * ring.x[i]; };
  Vector3 amount;
  if (n % 2 == 1) {
    // The start value -amount x[n-1] must equal g[n-1] + amount x[n-1].
    amount = -g[n - 1] / (2 * ring.x[n - 1]);
  } else {
    Vector3 along = Vector3::Zero();
    double square = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Vector3 wanted = mode == Mode::target ? Vector3(ring.target[i] - ring.point) : Vector3::Zero();
      along += null(i) * (wanted - g[i]);
      square += null(i) * null(i);
    }
    amount = along / square;
  }
  for (std::size_t i = 0; i < n; ++i) g[i] += amount * null(i);
  for (std::size_t i = 0; i < n; ++i) write_pair(ring.edges[i], g[i], g[before(i)], ring.point);
}

/// Solves an open chain: nearest to the targets under the conditions of the inner edges, G = Gt + C^T (C
/// C^T)^-1 (R - C Gt). C C^T is tridiagonal and diagonally dominant enough for elimination without pivoting.
void solve_open(Ring& ring) {
  const std::size_t n = ring.edges.size(), inner = n - 2;
  std::vector<Vector3> g(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) g[i] = ring.target[i] - ring.point;
  std::vector<Vector3> multiplier(inner);
  std::vector<double> diagonal(inner), off(inner, 0.0);
  for (std::size_t k = 0; k < inner; ++k) {
    const RingEdge& edge = ring.edges[k + 1];
    diagonal[k] = edge.a1 * edge.a1 + edge.a2 * edge.a2;
    if (k + 1 < inner) off[k] = edge.a1 * ring.edges[k + 2].a2;
    multiplier[k] = edge.r - edge.a1 * g[k + 1] - edge.a2 * g[k];
  }
  for (std::size_t k = 1; k < inner; ++k) {
    const double factor = off[k - 1] / diagonal[k - 1];
    diagonal[k] -= factor * off[k - 1];
    multiplier[k] -= factor * multiplier[k - 1];
  }
  for (std::size_t k = inner; k-- > 0;) {
    if (k + 1 < inner) multiplier[k] -= off[k] * multiplier[k + 1];
    multiplier[k] /= diagonal[k];
  }
  for (std::size_t k = 0; k < inner; ++k) {
    g[k + 1] += ring.edges[k + 1].a1 * multiplier[k];
    g[k] += ring.edges[k + 1].a2 * multiplier[k];
  }
  if (!ring.edges.front().given) *ring.edges.front().left = ring.point + g.front();
  if (!ring.edges.back().given) *ring.edges.back().right = ring.point + g.back();
  for (std::size_t k = 0; k < inner; ++k) write_pair(ring.edges[k + 1], g[k + 1], g[k], ring.point);
}

class RingSolver {
 public:
  RingSolver(const HalfEdgeMesh& mesh, const PatchConstants& constants, Mode mode,
             std::span<QuarticPatch> patches, const std::vector<bool>& given_side)
      : mesh_(mesh), constants_(constants), mode_(mode), patches_(patches), given_side_(given_side) {}

  void centre(Index face) {
    using namespace quartic;
    ring_.clear();
    ring_.closed = true;
    const Index first = mesh_.face_begin(face);
    ring_.point = patches_[first].control[d400];
    for (Index h = first; h < mesh_.face_end(face); ++h) {
      Vector3* left = &patches_[h].control[d211w];
      Vector3* right = &patches_[mesh_.previous(h)].control[d211v];
      const double own = constants_.own_split[h];
      ring_.edges.push_back({*left - ring_.point, own, 1 - own, left, right});
      ring_.x.push_back(constants_.x[h]);
      ring_.target.push_back(target_at(patches_[h], 0));
    }
    solve_closed(ring_, mode_);
  }

  void vertex(Index v) {
    const Index first = mesh_.outgoing(v);
    if (first == no_index) return;
    // Start at a sharp edge if there is one, so that sectors are never cut.
    Index start = first;
    bool any_sharp = false;
    Index h = first;
    do {
      if (!constants_.smooth[h]) {
        start = h;
        any_sharp = true;
        break;
      }
      h = mesh_.rotate(h);
    } while (h != no_index && h != first);

    begin_ring(v, !any_sharp);
    h = start;
    Index last = start;
    do {
      if (h != start && !constants_.smooth[h]) {
        finish_sector(last);
        begin_ring(v, false);
      }
      add_corner(h);
      last = h;
      h = mesh_.rotate(h);
    } while (h != no_index && h != start);
    if (any_sharp)
      finish_sector(last);
    else
      solve_closed(ring_, mode_);
  }

 private:
  bool is_given(Index h) const { return !given_side_.empty() && given_side_[h]; }

  void begin_ring(Index v, bool closed) {
    ring_.clear();
    ring_.closed = closed;
    ring_.point = patches_[mesh_.outgoing(v)].control[quartic::d040];
  }

  /// Adds the corner's opening edge, its patch, its split edge, and the patch behind it.
  void add_corner(Index h) {
    using namespace quartic;
    const Index previous = mesh_.previous(h), twin = mesh_.twin(h);
    Vector3* left = &patches_[h].control[d121u];
    Vector3* right = twin == no_index ? nullptr : &patches_[twin].control[d112u];
    const double own = constants_.own[h];
    const bool given = is_given(h);
    ring_.edges.push_back({*left - ring_.point, own, 1 - own, left, right, given});
    Vector3* split_left = &patches_[previous].control[d112v];
    Vector3* split_right = &patches_[h].control[d121w];
    const double own_split = constants_.own_split[h];
    ring_.edges.push_back({*split_left - ring_.point, 1 - own_split, own_split, split_left, split_right});
    ring_.x.push_back(constants_.x[h]);
    ring_.x.push_back(constants_.x[previous]);
    // The other point of a pair stays as near to its given point as possible.
    ring_.target.push_back(given ? *left : target_at(patches_[h], 1));
    ring_.target.push_back(is_given(previous) ? patches_[previous].control[d112u]
                                              : target_at(patches_[previous], 2));
  }

  void finish_sector(Index last_corner) {
    RingEdge closing;
    const Index side = mesh_.previous(last_corner);
    closing.given = is_given(side);
    closing.right = &patches_[side].control[quartic::d112u];
    ring_.edges.push_back(closing);
    solve_open(ring_);
  }

  const HalfEdgeMesh& mesh_;
  const PatchConstants& constants_;
  Mode mode_;
  std::span<QuarticPatch> patches_;
  const std::vector<bool>& given_side_;
  Ring ring_;
};

}  // namespace

void solve_rings(const HalfEdgeMesh& mesh, const PatchConstants& constants, Mode mode,
                 std::span<const Index> vertices, std::span<const Index> faces,
                 std::span<QuarticPatch> patches, const std::vector<bool>& given_side) {
  // Rings write different inner points of a patch, and read only boundary points and their own inner points.
  parallel_for(vertices.size(), 512, [&](std::size_t begin, std::size_t end) {
    RingSolver solver(mesh, constants, mode, patches, given_side);
    for (std::size_t k = begin; k < end; ++k) solver.vertex(vertices[k]);
  });
  parallel_for(faces.size(), 512, [&](std::size_t begin, std::size_t end) {
    RingSolver solver(mesh, constants, mode, patches, given_side);
    for (std::size_t k = begin; k < end; ++k) solver.centre(faces[k]);
  });
}

}  // namespace hariko
