// Recent files: latest first, without those that are gone, whatever the file of the list holds.

#include "app/persistence/recent_files.hpp"

#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;

class RecentFilesTest : public ::testing::Test {
 protected:
  fs::path make(const std::string& name) {
    const fs::path file = folder_.path() / name;
    test::spill(file, "a document");
    return file;
  }
  std::vector<std::string> names() const {
    std::vector<std::string> out;
    for (const RecentEntry& entry : recent_.load()) out.push_back(entry.path.filename().string());
    return out;
  }
  using Names = std::vector<std::string>;

  test::TemporaryFolder folder_;
  RecentFiles recent_{folder_.path() / "state" / "recent.json"};
};

TEST_F(RecentFilesTest, TheLatestComesFirstAndOnce) {
  EXPECT_TRUE(recent_.load().empty());
  const fs::path a = make("a.hariko"), b = make("b.hariko"), umlaut = make("W\u00fcrfel 1.hariko");
  ASSERT_TRUE(recent_.touch(a, 10).ok());
  ASSERT_TRUE(recent_.touch(b, 20).ok());
  ASSERT_TRUE(recent_.touch(umlaut, 30).ok());
  EXPECT_EQ(names(), (Names{"W\u00fcrfel 1.hariko", "b.hariko", "a.hariko"}));
  ASSERT_TRUE(recent_.touch(a, 40).ok());
  EXPECT_EQ(names(), (Names{"a.hariko", "W\u00fcrfel 1.hariko", "b.hariko"}));
  EXPECT_EQ(recent_.load()[0].used_at, 40);
  EXPECT_EQ(recent_.load()[0].path, a);
}

TEST_F(RecentFilesTest, FilesThatAreGoneAreLeftOut) {
  const fs::path a = make("a.hariko"), b = make("b.hariko");
  ASSERT_TRUE(recent_.touch(a, 10).ok());
  ASSERT_TRUE(recent_.touch(b, 20).ok());
  fs::remove(b);
  EXPECT_EQ(names(), Names{"a.hariko"});
}

TEST_F(RecentFilesTest, TheOldestAreForgotten) {
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(recent_.touch(make(std::to_string(i) + ".hariko"), i).ok());
  const auto entries = recent_.load();
  ASSERT_EQ(entries.size(), RecentFiles::most);
  for (std::size_t i = 0; i < entries.size(); ++i) EXPECT_EQ(entries[i].used_at, 99 - static_cast<int>(i));
}

TEST_F(RecentFilesTest, ABrokenListIsAnEmptyOneAndIsWrittenAnew) {
  const fs::path list = folder_.path() / "state" / "recent.json";
  fs::create_directories(list.parent_path());
  const fs::path a = make("a.hariko");
  for (const char* broken :
       {"", "[", "{}", "[1, null, {}]", "[{\"uri\": 3}]", "{\"files\": [{\"uri\": \"x\"}]}", "\xff\xfe"}) {
    test::spill(list, broken);
    EXPECT_TRUE(recent_.load().empty()) << broken;
    ASSERT_TRUE(recent_.touch(a, 5).ok()) << broken;
    EXPECT_EQ(names(), Names{"a.hariko"}) << broken;
  }
}

TEST_F(RecentFilesTest, AListThatCannotBeWrittenSaysSo) {
  test::spill(folder_.path() / "state", "a file where the folder should be");
  EXPECT_FALSE(recent_.touch(make("a.hariko"), 1).ok());
  EXPECT_TRUE(recent_.load().empty());
}

}  // namespace
}  // namespace hariko
