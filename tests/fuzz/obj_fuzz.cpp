#include "core/exchange/obj/read_obj.hpp"
#include "tests/fuzz/check_scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hariko;
  const auto read = [](std::string_view bytes) { return read_obj(bytes); };
  const auto result = read({reinterpret_cast<const char*>(data), size});
  fuzz::check(result, size);
  fuzz::check_round_trip(result, read, [](auto meshes) { return write_obj(meshes); });
  if (size < fuzz::small_limits().vertices)
    fuzz::check(read_obj_scene({reinterpret_cast<const char*>(data), size}, fuzz::small_limits()), false);
  return 0;
}
