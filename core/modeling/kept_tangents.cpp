#include "core/modeling/kept_tangents.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/geometry/angles.hpp"
#include "core/network/kept_form.hpp"
#include "core/network/network_system.hpp"

namespace hariko {
namespace {

constexpr double half_circle = std::numbers::pi;
/// Share of a turn: how far tangents in one plane may miss to go round once.
constexpr double turn_tolerance = 1e-2;

/// Cosine of the angle from which on two tangents count as nearly opposite: 165 degrees.
constexpr double nearly_opposite = -0.966;

struct Wish {
  Index end = no_index;
  VertexId other;
  bool copy = false;  ///< leads to an image in a mirror
  Vector3 tangent = Vector3::Zero();
  double turn = 0, stretch = 0;
};

class FormFinder {
 public:
  FormFinder(const PolyhedronSurfaceInput& input, const WantedTangents& wanted)
      : polyhedron_(input.polyhedron), mesh_(polyhedron_.topology()), input_(input), wanted_(wanted) {}

  Result<FlatMap<VertexId, KeptForm>> run() {
    auto frames = build_vertex_frames(polyhedron_, input_.shaping, {Frames::metric});
    if (!frames) return frames.error();
    frames_ = std::move(frames).value();
    for (Index v = 0; v < polyhedron_.vertex_count(); ++v) {
      if (!takes_form(v)) continue;
      std::vector<Wish> fan = wishes(v);
      if (fan.empty()) continue;
      lay_out(v, fan);
      fans_.emplace(v, std::move(fan));
    }
    return offsets();
  }

 private:
  bool is_copy(VertexId id) const { return input_.aliases && input_.aliases->is_copy(id); }

  bool takes_form(Index v) const {
    if (mesh_.outgoing(v) == no_index || is_copy(polyhedron_.vertex_id(v))) return false;
    const Pin* pin = input_.shaping.pin.find(polyhedron_.vertex_id(v));
    return !pin || pin->kind != Pin::Kind::tangents;
  }

  /// The edges of a vertex, in the order of its fan; none where something is not wanted.
  std::vector<Wish> wishes(Index v) const {
    std::vector<Wish> out;
    bool copies = false;
    for (const FanEnd& each : fan_ends(mesh_, v)) {
      Wish wish{each.end, polyhedron_.vertex_id(each.other), is_copy(polyhedron_.vertex_id(each.other))};
      if (wish.copy) {
        copies = true;
      } else if (const auto both = wanted_(polyhedron_.vertex_id(v), wish.other)) {
        wish.tangent = both->first;
        if (!(wish.tangent.norm() > 0)) return {};
      } else {
        return {};
      }
      out.push_back(wish);
    }
    if (!copies) return out;
    // The vertex lies in a mirror's plane: its own edges come first, from one in the plane to the other.
    if (frames_.kind[v] != FrameKind::smooth) return {};
    std::size_t first = 0;
    const std::size_t n = out.size();
    while (first < n && !(out[(first + n - 1) % n].copy && !out[first].copy)) ++first;
    if (first == n) return {};
    std::rotate(out.begin(), out.begin() + std::ptrdiff_t(first), out.end());
    return out;
  }

  /// The corner between an edge of a fan and the next one, by its half-edge.
  static Index corner(const Wish& wish) { return wish.end / 2; }

  /// Tangents that are nearly opposite: the split edge between them stays well within the corner only if
  /// their lengths are as the areas of the patches over their edges: the shorter one gives way, which hardly
  /// changes its curve.
  void balance(std::vector<Wish>& fan) const {
    const bool closed = fan.back().end % 2 == 0;
    for (std::size_t k = 0; k + (closed ? 0 : 1) < fan.size(); ++k) {
      Wish &a = fan[k], &b = fan[(k + 1) % fan.size()];
      if (a.copy || b.copy) continue;
      const double first = a.tangent.norm(), second = b.tangent.norm();
      if (a.tangent.dot(b.tangent) > nearly_opposite * first * second) continue;
      const FaceCharts& charts = frames_.charts;
      const double ratio = charts.area[corner(a)] / charts.area[mesh_.previous(corner(a))];
      if (first < second)
        a.tangent *= ratio * second / first;
      else
        b.tangent *= first / (ratio * second);
    }
  }

  void lay_out(Index v, std::vector<Wish>& fan) const {
    balance(fan);
    for (Wish& wish : fan)
      if (!wish.copy) wish.stretch = std::log(3 * wish.tangent.norm() / frames_.length[wish.end]);
    std::size_t own = 0;
    while (own < fan.size() && !fan[own].copy) ++own;
    switch (frames_.kind[v]) {
      case FrameKind::smooth:
        if (own < fan.size())
          turn_within(fan, 0, own - 1, half_circle);
        else
          turn_all_round(fan);
        break;
      case FrameKind::sharp_line:
        for_sectors(fan, [&](std::size_t first, std::size_t corners) {
          turn_within(fan, first, corners, half_circle);
        });
        break;
      case FrameKind::corner:
        for_sectors(fan, [&](std::size_t first, std::size_t corners) { turn_corner(fan, first, corners); });
        break;
      case FrameKind::straight: {
        const double mean = (fan[0].stretch + fan[1].stretch) / 2;
        fan[0].stretch = fan[1].stretch = mean;
        break;
      }
      case FrameKind::isolated:
        break;
    }
  }

  template <class Body>
  void for_sectors(std::vector<Wish>& fan, const Body& body) const {
    std::vector<std::size_t> sharp;
    for (std::size_t k = 0; k < fan.size(); ++k)
      if (frames_.sharp[mesh_.edge(fan[k].end / 2)]) sharp.push_back(k);
    for (std::size_t i = 0; i + 1 < sharp.size(); ++i) body(sharp[i], sharp[i + 1] - sharp[i]);
    if (fan.back().end % 2 == 0 && !sharp.empty())  // closed
      body(sharp.back(), fan.size() - sharp.back() + sharp.front());
  }

  /// Angles from the first tangent to the others round their common normal; none where they do not go round
  /// once by `total`.
  static std::vector<double> angles_of(const std::vector<Wish>& fan, std::size_t first, std::size_t corners,
                                       double total) {
    const auto at = [&](std::size_t j) -> const Vector3& { return fan[(first + j) % fan.size()].tangent; };
    Vector3 normal = Vector3::Zero();
    for (std::size_t j = 0; j < corners; ++j) normal += at(j).cross(at(j + 1));
    if (normal.isZero(0)) return {};
    normal = normal.stableNormalized();
    std::vector<double> out{0};
    for (std::size_t j = 0; j < corners; ++j) {
      double step = signed_angle(at(j), at(j + 1), normal);
      if (step < -turn_tolerance) step += 2 * half_circle;
      out.push_back(out.back() + step);
    }
    if (std::abs(out.back() - total) > turn_tolerance * total) return {};
    return out;
  }

  void turn_all_round(std::vector<Wish>& fan) const {
    const std::vector<double> angles = angles_of(fan, 0, fan.size(), 2 * half_circle);
    if (angles.empty()) return;
    double usual = 0, mean = 0;
    for (std::size_t k = 0; k < fan.size(); ++k) {
      fan[k].turn = angles[k] - usual;
      mean += fan[k].turn / double(fan.size());
      usual += frames_.step[corner(fan[k])];
    }
    for (Wish& wish : fan) wish.turn -= mean;
  }

  /// The first and the last edge stay in their directions.
  void turn_within(std::vector<Wish>& fan, std::size_t first, std::size_t corners, double total) const {
    const std::vector<double> angles = angles_of(fan, first, corners, total);
    if (angles.empty()) return;
    double usual = 0;
    for (std::size_t j = 0; j < corners; ++j) {
      Wish& wish = fan[(first + j) % fan.size()];
      if (j > 0) wish.turn = angles[j] - usual;
      usual += frames_.step[corner(wish)];
    }
  }

  /// Between two sharp edges tangents are any sums of those of both.
  void turn_corner(std::vector<Wish>& fan, std::size_t first, std::size_t corners) const {
    const auto at = [&](std::size_t j) -> Wish& { return fan[(first + j) % fan.size()]; };
    double opening = 0;
    for (std::size_t j = 0; j < corners; ++j) opening += frames_.step[corner(at(j))];
    const Vector3 a = at(0).tangent.stableNormalized() / 3, b = at(corners).tangent.stableNormalized() / 3;
    const double square = 1.0 / 9, mixed = a.dot(b), det = square * square - mixed * mixed;
    if (!(det > 1e-6 * square * square)) return;
    double usual = 0;
    for (std::size_t j = 1; j < corners; ++j) {
      usual += frames_.step[corner(at(j - 1))];
      Wish& wish = at(j);
      const double ta = a.dot(wish.tangent), tb = b.dot(wish.tangent);
      const double of_a = (square * ta - mixed * tb) / det, of_b = (square * tb - mixed * ta) / det;
      const double x = of_a + of_b * std::cos(opening), y = of_b * std::sin(opening);
      wish.turn = std::atan2(y, x) - usual;
      wish.stretch = std::log(std::hypot(x, y) / frames_.length[wish.end]);
    }
  }

  KeptForm form_of(const std::vector<Wish>& fan) const {
    KeptForm out;
    for (const Wish& wish : fan)
      if (!wish.copy) out.edges.push_back({wish.other, wish.turn, wish.stretch});
    std::sort(out.edges.begin(), out.edges.end(), [](const auto& x, const auto& y) { return x.to < y.to; });
    return out;
  }

  /// The edges to copies as the mirror will make them.
  KeptForm whole_form(const std::vector<Wish>& fan) const {
    KeptForm out = form_of(fan);
    for (const Wish& wish : fan) {
      if (!wish.copy) continue;
      const KeptForm::Edge* own = out.find(input_.aliases->original(wish.other));
      if (own) out.edges.push_back({wish.other, -own->turn, own->stretch});
    }
    return out;
  }

  Result<FlatMap<VertexId, KeptForm>> offsets() const {
    Shaping shaping = input_.shaping;
    for (const auto& [v, fan] : fans_) shaping.form.set(polyhedron_.vertex_id(v), whole_form(fan));
    add_images(shaping);
    const auto system = NetworkSystem::assemble(polyhedron_, shaping, {Frames::metric});
    if (!system) return system.error();
    const VertexFrames& frames = system->frames();
    const std::vector<Vector3> basis = system->solve(polyhedron_.positions(), {}).basis;
    std::vector<Vector3> offset(basis.size(), Vector3::Zero());
    FlatMap<VertexId, KeptForm> out;
    for (const auto& [v, fan] : fans_) {
      std::vector<Index> ends;
      std::vector<Vector3> images;
      for (const Wish& wish : fan) {
        if (wish.copy) continue;
        ends.push_back(wish.end);
        images.push_back(wish.tangent / frames.length[wish.end]);
      }
      if (!fit_basis(frames, v, ends, images, offset)) continue;
      for (Index b = frames.basis_begin[v]; b < frames.basis_begin[v + 1]; ++b) offset[b] -= basis[b];
      KeptForm form = form_of(fan);
      const std::vector<FanEnd> usual = fan_ends(mesh_, v);
      const std::vector<Matrix3> directions = edge_directions(polyhedron_, v, usual);
      for (std::size_t k = 0; k < usual.size(); ++k)
        for (KeptForm::Edge& edge : form.edges)
          if (edge.to == polyhedron_.vertex_id(usual[k].other))
            edge.offset = directions[k].transpose() * image_of_unit(frames, usual[k].end, offset);
      out.set(polyhedron_.vertex_id(v), std::move(form));
    }
    return out;
  }

  /// Vertices that are images in a mirror keep the image of the form.
  void add_images(Shaping& shaping) const {
    if (!input_.aliases) return;
    for (Index v = 0; v < polyhedron_.vertex_count(); ++v) {
      const VertexId id = polyhedron_.vertex_id(v);
      if (!is_copy(id)) continue;
      const KeptForm* own = shaping.form.find(input_.aliases->original(id));
      if (!own) continue;
      KeptForm image;
      for (const FanEnd& each : fan_ends(mesh_, v)) {
        const VertexId other = polyhedron_.vertex_id(each.other);
        if (const KeptForm::Edge* edge = own->find(input_.aliases->original(other)))
          image.edges.push_back({other, -edge->turn, edge->stretch});
      }
      shaping.form.set(id, std::move(image));
    }
  }

  const Polyhedron& polyhedron_;
  const HalfEdgeMesh& mesh_;
  const PolyhedronSurfaceInput& input_;
  const WantedTangents& wanted_;
  VertexFrames frames_;
  std::map<Index, std::vector<Wish>> fans_;
};

}  // namespace

Result<FlatMap<VertexId, KeptForm>> kept_tangents(const PolyhedronSurfaceInput& input,
                                                  const WantedTangents& wanted) {
  return FormFinder(input, wanted).run();
}

bool says_something(const KeptForm& form) {
  constexpr double least = 1e-3;
  return std::any_of(form.edges.begin(), form.edges.end(), [](const KeptForm::Edge& edge) {
    return std::max({std::abs(edge.turn), std::abs(edge.stretch), 3 * edge.offset.norm()}) > least;
  });
}

}  // namespace hariko
