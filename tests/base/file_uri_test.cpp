#include "core/base/files/file_uri.hpp"

#include "tests/support/random.hpp"

namespace hariko {
namespace {

TEST(FileUri, KeepsEveryBytesOfAName) {
  EXPECT_EQ(file_uri("/home/Ada/a b%.hariko"), "file:///home/Ada/a%20b%25.hariko");
  test::for_random(11, 200, [](std::mt19937_64& rng) {
    std::string name = "/";
    const int length = test::uniform_int(rng, 0, 40);
    for (int i = 0; i < length; ++i) name += static_cast<char>(test::uniform_int(rng, 1, 255));
    const std::string uri = file_uri(name);
    for (const char c : uri) ASSERT_TRUE(c > ' ' && c < 0x7f) << uri;
    const auto path = path_of_uri(uri);
    ASSERT_TRUE(path);
    ASSERT_EQ(path->native(), name);
  });
}

TEST(FileUri, RefusesWhatIsNoFileOfThisMachine) {
  for (const char* text : {"", "file://", "file://host/a", "http:///a", "/a", "file:///a%", "file:///a%2",
                           "file:///a%zz", "file:///a%00b"})
    EXPECT_FALSE(path_of_uri(text)) << text;
}

}  // namespace
}  // namespace hariko
