#include "core/network/vertex_frames.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "core/base/assert.hpp"
#include "core/network/network.hpp"

namespace hariko {

namespace {

constexpr double pi = std::numbers::pi;

/// One edge of a fan: the half-edge that carries it and which of its ends lies at the vertex.
struct FanEdge {
  Index half_edge;
  bool at_origin;
};

/// Edges counter-clockwise; corner k lies between edges k and k + 1.
struct Fan {
  std::vector<FanEdge> edges;
  std::vector<Index> corners;
  bool closed;
};

Fan fan_of(const HalfEdgeMesh& mesh, Index v) {
  Fan fan;
  fan.closed = !mesh.is_border_vertex(v);
  const Index first = mesh.outgoing(v);
  Index h = first;
  do {
    fan.edges.push_back({h, true});
    fan.corners.push_back(h);
    const Index following = mesh.rotate(h);
    if (following == no_index) fan.edges.push_back({mesh.previous(h), false});
    h = following;
  } while (h != no_index && h != first);
  return fan;
}

class FrameBuilder {
 public:
  FrameBuilder(const Polyhedron& polyhedron, const Shaping& shaping, std::span<const FrameRequest> requests)
      : polyhedron_(polyhedron), mesh_(polyhedron.topology()), shaping_(shaping) {
    for (const FrameRequest& request : requests) requests_[request.vertex] = &request;
  }

  Result<VertexFrames> build() {
    frames_.kind.assign(mesh_.vertex_count(), FrameKind::isolated);
    frames_.ends.resize(2 * std::size_t(mesh_.half_edge_count()));
    frames_.step.assign(mesh_.half_edge_count(), 0.0);
    mark_sharp_edges();
    frames_.basis_begin.reserve(mesh_.vertex_count() + 1);
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      frames_.basis_begin.push_back(next_basis_);
      if (mesh_.outgoing(v) == no_index) continue;
      if (auto failed = build_vertex(v)) return *failed;
    }
    frames_.basis_begin.push_back(next_basis_);
    return std::move(frames_);
  }

 private:
  void mark_sharp_edges() {
    frames_.sharp.resize(mesh_.edge_count());
    for (Index e = 0; e < mesh_.edge_count(); ++e) frames_.sharp[e] = mesh_.is_border_edge(e);
    for (const auto& [id, on] : shaping_.crease)
      if (const Index e = polyhedron_.find(id); on && e != no_index) frames_.sharp[e] = true;
  }

  std::optional<Message> build_vertex(Index v) {
    fan_ = fan_of(mesh_, v);
    const VertexTag tag = shaping_.tag.get_or(polyhedron_.vertex_id(v), VertexTag::automatic);
    std::vector<std::size_t> sharp;
    for (std::size_t k = 0; k < fan_.edges.size(); ++k)
      if (frames_.sharp[mesh_.edge(fan_.edges[k].half_edge)]) sharp.push_back(k);

    if (fan_.closed && tag == VertexTag::corner && sharp.size() < 2)
      return make_error(e_corner_needs_crease,
                        "Vertex " + std::to_string(polyhedron_.vertex_id(v).value) +
                            " is tagged as a corner, but fewer than two creases meet there.",
                        "Crease two or more of its edges, or remove the tag.",
                        element_of(polyhedron_.vertex_id(v)));

    const auto requested = requests_.find(v);
    const FrameRequest* request = requested == requests_.end() ? nullptr : requested->second;
    HARIKO_ASSERT(!request || (!fan_.closed && sharp.size() == 2), "frames are asked for on plain borders");
    const bool border_tip = !fan_.closed && fan_.edges.size() == 2;
    const bool corner =
        sharp.size() >= 3 || tag == VertexTag::corner || (border_tip && tag != VertexTag::smooth);
    if (fan_.closed && sharp.size() <= 1)
      smooth_vertex(v);
    else if (request && request->line)
      sharp_line_vertex(v, sharp);
    else if (request)
      corner_vertex(v, sharp, request->opening);
    else if (corner)
      corner_vertex(v, sharp);
    else
      sharp_line_vertex(v, sharp);
    return std::nullopt;
  }

  Index take_basis(Index count) {
    const Index first = next_basis_;
    next_basis_ += count;
    return first;
  }

  void set_edge(std::size_t k, const TangentCoefficients& tangent) {
    const FanEdge& edge = fan_.edges[k % fan_.edges.size()];
    frames_.ends[2 * edge.half_edge + (edge.at_origin ? 0 : 1)] = tangent;
    const Index twin = mesh_.twin(edge.half_edge);
    if (twin != no_index) frames_.ends[2 * twin + (edge.at_origin ? 1 : 0)] = tangent;
  }
  void set_step(std::size_t corner, double step) {
    frames_.step[fan_.corners[corner % fan_.corners.size()]] = step;
  }

  void smooth_vertex(Index v) {
    const std::size_t n = fan_.edges.size();
    if (n == 2) {
      frames_.kind[v] = FrameKind::straight;
      const Index tc = take_basis(1);
      set_edge(0, {{tc, no_index}, {1, 0}});
      set_edge(1, {{tc, no_index}, {-1, 0}});
    } else {
      frames_.kind[v] = FrameKind::smooth;
      const Index ts = take_basis(2);
      for (std::size_t k = 0; k < n; ++k) {
        const double angle = 2 * pi * double(k) / double(n);
        set_edge(k, {{ts, ts + 1}, {std::sin(angle), std::cos(angle)}});
      }
    }
    for (std::size_t k = 0; k < n; ++k) set_step(k, 2 * pi / double(n));
  }

  /// Sectors between consecutive sharp edges: (first edge, number of corners).
  std::vector<std::pair<std::size_t, std::size_t>> sectors(const std::vector<std::size_t>& sharp) const {
    std::vector<std::pair<std::size_t, std::size_t>> out;
    for (std::size_t i = 0; i + 1 < sharp.size(); ++i) out.emplace_back(sharp[i], sharp[i + 1] - sharp[i]);
    if (fan_.closed) out.emplace_back(sharp.back(), fan_.edges.size() - sharp.back() + sharp.front());
    return out;
  }

  void sharp_line_vertex(Index v, const std::vector<std::size_t>& sharp) {
    frames_.kind[v] = FrameKind::sharp_line;
    const Index tc = take_basis(1);
    double sign = 1;
    for (const auto& [first, m] : sectors(sharp)) {
      const Index ts = m >= 2 ? take_basis(1) : no_index;
      for (std::size_t j = 0; j <= m; ++j) {
        const double angle = pi * double(j) / double(m);
        const bool on_line = j == 0 || j == m;
        const double cosine = j == 0 ? 1 : j == m ? -1 : std::cos(angle);
        if (on_line)
          set_edge(first + j, {{tc, no_index}, {sign * cosine, 0}});
        else
          set_edge(first + j, {{ts, tc}, {std::sin(angle), sign * cosine}});
        if (j < m) set_step(first + j, pi / double(m));
      }
      sign = -sign;
    }
  }

  /// `given`: the opening of the only sector, where it is known.
  void corner_vertex(Index v, const std::vector<std::size_t>& sharp, std::optional<double> given = {}) {
    frames_.kind[v] = FrameKind::corner;
    const Index first_basis = take_basis(static_cast<Index>(sharp.size()));
    const auto parts = sectors(sharp);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto [first, m] = parts[i];
      const Index xa = first_basis + static_cast<Index>(i);
      const Index xb = first_basis + static_cast<Index>((i + 1) % sharp.size());
      const double full = fan_.closed ? 2 * pi : pi;
      const double usual = parts.size() == 1 && !fan_.closed
                               ? pi / 2
                               : std::min(full * double(m) / double(fan_.corners.size()), 2 * pi / 3);
      const double opening = given.value_or(usual);
      const double step = opening / double(m);
      set_edge(first, {{xa, no_index}, {1, 0}});
      set_edge(first + m, {{xb, no_index}, {1, 0}});
      for (std::size_t j = 1; j < m; ++j)
        set_edge(first + j, {{xa, xb},
                             {std::sin(opening - double(j) * step) / std::sin(opening),
                              std::sin(double(j) * step) / std::sin(opening)}});
      for (std::size_t j = 0; j < m; ++j) set_step(first + j, step);
    }
  }

  const Polyhedron& polyhedron_;
  const HalfEdgeMesh& mesh_;
  const Shaping& shaping_;
  std::map<Index, const FrameRequest*> requests_;
  VertexFrames frames_;
  Fan fan_;
  Index next_basis_ = 0;
};

}  // namespace

Result<VertexFrames> build_vertex_frames(const Polyhedron& polyhedron, const Shaping& shaping,
                                         std::span<const FrameRequest> requests) {
  return FrameBuilder(polyhedron, shaping, requests).build();
}

}  // namespace hariko
