#pragma once

// Random polyhedra with borders, and sides of bicubic patches that fit their border edges.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/patching/joins/join_plan.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "core/surface/bicubic_patch.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko::test {

/// Polyhedron with joins to patches along its border.
struct JoinCase {
  Polyhedron polyhedron;
  Shaping shaping;
  std::vector<Join> joins;

  PolyhedronSurfaceInput input(Mode mode) const {
    return {polyhedron, shaping, mode, Vector3::Zero(), {}, joins};
  }
};

/// Random mesh with a border.
inline PolygonMesh random_open_mesh(std::mt19937_64& rng) {
  switch (uniform_int(rng, 0, 3)) {
    case 0:
      return grid(uniform_int(rng, 1, 4), uniform_int(rng, 1, 4));
    case 1:
      return without_face(prism(uniform_int(rng, 3, 9)), 1);
    case 2:
      return without_face(genus_box(1), std::size_t(uniform_int(rng, 0, 20)));
    default: {
      PolygonMesh one = prism(uniform_int(rng, 3, 10));
      PolygonMesh mesh;  // a single face
      std::vector<Index> face;
      for (std::size_t i = 0; i < one.positions.size() / 2; ++i) {
        mesh.positions.push_back(one.positions[i]);
        face.push_back(Index(i));
      }
      mesh.add_face(face);
      return mesh;
    }
  }
}

/// Tangent plane and tangents of the patches' sides at a border vertex.
struct BorderVertex {
  Vector3 normal, out, in;  ///< tangents from the vertex along the border, forwards and backwards
  Vector3 across;           ///< derivative across both sides where they form one smooth curve
  bool smooth = true;
  double opening = std::numbers::pi;
  Index corners = 0;
};

/// Random tangent planes and tangents at all border vertices.
inline std::vector<BorderVertex> random_border(const Polyhedron& polyhedron, std::mt19937_64& rng) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  std::vector<BorderVertex> out(mesh.vertex_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!mesh.is_border_vertex(v)) continue;
    BorderVertex& at = out[v];
    const Vector3 p = polyhedron.position(v);
    Vector3 normal = Vector3::Zero();
    Index last = no_index;
    for (Index h = mesh.outgoing(v); h != no_index; h = mesh.rotate(h)) {
      last = h;
      ++at.corners;
      normal += (polyhedron.position(mesh.target(h)) - p)
                    .cross(polyhedron.position(mesh.origin(mesh.previous(h))) - p);
    }
    at.normal = (normal.normalized() + random_vector(rng, 0.2)).normalized();
    const auto flat = [&](const Vector3& y) { return Vector3(y - at.normal * at.normal.dot(y)); };
    const Vector3 ahead = polyhedron.position(mesh.target(mesh.outgoing(v))) - p;
    const Vector3 behind = polyhedron.position(mesh.origin(mesh.previous(last))) - p;
    at.out = flat(ahead) * uniform(rng, 0.2, 0.4);
    at.in = flat(behind) * uniform(rng, 0.2, 0.4);
    at.opening = std::atan2(at.out.cross(at.in).dot(at.normal), at.out.dot(at.in));
    if (at.opening < 0) at.opening += 2 * std::numbers::pi;
    const bool possible =
        std::abs(std::sin(at.opening)) > 0.2 && (at.opening < std::numbers::pi || at.corners >= 2);
    at.smooth = !possible || chance(rng, 0.5);
    if (at.smooth) {
      const Vector3 line = flat(ahead.normalized() - behind.normalized()).normalized();
      at.out = line * uniform(rng, 0.2, 0.4) * std::min(ahead.norm(), behind.norm());
      at.in = -at.out;
      at.opening = std::numbers::pi;
    }
    const Vector3 inward = at.normal.cross(at.out.normalized());
    at.across =
        (uniform(rng, -0.3, 0.3) * at.out.normalized() - inward) * uniform(rng, 0.2, 0.5) * ahead.norm();
  }
  return out;
}

/// Polyhedron with some border edges joined to sides that fit: tangent planes agree at corners, and every
/// side admits one lambda.
inline JoinCase random_join_case(std::mt19937_64& rng, double joined = 0.75, double smooth = 0.75) {
  PolygonMesh mesh_in = random_open_mesh(rng);
  perturb(mesh_in, rng, 0.08);
  JoinCase out{Polyhedron::build(mesh_in).value(), {}, {}};
  const Polyhedron& polyhedron = out.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const auto border = random_border(polyhedron, rng);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (chance(rng, 0.3)) out.shaping.beta.set(polyhedron.edge_id(e), log_uniform(rng, 0.2, 5));
    const Index h = mesh.half_edge_of_edge(e);
    const auto at_smooth = [&](Index v) { return mesh.is_border_vertex(v) && border[v].smooth; };
    if (mesh.twin(h) != no_index && !at_smooth(mesh.origin(h)) && !at_smooth(mesh.target(h)) &&
        chance(rng, 0.15))
      out.shaping.crease.set(polyhedron.edge_id(e), true);
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (chance(rng, 0.2)) out.shaping.alpha.set(polyhedron.vertex_id(v), log_uniform(rng, 0.05, 2));

  const double speed = uniform(rng, 0.5, 1.5);
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    if (mesh.twin(h) != no_index || !chance(rng, joined)) continue;
    const BorderVertex &a = border[mesh.origin(h)], &b = border[mesh.target(h)];
    Join join;
    join.half_edge = h;
    join.continuity = chance(rng, smooth) ? Continuity::g1 : Continuity::g0;
    const Vector3 from = polyhedron.position(mesh.origin(h)), to = polyhedron.position(mesh.target(h));
    join.curve = {from, from + a.out, to + b.in, to};
    const double f = split_factor(mesh.side_count(mesh.face(h))), lambda = speed * f;
    // At a corner between two sides everything follows from their tangents.
    const auto across = [&](const BorderVertex& at, const Vector3& own, const Vector3& other) -> Vector3 {
      if (at.smooth) return at.across + uniform(rng, -0.5, 0.5) * own;
      const double step = at.opening / double(at.corners);
      const Vector3 beside =
          (std::sin(at.opening - step) * own + std::sin(step) * other) / std::sin(at.opening);
      return -(f * (own + beside) + uniform(rng, -0.3, 0.3) * own) / lambda;
    };
    const Vector3 first = across(a, a.out, a.in), last = across(b, b.in, b.out);
    const double size = 0.15 * (first.norm() + last.norm());
    join.row = {from + first, join.curve[1] + (2 * first + last) / 3 + random_vector(rng, size),
                join.curve[2] + (first + 2 * last) / 3 + random_vector(rng, size), to + last};
    out.joins.push_back(join);
  }
  return out;
}

/// Net of a patch with this side, as side 0 of its only patch. Its normals point the other way.
inline BicubicNet net_of(const Join& join) {
  BicubicNet net{1, 1, {}};
  for (int j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 4; ++i)
      net.points.push_back(join.curve[i] + j * (join.row[i] - join.curve[i]));
  return net;
}

/// Largest angle between the surface's normals and those of the patch along a joined edge, at 33 points.
inline double normal_jump(const Surface& surface, const Join& join) {
  const BicubicPatchSet patch(net_of(join));
  double largest = 0;
  for (int i = 0; i <= 32; ++i) {
    const double x = i / 32.0;
    const Vector3 own = surface.normal(join.half_edge, side_parameter(Domain::triangle, 1, x));
    const Vector3 theirs = -unit_normal(patch.evaluate(0, {x, 0}, Order::first));
    largest = std::max(largest, std::atan2(own.cross(theirs).norm(), own.dot(theirs)));
  }
  return largest;
}
/// Largest distance of the edge's curve from the side, at 33 points.
inline double gap(const Surface& surface, const Join& join) {
  const BicubicPatchSet patch(net_of(join));
  double largest = 0;
  for (int i = 0; i <= 32; ++i) {
    const double x = i / 32.0;
    const Vector3 own = surface.patches()
                            .evaluate(join.half_edge, side_parameter(Domain::triangle, 1, x), Order::first)
                            .position;
    largest = std::max(largest, (own - patch.evaluate(0, {x, 0}, Order::first).position).norm());
  }
  return largest;
}

}  // namespace hariko::test
