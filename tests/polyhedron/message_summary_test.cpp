#include "core/polyhedron/message_summary.hpp"

#include <gtest/gtest.h>

#include "core/base/ids.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {
namespace {

TEST(MessageSummary, OneAKindWithTheCountAndTheFirstElements) {
  // Triangles of which every one turns against its neighbours, at 3,424 edges.
  PolygonMesh mesh;
  const Index count = 3425;
  for (Index k = 0; k < count + 2; ++k) mesh.positions.emplace_back(k, k % 2, 0);
  for (Index k = 0; k < count; ++k) mesh.add_face({k, k + 1, k + 2});
  const std::vector<Message> all = validate(mesh);
  ASSERT_EQ(all.size(), 100U);
  const auto summaries = summarised(all);
  ASSERT_EQ(summaries.size(), 1U);
  EXPECT_EQ(summaries[0].count, count - 1U);
  EXPECT_EQ(summaries[0].list(), "edge 1-2, edge 2-3, edge 3-4, edge 4-5, edge 5-6 ...");
  const Message one = one_message(summaries[0]);
  EXPECT_TRUE(one.text.ends_with("(3424 like this: edge 1-2, edge 2-3, edge 3-4, edge 4-5, edge 5-6 ...)"))
      << one.text;
}

TEST(MessageSummary, OtherMessagesStayAsTheyAre) {
  const std::vector<Message> messages{make_warning({"W_A"}, "One thing."), make_warning({"W_A"}, "Another."),
                                      make_error({"E_A"}, "\"left\": It.", {}, element_of(VertexId{1})),
                                      make_error({"E_A"}, "\"right\": It.", {}, element_of(VertexId{1})),
                                      make_warning({"W_A"}, "One thing.")};
  const auto summaries = summarised(messages);
  ASSERT_EQ(summaries.size(), 4U);
  EXPECT_EQ(one_message(summaries[0]).text, "One thing. (2 like this)");
  EXPECT_EQ(one_message(summaries[1]).text, "Another.");
  EXPECT_EQ(one_message(summaries[2]).text, "\"left\": It.");
}

}  // namespace
}  // namespace hariko
