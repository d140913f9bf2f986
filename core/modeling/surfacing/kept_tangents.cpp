#include "core/modeling/surfacing/kept_tangents.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/geometry/angles.hpp"
#include "core/network/fan_angles.hpp"
#include "core/network/kept_form.hpp"
#include "core/network/network_system.hpp"
#include "core/network/short_edges.hpp"

namespace hariko {
namespace {

constexpr double half_circle = std::numbers::pi;
/// Relative tolerance of the sum of the angles between tangents, and tolerance of negative angles in radians.
constexpr double turn_tolerance = 1e-2;

struct Wish {
  Index end = no_index;
  VertexId other;
  bool copy = false;  ///< leads to a mirror image
  Vector3 tangent = Vector3::Zero();
  double turn = 0, stretch = 0, lean = 0, side = 0;
};

class FormFinder {
 public:
  FormFinder(const PolyhedronSurfaceInput& input, const WantedForm& wanted)
      : polyhedron_(input.polyhedron), mesh_(polyhedron_.topology()), input_(input), wanted_(wanted) {}

  Result<FlatMap<VertexId, KeptForm>> run() {
    Shaping with_sides = input_.shaping;
    with_sides.form = sides();
    auto frames = build_vertex_frames(polyhedron_, with_sides, {Frames::metric});
    if (!frames) return frames.error();
    frames_ = std::move(frames).value();
    for (Index v = 0; v < polyhedron_.vertex_count(); ++v) {
      if (!takes_form(v)) continue;
      std::vector<Wish> fan = wishes(v);
      if (fan.empty()) continue;
      if (const KeptForm* on_side = with_sides.form.find(polyhedron_.vertex_id(v)))
        for (Wish& wish : fan)
          if (const KeptForm::Edge* edge = on_side->find(wish.other)) wish.side = edge->side;
      lay_out(v, fan);
      fans_.emplace(v, std::move(fan));
    }
    return offsets();
  }

 private:
  bool is_copy(VertexId id) const { return input_.aliases && input_.aliases->is_copy(id); }

  /// Forms that record only which vertices lie on sides of faces.
  FlatMap<VertexId, KeptForm> sides() const {
    FlatMap<VertexId, KeptForm> out;
    for (Index v = 0; v < polyhedron_.vertex_count(); ++v) {
      if (!takes_form(v)) continue;
      const std::vector<FanEnd> fan = fan_ends(mesh_, v);
      KeptForm form;
      for (std::size_t k = 0; k < fan.size() && fan.size() > 2; ++k) {
        if (fan[k].end % 2 == 1) continue;  // the last edge of an open fan
        const FaceId face = polyhedron_.face_id(mesh_.face(fan[k].end / 2));
        const auto parts = is_copy(face) ? std::nullopt : wanted_.sides(polyhedron_.vertex_id(v), face);
        if (!parts) continue;
        const FanEnd& before = fan[(k + 1) % fan.size()];
        form.edges.push_back({.to = polyhedron_.vertex_id(fan[k].other), .side = parts->second});
        form.edges.push_back({.to = polyhedron_.vertex_id(before.other), .side = parts->first});
        break;
      }
      if (form.edges.empty()) continue;
      std::sort(form.edges.begin(), form.edges.end(),
                [](const auto& x, const auto& y) { return x.to < y.to; });
      out.set(polyhedron_.vertex_id(v), std::move(form));
    }
    return out;
  }

  bool is_copy(FaceId id) const { return input_.aliases && input_.aliases->is_copy(id); }

  bool takes_form(Index v) const {
    if (mesh_.outgoing(v) == no_index || is_copy(polyhedron_.vertex_id(v))) return false;
    const Pin* pin = input_.shaping.pin.find(polyhedron_.vertex_id(v));
    return !pin || pin->kind != Pin::Kind::tangents;
  }

  /// Wishes for the edges of a vertex in the order of its fan; empty where something is not wanted.
  std::vector<Wish> wishes(Index v) const {
    std::vector<Wish> out;
    bool copies = false;
    for (const FanEnd& each : fan_ends(mesh_, v)) {
      Wish wish{each.end, polyhedron_.vertex_id(each.other), is_copy(polyhedron_.vertex_id(each.other))};
      if (wish.copy) {
        copies = true;
      } else if (const auto both = wanted_.tangents(polyhedron_.vertex_id(v), wish.other)) {
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

  /// Corner between an edge of a fan and the next one, by its half-edge.
  static Index corner(const Wish& wish) { return wish.end / 2; }

  double edge_length(const Wish& wish) const { return frames_.charts.edge_length[mesh_.edge(wish.end / 2)]; }

  /// Lengths of the edges in the vertex's fan without any form.
  std::vector<double> lengths_of(const std::vector<Wish>& fan) const {
    double longest = 0;
    for (const Wish& wish : fan) longest = std::max(longest, edge_length(wish));
    if (!(longest > 0)) longest = frames_.charts.mean_length;
    std::vector<double> out;
    for (const Wish& wish : fan) out.push_back(fan_length(edge_length(wish), longest));
    return out;
  }

  void lay_out(Index v, std::vector<Wish>& fan) const {
    const std::vector<double> lengths = lengths_of(fan);
    for (std::size_t k = 0; k < fan.size(); ++k)
      if (!fan[k].copy) fan[k].stretch = std::log(3 * fan[k].tangent.norm() / lengths[k]);
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
    if (frames_.kind[v] == FrameKind::smooth || frames_.kind[v] == FrameKind::sharp_line) find_leans(v, fan);
  }

  /// Finds the wanted offsets of the split vectors of nearly flat corners from their default directions.
  void find_leans(Index v, std::vector<Wish>& fan) const {
    const bool closed = fan.back().end % 2 == 0;
    for (std::size_t k = 0; k + (closed ? 0 : 1) < fan.size(); ++k) {
      Wish &first = fan[k], &second = fan[(k + 1) % fan.size()];
      if (first.copy || second.copy || frames_.half_turn[corner(first)]) continue;
      const Vector3 &a = first.tangent, &b = second.tangent;
      if (flat_share(angle_between(a, b), corner_angle(mesh_, frames_.charts, corner(first))) == 0) continue;
      const auto split =
          wanted_.splits(polyhedron_.vertex_id(v), polyhedron_.face_id(mesh_.face(corner(first))));
      if (!split) continue;
      const double before = angle_between(a, *split), behind = angle_between(*split, b);
      if (!(before + behind > 0)) continue;
      const double lean = before / (before + behind) - place_in_corner(mesh_, frames_.charts, corner(first));
      first.lean = second.lean = lean;
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

  /// Angles from the first tangent to the others about their common normal; empty where they do not add up to
  /// `total`.
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

  /// Sets turns relative to the default angles; the first and the last edge keep their directions.
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

  /// Sets turns and stretches between two sharp edges, where each tangent is a linear combination of those of
  /// both.
  void turn_corner(std::vector<Wish>& fan, std::size_t first, std::size_t corners) const {
    const auto at = [&](std::size_t j) -> Wish& { return fan[(first + j) % fan.size()]; };
    const std::vector<double> lengths = lengths_of(fan);
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
      wish.stretch = std::log(std::hypot(x, y) / lengths[(first + j) % fan.size()]);
    }
  }

  KeptForm form_of(const std::vector<Wish>& fan) const {
    KeptForm out;
    for (const Wish& wish : fan)
      if (!wish.copy)
        out.edges.push_back({wish.other, wish.turn, wish.stretch, Vector3::Zero(), wish.lean, wish.side});
    std::sort(out.edges.begin(), out.edges.end(), [](const auto& x, const auto& y) { return x.to < y.to; });
    return out;
  }

  /// Form that includes the edges to mirror images, as the mirror will make them.
  KeptForm whole_form(const std::vector<Wish>& fan) const {
    KeptForm out = form_of(fan);
    for (const Wish& wish : fan) {
      if (!wish.copy) continue;
      const KeptForm::Edge* own = out.find(input_.aliases->original(wish.other));
      if (own)
        out.edges.push_back({wish.other, -own->turn, own->stretch, Vector3::Zero(), -own->lean, own->side});
    }
    return out;
  }

  /// Wanted images of the unit vectors along the edges of a fan. The two beside a flat corner get equal
  /// length, because their unit vectors are nearly opposite; the one of the shorter edge is changed.
  std::vector<Vector3> wanted_images(const VertexFrames& frames, const std::vector<Wish>& fan) const {
    std::vector<Vector3> out;
    for (const Wish& wish : fan) out.push_back(wish.tangent / frames.length[wish.end]);
    const bool closed = fan.back().end % 2 == 0;
    for (std::size_t k = 0; k + (closed ? 0 : 1) < fan.size(); ++k) {
      const std::size_t other = (k + 1) % fan.size();
      if (fan[k].copy || fan[other].copy) continue;
      const Index at = corner(fan[k]);
      const double share = flat_share(frames.step[at], corner_angle(mesh_, frames.charts, at));
      const bool shorter = frames.length[fan[k].end] < frames.length[fan[other].end];
      Vector3 &gives = out[shorter ? k : other], &stays = out[shorter ? other : k];
      if (share > 0) gives *= std::pow(stays.norm() / gives.norm(), share);
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
      const std::vector<Vector3> wanted = wanted_images(frames, fan);
      std::vector<Index> ends;
      std::vector<Vector3> images;
      for (std::size_t k = 0; k < fan.size(); ++k) {
        if (fan[k].copy) continue;
        ends.push_back(fan[k].end);
        images.push_back(wanted[k]);
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

  /// Adds the mirror images of forms at vertices that are images.
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
          image.edges.push_back(
              {other, -edge->turn, edge->stretch, Vector3::Zero(), -edge->lean, edge->side});
      }
      shaping.form.set(id, std::move(image));
    }
  }

  const Polyhedron& polyhedron_;
  const HalfEdgeMesh& mesh_;
  const PolyhedronSurfaceInput& input_;
  const WantedForm& wanted_;
  VertexFrames frames_;
  std::map<Index, std::vector<Wish>> fans_;
};

}  // namespace

Result<FlatMap<VertexId, KeptForm>> kept_tangents(const PolyhedronSurfaceInput& input,
                                                  const WantedForm& wanted) {
  return FormFinder(input, wanted).run();
}

bool says_something(const KeptForm& form) {
  constexpr double least = 1e-3;
  return std::any_of(form.edges.begin(), form.edges.end(), [](const KeptForm::Edge& edge) {
    return edge.side > 0 || std::max({std::abs(edge.turn), std::abs(edge.stretch), 3 * edge.offset.norm(),
                                      std::abs(edge.lean)}) > least;
  });
}

}  // namespace hariko
