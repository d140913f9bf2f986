#include "core/base/text/base64.hpp"

#include "tests/support/random.hpp"

namespace hariko {
namespace {

TEST(Base64, HasTheWordsOfItsDefinition) {
  // RFC 4648, section 10.
  const std::pair<const char*, const char*> words[] = {{"", ""},
                                                       {"f", "Zg=="},
                                                       {"fo", "Zm8="},
                                                       {"foo", "Zm9v"},
                                                       {"foob", "Zm9vYg=="},
                                                       {"fooba", "Zm9vYmE="},
                                                       {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : words) {
    EXPECT_EQ(to_base64(bytes), text);
    EXPECT_EQ(from_base64(text).bytes, bytes);
    EXPECT_FALSE(from_base64(text).wrong);
  }
}

TEST(Base64, RandomBytesComeBack) {
  test::for_random(1, 200, [](std::mt19937_64& rng) {
    std::string bytes(std::size_t(test::uniform_int(rng, 0, 300)), '\0');
    for (char& byte : bytes) byte = static_cast<char>(rng());
    const std::string text = to_base64(bytes);
    EXPECT_EQ(text.size() % 4, 0U);
    EXPECT_EQ(from_base64(text).bytes, bytes);
  });
}

TEST(Base64, TheFirstWrongCharacterIsNamed) {
  EXPECT_EQ(from_base64("Zm9*v").wrong, 3U);
  EXPECT_EQ(from_base64("Zm=9").wrong, 2U) << "padding stands at the end";
  EXPECT_EQ(from_base64("\xff").wrong, 0U);
}

}  // namespace
}  // namespace hariko
