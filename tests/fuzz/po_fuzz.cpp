#include "core/base/text/plural_forms.hpp"
#include "core/base/text/po_file.hpp"
#include "tests/fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hariko;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto file = read_po(bytes);
  if (file.ok()) {
    std::size_t texts = 0;
    for (const PoEntry& entry : file->entries) {
      fuzz::require(!entry.text.empty() && !entry.translations.empty(), "entries are whole");
      fuzz::require(!entry.plural.empty() || entry.translations.size() == 1, "only plurals have forms");
      texts += entry.context.size() + entry.text.size() + entry.plural.size();
      for (const std::string& translation : entry.translations) texts += translation.size();
    }
    fuzz::require(texts <= size, "size in proportion");
  } else {
    fuzz::check(file.error(), Severity::error);
  }
  const auto forms = PluralForms::parse(bytes);
  if (!forms.ok()) {
    fuzz::check(forms.error(), Severity::error);
    return 0;
  }
  for (const std::uint64_t n :
       {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{123'456'789}, ~std::uint64_t{0}})
    fuzz::require(forms->form(n) < forms->count(), "forms exist");
  return 0;
}
