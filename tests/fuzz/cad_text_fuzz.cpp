#include "core/cad/kernel/cad_text.hpp"
#include "tests/fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hariko;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto wrong = check_iges_text(text)) fuzz::check(*wrong, Severity::error);
  if (const auto wrong = check_step_text(text)) {
    fuzz::check(*wrong, Severity::error);
  } else {
    // What stands behind the end mark does not matter, and without the mark the file is not whole.
    fuzz::require(!check_step_text(std::string(text) + "("), "a whole file stays whole");
    const std::size_t mark = text.rfind("END-ISO-10303-21");
    fuzz::require(mark != std::string_view::npos, "a whole file has its end mark");
  }
  return 0;
}
