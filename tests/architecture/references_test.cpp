// Comments that point to a numbered section of a page in docs/, such as "kuriyama.md, section 12.4": the page
// and the section must be there.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/places.hpp"

namespace {

namespace fs = std::filesystem;
/// Numbers of the sections of each page, by its file name.
using Sections = std::map<std::string, std::set<std::string>>;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::set<std::string> sections_in(const std::string& page) {
  static const std::regex heading(R"(#+ ([0-9]+(?:\.[0-9]+)*)\.? .*)");
  std::set<std::string> out;
  std::istringstream lines(page);
  std::smatch found;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, found, heading)) out.insert(found[1]);
  return out;
}

struct Reference {
  std::string page, section;
};

/// Also over the end of a line of comment.
std::vector<Reference> references_in(const std::string& code) {
  static const std::regex reference(
      R"(\b([a-z0-9_-]+\.md)[,:]?\s*(?:///?)?\s*(?:sections?\s)?\s*([0-9]+(?:\.[0-9]+)*))");
  std::vector<Reference> out;
  for (std::sregex_iterator at(code.begin(), code.end(), reference), end; at != end; ++at)
    out.push_back({(*at)[1], (*at)[2]});
  return out;
}

bool is_there(const Sections& pages, const Reference& reference) {
  const auto page = pages.find(reference.page);
  return page != pages.end() && page->second.contains(reference.section);
}

TEST(References, SectionsThatCommentsNameAreThere) {
  const fs::path root = hariko::test::source_folder();
  Sections pages;
  for (const auto& entry : fs::directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md")
      pages[entry.path().filename()] = sections_in(text_of(entry.path()));
  std::size_t count = 0;
  for (const char* folder : {"core", "render", "ui", "app", "tests", "bench"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path& file = entry.path();
      if ((file.extension() != ".cpp" && file.extension() != ".hpp") ||
          file.filename() == "references_test.cpp")
        continue;
      for (const Reference& reference : references_in(text_of(file))) {
        ++count;
        EXPECT_TRUE(is_there(pages, reference))
            << fs::relative(file, root) << " names " << reference.page << " " << reference.section;
      }
    }
  EXPECT_GT(count, 50U) << "references are written in another way now";
}

TEST(References, DanglingOnesAreFound) {
  const Sections pages{{"a.md", sections_in("# Title\n## 1. One\n### 1.2 More\n")}};
  const auto found = references_in("// (a.md 1.2), a.md, section 3; in b.md\n/// section 1");
  ASSERT_EQ(found.size(), 3U);
  EXPECT_TRUE(is_there(pages, found[0]));
  EXPECT_FALSE(is_there(pages, found[1]));
  EXPECT_FALSE(is_there(pages, found[2])) << "there is no such page";
}

}  // namespace
