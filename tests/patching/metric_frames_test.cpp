// Frames by measure: the digits of an independent prototype, and what must hold for any cage.

#include <Eigen/Geometry>
#include <numbers>
#include <numeric>

#include "core/analysis/continuity.hpp"
#include "core/analysis/measures.hpp"
#include "core/network/network_system.hpp"
#include "core/patching/quartic/patch_constants.hpp"
#include "core/patching/quartic/quartic_patch.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/random_shaping.hpp"

namespace hariko::test {
namespace {

constexpr Mode metric_modes[] = {Mode::target, Mode::fair};

PolyhedronSurfaceInput metric_input(const PolygonMesh& mesh, Mode mode = Mode::fair,
                                    const Shaping& shaping = {}) {
  PolyhedronSurfaceInput input{Polyhedron::build(mesh).value(), shaping, mode, Vector3::Zero()};
  input.frames = Frames::metric;
  return input;
}

PolyhedronSurface surface_of(const PolyhedronSurfaceInput& input) {
  auto result = must(PolyhedronSurfacer().rebuild(input));
  return std::move(result).value();
}

std::vector<QuarticPatch> patches_of(const PolyhedronSurface& surface) {
  return dynamic_cast<const QuarticPatchSet&>(surface.surface.patches()).array().to_vector();
}

struct Built {
  PolyhedronSurfaceInput input;
  PolyhedronSurface made;
  VertexFrames frames;
  PatchConstants constants;

  explicit Built(const PolygonMesh& mesh) : input(metric_input(mesh)), made(surface_of(input)) {
    frames = build_vertex_frames(input.polyhedron, {}, {Frames::metric}).value();
    constants = patch_constants(input.polyhedron.topology(), frames);
  }
  const HalfEdgeMesh& mesh() const { return input.polyhedron.topology(); }
  Index half_edge(Index a, Index b) const { return mesh().find_half_edge(a, b); }
  Vector3 tangent(Index a, Index b) const { return made.network->start[half_edge(a, b)]; }
  double step(Index a, Index b) const { return frames.step[half_edge(a, b)]; }
  /// One for all corners of a vertex.
  double kappa(Index a, Index b) const {
    const Index h = half_edge(a, b);
    return frames.split_gain[h] * frames.length[2 * h] * frames.length[2 * mesh().previous(h) + 1] *
           std::sin(frames.step[h]);
  }
  Vector3 centre(Index face) const {
    return patches_of(made)[mesh().face_begin(face)].control[quartic::d400];
  }
  double c(Index a, Index b) const { return constants.c_origin[half_edge(a, b)]; }
  void expect_measures(double bending, double area, double volume) const {
    const Measures measures = measure(made.surface);
    EXPECT_NEAR(measures.bending, bending, 1e-6 * bending);
    if (area > 0) {
      EXPECT_NEAR(measures.area, area, 1e-6 * area);
    }
    if (volume > 0) {
      EXPECT_NEAR(measures.volume.value_or(0), volume, 1e-6 * volume);
    }
  }
};

void expect_vector(const Vector3& value, double x, double y, double z) {
  EXPECT_LT((value - Vector3(x, y, z)).norm(), 2e-10) << value.transpose();
}

TEST(MetricFrames, DigitsOfTheCube) {
  const Built cube(golden_obj("cube.obj"));
  const Index h = cube.half_edge(0, 3);
  EXPECT_NEAR(cube.frames.length[2 * h], 2.0000999975, 1e-10);
  EXPECT_NEAR(cube.step(0, 3), 2 * std::numbers::pi / 3, 1e-12);
  EXPECT_NEAR(cube.constants.x[h], 1, 1e-12);
  EXPECT_NEAR(cube.kappa(0, 3), 2.4496122142, 1e-10);
  EXPECT_NEAR(cube.c(0, 3), 0.2651517857, 1e-10);
  EXPECT_NEAR(cube.constants.c_split[h], 0.5303566017, 1e-10);
  expect_vector(cube.tangent(0, 3), -0.2852138153, 0.5704276305, -0.2852138153);
  expect_vector(cube.centre(0), 0, 0, -1.7162700052);
  const QuarticPatch patch = patches_of(cube.made)[0];
  expect_vector(4 * (patch.control[quartic::d310] - patch.control[quartic::d400]) / 3, -0.4208403100,
                -0.4208403100, 0);
  expect_vector(patch.control[quartic::d211w], -0.6802869547, -0.0125967074, -1.7162700052);
  expect_vector(patch.control[quartic::d121w], -0.9956867373, -0.3340388707, -1.5139785225);
  expect_vector(patch.control[quartic::d121u], -1.0027166656, -0.3281198300, -1.5172943300);
  const Vector3 middle = cube.made.surface.patches().evaluate(0, {1.0 / 3, 1.0 / 3}, Order::first).position;
  expect_vector(middle, -0.8419374731, 0, -1.4935447791);
  cube.expect_measures(25.234114, 37.146005, 21.285250);
}

TEST(MetricFrames, DigitsOfThePrism) {
  const Built prism(golden_obj("prism6.obj"));
  EXPECT_NEAR(prism.step(0, 5), 2.5132741229, 1e-10);
  EXPECT_NEAR(prism.step(0, 1), 1.8849555922, 1e-10);
  EXPECT_NEAR(prism.step(0, 6), 1.8849555922, 1e-10);
  EXPECT_NEAR(prism.kappa(0, 1), 2.1940740919, 1e-10);
  EXPECT_NEAR(prism.constants.x[prism.half_edge(0, 5)], 0.4330127019, 1e-10);
  EXPECT_NEAR(prism.constants.x[prism.half_edge(0, 6)], 0.5, 1e-10);
  EXPECT_NEAR(prism.c(0, 1), 0.2007015656, 2e-10);
  EXPECT_NEAR(prism.c(0, 6), 0.3656242774, 2e-10);
  EXPECT_NEAR(prism.constants.c_split[prism.half_edge(0, 5)], 0.2320981671, 1e-10);
  EXPECT_NEAR(prism.constants.c_split[prism.half_edge(0, 1)], 0.6503615397, 1e-10);
  const NetworkWeights weights = network_weights(prism.mesh(), prism.frames);
  const double mean = prism.frames.charts.mean_length;
  const auto share = [&](double weight, double length) { return weight * std::sqrt(length / mean); };
  EXPECT_NEAR(share(weights.edge[prism.mesh().edge(prism.half_edge(0, 1))], 1), 0.2092236522, 1e-10);
  EXPECT_NEAR(share(weights.edge[prism.mesh().edge(prism.half_edge(0, 6))], 2), 0.0815526957, 1e-10);
  EXPECT_NEAR(share(weights.ray[prism.half_edge(0, 5)], 1), 0.2, 1e-10);
  EXPECT_NEAR(share(weights.ray[prism.half_edge(0, 1)], std::hypot(0.5, 1)), 0.15, 1e-10);
  expect_vector(prism.tangent(0, 5), -0.0450698618, -0.3363699060, -0.0922432545);
  expect_vector(prism.tangent(0, 6), 0.2916545324, 0, 0.5969213618);
  expect_vector(prism.centre(0), 0, 0, -1.5222369142);
  prism.expect_measures(28.253503, 23.151760, 10.286837);
}

TEST(MetricFrames, DigitsOfUnevenCages) {
  const Built fig2(golden_obj("fig2.obj"));
  EXPECT_NEAR(fig2.step(6, 0), 1.5917987522, 1e-10);
  EXPECT_NEAR(fig2.step(6, 7), 1.5497939013, 1e-10);
  EXPECT_NEAR(fig2.kappa(6, 0), 2.3409958778, 2e-10);
  const Index corner = fig2.half_edge(6, 0);  // corner of the face (0, 1, 7, 6)
  EXPECT_NEAR(fig2.constants.x[corner], 0.3666550135, 1e-10);
  EXPECT_NEAR(fig2.constants.x[fig2.half_edge(7, 6)], 0.3790221624, 1e-10);
  EXPECT_NEAR(fig2.c(6, 0), 0.3756865274, 1e-10);
  EXPECT_NEAR(fig2.c(6, 7), 0.3534022385, 1e-10);
  EXPECT_NEAR(fig2.c(6, 12), 0.3540501779, 1e-10);
  expect_vector(fig2.tangent(6, 0), 0.0638781980, 0, -0.3186011378);
  expect_vector(fig2.tangent(6, 7), -0.0022662161, 0.5803810262, 0.0113030590);
  fig2.expect_measures(30.174212, 29.245241, 14.372056);

  const Built cylinder(prism(32));
  EXPECT_NEAR(cylinder.step(0, 31), 3.0401775024, 1e-10);
  EXPECT_NEAR(cylinder.step(0, 1), 1.6215039024, 1e-10);
  EXPECT_NEAR(cylinder.kappa(0, 1), 2.0176393938, 1e-10);
  expect_vector(cylinder.tangent(0, 31), -0.0022371341, -0.0661396748, -0.0026998487);
  expect_vector(cylinder.tangent(0, 32), 0.4479983802, 0, 0.5406595176);
  expect_vector(cylinder.centre(0), 0, 0, -1.4531838825);
  cylinder.expect_measures(25.596686, 0, 11.130805);

  const Built torus(golden_obj("torus.obj"));
  EXPECT_NEAR(torus.kappa(0, 4), 2.3189028016, 1e-10);
  expect_vector(torus.tangent(0, 4), 0, 0.7739158232, 0);
  expect_vector(torus.tangent(0, 1), 0, 0, 0.4699199503);
  expect_vector(torus.centre(0), 2.5131073639, 1.0409631538, 0.6170613768);
  torus.expect_measures(95.795445, 0, 0);

  Built(golden_obj("car.obj")).expect_measures(178.217934, 28.322115, 10.091807);
}

PolygonMesh tall_prism(int sides, double height) {
  PolygonMesh mesh = prism(sides);
  for (Vector3& p : mesh.positions) p.z() *= height / 2;
  return mesh;
}

/// Two regular n-gons of radius 1 at z = -1 and 1, turned by half a side, and triangles between them.
PolygonMesh antiprism(int n) {
  PolygonMesh mesh;
  for (const double turn : {0.0, 0.5})
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * (i + turn) / n;
      mesh.positions.emplace_back(std::cos(angle), std::sin(angle), turn > 0 ? 1.0 : -1.0);
    }
  const auto at = [n](int ring, int i) { return static_cast<Index>(ring * n + i % n); };
  std::vector<Index> bottom, top;
  for (int i = 0; i < n; ++i) {
    bottom.push_back(at(0, n - 1 - i));
    top.push_back(at(1, i));
  }
  mesh.add_face(bottom);
  mesh.add_face(top);
  for (int i = 0; i < n; ++i) {
    mesh.add_face({at(0, i), at(0, i + 1), at(1, i)});
    mesh.add_face({at(0, i + 1), at(1, i + 1), at(1, i)});
  }
  return mesh;
}

PolygonMesh tall_pyramid(int sides) {
  PolygonMesh mesh = pyramid(sides);
  mesh.positions.back().z() = 1.5;
  return mesh;
}

TEST(MetricFrames, BendingAndVolumeOfKnownCages) {
  struct Row {
    const char* name;
    PolygonMesh mesh;
    double bending, volume;
  };
  // Prisms of 7 sides and more with straightened rims, those of 128 with short edges that keep their lengths.
  const std::vector<Row> rows = {
      {"prism 3", tall_prism(3, 2), 26.72, 10.36},
      {"prism 4", tall_prism(4, 2), 27.06, 10.53},
      {"prism 5", tall_prism(5, 2), 28.09, 10.33},
      {"prism 8", tall_prism(8, 2), 27.74, 10.40},
      {"prism 12", tall_prism(12, 2), 26.54, 10.76},
      {"prism 20", tall_prism(20, 2), 25.79, 11.01},
      {"prism 64", tall_prism(64, 2), 25.66, 11.23},
      {"prism 128", tall_prism(128, 2), 26.34, 11.24},
      {"tall prism 3", tall_prism(3, 20), 190.86, 69.53},
      {"tall prism 6", tall_prism(6, 20), 148.35, 77.71},
      {"tall prism 12", tall_prism(12, 20), 134.86, 93.58},
      {"tall prism 32", tall_prism(32, 20), 129.05, 102.33},
      {"tall prism 128", tall_prism(128, 20), 129.90, 104.79},
      {"coin 6", tall_prism(6, 0.2), 113.28, 1.60},
      {"coin 12", tall_prism(12, 0.2), 182.78, 1.32},
      {"coin 32", tall_prism(32, 0.2), 243.69, 1.11},
      {"pyramid 3", tall_pyramid(3), 27.02, 4.21},
      {"pyramid 4", tall_pyramid(4), 27.52, 4.42},
      {"pyramid 6", tall_pyramid(6), 28.00, 4.38},
      {"pyramid 16", tall_pyramid(16), 28.10, 4.57},
      {"antiprism 4", antiprism(4), 27.64, 10.32},
      {"antiprism 6", antiprism(6), 28.27, 10.22},
      {"antiprism 12", antiprism(12), 26.15, 10.88},
      {"octahedron", octahedron(), 25.65, 3.90},
      {"genus 3", golden_obj("genus3.obj"), 221.99, 24.81},
      {"open figure", golden_obj("fig2_open.obj"), 29.42, 0},
      {"grid", golden_obj("grid3.obj"), 1.63, 0},
      {"concave", golden_obj("concave.obj"), 200.86, 17.97},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    const PolyhedronSurface made = surface_of(metric_input(row.mesh));
    const Measures measures = measure(made.surface);
    EXPECT_NEAR(measures.bending, row.bending, 0.005 * row.bending);
    if (row.volume > 0) {
      EXPECT_NEAR(measures.volume.value_or(0), row.volume, 0.006 * row.volume);
    }
    EXPECT_LE(*continuity(made.surface).largest_normal_jump, 1e-11);
  }
}

TEST(MetricFrames, RandomPolyhedraAreSmooth) {
  for_random(71, 60, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_polyhedron(rng);
    const Shaping shaping = random_shaping(Polyhedron::build(mesh).value(), rng, 1000, 0.001, 1000);
    for (const Mode mode : metric_modes) {
      const auto input = metric_input(mesh, mode, shaping);
      const PolyhedronSurface made = surface_of(input);
      EXPECT_TRUE(made.report.fair_converged) << made.report.fair_iterations;
      const ContinuityReport report = continuity(made.surface);
      EXPECT_LE(report.largest_normal_jump.value_or(0), 1e-10) << "mode " << int(mode);
      EXPECT_LE(report.largest_gap, 1e-13 * size_of(input.polyhedron));
    }
  });
}

TEST(MetricFrames, PinnedVerticesAreSmooth) {
  for_random(72, 20, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_closed_polyhedron(rng);
    const Polyhedron polyhedron = Polyhedron::build(mesh).value();
    const auto frames = build_vertex_frames(polyhedron, {}).value();
    Shaping shaping;
    for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
      if (frames.kind[v] != FrameKind::smooth || !chance(rng, 0.5)) continue;
      const Vector3 a = random_vector(rng), b = random_vector(rng);
      if (chance(rng, 0.5))
        shaping.pin.set(polyhedron.vertex_id(v), {Pin::Kind::tangents, {0.3 * a, 0.3 * b}});
      else
        shaping.pin.set(polyhedron.vertex_id(v), {Pin::Kind::normal, {a}});
    }
    for (const Mode mode : metric_modes) {
      const PolyhedronSurface made = surface_of(metric_input(mesh, mode, shaping));
      EXPECT_LE(continuity(made.surface).largest_normal_jump.value_or(0), 1e-10) << "mode " << int(mode);
    }
    // The basis vectors of a pin mean what they mean in equal frames.
    const PolyhedronSurface made = surface_of(metric_input(mesh, Mode::fair, shaping));
    for (const auto& [id, pin] : shaping.pin) {
      if (pin.kind != Pin::Kind::tangents) continue;
      const Index h = polyhedron.topology().outgoing(polyhedron.find(id));
      EXPECT_LT((made.network->start[h] - pin.vectors[1]).norm(), 1e-12);
    }
  });
}

TEST(MetricFrames, PrismsDoNotFold) {
  for (const int sides : {3, 4, 5, 7, 12, 31, 64, 128})
    for (const double height : {0.1, 1.0, 10.0, 100.0}) {
      SCOPED_TRACE(std::to_string(sides) + " sides, height " + std::to_string(height));
      const PolyhedronSurface made = surface_of(metric_input(tall_prism(sides, height)));
      for (const Message& warning : made.warnings) EXPECT_FALSE(warning.code == w_fold) << to_string(warning);
      const ContinuityReport report = continuity(made.surface);
      EXPECT_LE(*report.largest_normal_jump, 1e-10);
      EXPECT_EQ(report.folded_samples, 0U);
    }
}

double largest_difference(const std::vector<QuarticPatch>& a, const std::vector<QuarticPatch>& b) {
  double out = 0;
  for (std::size_t h = 0; h < a.size(); ++h)
    for (std::size_t i = 0; i < quartic_control_count; ++i)
      out = std::max(out, (a[h].control[i] - b[h].control[i]).norm());
  return out;
}

TEST(MetricFrames, SimilaritiesCommuteWithTheConstruction) {
  for_random(73, 20, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_polyhedron(rng);
    const Shaping shaping = random_shaping(Polyhedron::build(mesh).value(), rng, 10, 0.1, 10);
    const Matrix3 turn =
        Eigen::AngleAxisd(uniform(rng, 0, 6), random_vector(rng).normalized()).toRotationMatrix();
    const double scale = log_uniform(rng, 1e-3, 1e6);
    PolygonMesh mapped = mesh;
    for (Vector3& p : mapped.positions) p = scale * (turn * p);
    for (const Mode mode : metric_modes) {
      auto before = patches_of(surface_of(metric_input(mesh, mode, shaping)));
      for (QuarticPatch& patch : before)
        for (Vector3& point : patch.control) point = scale * (turn * point);
      const auto after = patches_of(surface_of(metric_input(mapped, mode, shaping)));
      EXPECT_LT(largest_difference(before, after), 1e-11 * scale * size_of(Polyhedron::build(mesh).value()));
    }
  });
}

TEST(MetricFrames, MirrorsAndNumberingDoNotMatter) {
  for_random(74, 20, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_polyhedron(rng);
    const double size = size_of(Polyhedron::build(mesh).value());
    // Each face the other way round, from the same corner, over mirrored positions.
    PolygonMesh mirrored;
    std::vector<Index> order(mesh.face_count());
    std::iota(order.begin(), order.end(), Index(0));
    std::shuffle(order.begin(), order.end(), rng);
    for (const Vector3& p : mesh.positions) mirrored.positions.emplace_back(-p.x(), p.y(), p.z());
    std::vector<std::size_t> begin(mesh.face_count() + 1, 0), mirrored_begin(mesh.face_count());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) begin[f + 1] = begin[f] + mesh.face(f).size();
    std::size_t next = 0;
    for (const Index f : order) {
      std::vector<Index> face(mesh.face(f).begin(), mesh.face(f).end());
      std::reverse(face.begin() + 1, face.end());
      mirrored.add_face(face);
      mirrored_begin[f] = next;
      next += face.size();
    }
    for (const Mode mode : metric_modes) {
      const auto before = patches_of(surface_of(metric_input(mesh, mode)));
      const auto after = patches_of(surface_of(metric_input(mirrored, mode)));
      for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::size_t n = begin[f + 1] - begin[f];
        for (std::size_t j = 0; j < n; ++j) {
          // Patch j, over the side from corner j to j + 1, is the image of patch n - 1 - j, turned round.
          const QuarticPatch& a = before[begin[f] + j];
          const QuarticPatch& b = after[mirrored_begin[f] + n - 1 - j];
          const auto near = [&](std::size_t i, std::size_t k) {
            const Vector3 image(-a.control[i].x(), a.control[i].y(), a.control[i].z());
            ASSERT_LT((image - b.control[k]).norm(), 1e-11 * size);
          };
          near(quartic::d400, quartic::d400);
          near(quartic::d310, quartic::d301);
          near(quartic::d211w, quartic::d211v);
          near(quartic::d121w, quartic::d112v);
          near(quartic::d121u, quartic::d112u);
          near(quartic::d022, quartic::d022);
        }
      }
    }
  });
}

TEST(MetricFrames, SmallMovesMoveLittle) {
  for_random(75, 40, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_polyhedron(rng);
    const auto input = metric_input(mesh);
    const double mean =
        metric_charts(input.polyhedron, std::vector<bool>(input.polyhedron.topology().half_edge_count()))
            .mean_length;
    PolygonMesh moved = mesh;
    for (Vector3& p : moved.positions) p += random_vector(rng, 1e-7 * mean / std::sqrt(3.0));
    const auto before = patches_of(surface_of(input)), after = patches_of(surface_of(metric_input(moved)));
    EXPECT_LT(largest_difference(before, after), 1e-5 * mean);
  });
}

TEST(MetricFrames, DegenerateCagesStayFinite) {
  const auto expect_bounded = [](const PolygonMesh& mesh, const char* what, double bound) {
    for (const Mode mode : metric_modes) {
      SCOPED_TRACE(what);
      for (const QuarticPatch& patch : patches_of(surface_of(metric_input(mesh, mode))))
        for (const Vector3& point : patch.control) {
          ASSERT_TRUE(point.allFinite());
          ASSERT_LT(point.norm(), bound);
        }
    }
  };
  PolygonMesh flat = cube(), needle = cube(), doubled = cube(), point = cube();
  for (Vector3& p : flat.positions) p.z() = 0;
  for (Vector3& p : needle.positions) p.x() *= 1e-9;
  doubled.positions[0] = doubled.positions[1];
  for (Vector3& p : point.positions) p.setZero();
  expect_bounded(flat, "flat", 5);
  expect_bounded(needle, "needle", 5);
  expect_bounded(doubled, "two vertices in one place", 40);
  expect_bounded(point, "all in one place", 1e-6);
}

TEST(MetricFrames, ModePaperKeepsEqualFrames) {
  auto input = metric_input(golden_obj("fig2.obj"), Mode::paper);
  const PolyhedronSurface metric = surface_of(input);
  input.frames = Frames::equal;
  const PolyhedronSurface equal = surface_of(input);
  for (Index p = 0; p < equal.surface.patches().patch_count(); ++p)
    EXPECT_EQ(metric.surface.patches().evaluate(p, {0.3, 0.3}, Order::first).position,
              equal.surface.patches().evaluate(p, {0.3, 0.3}, Order::first).position);
}

TEST(MetricFrames, AFinalSurfaceDoesNotDependOnDragsBefore) {
  const PolygonMesh mesh = golden_obj("fig2.obj");
  PolygonMesh moved = mesh;
  moved.positions[6].z() += 0.2;
  PolyhedronSurfacer surfacer;
  ASSERT_TRUE(surfacer.rebuild(metric_input(mesh)).ok());
  auto input = metric_input(mesh);
  const Polyhedron start = input.polyhedron;
  input.polyhedron =
      start.with_positions(std::vector<Index>{6}, std::vector<Vector3>{moved.positions[6]}).value();
  ASSERT_TRUE(surfacer.rebuild(input, Quality::drag).ok());
  const auto last = must(surfacer.rebuild(input));
  EXPECT_EQ(largest_difference(patches_of(*last), patches_of(surface_of(metric_input(moved)))), 0);
}

TEST(MetricFrames, SmallObjectsDoNotJumpWhenADragEnds) {
  for (const char* name : {"cube.obj", "fig2.obj", "car.obj"}) {
    SCOPED_TRACE(name);
    auto input = metric_input(golden_obj(name));
    const Polyhedron start = input.polyhedron;
    const double size = size_of(start);
    PolyhedronSurfacer surfacer;
    ASSERT_TRUE(surfacer.rebuild(input).ok());
    std::vector<QuarticPatch> last;
    for (int step = 1; step <= 5; ++step) {
      const Vector3 to = start.position(0) + 0.05 * step * size * Vector3(0.5, -0.3, 0.8);
      input.polyhedron = start.with_positions(std::vector<Index>{0}, std::vector<Vector3>{to}).value();
      const auto frame = must(surfacer.rebuild(input, Quality::drag));
      EXPECT_LE(*continuity(frame->surface).largest_normal_jump, 1e-10);
      last = patches_of(*frame);
    }
    EXPECT_LT(largest_difference(last, patches_of(surface_of(input))), 1e-4 * size);
  }
}

TEST(MetricFrames, LargeObjectsAreSmoothInADragAndExactAtItsEnd) {
  auto input = metric_input(torus(24, 12));
  const Polyhedron start = input.polyhedron;
  PolyhedronSurfacer surfacer;
  ASSERT_TRUE(surfacer.rebuild(input).ok());
  const Vector3 to = start.position(7) + Vector3(0.1, 0.05, 0.1);
  input.polyhedron = start.with_positions(std::vector<Index>{7}, std::vector<Vector3>{to}).value();
  const auto frame = must(surfacer.rebuild(input, Quality::drag));
  EXPECT_LE(*continuity(frame->surface).largest_normal_jump, 1e-7);
  const auto last = must(surfacer.rebuild(input));
  EXPECT_EQ(largest_difference(patches_of(*last), patches_of(surface_of(input))), 0);
}

TEST(MetricFrames, BoxesWithALoopNearTheirEnd) {
  // Bending by the prototype at a tenth, and no folds to a fortieth of the edges.
  for (const double gap : {0.2, 0.1, 0.05}) {
    PolygonMesh mesh;
    for (const double z : {-1.0, 1 - gap, 1.0})
      for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        mesh.positions.emplace_back(x, y, z);
    mesh.add_face({3, 2, 1, 0});
    mesh.add_face({8, 9, 10, 11});
    for (Index ring = 0; ring < 2; ++ring)
      for (Index i = 0; i < 4; ++i)
        mesh.add_face({4 * ring + i, 4 * ring + (i + 1) % 4, 4 * ring + 4 + (i + 1) % 4, 4 * ring + 4 + i});
    const PolyhedronSurface made = surface_of(metric_input(mesh));
    for (const Message& warning : made.warnings)
      EXPECT_FALSE(warning.code == w_fold) << to_string(warning) << " " << gap;
    if (gap == 0.2) {
      EXPECT_NEAR(measure(made.surface).bending, 167.18, 0.5);
    }
  }
}

}  // namespace
}  // namespace hariko::test
