#include "core/exchange/triangles/read_stl.hpp"
#include "tests/fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hariko;
  const auto result = read_stl({reinterpret_cast<const char*>(data), size});
  fuzz::check(result, size);
  if (!result.ok()) return 0;
  const NamedPolygons named[] = {{result->name, &result->mesh}};
  for (const MeshEncoding encoding : {MeshEncoding::ascii, MeshEncoding::binary}) {
    // Text may exceed the range of floats.
    const auto written = write_stl(std::span<const NamedPolygons>(named), encoding);
    if (written.ok()) fuzz::check(read_stl(*written), written->size());
  }
  return 0;
}
