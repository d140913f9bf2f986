#include "core/exchange/read_stl.hpp"
#include "tests/fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hariko;
  const auto result = read_stl({reinterpret_cast<const char*>(data), size});
  fuzz::check(result, size);
  if (!result.ok()) return 0;
  const NamedPolygons named[] = {{result->name, &result->mesh}};
  const auto written =
      write_stl(std::span<const NamedPolygons>(named));  // text may exceed the range of floats
  if (written.ok()) fuzz::check(read_stl(*written), written->size());
  return 0;
}
