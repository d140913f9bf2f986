// Solids, skins and outlines far from zero: their place carries the origin, positions keep every digit.

#include <cmath>
#include <string>

#include "core/base/files/file_io.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "core/document/format/folded_origin.hpp"
#include "core/document/format/format.hpp"
#include "core/document/format/read_origin.hpp"
#include "core/document/object_box.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "core/skinning/columns/simple_skin.hpp"
#include "tests/support/must.hpp"
#include "tests/support/places.hpp"

namespace hariko {
namespace {

std::string folded_fixture() {
  return read_file(test::source_folder() + "/tests/document/fixtures/v8_origins.hariko", 1 << 20).value();
}

TEST(FoldedOrigin, FixtureOfVersion8ReadsForEver) {
  const auto read = test::must(read_document(folded_fixture()));
  ASSERT_EQ(read->objects.size(), 4U);
  EXPECT_EQ(read->objects[0]->transform.translation, Vector3(2000000001, -3999998, 4));
  EXPECT_EQ(read->objects[0]->transform.scale, 2);
  EXPECT_EQ(read->objects[0]->solids()->input->solids[0].position, Vector3(0.1, 0.2, 0.3));
  EXPECT_EQ(read->objects[1]->transform.translation, Vector3(500000, 4000000, 100));
  EXPECT_EQ(read->objects[1]->skin()->skin->sections[1].points[2].position, Vector3(-1.3, 0, 1.1));
  EXPECT_EQ(read->objects[1]->skin()->skin->mirror, (MirrorPlane{0, 0.25}));
  EXPECT_EQ(read->objects[2]->transform.translation, Vector3(0, 0, -1000000));
  EXPECT_EQ(read->objects[2]->outline()->outline->loops[0].points[0], Vector3(1.7, 0, 0));
  EXPECT_EQ(read->objects[3]->transform.translation, Vector3(-1000000, 0, 7));
  for (const auto& object : read->objects) {
    if (const auto* solids = object->solids()) EXPECT_TRUE(solids->kept->empty());
    if (const auto* skin = object->skin()) EXPECT_TRUE(skin->kept->empty());
    if (const auto* outline = object->outline()) EXPECT_TRUE(outline->kept->empty());
  }
  const std::string text = write_document(*read);
  EXPECT_EQ(text.find("\"origin\""), std::string::npos);
  const auto again = test::must(read_document(text));
  EXPECT_EQ(*again, *read);
  EXPECT_EQ(write_document(*again), text);
}

TEST(FoldedOrigin, OlderFilesKeepAnUnknownMemberOfThatName) {
  std::string text = folded_fixture();
  text.replace(text.find("\"version\": 8"), 12, "\"version\": 7");
  const auto read = test::must(read_document(text));
  EXPECT_EQ(read->objects[1]->transform, Similarity());
  EXPECT_EQ(*read->objects[1]->skin()->kept, (KeptMembers{{"origin", "[500000, 4000000, 100]"}}));
}

TEST(FoldedOrigin, WhatIsNoPointIsRefused) {
  const auto code = [](const std::string& origin) {
    std::string text = folded_fixture();
    const std::string from = "[0, 0, -1000000]";
    text.replace(text.find(from), from.size(), origin);
    const auto read = read_document(text);
    return read.ok() ? std::string() : to_string(read.error());
  };
  EXPECT_EQ(code("[0, 0, 1]"), "");
  for (const char* wrong : {"[0, 0]", "3", "null", "[0, 0, \"1\"]"})
    EXPECT_NE(code(wrong).find("objects[2].source.origin"), std::string::npos) << code(wrong);
  // Twice as large in the document, this is no number any more.
  std::string text = folded_fixture();
  const std::string from = "[1000000000, -2000000, 0.5]";
  text.replace(text.find(from), from.size(), "[1.7e308, 0, 0]");
  const auto read = read_document(text);
  ASSERT_FALSE(read.ok());
  EXPECT_NE(to_string(read.error()).find("objects[0].source.origin"), std::string::npos);
}

TEST(FoldedOrigin, OfSeparateFiles) {
  EXPECT_EQ(read_origin("{\"loops\": []}").value(), Vector3::Zero());
  EXPECT_EQ(read_origin("{\"origin\": [1, 2.5, -3]}").value(), Vector3(1, 2.5, -3));
  EXPECT_FALSE(read_origin("{\"origin\": [1, 2]}").ok());
  EXPECT_FALSE(read_origin("{").ok());
}

/// Near sources whose positions have few binary digits, so that they can be moved far away exactly.
std::vector<Source> near_sources() {
  EnvelopeInput input;
  Solid box;
  box.size = {1, 1.5, 2};
  Solid ball;
  ball.id = 1;
  ball.kind = SolidKind::sphere;
  ball.position = {1.25, 0.5, -0.25};
  input.solids = {box, ball};
  Skin skin = arched_skin(6, 4, 1, 5);
  change_positions(skin, [](Vector3& p) { p = (p * 256).array().round().matrix() / 256; });
  skin.mirror = MirrorPlane{0, 0.5};
  OutlineLoop loop;
  for (int k = 0; k < 12; ++k) {
    const double angle = k * std::acos(-1.0) / 6;
    const Vector3 normal(std::cos(angle), std::sin(angle), 1);
    loop.points.push_back((normal * 256).array().round().matrix() / 256);
    loop.normals.push_back(normal);
  }
  Outline outline;
  outline.loops = {loop};
  return {SolidsSource{input, {}}, SkinSource{skin, {}}, OutlineSource{outline, {}, {}}};
}

/// The source with all positions moved.
Source moved_source(Source source, const Vector3& by) {
  if (auto* solids = std::get_if<SolidsSource>(&source)) {
    EnvelopeInput input = *solids->input;
    for (Solid& solid : input.solids) solid.position += by;
    solids->input = input;
  } else if (auto* skins = std::get_if<SkinSource>(&source)) {
    Skin skin = *skins->skin;
    change_positions(skin, [&](Vector3& p) { p += by; });
    skin.mirror->position += by[skin.mirror->axis];
    skins->skin = skin;
  } else {
    auto& outlines = std::get<OutlineSource>(source);
    Outline outline = *outlines.outline;
    for (OutlineLoop& loop : outline.loops)
      for (Vector3& p : loop.points) p += by;
    outlines.outline = outline;
  }
  return source;
}

TEST(FoldedOrigin, FarSourcesComeNearWithoutRounding) {
  for (const double distance : {1e6, 1e9, -1e9}) {
    const Vector3 by(distance, 0, -distance / 2);
    for (const Source& near : near_sources()) {
      SCOPED_TRACE(std::string(kind_of(near)) + " at " + std::to_string(distance));
      const Source far = moved_source(near, by);
      Source taken = far;
      const Vector3 origin = take_far_origin(taken);
      EXPECT_LT((origin - by).norm(), 100);
      EXPECT_EQ(origin.y(), 0);
      EXPECT_EQ(moved_source(taken, origin), far) << "every digit";
      EXPECT_EQ(moved_source(taken, origin - by), near);
      Source twice = taken;
      EXPECT_EQ(take_far_origin(twice), Vector3::Zero());
      EXPECT_EQ(twice, taken);
    }
  }
  for (const Source& near : near_sources()) {
    Source kept = moved_source(near, {100, -50, 300});
    EXPECT_EQ(take_far_origin(kept), Vector3::Zero()) << "what is not far stays";
  }
  Source none = OutlineSource{};
  EXPECT_EQ(take_far_origin(none), Vector3::Zero());
}

TEST(FoldedOrigin, PlanesOfSymmetryStay) {
  SolidsSource source = std::get<SolidsSource>(near_sources()[0]);
  EnvelopeInput input = *source.input;
  input.settings.symmetry = SymmetryPlane::x;
  source.input = input;
  Source far = moved_source(source, {1e6, 1e6, 0});
  const Vector3 origin = take_far_origin(far);
  EXPECT_EQ(origin.x(), 0);
  EXPECT_NEAR(origin.y(), 1e6, 100);
}

TEST(FoldedOrigin, SurfacesFarAwayAreThoseNearZero) {
  for (const double distance : {1e6, 1e9})
    for (const Source& near : near_sources()) {
      SCOPED_TRACE(std::string(kind_of(near)) + " at " + std::to_string(distance));
      const Vector3 by(distance, 0, -distance / 2);
      Source source = moved_source(near, by);
      const Vector3 origin = take_far_origin(source);
      const Document far = add_object({}, "far", source, with_origin({}, origin)).value().document;
      const auto read = test::must(read_document(write_document(far)));
      EXPECT_EQ(*read, far);
      const Document here = add_object({}, "near", near).value().document;
      const auto a = object_surface(here, *here.objects[0]);
      const auto b = object_surface(*read, *read->objects[0]);
      ASSERT_TRUE(a.ok()) << to_string(a.error());
      ASSERT_TRUE(b.ok()) << to_string(b.error());
      ASSERT_EQ(a->surface.patch_count(), b->surface.patch_count());
      const Vector3 place = read->objects[0]->transform.translation + b->surface.origin();
      // The place is a double; within the surface nothing is lost.
      const Vector3 shift = (place - by) - a->surface.origin();
      double largest = 0;
      for (Index patch = 0; patch < a->surface.patch_count(); ++patch)
        for (const Vector2& at : {Vector2(0, 0), Vector2(0.3, 0.7), Vector2(1, 0.5)}) {
          const Vector3 p = a->surface.patches().evaluate(patch, at, Order::first).position;
          const Vector3 q = b->surface.patches().evaluate(patch, at, Order::first).position;
          largest = std::max(largest, (q + shift - p).norm());
        }
      EXPECT_LT(largest, 1e-9);
      const Document there = add_object({}, "there", moved_source(near, by)).value().document;
      const Eigen::AlignedBox3d box = world_box(*read->objects[0]), wanted = world_box(*there.objects[0]);
      const double rounding = 4e-16 * distance;
      EXPECT_LE((box.min() - wanted.min()).norm(), rounding);
      EXPECT_LE((box.max() - wanted.max()).norm(), rounding);
    }
}

}  // namespace
}  // namespace hariko
