#include "core/exchange/triangles/read_ply.hpp"
#include "tests/fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hariko;
  const auto read = [](std::string_view bytes) { return read_ply(bytes); };
  const auto result = read({reinterpret_cast<const char*>(data), size});
  fuzz::check(result, size);
  for (const MeshEncoding encoding : {MeshEncoding::ascii, MeshEncoding::binary})
    fuzz::check_round_trip(result, read, [&](auto meshes) { return write_ply(meshes, encoding); });
  return 0;
}
