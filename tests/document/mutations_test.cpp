// Documents that something went wrong with load or are refused, and what loads can be saved. So do files of
// sections, solids and outlines alone.

#include "core/document/format/format.hpp"
#include "core/document/format/read_outline.hpp"
#include "core/document/format/read_skin.hpp"
#include "core/document/format/read_solids.hpp"
#include "tests/support/mutated.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

TEST(DocumentMutations, LoadOrAreRefused) {
  const std::string whole =
      test::slurp(std::filesystem::path(test::source_folder()) / "tests/fuzz/seeds/document/v1.hariko");
  ASSERT_FALSE(whole.empty());
  test::for_random(900, 100, [&](std::mt19937_64& rng) {
    std::string text = whole;
    for (int k = test::uniform_int(rng, 1, 4); k > 0; --k) {
      const std::size_t at = rng() % text.size(), length = 1 + rng() % 16;
      if (test::chance(rng, 0.3))
        text.erase(at, length);
      else if (test::chance(rng, 0.5))
        text[at] = char(rng());
      else
        text.insert(at, text.substr(rng() % text.size(), length));
    }
    const auto document = read_document(text);
    if (!document.ok()) {
      EXPECT_FALSE(document.error().text.empty());
      return;
    }
    const auto again = test::must(read_document(write_document(*document)));
    EXPECT_TRUE(*again == *document);
  });
}

/// A hundred mutations of a file under tests/, which is read itself.
template <class Read>
void try_layout(std::uint64_t seed, const char* file, const Read& read) {
  SCOPED_TRACE(file);
  const std::string whole = test::slurp(std::filesystem::path(test::source_folder()) / "tests" / file);
  ASSERT_TRUE(read(whole).ok());
  test::for_random(seed, 100, [&](std::mt19937_64& rng) {
    const auto layout = read(test::mutated(rng, whole));
    if (layout.ok()) return;
    EXPECT_FALSE(layout.error().text.empty());
    EXPECT_TRUE(layout.error().code.name.starts_with("E_")) << layout.error().code.name;
  });
}

TEST(DocumentMutations, FilesOfOneKindLoadOrAreRefused) {
  try_layout(1000, "cases/skin_far_from_origin.json", &read_skin_layout);
  try_layout(1100, "skinning/data/dome_unequal_sections.json", &read_skin_layout);
  try_layout(1200, "golden/envelope/drill.json", &read_scene);
  try_layout(1300, "golden/gaussmap/three_holes.json", &read_outline);
}

}  // namespace
}  // namespace hariko
