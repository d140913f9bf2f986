// The selection as a value: conversions between modes, and what is remembered of steps.

#include "tests/app/tool_rig.hpp"
#include "ui/editor/selection_memory.hpp"

namespace hariko::test {
namespace {

TEST(Selection, ConvertsBetweenModes) {
  const Document document = cube_document();
  const ObjectId id = document.objects[0]->id;
  Selection selection;
  selection.select({id, element_of(FaceId{1})}, Selection::How::replace);
  const Selection corners = converted(selection, document, ElementMode::face, ElementMode::vertex);
  EXPECT_EQ(corners.of(id).vertices, (std::set<VertexId>{{4}, {5}, {6}, {7}}));
  EXPECT_TRUE(corners.of(id).faces.empty());
  EXPECT_EQ(converted(corners, document, ElementMode::vertex, ElementMode::face).of(id).faces,
            std::set<FaceId>{FaceId{1}});
  EXPECT_EQ(converted(corners, document, ElementMode::vertex, ElementMode::edge).of(id).edges.size(), 4U);
  const Selection object = converted(selection, document, ElementMode::face, ElementMode::object);
  EXPECT_EQ(object.objects(), std::set<ObjectId>{id});
  EXPECT_EQ(converted(object, document, ElementMode::object, ElementMode::vertex).of(id).vertices.size(), 8U);
}

TEST(Selection, KnowsWhatItBeganWith) {
  using How = Selection::How;
  const ObjectId id = cube_document().objects[0]->id;
  const auto vertex = [&](unsigned v) { return ElementRef{id, element_of(VertexId{v})}; };
  Selection selection;
  selection.select(vertex(3), How::add);
  selection.select(vertex(1), How::add);
  EXPECT_EQ(selection.first, vertex(3));
  EXPECT_EQ(selection.last, vertex(1));
  selection.select(vertex(3), How::remove);
  EXPECT_EQ(selection.first, std::nullopt);
  selection.select(vertex(3), How::add);
  EXPECT_EQ(selection.first, std::nullopt) << "it is not the first any more";
  selection.select(vertex(5), How::replace);
  EXPECT_EQ(selection.first, vertex(5));
  ElementSelection many;
  many.vertices = {VertexId{1}, VertexId{2}};
  selection.select(id, many, How::replace);
  EXPECT_EQ(selection.first, std::nullopt) << "all at once";
}

TEST(SelectionMemory, KeepsWhatBelongsToStepsAndForgetsTheRest) {
  SelectionMemory memory(20);
  const auto chosen = [](unsigned first, unsigned count) {
    ChosenElements result;
    ElementSelection elements;
    for (unsigned i = 0; i < count; ++i) elements.vertices.insert(VertexId{first + i});
    result.selection.select(ObjectId{1}, elements, Selection::How::add);
    return result;
  };
  memory.step(0, chosen(0, 1), 0);
  memory.step(1, chosen(1, 1), 0);
  memory.leave(2, chosen(2, 1));
  memory.leave(2, chosen(9, 1));
  EXPECT_EQ(*memory.find(2), chosen(2, 1)) << "what a state was left with first stays";
  memory.step(1, chosen(3, 1), 0);
  EXPECT_EQ(memory.find(2), nullptr) << "what could be redone is gone";
  EXPECT_EQ(*memory.find(1), chosen(3, 1));
  memory.step(5, chosen(4, 12), 1);
  EXPECT_EQ(memory.find(0), nullptr) << "states that the history forgot are forgotten";
  memory.step(6, chosen(5, 12), 1);
  EXPECT_EQ(memory.find(5), nullptr) << "the limit";
  EXPECT_NE(memory.find(6), nullptr);
}

}  // namespace
}  // namespace hariko::test
