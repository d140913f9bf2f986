// Files that pasted text names, as file managers, terminals and notes write them.

#include "core/base/files/pasted_paths.hpp"

#include "core/base/files/file_ending.hpp"
#include "core/base/files/file_uri.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

using Paths = std::vector<std::filesystem::path>;

bool known_ending(const std::filesystem::path& path) {
  return lower_ending(path) == ".png" || lower_ending(path) == ".obj";
}
Result<Paths> pasted(std::string_view text) {
  return pasted_paths(text, "/home/ada", known_ending);
}
std::string why_no_place(std::string_view text) {
  const auto read = pasted(text);
  return read.ok() ? std::string() : read.error().text;
}

TEST(PastedPaths, EveryUsualWayToWriteAPathIsRead) {
  const Paths expected{"/home/ada/my car.png"};
  for (const char* text : {"/home/ada/my car.png", "  /home/ada/my car.png\r\n", "\"/home/ada/my car.png\"",
                           "'/home/ada/my car.png'", "~/my car.png", "\"~/my car.png\"",
                           "file:///home/ada/my%20car.png", "file://localhost/home/ada/my%20car.png",
                           "file:/home/ada/my%20car.png", "FILE:///home/ada/my car.png\n"}) {
    const auto read = pasted(text);
    ASSERT_TRUE(read.ok()) << text << ": " << to_string(read.error());
    EXPECT_EQ(*read, expected) << text;
  }
  EXPECT_EQ(pasted("file:///a%25b%C3%BC.PNG").value(), Paths{"/a%b\xc3\xbc.PNG"});
  EXPECT_EQ(pasted("/a%20b.png").value(), Paths{"/a%20b.png"}) << "escapes belong to addresses";
}

TEST(PastedPaths, SeveralLinesNameSeveralFilesInTheirOrder) {
  EXPECT_EQ(pasted("file:///b.png\r\n\r\n~/a.obj\n/c.png").value(),
            (Paths{"/b.png", "/home/ada/a.obj", "/c.png"}));
}

TEST(PastedPaths, OtherTextNamesNone) {
  for (const char* text :
       {"", "\n \n", "118 mm", "/home/ada", "/home/ada/notes.txt", "~", "file:///a.txt", "/a.png\nand a note",
        "https://example.org/", "\"", "''", "https://example.org/a.png?size=2"}) {
    const auto read = pasted(text);
    ASSERT_TRUE(read.ok()) << text;
    EXPECT_TRUE(read->empty()) << text;
  }
  EXPECT_TRUE(pasted("/" + std::string(std::size_t(1) << 20, 'a') + ".png").value().empty()) << "too long";
}

TEST(PastedPaths, ANameWithoutAPlaceIsRefusedWithASentence) {
  for (const char* text : {"front.png", "pictures/front.png", "../a.obj", "~bob/a.png", "/b.png\nfront.png"})
    EXPECT_NE(why_no_place(text).find("relative"), std::string::npos) << text;
  EXPECT_NE(why_no_place("file://server/share/a.png").find("another computer"), std::string::npos);
  EXPECT_NE(why_no_place("https://example.org/a.png").find("no file of this computer"), std::string::npos);
  for (const char* text : {"file:///a%zz.png", "file:///a%0.png", "file:///a%00.png"})
    EXPECT_NE(why_no_place(text).find("escapes"), std::string::npos) << text;
  const auto homeless = pasted_paths("~/a.png", {}, known_ending);
  test::must_fail(homeless, e_pasted_path);
  EXPECT_FALSE(homeless.error().remedy.empty());
}

TEST(PastedPaths, VeryManyAreRefused) {
  std::string text;
  for (std::size_t i = 0; i < most_pasted_paths; ++i) text += "/a.png\n";
  EXPECT_EQ(pasted(text)->size(), most_pasted_paths);
  EXPECT_NE(why_no_place(text + "/b.png").find("257 files"), std::string::npos);
}

TEST(PastedPaths, AddressesOfAnyNameComeBackAndAnyTextIsJudged) {
  test::for_random(41, 300, [](std::mt19937_64& rng) {
    std::string name = "/";
    for (int i = test::uniform_int(rng, 0, 30); i > 0; --i)
      name += static_cast<char>(test::uniform_int(rng, 1, 255));
    name += "a.png";
    const auto read = test::must(pasted(file_uri(name)));
    ASSERT_EQ(*read, Paths{name});
    std::string text = "file:///a%20b.png\n'~/c.obj'\nhttps://d/e.png";
    for (int i = test::uniform_int(rng, 1, 8); i > 0; --i)
      text[rng() % text.size()] = static_cast<char>(rng());
    const auto any = pasted(text);
    if (!any.ok()) {
      EXPECT_EQ(any.error().code, e_pasted_path);
    } else {
      for (const auto& path : *any) EXPECT_TRUE(path.is_absolute()) << path;
    }
  });
}

}  // namespace
}  // namespace hariko
