#include "core/exchange/triangles/read_off.hpp"
#include "tests/fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hariko;
  fuzz::check(read_off({reinterpret_cast<const char*>(data), size}), size);
  return 0;
}
