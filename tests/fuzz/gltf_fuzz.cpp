#include "core/exchange/gltf/read_gltf.hpp"
#include "tests/fuzz/check_scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hariko;
  const std::string_view bytes{reinterpret_cast<const char*>(data), size};
  // Whatever is asked for lies beside the file.
  const SidecarReader beside = [](const std::string& path) -> Result<std::string> {
    fuzz::require(!path.starts_with('/') && !path.starts_with(".."), "paths stay in the folder");
    return std::string(64, '\x3f');
  };
  fuzz::check(read_gltf(bytes, fuzz::small_limits(), beside));
  return 0;
}
