#include "core/exchange/archive_3mf/read_3mf.hpp"
#include "tests/fuzz/check_scene.hpp"

/// Archives, and the text of models without an archive: packed text hardly changes in small ways.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hariko;
  const std::string_view bytes{reinterpret_cast<const char*>(data), size};
  fuzz::check(looks_like_zip(bytes) ? read_3mf(bytes, fuzz::small_limits())
                                    : read_3mf_model(bytes, fuzz::small_limits()));
  return 0;
}
