// Invariance of the construction under affine maps, numbering, where a fan starts, where the object stands.

#include <Eigen/Geometry>
#include <numbers>
#include <numeric>

#include "core/base/parallel.hpp"
#include "core/network/network_system.hpp"
#include "core/patching/quartic/patch_constants.hpp"
#include "core/patching/quartic/quartic_patch.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/random_shaping.hpp"

namespace hariko::test {
namespace {

std::vector<QuarticPatch> patches_of(const PolyhedronSurfaceInput& input) {
  PolyhedronSurfacer surfacer;
  const auto result = must(surfacer.rebuild(input));
  return dynamic_cast<const QuarticPatchSet&>(result->surface.patches()).array().to_vector();
}

double largest(const std::vector<QuarticPatch>& patches) {
  double size = 0;
  for (const QuarticPatch& patch : patches)
    for (const Vector3& control : patch.control) size = std::max(size, control.lpNorm<Eigen::Infinity>());
  return size;
}

TEST(Invariance, AffineMapsCommuteWithTheConstruction) {
  for_random(21, 20, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_polyhedron(rng);
    Matrix3 map;
    do {
      for (int i = 0; i < 9; ++i) map.data()[i] = uniform(rng, -1, 1);
    } while (std::abs(map.determinant()) < 0.1);
    const Vector3 shift = random_vector(rng, 3);
    PolygonMesh mapped = mesh;
    for (Vector3& p : mapped.positions) p = map * p + shift;
    const Polyhedron a = Polyhedron::build(mesh).value(), b = Polyhedron::build(mapped).value();
    const Shaping shaping = random_shaping(a, rng, 10, 0.1, 10);
    for (const Mode mode : quartic_modes) {
      const auto before = patches_of({a, shaping, mode, Vector3::Zero()});
      const auto after = patches_of({b, shaping, mode, Vector3::Zero()});
      const double size = largest(after);
      for (std::size_t h = 0; h < before.size(); ++h)
        for (std::size_t i = 0; i < quartic_control_count; ++i)
          ASSERT_LT((map * before[h].control[i] + shift - after[h].control[i]).norm(), 1e-11 * size);
    }
  });
}

TEST(Invariance, NumberingAndFaceRotationDoNotMatter) {
  for_random(22, 20, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_polyhedron(rng);
    std::vector<Index> new_vertex(mesh.positions.size()), face_order(mesh.face_count());
    std::iota(new_vertex.begin(), new_vertex.end(), Index(0));
    std::iota(face_order.begin(), face_order.end(), Index(0));
    std::shuffle(new_vertex.begin(), new_vertex.end(), rng);
    std::shuffle(face_order.begin(), face_order.end(), rng);
    PolygonMesh shuffled;
    shuffled.positions.resize(mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      shuffled.positions[new_vertex[v]] = mesh.positions[v];
    std::vector<Index> turn(mesh.face_count());
    for (const Index f : face_order) {
      const auto old = mesh.face(f);
      turn[f] = static_cast<Index>(rng() % old.size());
      std::vector<Index> face;
      for (std::size_t j = 0; j < old.size(); ++j)
        face.push_back(new_vertex[old[(j + turn[f]) % old.size()]]);
      shuffled.add_face(face);
    }
    const Polyhedron a = Polyhedron::build(mesh).value(), b = Polyhedron::build(shuffled).value();
    for (const Mode mode : quartic_modes) {
      const auto before = patches_of({a, {}, mode, Vector3::Zero()});
      const auto after = patches_of({b, {}, mode, Vector3::Zero()});
      const double size = largest(before);
      for (Index k = 0; k < face_order.size(); ++k) {
        const Index f = face_order[k], n = a.topology().side_count(f);
        for (Index j = 0; j < n; ++j) {
          const QuarticPatch& x = before[a.topology().face_begin(f) + (j + turn[f]) % n];
          const QuarticPatch& y = after[b.topology().face_begin(k) + j];
          for (std::size_t i = 0; i < quartic_control_count; ++i)
            ASSERT_LT((x.control[i] - y.control[i]).norm(), 1e-11 * size);
        }
      }
    }
  });
}

TEST(Invariance, MirrorSymmetryIsKept) {
  // prism6 is symmetric in y: the reflected mesh is the same mesh with other numbers.
  for (const Mode mode : quartic_modes) {
    const PolygonMesh mesh = golden_obj("prism6.obj");
    PolygonMesh mirrored;
    for (const Vector3& p : mesh.positions) mirrored.positions.push_back({p.x(), -p.y(), p.z()});
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      std::vector<Index> face(mesh.face(f).rbegin(), mesh.face(f).rend());
      mirrored.add_face(face);
    }
    PolyhedronSurfacer first, second;
    const auto a = first.rebuild({Polyhedron::build(mesh).value(), {}, mode, Vector3::Zero()});
    const auto b = second.rebuild({Polyhedron::build(mirrored).value(), {}, mode, Vector3::Zero()});
    const auto points = [](const Surface& surface, double sign) {
      std::vector<Vector3> out;
      for (Index patch = 0; patch < surface.patch_count(); ++patch)
        for (const Vector2& at : {Vector2(1.0 / 3, 1.0 / 3), Vector2(0.2, 0.2), Vector2(0.4, 0.4)}) {
          Vector3 p = surface.patches().evaluate(patch, at, Order::first).position;
          p.y() *= sign;
          out.push_back(p);
        }
      return out;
    };
    for (const Vector3& p : points(a->surface, -1)) {
      double nearest = 1;
      for (const Vector3& q : points(b->surface, 1)) nearest = std::min(nearest, (p - q).norm());
      EXPECT_LT(nearest, 1e-12);
    }
  }
}

TEST(Invariance, MovedAMillionAwayItHasTheSameControlPoints) {
  for_random(23, 10, [](std::mt19937_64& rng) {
    PolygonMesh mesh = random_polyhedron(rng);
    for (Vector3& p : mesh.positions)  // a grid of 2^-20, so that moving is exact
      p = (p * 1048576).array().round() / 1048576;
    PolygonMesh moved = mesh;
    const Vector3 far(1048576, -2097152, 1048576);
    for (Vector3& p : moved.positions) p += far;
    const Vector3 here = origin_for(mesh.positions), there = origin_for(moved.positions);
    for (Vector3& p : mesh.positions) p -= here;
    for (Vector3& p : moved.positions) p -= there;
    for (const Mode mode : quartic_modes) {
      const auto a = patches_of({Polyhedron::build(mesh).value(), {}, mode, here});
      const auto b = patches_of({Polyhedron::build(moved).value(), {}, mode, there});
      for (std::size_t h = 0; h < a.size(); ++h)
        for (std::size_t i = 0; i < quartic_control_count; ++i) ASSERT_EQ(a[h].control[i], b[h].control[i]);
    }
    EXPECT_EQ(there - here, far);
  });
}

TEST(Invariance, ScaleFromAThousandthToAMillion) {
  std::mt19937_64 rng(24);
  const PolygonMesh mesh = random_polyhedron(rng);
  for (const double scale : {1e-3, 1e3, 1e6}) {
    PolygonMesh scaled = mesh;
    for (Vector3& p : scaled.positions) p *= scale;
    for (const Mode mode : quartic_modes) {
      const auto a = patches_of({Polyhedron::build(mesh).value(), {}, mode, Vector3::Zero()});
      const auto b = patches_of({Polyhedron::build(scaled).value(), {}, mode, Vector3::Zero()});
      const double size = largest(a);
      for (std::size_t h = 0; h < a.size(); ++h)
        for (std::size_t i = 0; i < quartic_control_count; ++i)
          ASSERT_LT((a[h].control[i] - b[h].control[i] / scale).norm(), 1e-11 * size);
    }
  }
}

TEST(Invariance, ThreadsDoNotMatter) {
  std::mt19937_64 rng(25);
  const PolyhedronSurfaceInput input{
      Polyhedron::build(torus(60, 40)).value(), {}, Mode::fair, Vector3::Zero()};
  std::vector<QuarticPatch> serial;
  {
    const ParallelLimit limit(1);
    serial = patches_of(input);
  }
  const auto parallel = patches_of(input);
  for (std::size_t h = 0; h < serial.size(); ++h)
    for (std::size_t i = 0; i < quartic_control_count; ++i)
      ASSERT_EQ(serial[h].control[i], parallel[h].control[i]);
}

TEST(Properties, FlatRegularPolygonSplitsIntoThirds) {
  for (int n = 3; n <= 20; ++n) {
    PolygonMesh mesh;
    std::vector<Index> face;
    for (int i = 0; i < n; ++i) {
      const double a = 2 * std::numbers::pi * i / n;
      mesh.positions.emplace_back(std::cos(a), std::sin(a), 0);
      face.push_back(static_cast<Index>(i));
    }
    mesh.add_face(face);
    const Polyhedron polyhedron = Polyhedron::build(mesh).value();
    // Straight edges: pin every corner's tangents to a third of its edges.
    Shaping shaping;
    for (int i = 0; i < n; ++i) {
      const Vector3 p = mesh.positions[std::size_t(i)];
      const Vector3 next = mesh.positions[std::size_t((i + 1) % n)],
                    before = mesh.positions[std::size_t((i + n - 1) % n)];
      shaping.pin.set({static_cast<std::uint32_t>(i)},
                      {Pin::Kind::tangents, {(next - p) / 3, (before - p) / 3}});
    }
    const auto patches = patches_of({polyhedron, shaping, Mode::paper, Vector3::Zero()});
    for (int j = 0; j < n; ++j) {
      const auto& d = patches[std::size_t(j)].control;
      EXPECT_LT(d[quartic::d400].norm(), 1e-14);
      const Vector3 split = 4 * (d[quartic::d130] - d[quartic::d040]) / 3;
      EXPECT_LT((split - (d[quartic::d400] - d[quartic::d040]) / 3).norm(), 1e-14) << n;
    }
  }
}

/// z = xx x^2 + xy x y + yy y^2 + x - 0.4 y over a square grid.
void expect_height_field(Mode mode, double xx, double xy, double yy) {
  const auto height = [&](double x, double y) { return xx * x * x + xy * x * y + yy * y * y + x - 0.4 * y; };
  const int n = 4;
  PolygonMesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) mesh.positions.emplace_back(i, j, height(i, j));
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      mesh.add_face({a, a + 1, a + n + 2, a + n + 1});
    }
  const Polyhedron polyhedron = Polyhedron::build(mesh).value();
  const auto frames = build_vertex_frames(polyhedron, {}).value();
  const HalfEdgeMesh& topology = polyhedron.topology();
  Shaping shaping;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
    // The basis of a smooth or border vertex is made of tangents of its own edges: Tc along e_0, Ts a quarter
    // turn on.
    const Vector3 p = mesh.positions[v];
    const double dx = 2 * xx * p.x() + xy * p.y() + 1, dy = xy * p.x() + 2 * yy * p.y() - 0.4;
    const auto along = [&](const Vector3& q) {
      const Vector2 d = (q - p).head<2>();
      return Vector3(d.x() / 3, d.y() / 3, (dx * d.x() + dy * d.y()) / 3);
    };
    std::vector<Vector3> tangents;
    Index h = topology.outgoing(v);
    do {
      tangents.push_back(along(mesh.positions[topology.target(h)]));
      const Index next = topology.rotate(h);
      if (next == no_index) tangents.push_back(along(mesh.positions[topology.origin(topology.previous(h))]));
      h = next;
    } while (h != no_index && h != topology.outgoing(v));
    const bool smooth =
        frames.kind[v] == FrameKind::smooth;  // basis Ts, Tc; Tc, Ts on a border; Xa, Xb at a corner
    shaping.pin.set(polyhedron.vertex_id(v),
                    {Pin::Kind::tangents, {tangents[smooth ? 1 : 0], tangents[smooth ? 0 : 1]}});
  }
  PolyhedronSurfacer surfacer;
  const auto result = must(surfacer.rebuild({polyhedron, shaping, mode, Vector3::Zero()}));
  for (Index patch = 0; patch < result->surface.patch_count(); ++patch)
    for (const Vector2& at :
         {Vector2(1.0 / 3, 1.0 / 3), Vector2(0.1, 0.2), Vector2(0.5, 0.4), Vector2(0.8, 0.1)}) {
      const Vector3 p = result->surface.patches().evaluate(patch, at, Order::first).position;
      EXPECT_NEAR(p.z(), height(p.x(), p.y()), 1e-13);
    }
}

TEST(Properties, QuadraticHeightFieldsAreReproduced) {
  // Tangents pinned to the field's own; then TARGET gives the field itself on a 4-valent grid. PAPER gives it
  // only where x^2 and y^2 have equal weight: round an even ring it takes the inner points whose alternating
  // sum vanishes, and that sum of the field's own points is proportional to the difference of the two.
  for (const auto& [mode, xx, yy] : {std::tuple(Mode::target, 0.3, 0.2), std::tuple(Mode::paper, 0.3, 0.3)})
    expect_height_field(mode, xx, -0.5, yy);
}

TEST(Properties, WeightRatiosComeFromTheTangents) {
  // a1 : a2 from cross products of the network's tangents equals f_right : f_left at both ends of every edge.
  for_random(26, 10, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = Polyhedron::build(random_closed_polyhedron(rng)).value();
    const auto network = must(NetworkSystem::assemble(polyhedron, {}));
    const PatchConstants constants = patch_constants(polyhedron.topology(), network->frames());
    const auto patches = patches_of({polyhedron, {}, Mode::paper, Vector3::Zero()});
    const HalfEdgeMesh& mesh = polyhedron.topology();
    for (Index h = 0; h < mesh.half_edge_count(); ++h) {
      using namespace quartic;
      const Index twin = mesh.twin(h);
      const auto& left = patches[h].control;
      const auto& right = patches[twin].control;
      const Vector3 along = left[d031] - left[d040];
      const Vector3 left_area = along.cross(left[d130] - left[d040]);
      const Vector3 right_area = (right[d103] - right[d004]).cross(along);
      if (left_area.norm() < 1e-3 * along.squaredNorm()) continue;  // parallel tangents say nothing
      // a1 : a2 = area of the right patch : area of the left patch.
      const double ratio = right_area.dot(left_area) / left_area.squaredNorm();
      EXPECT_NEAR(ratio, constants.own[h] / constants.own[twin], 1e-9 * (1 + ratio));
    }
  });
}

}  // namespace
}  // namespace hariko::test
