#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/flat_map.hpp"
#include "core/base/ids.hpp"
#include "core/base/index_list.hpp"
#include "core/base/message.hpp"
#include "core/base/result.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

constexpr Code e_test{"E_TEST"};

TEST(Result, HoldsAValueOrAnError) {
  const Result<int> good = 7;
  EXPECT_TRUE(good.ok());
  EXPECT_TRUE(static_cast<bool>(good));
  EXPECT_EQ(*good, 7);
  const Result<int> bad = make_error(e_test, "No.");
  EXPECT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().code, e_test);
  EXPECT_EQ(bad.error().severity, Severity::error);
}

TEST(Result, MovesItsValueOut) {
  Result<std::unique_ptr<int>> result = std::make_unique<int>(5);
  const std::unique_ptr<int> value = std::move(result).value();
  EXPECT_EQ(*value, 5);
  Result<std::string> text = std::string("abc");
  text.value() += "d";
  EXPECT_EQ(text->size(), 4U);
}

TEST(Result, OfDoneSaysWhetherWorkWasDone) {
  const Result<Done> good = Done{}, bad = make_error(e_test, "No.");
  EXPECT_TRUE(good.ok());
  EXPECT_FALSE(bad.ok());
}

TEST(ResultDeathTest, MisuseIsAnAssertion) {
  const Result<int> bad = make_error(e_test, "No."), good = 1;
  EXPECT_DEATH(static_cast<void>(bad.value()), "value\\(\\) of a failed result");
  EXPECT_DEATH(static_cast<void>(good.error()), "error\\(\\) of a good result");
}

TEST(Message, ElementsAsText) {
  EXPECT_EQ(to_string(Element{}), "");
  EXPECT_EQ(to_string(element_of(VertexId{12})), "vertex 12");
  EXPECT_EQ(to_string(element_of(EdgeId::of(VertexId{13}, VertexId{12}))), "edge 12-13");
  EXPECT_EQ(to_string(element_of(FaceId{3})), "face 3");
  EXPECT_EQ(to_string(element_of(ObjectId{4})), "object 4");
  EXPECT_EQ(to_string(Element{Element::Kind::line, 7}), "line 7");
}

TEST(Message, AsText) {
  EXPECT_EQ(to_string(make_error(e_test, "The face has 2 corners.", "Add one.", element_of(FaceId{3}))),
            "E_TEST (face 3): The face has 2 corners. Add one.");
  EXPECT_EQ(to_string(make_warning({"W_TEST"}, "Careful.")), "W_TEST: Careful.");
  EXPECT_EQ(make_warning({"W_TEST"}, "Careful.").severity, Severity::warning);
}

TEST(Message, CountsAndNumbersInSentences) {
  EXPECT_EQ(counted(0, " face", " faces"), "0 faces");
  EXPECT_EQ(counted(1, " face", " faces"), "1 face");
  EXPECT_EQ(counted(12, " face", " faces"), "12 faces");
  EXPECT_EQ(rounded_text(1234.5, 3), "1.23e+03");
  EXPECT_EQ(rounded_text(0.123456, 4), "0.1235");
  EXPECT_EQ(rounded_text(2, 3), "2");
}

TEST(IndexList, AscendsFromItsFirst) {
  EXPECT_EQ(ascending_indices(3), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(ascending_indices(2, 7), (std::vector<Index>{7, 8}));
  EXPECT_TRUE(ascending_indices(0).empty());
}

TEST(IndexList, EqualRanksStayInOrder) {
  const std::vector<double> rank{2, 1, 2, 1};
  const auto order = stable_order(4, [&](Index a, Index b) { return rank[a] < rank[b]; });
  EXPECT_EQ(order, (std::vector<Index>{1, 3, 0, 2}));
}

TEST(IndexList, RepetitionsGo) {
  std::vector<Index> values{3, 1, 3, 2, 1};
  sort_unique(values);
  EXPECT_EQ(values, (std::vector<Index>{1, 2, 3}));
  std::vector<Index> loop{5, 5, 7, 7, 5, 8, 5};
  remove_repeats(loop);
  EXPECT_EQ(loop, (std::vector<Index>{5, 7, 5, 8}));
  std::vector<Index> same{4, 4, 4}, none;
  remove_repeats(same);
  remove_repeats(none);
  EXPECT_EQ(same, (std::vector<Index>{4}));
  EXPECT_TRUE(none.empty());
}

TEST(Ids, EdgesHaveNoDirection) {
  const EdgeId edge = EdgeId::of(VertexId{9}, VertexId{2});
  EXPECT_EQ(edge, EdgeId::of(VertexId{2}, VertexId{9}));
  EXPECT_EQ(edge.low, VertexId{2});
  EXPECT_EQ(EdgeId::from_packed(edge.packed()), edge);
  const EdgeId extreme = EdgeId::of(VertexId{0xfffffffeU}, VertexId{0x80000000U});
  EXPECT_EQ(EdgeId::from_packed(extreme.packed()), extreme);
  EXPECT_LT(edge, extreme);
}

TEST(FlatMap, BehavesLikeAMap) {
  test::for_random(601, 50, [](std::mt19937_64& rng) {
    FlatMap<int, double> flat;
    std::map<int, double> model;
    for (int step = 0; step < 200; ++step) {
      const int key = test::uniform_int(rng, 0, 20);
      if (test::chance(rng, 0.6)) {
        const double value = test::uniform(rng);
        flat.set(key, value);
        model[key] = value;
      } else {
        flat.erase(key);
        model.erase(key);
      }
      ASSERT_EQ(flat.size(), model.size());
      ASSERT_EQ(flat.empty(), model.empty());
      ASSERT_TRUE(std::equal(flat.begin(), flat.end(), model.begin(), [](const auto& a, const auto& b) {
        return a.first == b.first && a.second == b.second;
      }));
      for (int probe = -1; probe <= 21; ++probe) {
        const auto found = model.find(probe);
        ASSERT_EQ(flat.contains(probe), found != model.end());
        ASSERT_EQ(flat.get_or(probe, -1), found == model.end() ? -1 : found->second);
      }
    }
  });
}

TEST(FlatMap, ComparesByContent) {
  FlatMap<int, int> a, b;
  a.set(1, 10);
  a.set(2, 20);
  b.set(2, 20);
  EXPECT_NE(a, b);
  b.set(1, 10);
  EXPECT_EQ(a, b);
}

TEST(CancelToken, CopiesShareTheFlag) {
  const CancelToken none;
  none.cancel();
  EXPECT_FALSE(none.cancelled());
  const CancelToken token = CancelToken::make(), copy = token;
  EXPECT_FALSE(copy.cancelled());
  token.cancel();
  EXPECT_TRUE(copy.cancelled());
}

}  // namespace
}  // namespace hariko
