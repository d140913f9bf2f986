#include "core/base/text/utf8.hpp"
#include "core/cad/kernel/cad_text.hpp"
#include "tests/fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hariko;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const auto& prepared : {iges_text_of(std::string(text)), step_text_of(std::string(text))}) {
    if (!prepared.ok()) {
      fuzz::check(prepared.error(), Severity::error);
      continue;
    }
    for (const Message& warning : prepared->warnings) fuzz::check(warning, Severity::warning);
    for (std::string_view left = prepared->text; !left.empty(); left.remove_prefix(utf8_length(left)))
      fuzz::require(utf8_length(left) > 0, "the kernel gets UTF-8");
  }
  const auto iges = check_iges_text(text);
  if (iges.ok()) fuzz::require(iges->end <= text.size(), "a file ends in its text");
  if (check_step_text(text).ok()) {
    // Bytes behind the end mark do not matter, and without the mark the file is not whole.
    fuzz::require(check_step_text(std::string(text) + "(").ok(), "a whole file stays whole");
    const std::size_t mark = text.rfind("END-ISO-10303-21");
    fuzz::require(mark != std::string_view::npos, "a whole file has its end mark");
  }
  return 0;
}
