// Reference pictures of 8 megapixels: how long one takes to be decoded (off the main thread), and frames with
// twenty of them: while they come to the GPU, and when they are there.

#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <chrono>
#include <cmath>
#include <filesystem>

#include "core/base/files/file_io.hpp"
#include "render/offscreen.hpp"
#include "render/renderer.hpp"

namespace hariko {
namespace {

constexpr PixelSize eight_megapixels{3464, 2310};
constexpr int pictures = 20;
constexpr std::size_t bytes_a_frame = std::size_t(8) << 20;  // as in the window

/// Waves of colour with some grain: neither flat nor noise.
Image photograph(PixelSize size) {
  Image image(size.width, size.height);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      std::uint8_t* p = image.pixel(x, y);
      for (int c = 0; c < 3; ++c)
        p[c] =
            static_cast<std::uint8_t>(128 + 100 * std::sin(0.01 * (x + 2 * y) + c) + (7 * x + 13 * y) % 17);
      p[3] = 255;
    }
  return image;
}

std::string png_of(const Image& image) {
  const auto path = std::filesystem::temp_directory_path() / "hariko_reference_bench.png";
  (void)write_png(path, image);
  std::string bytes = read_file(path).value();
  std::filesystem::remove(path);
  return bytes;
}

void decode(benchmark::State& state) {
  const std::string file = png_of(photograph(eight_megapixels));
  for (auto _ : state) benchmark::DoNotOptimize(decode_reference(file));
}
BENCHMARK(decode)->Unit(benchmark::kMillisecond);

Scene scene_of_twenty() {
  const auto decoded = decode_reference(png_of(photograph(eight_megapixels)));
  Scene scene;
  for (int i = 0; i < pictures; ++i) {
    ScenePicture picture;
    // Each with pixels of its own.
    picture.image = std::make_shared<const ReferenceImage>(*decoded);
    picture.half = {1.5, 1};
    picture.transform.topRightCorner<3, 1>() = Vector3(3.2 * (i % 5) - 6.4, 2.2 * (i / 5) - 3.3, 0.01 * i);
    scene.pictures.push_back(picture);
  }
  return scene;
}

Camera over_all() {
  Camera camera = Camera::standard(StandardView::top);
  camera.distance = 20;
  return camera;
}

/// One drawing of the frame with all samples, 1280 x 800 pixels.
double frame_milliseconds(Renderer& renderer, const Scene& scene, const Camera& camera) {
  const auto start = std::chrono::steady_clock::now();
  (void)renderer.draw(scene, camera, {{1280, 800}, 1, 0, bytes_a_frame});
  glFinish();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void frames_of_twenty(benchmark::State& state) {
  auto context = OffscreenContext::create();
  auto made = Renderer::create();
  if (!context || !made) return state.SkipWithError("no OpenGL");
  Renderer renderer = std::move(made).value();
  const Scene scene = scene_of_twenty();
  const Camera camera = over_all();
  double longest = 0;
  int arriving = 0;
  do {
    const double now = frame_milliseconds(renderer, scene, camera);
    // The first one compiles shaders.
    if (arriving++ > 0) longest = std::max(longest, now);
  } while (renderer.statistics().unfinished);
  for (auto _ : state) frame_milliseconds(renderer, scene, camera);
  state.counters["longest while they arrive, ms"] = longest;
  state.counters["frames until all are sharp"] = arriving;
}
BENCHMARK(frames_of_twenty)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hariko
