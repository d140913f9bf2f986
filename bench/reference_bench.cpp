// Reference pictures of 8 megapixels: how long one takes to be decoded (off the main thread), and frames with
// twenty of them: while they come to the GPU, and when they are there.

#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <chrono>
#include <string>

#include "bench/photographs.hpp"
#include "render/offscreen.hpp"
#include "render/renderer.hpp"

namespace hariko {
namespace {

constexpr int pictures = 20;
constexpr std::size_t bytes_a_frame = std::size_t(8) << 20;  // as in the window

void decode(benchmark::State& state) {
  const std::string file = png_of(bench_photograph(eight_megapixels));
  for (auto _ : state) benchmark::DoNotOptimize(decode_reference(file));
}
BENCHMARK(decode)->Unit(benchmark::kMillisecond);

Scene scene_of_twenty() {
  const auto decoded = decode_reference(png_of(bench_photograph(eight_megapixels)));
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
