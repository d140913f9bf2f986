// The page that describes the format shows a file that this program reads and writes.

#include <gtest/gtest.h>

#include "core/base/files/file_io.hpp"
#include "core/document/format/format.hpp"
#include "tests/support/places.hpp"

namespace hariko {
namespace {

TEST(FormatPage, ItsExampleIsADocument) {
  const std::string page = read_file(test::source_folder() + "/docs/format.md").value();
  const std::string fence = "```json\n";
  const std::size_t begin = page.find(fence) + fence.size();
  const std::string example = page.substr(begin, page.find("```", begin) - begin);
  const Result<Document> document = read_document(example);
  ASSERT_TRUE(document) << to_string(document.error());
  EXPECT_EQ(write_document(*document), example);
  EXPECT_NE(page.find("version " + std::to_string(format_version) + "."), std::string::npos);
}

}  // namespace
}  // namespace hariko
