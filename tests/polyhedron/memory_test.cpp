// A history of small edits costs little memory: versions of a polyhedron share what they have in common.

#include <cstdio>

#include "core/polyhedron/polyhedron.hpp"
#include "tests/polyhedron/counting_new.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko {
namespace {

TEST(PolyhedronMemory, ThousandEditsOfALargeObjectStaySmall) {
  const Polyhedron first = Polyhedron::build(test::grid(200, 100)).value();
  ASSERT_EQ(first.face_count(), 20000U);
  std::vector<Polyhedron> history{first};
  history.reserve(1001);
  std::mt19937_64 rng(501);
  const std::size_t before = live_bytes();
  for (int i = 0; i < 1000; ++i) {
    const Index vertex = static_cast<Index>(rng() % first.vertex_count());
    const Vector3 position = test::random_vector(rng);
    history.push_back(history.back().with_positions({&vertex, 1}, {&position, 1}).value());
  }
  const std::size_t added = live_bytes() - before;
  RecordProperty("bytes_of_1000_edits", static_cast<int>(added));
  std::printf("1,000 edits of 20,000 faces: %.1f MB\n", static_cast<double>(added) / 1e6);
  EXPECT_LT(added, 64U << 20);
  EXPECT_GT(added, 1000U * 100);  // the counter counts
  EXPECT_EQ(history.front(), Polyhedron::build(test::grid(200, 100)).value());
}

TEST(PolyhedronMemory, MovingNothingCopiesNoPositions) {
  const Polyhedron before = Polyhedron::build(test::grid(100, 100)).value();
  const Index vertex = 17;
  const Vector3 same = before.position(vertex);
  const std::size_t start = live_bytes();
  const Polyhedron after = before.with_positions({&vertex, 1}, {&same, 1}).value();
  EXPECT_LT(live_bytes() - start, 16U * before.vertex_count() / 100);  // chunk pointers only
  EXPECT_EQ(after, before);
}

}  // namespace
}  // namespace hariko
