#include "core/g2/degrees_of_freedom.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/assert.hpp"
#include "core/g2/faces/face_chart.hpp"

namespace hariko {

namespace {

/// Map of a form (H11, H12, H22) to a frame rotated by an angle.
Matrix3 turned(double cosine, double sine) {
  const double c = cosine, s = sine;
  Matrix3 m;
  m << c * c, 2 * c * s, s * s, -c * s, c * c - s * s, c * s, s * s, -2 * c * s, c * c;
  return m;
}

/// Map to the form (H11, H12, H22) of a corner sector with opening phi from (c_a, m, c_b) = (H(a, a), H(a,
/// b), H(b, b)).
Matrix3 from_sharp_edges(double phi) {
  const double c = std::cos(phi), s = std::sin(phi);
  Matrix3 m;
  m << 1, 0, 0, -c / s, 1 / s, 0, c * c / (s * s), -2 * c / (s * s), 1 / (s * s);
  return m;
}

/// Map to the frame (J1, J2) of a corner sector with opening phi from the images of its sharp edges.
Eigen::Matrix2d frame_from_sharp_edges(double phi) {
  Eigen::Matrix2d m;
  m << 1, 0, -std::cos(phi) / std::sin(phi), 1 / std::sin(phi);
  return m;
}

class UnknownBuilder {
 public:
  UnknownBuilder(const HalfEdgeMesh& mesh, const VertexFrames& frames) : mesh_(mesh), frames_(frames) {}

  G2Unknowns build() {
    out_.corner.resize(mesh_.half_edge_count());
    out_.side.resize(mesh_.half_edge_count());
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (mesh_.outgoing(v) != no_index) add_vertex(v);
    for (Index e = 0; e < mesh_.edge_count(); ++e) add_edge(e);
    return std::move(out_);
  }

 private:
  Index take(Index count) {
    const Index first = out_.count;
    out_.count += count;
    return first;
  }
  bool opens_sector(Index h) const { return frames_.sharp[mesh_.edge(h)]; }

  /// Corners of v counter-clockwise, beginning at a sharp edge where there are several sectors.
  std::vector<Index> fan(Index v) const {
    std::vector<Index> corners;
    for (const Index h : mesh_.fan_corners(v)) corners.push_back(h);
    if (mesh_.is_border_vertex(v) || frames_.kind[v] == FrameKind::smooth ||
        frames_.kind[v] == FrameKind::straight)
      return corners;
    std::size_t begin = 0;
    while (!opens_sector(corners[begin])) ++begin;
    std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(begin), corners.end());
    return corners;
  }

  struct Sector {
    std::array<Index, 3> form;
    Matrix3 form_base = Matrix3::Identity();
    std::array<Index, 2> tangent;
    Eigen::Matrix2d tangent_base = Eigen::Matrix2d::Identity();
    bool between_sharp_edges = false;
  };

  /// Adds the corners of one sector: form and derivative of the first are base * (x[unknown...]).
  void add_sector(std::span<const Index> corners, const Sector& sector) {
    double opening = 0, angle = 0;
    for (const Index h : corners) opening += frames_.step[h];
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const double step = frames_.step[corners[k]];
      CornerUnknowns& corner = out_.corner[corners[k]];
      corner.unknown = sector.form;
      corner.tangent = sector.tangent;
      corner.opening = opening;
      corner.between_sharp_edges = sector.between_sharp_edges;
      if (is_straight(step)) {
        // Half turns leave a quadratic form unchanged and reverse both tangents.
        corner.turn = sector.form_base;
        corner.tangent_turn = (k % 2 == 0 ? 1.0 : -1.0) * sector.tangent_base;
      } else {
        const double c = std::cos(angle), s = std::sin(angle);
        corner.turn = turned(c, s) * sector.form_base;
        Eigen::Matrix2d turn;
        turn << c, s, -s, c;
        corner.tangent_turn = turn * sector.tangent_base;
      }
      angle += step;
    }
  }

  void add_vertex(Index v) {
    const std::vector<Index> corners = fan(v);
    if (frames_.kind[v] == FrameKind::smooth || frames_.kind[v] == FrameKind::straight) {
      const Index h = take(5);
      Sector sector;
      sector.form = {h, h + 1, h + 2};
      sector.tangent = {h + 3, h + 4};
      add_sector(corners, sector);
      return;
    }
    std::vector<std::size_t> begin;  // first corner of each sector
    for (std::size_t k = 0; k < corners.size(); ++k)
      if (opens_sector(corners[k])) begin.push_back(k);
    const std::size_t sectors = begin.size();
    begin.push_back(corners.size());
    const auto part = [&](std::size_t i) {
      return std::span<const Index>(corners).subspan(begin[i], begin[i + 1] - begin[i]);
    };
    if (frames_.kind[v] == FrameKind::sharp_line) {
      const Index along = take(1), tangent = take(1);
      for (std::size_t i = 0; i < sectors; ++i) {
        const Index across = take(3);
        Sector sector;
        sector.form = {along, across, across + 1};
        sector.tangent = {tangent, across + 2};
        sector.tangent_base(0, 0) = i % 2 == 0 ? 1 : -1;  // each begins with its own sharp edge
        add_sector(part(i), sector);
      }
      return;
    }
    HARIKO_ASSERT(frames_.kind[v] == FrameKind::corner, "every vertex with faces has a frame");
    const bool closed = !mesh_.is_border_vertex(v);
    const Index edges = static_cast<Index>(closed ? sectors : sectors + 1), first = take(edges),
                first_tangent = take(edges);
    for (std::size_t i = 0; i < sectors; ++i) {
      const Index a = static_cast<Index>(i), b = static_cast<Index>((i + 1) % edges);
      double phi = 0;
      for (const Index h : part(i)) phi += frames_.step[h];
      Sector sector;
      sector.form = {first + a, take(1), first + b};
      sector.form_base = from_sharp_edges(phi);
      sector.tangent = {first_tangent + a, first_tangent + b};
      sector.tangent_base = frame_from_sharp_edges(phi);
      sector.between_sharp_edges = true;
      add_sector(part(i), sector);
    }
  }

  void add_edge(Index e) {
    const Index h = mesh_.half_edge_of_edge(e), twin = mesh_.twin(h);
    const Index curve = take(1), cross = take(4);
    out_.side[h] = {{curve, cross, cross + 1, cross + 2, cross + 3}, {1, 1, 1, 1, 1}};
    if (twin == no_index) return;
    if (frames_.sharp[e]) {
      const Index other = take(4);
      out_.side[twin] = {{curve, other, other + 1, other + 2, other + 3}, {1, 1, 1, 1, 1}};
    } else {
      // Seen from the other side, t runs backwards and s points the other way.
      out_.side[twin] = {{curve, cross, cross + 1, cross + 2, cross + 3}, {1, -1, 1, 1, -1}};
    }
  }

  const HalfEdgeMesh& mesh_;
  const VertexFrames& frames_;
  G2Unknowns out_;
};

}  // namespace

G2Unknowns g2_unknowns(const HalfEdgeMesh& mesh, const VertexFrames& frames) {
  return UnknownBuilder(mesh, frames).build();
}

}  // namespace hariko
