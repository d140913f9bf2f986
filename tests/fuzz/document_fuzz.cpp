#include "core/document/format/format.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "core/base/text/sanitized_utf8.hpp"

/// Documents that read are written, and read again as equal ones with the same text; others say why.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hariko;
  const auto require = [](bool condition, const char* what) {
    if (condition) return;
    std::fprintf(stderr, "broken promise: %s\n", what);
    std::abort();
  };
  const auto document = read_document({reinterpret_cast<const char*>(data), size});
  if (!document.ok()) {
    require(!document.error().text.empty(), "message is empty");
    require(sanitized_utf8(document.error().text, 100'000) == document.error().text, "text is printable");
    return 0;
  }
  const std::string text = write_document(*document);
  const auto again = read_document(text);
  require(again.ok(), "what is written can be read");
  require(*again == *document, "the document comes back");
  require(write_document(*again) == text, "the text comes back");
  return 0;
}
