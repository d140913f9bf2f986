#include "core/envelope/valley_cage.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "core/envelope/cage_frames.hpp"
#include "core/envelope/loop_mesh.hpp"
#include "core/envelope/loop_pieces.hpp"
#include "core/envelope/valley_chain.hpp"

namespace hariko {

namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double join_low = 15, join_high = 165;  ///< degrees
constexpr double thin_angle = 24, thin_length = 0.08, short_length = 0.04;
constexpr int lifting_rounds = 40;
constexpr std::size_t largest_star = 10;  ///< corners of faces that corners of solids are put into

double angle(const Vector3& a, const Vector3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * degrees;
}

double triangle_distance(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) {
  const auto segment = [&](const Vector3& x, const Vector3& y) {
    const Vector3 e = y - x;
    return (x + std::clamp((p - x).dot(e) / std::max(e.squaredNorm(), 1e-300), 0.0, 1.0) * e - p).norm();
  };
  const Vector3 n = (b - a).cross(c - a);
  if (n.dot((b - a).cross(p - a)) >= 0 && n.dot((c - b).cross(p - b)) >= 0 &&
      n.dot((a - c).cross(p - c)) >= 0)
    return std::abs(n.dot(p - a)) / std::max(n.norm(), 1e-300);
  return std::min({segment(a, b), segment(b, c), segment(c, a)});
}

class ValleyCutter {
 public:
  ValleyCutter(NetworkCage hull, const ValleyCageInput& input)
      : input_(input), vertices_(std::move(hull.vertices)), labels_(vertices_.size()) {
    const NetworkCage whole{vertices_, std::move(hull.faces)};
    hull_count_ = vertices_.size();
    const ValleyChains chains = valley_chains(whole, input);
    sunk_ = !chains.empty();
    if (sunk_) insert(whole.faces, chains);
  }

  bool sunk() const { return sunk_; }

  NetworkCage cut() {
    edges_ = edges_of(loops_);
    const CageLoops whole = std::move(loops_);
    loops_.clear();
    for (std::size_t f = 0; f < whole.size(); ++f)
      if (whole[f].corners.size() == plain_sizes_[f])
        loops_.push_back(whole[f]);
      else
        join(whole[f]);
    mend_flat_vertices();
    collapse_thin();
    collapse_short();
    for (std::size_t v = hull_count_; v < vertices_.size(); ++v)
      if (input_.pushes)
        if (const auto push = input_.pushes->find(vertices_[v].vertex);
            push != input_.pushes->end() && vertices_[v].solid == no_index)
          vertices_[v].position += push->second;
    if (input_.stars)
      for (const SolidVertex& corner : *input_.stars) put_in(corner);
    return finished();
  }

 private:
  Index add(const CageVertex& vertex, const ValleyLabel& label) {
    vertices_.push_back(vertex);
    labels_.push_back(label);
    return Index(vertices_.size() - 1);
  }
  bool is_sunk(Index v) const { return v >= hull_count_ && vertices_[v].solid == no_index; }
  const Vector3& at(Index v) const { return vertices_[v].position; }

  void insert(const std::vector<CageFace>& faces, const ValleyChains& chains) {
    std::map<std::pair<Index, Index>, std::vector<Index>> numbers;
    for (const auto& [edge, chain] : chains)
      for (const ChainVertex& link : chain) numbers[edge].push_back(add(link.vertex, link.label));
    for (const CageFace& face : faces) {
      CageLoop loop{{}, newell_normal(face.loop, vertices_)};
      for (std::size_t i = 0; i < face.loop.size(); ++i) {
        const Index a = face.loop[i], b = face.loop[(i + 1) % face.loop.size()];
        loop.corners.push_back(a);
        const auto chain = numbers.find(std::minmax(a, b));
        if (chain == numbers.end()) continue;
        if (a < b)
          loop.corners.insert(loop.corners.end(), chain->second.begin(), chain->second.end());
        else
          loop.corners.insert(loop.corners.end(), chain->second.rbegin(), chain->second.rend());
      }
      plain_sizes_.push_back(face.loop.size());
      loops_.push_back(std::move(loop));
    }
  }

  bool allowed(Index a, Index b) const { return a != b && !edges_.contains(std::minmax(a, b)); }

  static std::pair<CageLoop, CageLoop> halves(const CageLoop& loop, std::size_t i, std::size_t j) {
    CageLoop one{{loop.corners.begin() + std::ptrdiff_t(i), loop.corners.begin() + std::ptrdiff_t(j) + 1},
                 loop.outside};
    CageLoop other{{loop.corners.begin(), loop.corners.begin() + std::ptrdiff_t(i) + 1}, loop.outside};
    other.corners.insert(other.corners.end(), loop.corners.begin() + std::ptrdiff_t(j), loop.corners.end());
    return {std::move(one), std::move(other)};
  }

  /// A diagonal meets the loop's edges at angles that are neither flat nor sharp.
  bool joins_well(const CageLoop& loop, std::size_t i, std::size_t j) const {
    const std::size_t n = loop.corners.size();
    for (const auto& [from, to] : {std::pair(i, j), std::pair(j, i)}) {
      const Vector3& p = at(loop.corners[from]);
      const Vector3 d = at(loop.corners[to]) - p;
      for (const std::size_t k : {(from + 1) % n, (from + n - 1) % n})
        if (const double x = angle(d, at(loop.corners[k]) - p); !(x > join_low && x < join_high))
          return false;
    }
    return true;
  }

  /// Joins points of one valley across the face, then cuts what is left.
  void join(const CageLoop& loop) {
    const std::size_t n = loop.corners.size();
    double shortest = 1e300;
    std::size_t bi = 0, bj = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 2; j < n; ++j) {
        const Index a = loop.corners[i], b = loop.corners[j];
        if ((i == 0 && j + 1 == n) || labels_[a].low == no_index || labels_[a] != labels_[b] ||
            !allowed(a, b))
          continue;
        const double length = (at(a) - at(b)).norm();
        if (length >= shortest - 1e-9 * input_.diagonal || !joins_well(loop, i, j)) continue;
        shortest = length, bi = i, bj = j;
      }
    if (bi == bj) {
      meet(loop);
      return;
    }
    edges_.insert(std::minmax(loop.corners[bi], loop.corners[bj]));
    const auto [one, other] = halves(loop, bi, bj);
    join(one);
    join(other);
  }

  /// Where three valleys run into a face, they meet in a vertex of their own.
  void meet(const CageLoop& loop) {
    const std::size_t n = loop.corners.size();
    std::vector<std::size_t> sunk;
    std::set<ValleyLabel> labels;
    for (std::size_t i = 0; i < n; ++i)
      if (is_sunk(loop.corners[i])) sunk.push_back(i), labels.insert(labels_[loop.corners[i]]);
    bool apart = labels.size() >= 3;
    for (std::size_t k = 0; apart && k < sunk.size(); ++k)
      apart = (sunk[k] + 1) % n != sunk[(k + 1) % sunk.size()];
    if (!apart) {
      divide(loop);
      return;
    }
    CageVertex centre;
    centre.vertex = 2166136261U;
    for (const std::size_t i : sunk) {
      const CageVertex& v = vertices_[loop.corners[i]];
      centre.position += v.position / double(sunk.size());
      centre.outward += v.outward;
      centre.vertex = (centre.vertex ^ v.vertex) * 16777619U;
    }
    centre.name = vertices_[loop.corners[sunk[0]]].name;
    centre.name.vertex = centre.vertex;
    centre.outward = centre.outward.stableNormalized();
    lift(centre);
    const Index c = add(centre, {});
    for (const std::size_t i : sunk) edges_.insert(std::minmax(c, loop.corners[i]));
    for (std::size_t k = 0; k < sunk.size(); ++k) {
      CageLoop part{{c}, loop.outside};
      for (std::size_t i = sunk[k];; i = (i + 1) % n) {
        part.corners.push_back(loop.corners[i]);
        if (i == sunk[(k + 1) % sunk.size()]) break;
      }
      divide(part);
    }
  }

  /// Outwards until it is in no solid.
  void lift(CageVertex& vertex) const {
    for (int round = 0; round < lifting_rounds; ++round) {
      double depth = 1e-9 * input_.diagonal;
      Index solid = no_index;
      for (Index s = 0; s < input_.grown->count(); ++s)
        if (const double d = -input_.grown->distance(s, vertex.position); d > depth) depth = d, solid = s;
      if (solid == no_index) return;
      const double slope = input_.grown->gradient(solid, vertex.position).dot(vertex.outward);
      vertex.position += depth / std::max(slope, 0.3) * vertex.outward;
    }
  }

  std::vector<Vector3> places(const std::vector<Index>& corners) const {
    std::vector<Vector3> out;
    for (const Index v : corners) out.push_back(at(v));
    return out;
  }

  void divide(const CageLoop& loop) {
    const auto& c = loop.corners;
    for (const auto& piece :
         cheapest_pieces(places(c), loop.outside, [&](Index i, Index j) { return allowed(c[i], c[j]); })) {
      CageLoop part{{}, loop.outside};
      for (const Index i : piece) part.corners.push_back(c[i]);
      for (std::size_t i = 0; i < part.corners.size(); ++i)
        edges_.insert(std::minmax(part.corners[i], part.corners[(i + 1) % part.corners.size()]));
      loops_.push_back(std::move(part));
    }
  }

  // --- clean-up ------------------------------------------------------------------------------------------

  /// Vertices with two faces get a diagonal, or go.
  void mend_flat_vertices() {
    for (Index v = Index(hull_count_); v < vertices_.size(); ++v) {
      std::vector<std::size_t> faces;
      for (std::size_t f = 0; f < loops_.size(); ++f)
        if (std::find(loops_[f].corners.begin(), loops_[f].corners.end(), v) != loops_[f].corners.end())
          faces.push_back(f);
      if (faces.size() != 2) continue;
      double least = 1e300;
      std::size_t face = 0, bi = 0, bj = 0;
      for (const std::size_t f : faces) {
        const CageLoop& loop = loops_[f];
        const std::size_t n = loop.corners.size();
        const auto i =
            std::size_t(std::find(loop.corners.begin(), loop.corners.end(), v) - loop.corners.begin());
        for (std::size_t j = 0; j < n; ++j) {
          if (j == i || (i + 1) % n == j || (j + 1) % n == i || !allowed(v, loop.corners[j])) continue;
          const auto [one, other] = halves(loop, std::min(i, j), std::max(i, j));
          const double cost =
              piece_cost(places(one.corners), loop.outside) + piece_cost(places(other.corners), loop.outside);
          if (cost < least - 1e-6) least = cost, face = f, bi = std::min(i, j), bj = std::max(i, j);
        }
      }
      if (bi != bj) {
        edges_.insert(std::minmax(loops_[face].corners[bi], loops_[face].corners[bj]));
        auto [one, other] = halves(loops_[face], bi, bj);
        loops_[face] = std::move(one);
        loops_.push_back(std::move(other));
      } else if (loops_[faces[0]].corners.size() > 3 && loops_[faces[1]].corners.size() > 3) {
        for (const std::size_t f : faces) std::erase(loops_[f].corners, v);
      }
    }
  }

  bool collapse(Index a, Index b) {
    CageLoops next = collapsed(loops_, std::min(a, b), std::max(a, b));
    if (!is_sphere(next)) return false;
    loops_ = std::move(next);
    CageVertex& kept = vertices_[std::min(a, b)];
    const CageVertex& gone = vertices_[std::max(a, b)];
    kept.position = 0.5 * (kept.position + gone.position);
    kept.outward = (kept.outward + gone.outward).stableNormalized();
    return true;
  }

  struct Short {
    double measure;
    Index a, b;
  };

  /// The candidates in order until one can be collapsed; again until there is none.
  template <class List>
  void collapse_all(const List& list) {
    for (bool again = true; again;) {
      again = false;
      std::vector<Short> shorts = list();
      std::stable_sort(shorts.begin(), shorts.end(),
                       [](const Short& x, const Short& y) { return x.measure < y.measure - 1e-9; });
      for (const Short& s : shorts)
        if (collapse(s.a, s.b)) {
          again = true;
          break;
        }
    }
  }

  void collapse_thin() {
    collapse_all([&] {
      std::vector<Short> out;
      for (const CageLoop& loop : loops_) {
        if (loop.corners.size() != 3) continue;
        for (std::size_t k = 0; k < 3; ++k) {
          const Index c = loop.corners[k], a = loop.corners[(k + 1) % 3], b = loop.corners[(k + 2) % 3];
          if (is_sunk(c) || !is_sunk(a) || !is_sunk(b)) continue;
          const double x = angle(at(a) - at(c), at(b) - at(c));
          if (x < thin_angle && (at(a) - at(b)).norm() < thin_length * input_.diagonal)
            out.push_back({x, a, b});
        }
      }
      return out;
    });
  }

  void collapse_short() {
    collapse_all([&] {
      std::vector<Short> out;
      for (const auto& [a, b] : edges_of(loops_)) {
        if (!is_sunk(a) || !is_sunk(b)) continue;
        const double part = (at(a) - at(b)).norm() / input_.diagonal;
        if (part < short_length) out.push_back({part, a, b});
      }
      return out;
    });
  }

  // --- corners of solids that the faces have cut off -----------------------------------------------------

  std::size_t nearest_face(const Vector3& p) const {
    double least = 1e300;
    std::size_t best = 0;
    for (std::size_t f = 0; f < loops_.size(); ++f) {
      const auto& c = loops_[f].corners;
      Vector3 mean = Vector3::Zero();
      for (const Index v : c) mean += at(v) / double(c.size());
      for (std::size_t i = 0; i < c.size(); ++i)
        if (const double d = triangle_distance(p, mean, at(c[i]), at(c[(i + 1) % c.size()]));
            d < least - 1e-9 * input_.diagonal)
          least = d, best = f;
    }
    return best;
  }

  /// The face's parts round a new vertex that is joined to the corners of a set.
  std::vector<CageLoop> star(const CageLoop& loop, Index centre, unsigned spokes) const {
    std::vector<CageLoop> out;
    const std::size_t n = loop.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (!(spokes >> i & 1U)) continue;
      CageLoop part{{centre, loop.corners[i]}, loop.outside};
      for (std::size_t k = (i + 1) % n;; k = (k + 1) % n) {
        part.corners.push_back(loop.corners[k]);
        if (spokes >> k & 1U) break;
      }
      out.push_back(std::move(part));
    }
    return out;
  }

  void put_in(const SolidVertex& corner) {
    if (std::any_of(vertices_.begin(), vertices_.end(), [&](const CageVertex& v) {
          return v.solid == corner.first && v.vertex == corner.second;
        }))
      return;
    CageVertex vertex;
    vertex.solid = corner.first;
    vertex.vertex = corner.second;
    vertex.position = input_.solids[corner.first].world(
        input_.solids[corner.first].unit_vertices[corner.second], input_.growth[corner.first]);
    const std::size_t face = nearest_face(vertex.position);
    const CageLoop loop = loops_[face];
    const std::size_t n = loop.corners.size();
    if (n > largest_star) return;
    const Index centre = add(vertex, {});
    double least = 1e300;
    unsigned best = 0;
    for (unsigned spokes = 0; spokes < 1U << n; ++spokes) {
      const int count = std::popcount(spokes);
      if (count < 3 || count > 5) continue;
      double cost = 0;
      for (const CageLoop& part : star(loop, centre, spokes))
        cost += piece_cost(places(part.corners), loop.outside);
      for (std::size_t i = 0; i < n; ++i)
        if (spokes >> i & 1U)
          cost += 0.15 + 0.3 * (at(loop.corners[i]) - vertex.position).norm() / input_.diagonal;
      if (cost < least - 1e-6) least = cost, best = spokes;
    }
    std::vector<CageLoop> parts = star(loop, centre, best);
    loops_[face] = parts[0];
    loops_.insert(loops_.end(), parts.begin() + 1, parts.end());
  }

  NetworkCage finished() {
    if (!is_sphere(loops_)) return {};
    std::vector<Index> number(vertices_.size(), no_index);
    for (const CageLoop& loop : loops_)
      for (const Index v : loop.corners) number[v] = 0;
    NetworkCage out;
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (number[v] == no_index) {
        if (v < hull_count_) return {};
        continue;
      }
      number[v] = Index(out.vertices.size());
      CageVertex vertex = vertices_[v];
      if (vertex.solid != no_index) put_on_solid(vertex, input_.solids[vertex.solid]);
      out.vertices.push_back(vertex);
    }
    for (const CageLoop& loop : loops_) {
      CageFace face;
      for (const Index v : loop.corners) face.loop.push_back(number[v]);
      const Index owner = out.vertices[face.loop[0]].solid;
      if (std::all_of(face.loop.begin(), face.loop.end(),
                      [&](Index v) { return out.vertices[v].solid == owner; }))
        face.solid = owner;
      out.faces.push_back(std::move(face));
    }
    set_valley_frames(out);
    return out;
  }

  const ValleyCageInput& input_;
  std::vector<CageVertex> vertices_;
  std::vector<ValleyLabel> labels_;
  std::size_t hull_count_ = 0;
  bool sunk_ = false;
  CageLoops loops_;
  std::vector<std::size_t> plain_sizes_;  ///< corners of the hull's faces, before anything was inserted
  std::set<std::pair<Index, Index>> edges_;
};

}  // namespace

NetworkCage valley_cage(NetworkCage hull, const ValleyCageInput& input) {
  NetworkCage plain = hull;
  ValleyCutter cutter(std::move(hull), input);
  return cutter.sunk() ? cutter.cut() : plain;
}

}  // namespace hariko
