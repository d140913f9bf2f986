// Mirror images of objects of every kind: where their points lie, what they look at, and that the image of an
// image is the object again.

#include <Eigen/Geometry>
#include <array>
#include <map>

#include "core/analysis/quadrature.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/file.hpp"
#include "core/modeling/objects/arrange.hpp"
#include "core/modeling/objects/parabolic_grid.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "core/polyhedron/volume.hpp"
#include "tests/modeling/support.hpp"
#include "tests/support/places.hpp"

namespace hariko {
namespace {

Source source_of_sample(const char* name) {
  return load_document(test::source_folder() + "/assets/samples/" + name + ".hariko")
      .value()
      .objects[0]
      ->source;
}

/// Two patches of degree 2 by 1 that bulge upwards.
Source bulging_patches() {
  std::vector<BezierPatch> patches;
  for (const double x : {0.0, 2.0}) {
    BezierPatch& patch = patches.emplace_back();
    patch.degree_s = 2;
    patch.degree_t = 1;
    for (const double y : {0.0, 3.0})
      for (int i = 0; i < 3; ++i) patch.points.emplace_back(x + i, y, 1 + (i == 1 ? 0.5 : 0.0) + 0.1 * y);
  }
  return BezierSource::from_patches(std::move(patches)).value();
}

/// One of each kind, none of them symmetric to a coordinate plane.
std::map<std::string, Source> mirrorable_sources() {
  std::mt19937_64 rng(511);
  PolygonMesh mesh = test::prism(5);
  test::perturb(mesh, rng, 0.15);
  for (Vector3& p : mesh.positions) p += Vector3(0.7, 0.3, -0.4);
  std::map<std::string, Source> out;
  out.emplace("polyhedron", PolyhedronSource::from_mesh(mesh).value());
  out.emplace("mesh", MeshSource::from_mesh(mesh).value());
  BicubicNet net = parabolic_grid(2, 3, 2, 3, 0.4);
  for (Vector3& p : net.points) p += test::random_vector(rng, 0.05) + Vector3(0.5, 0.2, 1);
  out.emplace("patches", PatchSource::from_net(net).value());
  out.emplace("bezier", bulging_patches());
  out.emplace("solids", source_of_sample("solids_t"));
  out.emplace("skin", source_of_sample("skin_smooth"));
  out.emplace("outline", source_of_sample("sphere_cap"));
  return out;
}

/// Area, flux of the place through the surface (three volumes of a closed one), and the vector area.
struct SurfaceMoments {
  double area = 0, flux = 0;
  Vector3 vector_area = Vector3::Zero();
};

SurfaceMoments moments_of(const Document& document, ObjectId id) {
  const Object& object = *document.find(id);
  const auto made = object_surface(document, object);
  SurfaceMoments out;
  if (!made.ok()) {
    ADD_FAILURE() << to_string(made.error());
    return out;
  }
  const PatchSet& patches = made->surface.patches();
  const DomainRule rule = gauss_rule(patches.domain(), 4);
  for (Index patch = 0; patch < patches.patch_count(); ++patch)
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const PatchPoint at = patches.evaluate(patch, rule.points[i], Order::first);
      const Vector3 place = object.transform.apply(made->surface.origin() + at.position);
      const Vector3 normal =
          object.transform.scale * object.transform.scale * (object.transform.rotation * at.ds.cross(at.dt));
      out.area += rule.weights[i] * normal.norm();
      out.flux += rule.weights[i] * normal.dot(place);
      out.vector_area += rule.weights[i] * normal;
    }
  return out;
}

TEST(MirroredCopies, SurfacesAreReflectedAndLookOutwards) {
  for (const auto& [kind, source] : mirrorable_sources()) {
    if (kind == "mesh") continue;
    for (const int axis : {0, 1, 2}) {
      SCOPED_TRACE(kind + " across axis " + std::to_string(axis));
      const MirrorPlane plane{axis, 0};
      const auto one = add_object({}, "Thing", source).value();
      const auto added = test::must(mirrored_copies(one.document, std::array{one.id}, plane));
      const SurfaceMoments own = moments_of(one.document, one.id);
      const SurfaceMoments image = moments_of(added->document, added->ids[0]);
      // Surfaces of solids and outlines choose their patches anew.
      const double share = kind == "solids" || kind == "outline" || kind == "skin" ? 0.02 : 1e-9;
      ASSERT_GT(own.area, 0);
      const double size = world_box(*one.document.objects[0]).diagonal().norm();
      EXPECT_NEAR(image.area, own.area, share * own.area);
      EXPECT_NEAR(image.flux, own.flux, share * own.area * size) << "it is inside out";
      EXPECT_LE((image.vector_area - plane.image(own.vector_area)).norm(), share * own.area);
    }
  }
}

TEST(MirroredCopies, FacetsLookOutwards) {
  const Source source = mirrorable_sources().at("mesh");
  const auto one = add_object({}, "Thing", source).value();
  const auto added = test::must(mirrored_copies(one.document, std::array{one.id}, {1, 2}));
  const MeshSource &own = *one.document.objects[0]->mesh(), &image = *added->document.objects[1]->mesh();
  const auto volume = [](const MeshSource& mesh) {
    const auto polyhedron = Polyhedron::build(*mesh.mesh).value();
    return closed_component_volumes(polyhedron.topology(), polyhedron.positions())[0];
  };
  EXPECT_GT(volume(own), 0);
  EXPECT_NEAR(volume(image), volume(own), 1e-12 * volume(own));
}

Similarity placed_at_will(std::mt19937_64& rng, double scale, const Vector3& far) {
  Similarity place;
  place.rotation = Eigen::Quaterniond(test::uniform(rng, 0.1, 1), test::uniform(rng, -1, 1),
                                      test::uniform(rng, -1, 1), test::uniform(rng, -1, 1))
                       .normalized();
  place.scale = test::log_uniform(rng, 1e-3, 1e3) * scale;
  place.translation = test::random_vector(rng, 10 * scale) + far;
  return place;
}

TEST(MirroredCopies, BoxesAreReflectedWhereverTheyStand) {
  const auto sources = mirrorable_sources();
  for (const double scale : {1e-3, 1.0, 1e6})
    test::for_random(512, 4, [&](std::mt19937_64& rng) {
      const Vector3 far = test::chance(rng, 0.5) ? test::random_vector(rng, 1e6) : Vector3(Vector3::Zero());
      const MirrorPlane plane{test::uniform_int(rng, 0, 2), test::uniform(rng, -5, 5) * scale};
      for (const auto& [kind, source] : sources) {
        SCOPED_TRACE(kind);
        if (kind == "solids") continue;  // their boxes are not those of their points
        const auto one = add_object({}, "Thing", source, placed_at_will(rng, scale, far)).value();
        const auto added = test::must(mirrored_copies(one.document, std::array{one.id}, plane));
        Eigen::AlignedBox3d wanted;
        const Eigen::AlignedBox3d own = world_box(*one.document.objects[0]);
        wanted.extend(plane.image(own.min()));
        wanted.extend(plane.image(own.max()));
        const Eigen::AlignedBox3d image = world_box(*added->document.objects[1]);
        const double tolerance =
            1e-12 * (own.diagonal().norm() + own.min().norm() + own.max().norm() + std::abs(plane.position));
        EXPECT_LE((image.min() - wanted.min()).norm(), tolerance);
        EXPECT_LE((image.max() - wanted.max()).norm(), tolerance);
      }
    });
}

TEST(MirroredCopies, TheImageOfTheImageIsTheObjectAgain) {
  const auto sources = mirrorable_sources();
  test::for_random(513, 8, [&](std::mt19937_64& rng) {
    const MirrorPlane plane{test::uniform_int(rng, 0, 2), test::chance(rng, 0.5) ? 0 : test::uniform(rng)};
    for (const auto& [kind, source] : sources) {
      SCOPED_TRACE(kind);
      const auto one = add_object({}, "Thing", source, placed_at_will(rng, 1, Vector3::Zero())).value();
      const auto once = test::must(mirrored_copies(one.document, std::array{one.id}, plane));
      const auto twice = test::must(mirrored_copies(once->document, once->ids, plane));
      const Object &own = *one.document.objects[0], &again = *twice->document.find(twice->ids[0]);
      EXPECT_LE((again.transform.translation - own.transform.translation).norm(),
                1e-14 * (1 + own.transform.translation.norm()));
      EXPECT_LE(again.transform.rotation.angularDistance(own.transform.rotation), 1e-12);
      EXPECT_EQ(again.transform.scale, own.transform.scale);
      if (kind != "solids") {
        EXPECT_TRUE(again.source == own.source);
        continue;
      }
      const auto &a = own.solids()->input->solids, &b = again.solids()->input->solids;
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].position, b[i].position);
        EXPECT_LE((a[i].rotation - b[i].rotation).norm(), 1e-12);
      }
    }
  });
}

TEST(MirroredCopies, PointsOfATurnedPolyhedronAreReflectedOneByOne) {
  test::for_random(514, 40, [](std::mt19937_64& rng) {
    const PolyhedronSource source = test::random_shape_source(rng);
    const auto one = add_object({}, "Thing", source, placed_at_will(rng, 1, Vector3::Zero())).value();
    const MirrorPlane plane{test::uniform_int(rng, 0, 2), test::uniform(rng, -5, 5)};
    const auto added = test::must(mirrored_copies(one.document, std::array{one.id}, plane));
    const Object &own = *one.document.objects[0], &image = *added->document.objects[1];
    const Polyhedron &a = own.polyhedron()->polyhedron, &b = image.polyhedron()->polyhedron;
    ASSERT_EQ(a.vertex_count(), b.vertex_count());
    for (Index v = 0; v < a.vertex_count(); ++v) {
      const Vector3 place = own.transform.apply(own.cage_origin() + a.position(v));
      const Index w = b.find(a.vertex_id(v));
      ASSERT_NE(w, no_index);
      EXPECT_LE((image.transform.apply(image.cage_origin() + b.position(w)) - plane.image(place)).norm(),
                1e-12 * (1 + place.norm() + own.transform.scale * own.cage_origin().norm()));
    }
    EXPECT_EQ(Vector3(image.cage_origin().cwiseAbs()), Vector3(own.cage_origin().cwiseAbs()))
        << "no digits are lost far away";
  });
}

TEST(MirroredCopies, LiveMirrorsAndPlanesOfSymmetryStay) {
  PolyhedronSource half = PolyhedronSource::from_mesh(test::grid(2, 2)).value();
  half.mirror = Mirror{Axis::y, 0.01};
  SolidsSource solids = std::get<SolidsSource>(source_of_sample("solids_t"));
  EnvelopeInput input = *solids.input;
  input.settings.symmetry = SymmetryPlane::z;
  solids.input = input;
  Skin skin = *std::get<SkinSource>(source_of_sample("skin_smooth")).skin;
  skin.mirror = MirrorPlane{0, 3};
  Document document = add_object({}, "Half", half)->document;
  document = add_object(document, "Solids", solids)->document;
  document = add_object(document, "Skin", SkinSource{skin, {}})->document;
  const std::vector<ObjectId> ids{{1}, {2}, {3}};
  const auto added = test::must(mirrored_copies(document, ids, {0, 0}));
  const auto image = [&](std::size_t i) -> const Object& { return *added->document.find(added->ids[i]); };
  EXPECT_EQ(image(0).polyhedron()->mirror, half.mirror);
  EXPECT_EQ(image(1).solids()->input->settings.symmetry, SymmetryPlane::z);
  EXPECT_EQ(image(2).skin()->skin->mirror, (MirrorPlane{0, -3}));
}

TEST(MirroredCopies, FrozenSidesAreReflected) {
  Document document = document_from_mesh(test::grid(1, 1), "Sheet").value();
  const ObjectId sheet = document.objects[0]->id;
  BicubicNet net{1, 1, {}};
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) net.points.emplace_back(-1 + 2 * i / 3.0, -1 - j / 3.0, 0.2 * i);
  const auto with_patch = add_object(document, "Patch", PatchSource::from_net(net).value()).value();
  const EdgeId edge{VertexId{0}, VertexId{1}};
  const auto side = nearest_side(with_patch.document, *with_patch.document.find(sheet), edge);
  ASSERT_TRUE(side);
  const auto joined = test::must(attach_edge(with_patch.document, sheet, edge, *side));
  const auto added = test::must(mirrored_copies(*joined, std::array{sheet}, {0, 0}));
  const Document cut = duplicate_object(*joined, sheet)->document;
  const auto& own = *cut.objects[1]->polyhedron()->attachments->find(edge)->frozen;
  const auto& image = *added->document.find(added->ids[0])->polyhedron()->attachments->find(edge)->frozen;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(image.curve[i], (MirrorPlane{0, 0}.image(own.curve[3 - i]))) << "along the turned half-edge";
    EXPECT_EQ(image.row[i], (MirrorPlane{0, 0}.image(own.row[3 - i])));
  }
  EXPECT_TRUE(object_surface(added->document, *added->document.find(added->ids[0])).ok());
}

TEST(MirroredCopies, WhatHasNoImageIsNamed) {
  Document document = document_from_mesh(test::cube(), "Box").value();
  document = add_object(document, "Odd", UnknownSource{"odd", std::string("{}")})->document;
  const std::vector<ObjectId> both{{1}, {2}};
  const auto refused = mirrored_copies(document, both, {0, 0});
  test::must_fail(refused, e_no_mirror_image);
  EXPECT_NE(refused.error().text.find("\"Odd\""), std::string::npos);
  EXPECT_EQ(refused.error().element, element_of(ObjectId{2}));
  EXPECT_EQ(mirrored_copies(document, {}, {0, 0}).error().code, e_no_objects);
  EXPECT_EQ(mirrored_copies(document, std::array{ObjectId{77}}, {0, 0}).error().code, e_unknown_object);
}

}  // namespace
}  // namespace hariko
