// The guided first model: each step is recognised by what happened, and by nothing else.

#include "ui/editor/guide.hpp"

#include <gtest/gtest.h>

#include "core/document/edits/edits.hpp"
#include "core/modeling/objects/primitives.hpp"

namespace hariko {
namespace {

const ObjectId box_id{1};

Document box() {
  return document_from_mesh(make_primitive(BoxShape{}).value(), "Box").value();
}

const PolyhedronSource& source_of(const Document& document) {
  return *document.find(box_id)->polyhedron();
}

Document pulled(const Document& document) {
  const PolyhedronSource& source = source_of(document);
  const VertexId id = source.polyhedron.vertex_id(0);
  const Vector3 to = source.polyhedron.position(0) + Vector3(0, 0, 1);
  return move_vertices(document, box_id, {&id, 1}, {&to, 1}).value();
}

Document tensed(const Document& document) {
  const VertexId id = source_of(document).polyhedron.vertex_id(0);
  return set_alpha(document, box_id, {&id, 1}, 4).value();
}

Document creased(const Document& document) {
  const EdgeId id = source_of(document).polyhedron.edge_id(0);
  return set_crease(document, box_id, {&id, 1}, true).value();
}

TEST(Guide, is_walked_through_from_the_box_to_the_export) {
  Guide guide;
  Document document;
  guide.start({document, 0});
  EXPECT_TRUE(guide.shown());
  const auto step = [&](GuideStep now, Document next, int exports = 0) {
    EXPECT_EQ(guide.step(), now);
    EXPECT_FALSE(guide.look({document, 0})) << "nothing happened";
    EXPECT_TRUE(guide.look({next, exports}));
    EXPECT_FALSE(guide.look({next, exports})) << "one thing fulfils one step";
    document = std::move(next);
  };
  step(GuideStep::box, box());
  step(GuideStep::pull, pulled(document));
  step(GuideStep::tension, tensed(document));
  step(GuideStep::crease, creased(document));
  guide.look({document, 0, true});
  EXPECT_EQ(guide.step(), GuideStep::export_file) << "zebra is a way of looking";
  step(GuideStep::export_file, document, 1);
  EXPECT_EQ(guide.step(), GuideStep::done);
}

TEST(Guide, other_changes_do_not_fulfil_a_step) {
  const Document start = box();
  const std::pair<GuideStep, Document> wrong[] = {
      {GuideStep::pull, tensed(start)},
      {GuideStep::pull, rename_object(start, box_id, "Other").value()},
      {GuideStep::tension, pulled(start)},
      {GuideStep::tension, creased(start)},
      {GuideStep::crease, tensed(start)},
      {GuideStep::zebra, creased(start)},
      {GuideStep::export_file, creased(start)},
  };
  for (const auto& [step, now] : wrong)
    EXPECT_FALSE(fulfilled(step, {start, 0}, {now, 0})) << static_cast<int>(step);
  EXPECT_FALSE(fulfilled(GuideStep::crease, {creased(start), 0}, {start, 0}))
      << "a crease that was taken away";
}

TEST(Guide, can_be_left_and_taken_up_again) {
  Guide guide;
  guide.start({box(), 0});
  ASSERT_TRUE(guide.look({box(), 0}));
  guide.leave();
  EXPECT_TRUE(guide.paused());
  EXPECT_FALSE(guide.look({pulled(box()), 0})) << "left: nothing is looked at";
  guide.start({pulled(box()), 0});
  EXPECT_EQ(guide.step(), GuideStep::pull) << "what happened meanwhile was not done for the guide";
  EXPECT_TRUE(guide.look({pulled(pulled(box())), 0}));
}

TEST(Guide, a_new_object_is_no_pulled_vertex) {
  Guide guide;
  guide.start({Document{}, 0});
  ASSERT_TRUE(guide.look({box(), 0}));
  const auto twice = duplicate_object(box(), box_id);
  ASSERT_TRUE(twice.ok());
  EXPECT_FALSE(guide.look({twice->document, 0}));
  // ... but pulling one of its vertices later is.
  const PolyhedronSource& source = *twice->document.find(twice->id)->polyhedron();
  const VertexId id = source.polyhedron.vertex_id(0);
  const Vector3 to = source.polyhedron.position(0) + Vector3(0, 0, 1);
  EXPECT_TRUE(guide.look({move_vertices(twice->document, twice->id, {&id, 1}, {&to, 1}).value(), 0}));
}

}  // namespace
}  // namespace hariko
