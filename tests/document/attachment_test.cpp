// Attachments: border edges joined to sides of patch objects, as a document keeps them and as surfaces
// follow.

#include "core/document/convert_unit.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/format/format.hpp"
#include "core/document/history/history.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "tests/document/random_documents.hpp"
#include "tests/support/random_joins.hpp"

namespace hariko::test {
namespace {

/// An object 1 with a side for each join of a random case, each a net of its own, and the polyhedron after
/// them.
struct Joined {
  Document document;
  ObjectId polyhedron;
  std::vector<ObjectId> patches;
  std::vector<EdgeId> edges;
};

Joined random_joined(std::mt19937_64& rng, double smooth, Adapts adapts, const Similarity& place = {}) {
  const JoinCase given = random_join_case(rng, 0.75, smooth);
  Joined out;
  for (const Join& join : given.joins) {
    auto source = PatchSource::from_net(net_of(join)).value();
    auto added = add_object(out.document, "Patch " + std::to_string(join.half_edge), source, place).value();
    out.document = added.document;
    out.patches.push_back(added.id);
  }
  PolyhedronSource source{
      Vector3::Zero(), given.polyhedron, given.shaping, static_cast<Mode>(uniform_int(rng, 0, 3)), {}};
  auto added = add_object(out.document, "Hood", source, place).value();
  out.document = added.document;
  out.polyhedron = added.id;
  for (std::size_t j = 0; j < given.joins.size(); ++j) {
    const Join& join = given.joins[j];
    const EdgeId edge = given.polyhedron.edge_id(given.polyhedron.topology().edge(join.half_edge));
    out.edges.push_back(edge);
    Attachment attachment{out.patches[j], {0, 0}, false, join.continuity, adapts, {}};
    if (adapts == Adapts::patch) attachment.continuity = Continuity::g1;
    out.document = attach_edge(out.document, out.polyhedron, edge, attachment).value();
  }
  return out;
}

Surface surface_in(const Document& document, ObjectId id) {
  auto made = must(object_surface(document, *document.find(id)));
  EXPECT_TRUE(std::none_of(made->warnings.begin(), made->warnings.end(),
                           [](const Message& warning) { return warning.code == w_join_refused; }));
  return made->surface;
}

/// Largest angle between normals of the polyhedron's surface and of side 0 of the patch, in document space,
/// over all attached edges; of G1 ones only.
double largest_jump(const Joined& joined) {
  const Object& hood = *joined.document.find(joined.polyhedron);
  const Surface surface = surface_in(joined.document, joined.polyhedron);
  const Polyhedron& polyhedron = hood.polyhedron()->polyhedron;
  double largest = 0;
  for (std::size_t j = 0; j < joined.edges.size(); ++j) {
    if (hood.polyhedron()->attachments->find(joined.edges[j])->continuity == Continuity::g0) continue;
    const Object& patch = *joined.document.find(joined.patches[j]);
    const Surface beyond = surface_in(joined.document, joined.patches[j]);
    const Index h = polyhedron.topology().half_edge_of_edge(polyhedron.find(joined.edges[j]));
    for (int i = 0; i <= 32; ++i) {
      const double x = i / 32.0;
      const Vector3 own = hood.transform.rotation * surface.normal(h, side_parameter(Domain::triangle, 1, x));
      const Vector3 theirs = -(patch.transform.rotation * beyond.normal(0, {x, 0}));
      largest = std::max(largest, std::atan2(own.cross(theirs).norm(), own.dot(theirs)));
    }
  }
  return largest;
}

Similarity random_place(std::mt19937_64& rng, double scale, double distance) {
  Similarity place;
  place.rotation =
      Eigen::Quaterniond(uniform(rng, 0.1, 1), uniform(rng, -1), uniform(rng, -1), uniform(rng, -1))
          .normalized();
  place.scale = scale;
  place.translation = random_vector(rng, distance);
  return place;
}

TEST(Attachment, SurfacesMeetWhereverTheObjectsStand) {
  double largest = 0;
  for_random(4701, 60, [&](std::mt19937_64& rng) {
    const Adapts adapts = chance(rng, 0.5) ? Adapts::surface : Adapts::patch;
    const Similarity place =
        random_place(rng, std::pow(10.0, uniform_int(rng, -3, 3)), chance(rng, 0.5) ? 1 : 1e6);
    const Joined joined = random_joined(rng, adapts == Adapts::surface ? 0.75 : 0, adapts, place);
    const double jump = largest_jump(joined);
    EXPECT_LT(jump, 1e-10);
    largest = std::max(largest, jump);
  });
  std::printf("largest normal jump between objects %.2e rad\n", largest);
}

TEST(Attachment, StaysLiveWhenAPatchMoves) {
  for_random(4721, 20, [&](std::mt19937_64& rng) {
    Joined joined = random_joined(rng, 1, Adapts::surface);
    if (joined.patches.empty()) return;
    // All patches turn together, as objects.
    const Similarity turn = random_place(rng, 1, 0.2);
    for (const ObjectId id : joined.patches)
      joined.document = set_transform(joined.document, id, turn).value();
    EXPECT_LT(largest_jump(joined), 1e-10);
  });
}

TEST(Attachment, EndsCanBeStoredWhereTheyAreSeen) {
  for_random(4731, 20, [&](std::mt19937_64& rng) {
    Joined joined = random_joined(rng, 1, Adapts::surface);
    if (joined.patches.empty()) return;
    const Similarity turn = random_place(rng, 1, 0.2);
    for (const ObjectId id : joined.patches)
      joined.document = set_transform(joined.document, id, turn).value();
    const Document stored = with_seen_ends(joined.document, joined.polyhedron);
    EXPECT_NE(stored, joined.document);
    const Object& hood = *stored.find(joined.polyhedron);
    EXPECT_EQ(attached_polyhedron(joined.document, *joined.document.find(joined.polyhedron)),
              hood.polyhedron()->polyhedron);
    // The picture does not change by storing the seen ends.
    EXPECT_EQ(attached_polyhedron(stored, hood), hood.polyhedron()->polyhedron);
    EXPECT_EQ(with_seen_ends(stored, joined.polyhedron), stored);
    EXPECT_EQ(with_seen_ends(joined.document, joined.patches.front()), joined.document);
  });
}

TEST(Attachment, DeletingThePatchKeepsACopyOfItsSide) {
  for_random(4741, 20, [&](std::mt19937_64& rng) {
    const Joined joined = random_joined(rng, 0.75, Adapts::surface, random_place(rng, 2, 10));
    if (joined.patches.empty()) return;
    const Surface before = surface_in(joined.document, joined.polyhedron);
    EXPECT_EQ(attached_to(joined.document, joined.patches), joined.patches.size());
    const Document after = delete_objects(joined.document, joined.patches).value();
    for (const auto& [edge, attachment] : *after.find(joined.polyhedron)->polyhedron()->attachments)
      EXPECT_TRUE(attachment.frozen.has_value());
    const Surface copy = surface_in(after, joined.polyhedron);
    for (Index h = 0; h < before.patch_count(); ++h)
      EXPECT_EQ(before.patches().evaluate(h, {0.25, 0.5}, Order::first).position,
                copy.patches().evaluate(h, {0.25, 0.5}, Order::first).position);
    EXPECT_EQ(read_document(write_document(after)).value(), after);
  });
}

TEST(Attachment, RoundTripsAndUndoes) {
  for_random(4761, 20, [&](std::mt19937_64& rng) {
    Joined joined = random_joined(rng, 0.5, chance(rng, 0.5) ? Adapts::surface : Adapts::patch);
    if (joined.patches.empty()) return;
    const std::string text = write_document(joined.document);
    const auto read = must(read_document(text));
    EXPECT_EQ(*read, joined.document);
    EXPECT_EQ(write_document(*read), text);
    History history(joined.document);
    history.push(release_edges(joined.document, joined.polyhedron, joined.edges).value(), "Release");
    EXPECT_TRUE(history.current().find(joined.polyhedron)->polyhedron()->attachments->empty());
    history.undo();
    EXPECT_EQ(history.current(), joined.document);
  });
}

TEST(Attachment, AppendedDocumentsKeepTheirOwn) {
  std::mt19937_64 rng(4781);
  Joined joined = random_joined(rng, 0.5, Adapts::surface);
  while (joined.patches.empty()) joined = random_joined(rng, 0.5, Adapts::surface);
  const Document both = append_document(joined.document, joined.document).value();
  const Object& copy = *both.objects.back();
  for (const auto& [edge, attachment] : *copy.polyhedron()->attachments) {
    EXPECT_GE(attachment.patch.value, joined.document.next_object_id.value);
    ASSERT_NE(both.find(attachment.patch), nullptr);
    EXPECT_TRUE(both.find(attachment.patch)->patches());
  }
  const Document doubled = duplicate_object(joined.document, joined.polyhedron).value().document;
  for (const auto& [edge, attachment] : *doubled.objects.back()->polyhedron()->attachments)
    EXPECT_TRUE(attachment.frozen.has_value());
}

TEST(Attachment, AppendedJoinsToObjectsThatAreGoneAreReleased) {
  std::mt19937_64 rng(4787);
  Joined joined = random_joined(rng, 0.5, Adapts::surface);
  while (joined.patches.empty()) joined = random_joined(rng, 0.5, Adapts::surface);
  Document lost = joined.document;
  std::erase_if(lost.objects, [&](const auto& object) { return object->id == joined.patches.front(); });
  ASSERT_TRUE(read_document(write_document(lost))) << "a file may name what is not there";
  const Document both = append_document(cube_document(), lost).value();
  EXPECT_EQ(both.objects.back()->polyhedron()->attachments->size(), joined.edges.size() - 1);
  const auto again = must(read_document(write_document(both)));
  EXPECT_TRUE(*again == both) << "it cannot be saved";
}

TEST(Attachment, RefusalsAndCycles) {
  std::mt19937_64 rng(1);
  BicubicNet net{1, 1, {}};
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) net.points.emplace_back(i, j, 0);
  Document document;
  const auto patch = add_object(document, "Wing", PatchSource::from_net(net).value()).value();
  document = patch.document;
  auto mesh = grid(1, 1);
  const auto hood = add_object(document, "Hood", PolyhedronSource::from_mesh(mesh).value()).value();
  document = hood.document;
  const EdgeId edge = EdgeId::of({0}, {1}), other = EdgeId::of({1}, {3});
  const auto code = [](const Result<Document>& result) {
    return result.ok() ? Code{"none"} : result.error().code;
  };
  EXPECT_EQ(code(attach_edge(document, hood.id, EdgeId::of({0}, {3}), {patch.id, {0, 0}})),
            e_unknown_element);
  EXPECT_EQ(code(attach_edge(document, hood.id, edge, {patch.id, {0, 1}})), e_no_side);
  EXPECT_EQ(code(attach_edge(document, hood.id, edge, {hood.id, {0, 0}})), e_wrong_kind);
  EXPECT_EQ(code(attach_edge(document, patch.id, edge, {patch.id, {0, 0}})), e_wrong_kind);
  const Document one = attach_edge(document, hood.id, edge, {patch.id, {2, 0}}).value();
  EXPECT_EQ(code(attach_edge(one, hood.id, other, {patch.id, {2, 0}})), e_side_taken);
  // The hood follows the wing; the wing cannot follow the hood as well.
  const auto cycle =
      attach_edge(one, hood.id, other, {patch.id, {1, 0}, true, Continuity::g1, Adapts::patch});
  must_fail(cycle, e_attachment_cycle);
  EXPECT_NE(cycle.error().text.find("Hood"), std::string::npos);
  EXPECT_NE(cycle.error().text.find("Wing"), std::string::npos);
  // A file with such a cycle opens, and the surface says what is wrong.
  PolyhedronSource forced = *one.find(hood.id)->polyhedron();
  Attachments attachments = *forced.attachments;
  attachments.set(other, {patch.id, {1, 0}, true, Continuity::g1, Adapts::patch, {}});
  forced.attachments = attachments;
  const Document closed = set_source(one, hood.id, forced).value();
  EXPECT_EQ(read_document(write_document(closed)).value(), closed);
  const auto surface = object_surface(closed, *closed.find(hood.id));
  EXPECT_TRUE(!surface.ok() || surface->surface.patch_count() > 0);
}

TEST(Attachment, NearestSideAndSidesOfNetEdges) {
  BicubicNet net{2, 3, {}};
  for (Index j = 0; j < net.height(); ++j)
    for (Index i = 0; i < net.width(); ++i) net.points.emplace_back(i, j, 0);
  const PatchSource patches = PatchSource::from_net(net).value();
  for (std::uint8_t side = 0; side < 4; ++side)
    for (Index place = 0; place < places_of(net, side); ++place) {
      const SideRows rows = side_rows(net, {side, place});
      for (std::size_t i = 0; i < 3; ++i) {
        const EdgeId edge = EdgeId::of({rows.curve[i]}, {rows.curve[i + 1]});
        EXPECT_EQ(side_of(patches, edge), (NetSide{side, place}));
      }
    }
  EXPECT_FALSE(side_of(patches, EdgeId::of({net.index(1, 1)}, {net.index(2, 1)})));
  Document document = add_object({}, "Wing", patches).value().document;
  PolygonMesh mesh;  // below side 0, its second patch
  mesh.positions = {{3, -4, 0}, {6, -4, 0}, {6, -0.2, 0}, {3, -0.2, 0}};
  mesh.add_face({0, 1, 2, 3});
  document = add_object(document, "Hood", PolyhedronSource::from_mesh(mesh).value()).value().document;
  const auto found = nearest_side(document, *document.objects[1], EdgeId::of({2}, {3}));
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->side, (NetSide{0, 1}));
  EXPECT_TRUE(found->reversed);
}

TEST(Attachment, TheImageOfAHalfIsJoinedToTheImageOfTheSide) {
  for_random(4791, 10, [](std::mt19937_64& rng) {
    PolygonMesh mesh;  // 2 x 1 squares; the edge at x = 2 is attached, the one at x = 0 is the seam
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i) mesh.positions.emplace_back(i, j, i == 0 ? 0.0 : uniform(rng, -0.2, 0.2));
    mesh.add_face({0, 1, 4, 3});
    mesh.add_face({1, 2, 5, 4});
    PolyhedronSource half = PolyhedronSource::from_mesh(mesh).value();
    half.mirror = Mirror{Axis::x, 1e-6};
    half.mode = static_cast<Mode>(uniform_int(rng, 0, 2));
    BicubicNet net{1, 1, {}};
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i)
        net.points.push_back(Vector3(2.1 + i, j / 3.0, 0.2) + random_vector(rng, 0.1));
    Document document = add_object({}, "Wing", PatchSource::from_net(net).value()).value().document;
    document = add_object(document, "Hood", half).value().document;
    const ObjectId wing = document.objects[0]->id, hood = document.objects[1]->id;
    const EdgeId edge = EdgeId::of({2}, {5});
    const auto nearest = nearest_side(document, *document.find(hood), edge);
    ASSERT_TRUE(nearest.has_value());
    EXPECT_EQ(nearest->side, (NetSide{3, 0}));
    EXPECT_TRUE(nearest->reversed);
    document = attach_edge(document, hood, edge, *nearest).value();
    const Surface surface = surface_in(document, hood), beyond = surface_in(document, wing);
    ASSERT_EQ(surface.patch_count(), 16U);
    const Index h = half.polyhedron.topology().half_edge_of_edge(half.polyhedron.find(edge));
    for (int i = 0; i <= 16; ++i) {
      const double x = i / 16.0;
      const Vector3 own = surface.normal(h, side_parameter(Domain::triangle, 1, x));
      EXPECT_LT((own - beyond.normal(0, {0, x})).norm(), 1e-10);
      const auto place = [&](Index patch, double at) {
        return Vector3(surface.origin() +
                       surface.patches()
                           .evaluate(patch, side_parameter(Domain::triangle, 1, at), Order::first)
                           .position);
      };
      Vector3 image = place(8 + 4 + (3 - h % 4), 1 - x);
      image.x() *= -1;
      EXPECT_LT((image - place(h, x)).norm(), 1e-12);
    }
  });
}

TEST(Attachment, Units) {
  for_random(4801, 10, [&](std::mt19937_64& rng) {
    Joined joined = random_joined(rng, 0.75, Adapts::surface, random_place(rng, 2, 10));
    if (joined.patches.empty()) return;
    joined.document = convert_unit(joined.document, Unit::inch).value();
    EXPECT_LT(largest_jump(joined), 1e-10);
  });
}

/// A wavy strip of three patches that follows a polyhedron along its side 0: points that two sides claim, and
/// smoothness between the patches, which a surface of mode G2 leaves and others need not.
TEST(AdaptedNet, SidesOfOneGridAgree) {
  for (const Mode mode : {Mode::target, Mode::fair, Mode::g2}) {
    SCOPED_TRACE(int(mode));
    BicubicNet net{3, 1, {}};
    for (Index j = 0; j < net.height(); ++j)
      for (Index i = 0; i < net.width(); ++i) net.points.emplace_back(i, j, 0.1 * i * j);
    PolygonMesh mesh;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 4; ++i) mesh.positions.emplace_back(3 * i, -3 * j, 0.3 * j * j + 0.2 * i);
    for (Index j = 0; j < 2; ++j)
      for (Index i = 0; i < 3; ++i)
        mesh.add_face({4 * j + i, 4 * (j + 1) + i, 4 * (j + 1) + i + 1, 4 * j + i + 1});
    PolyhedronSource source = PolyhedronSource::from_mesh(mesh).value();
    source.mode = mode;
    Document document = add_object({}, "Strip", PatchSource::from_net(net).value()).value().document;
    document = add_object(document, "Apron", source).value().document;
    const ObjectId strip = document.objects[0]->id, apron = document.objects[1]->id;
    for (Index k = 0; k < 3; ++k) {
      const Attachment attachment{strip, {0, k}, true, Continuity::g1, Adapts::patch, {}};
      document = attach_edge(document, apron, EdgeId::of({k}, {k + 1}), attachment).value();
    }
    const auto made = object_surface(document, *document.find(strip)).value();
    const Surface &surface = made.surface, beyond = surface_in(document, apron);
    ASSERT_EQ(surface.seams().size(), 2U);  // in one piece
    std::size_t kinks = 0;
    for (const Message& warning : made.warnings) {
      EXPECT_EQ(warning.code, w_join_kink);
      EXPECT_FALSE(warning.remedy.empty());
      ++kinks;
    }
    std::size_t smooth = 0;
    for (const Seam& seam : surface.seams()) smooth += seam.intended == Continuity::g1 ? 1U : 0U;
    EXPECT_GE(smooth + kinks, 2U);
    if (mode == Mode::g2) {
      EXPECT_EQ(smooth, 2U);
      EXPECT_EQ(kinks, 0U);
    }
    const Polyhedron& polyhedron = document.objects[1]->polyhedron()->polyhedron;
    double largest = 0;
    for (Index k = 0; k < 3; ++k)
      for (int i = 0; i <= 16; ++i) {
        const Index h = polyhedron.topology().half_edge_of_edge(polyhedron.find(EdgeId::of({k}, {k + 1})));
        const Vector3 a = surface.normal(k, {i / 16.0, 0});
        const Vector3 b = beyond.normal(h, side_parameter(Domain::triangle, 1, 1 - i / 16.0));
        largest = std::max(largest, a.cross(b).norm());
      }
    EXPECT_LT(largest, 1e-10);
  }
}

}  // namespace
}  // namespace hariko::test
