// Documents that something went wrong with load or are refused, and what loads can be saved.

#include "core/document/format/format.hpp"
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

}  // namespace
}  // namespace hariko
