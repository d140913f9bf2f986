// Heavy work of a designer's day: a scan of two million triangles that is opened, framed and made ready
// for drawing; twenty reference pictures of 8 megapixels that are decoded; a thousand live copies that are
// placed and measured. Nothing is drawn, so that no graphics card is needed.
//   hariko_heavy_bench [--benchmark_filter=scan|pictures|copies]

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/engines/surface_builder.hpp"
#include "app/files/open_file.hpp"
#include "app/files/prepare_meshes.hpp"
#include "bench/models.hpp"
#include "bench/photographs.hpp"
#include "core/analysis/measures.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/object_box.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/exchange/repair/mesh_import.hpp"
#include "core/modeling/objects/arrange.hpp"
#include "render/reference_image.hpp"
#include "render/scene.hpp"
#include "ui/editor/object_lines.hpp"

namespace hariko {
namespace {

constexpr std::int64_t scanned_quads = 1'000'000;
constexpr int pictures = 20;
constexpr int copies_in_a_row = 10, copies_round = 50;  // and their mirror images: 1,000
constexpr std::int64_t faces_of_a_copy = 1000;
constexpr PixelSize window_size{1280, 800};

/// About two million triangles.
TriangleMesh scanned_triangles() {
  const PolygonMesh quads = bench_torus_mesh(scanned_quads);
  TriangleMesh mesh;
  mesh.positions = quads.positions;
  for (std::size_t f = 0; f < quads.face_count(); ++f) {
    const auto quad = quads.face(f);
    mesh.triangles.push_back({quad[0], quad[1], quad[2]});
    mesh.triangles.push_back({quad[0], quad[2], quad[3]});
  }
  return mesh;
}

/// File of the scan in the folder for temporary files, which goes with it.
class ScanFile {
 public:
  ScanFile()
      : path_(std::filesystem::temp_directory_path() /
              ("hariko_heavy_bench." + std::to_string(::getpid()) + ".stl")) {
    const TriangleMesh mesh = scanned_triangles();
    const NamedTriangles named[] = {{"Scan", &mesh}};
    written_ = write_mesh_file(path_, named).ok();
    triangles_ = mesh.triangles.size();
  }
  ~ScanFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  ScanFile(const ScanFile&) = delete;
  ScanFile& operator=(const ScanFile&) = delete;

  bool written() const { return written_; }
  std::size_t triangles() const { return triangles_; }
  /// The scan as reference facets, as the window opens it.
  std::optional<Document> open() const {
    OpenedFile opened = open_file(path_);
    prepare_meshes(opened, MeshImport{MeshUse::reference});
    return std::move(opened.document);
  }

 private:
  std::filesystem::path path_;
  bool written_ = false;
  std::size_t triangles_ = 0;
};

SurfaceView view_of_object(const std::shared_ptr<const Object>& object) {
  return SurfaceBuilder().build(object, {}, {}, Quality::final, {});
}

void scan_opened(benchmark::State& state) {
  const ScanFile file;
  if (!file.written()) return state.SkipWithError("not written");
  for (auto _ : state) {
    const std::optional<Document> document = file.open();
    if (!document) return state.SkipWithError("not opened");
    benchmark::DoNotOptimize(document->objects.front().get());
  }
  state.counters["triangles"] = double(file.triangles());
}

void scan_framed(benchmark::State& state) {
  const std::optional<Document> document = ScanFile().open();
  if (!document) return state.SkipWithError("not opened");
  const std::shared_ptr<const Object> object = document->objects.front();
  Scene scene;
  scene.objects.emplace_back().mesh = view_of_object(object).mesh;
  if (!scene.objects.front().mesh) return state.SkipWithError("no mesh");
  for (auto _ : state) {
    benchmark::DoNotOptimize(world_box(*object));
    benchmark::DoNotOptimize(framed(Camera::standard(StandardView::iso), scene, window_size));
  }
}

/// The facets with their normals, and their edges, as they go to the graphics card.
void scan_made_ready_for_drawing(benchmark::State& state) {
  const std::optional<Document> document = ScanFile().open();
  if (!document) return state.SkipWithError("not opened");
  const std::shared_ptr<const Object> object = document->objects.front();
  for (auto _ : state) {
    benchmark::DoNotOptimize(view_of_object(object).mesh.get());
    benchmark::DoNotOptimize(lines_of(*document, *object).get());
  }
}

/// One after the other, as the window's worker does it, with all of them in memory at the end.
void pictures_decoded(benchmark::State& state) {
  const std::string file = png_of(bench_photograph(eight_megapixels));
  for (auto _ : state) {
    std::vector<ReferenceImage> decoded;
    for (int i = 0; i < pictures; ++i) {
      auto picture = decode_reference(file);
      if (!picture.ok()) return state.SkipWithError("not decoded");
      decoded.push_back(std::move(picture).value());
    }
    benchmark::DoNotOptimize(decoded.data());
  }
}

/// A part in a row, round an axis, and with its mirror image.
Result<Document> with_copies(const Document& document) {
  const ObjectId id = document.objects.front()->id;
  const std::span<const ObjectId> ids(&id, 1);
  const CopyArray arrays[] = {RowOfCopies{copies_in_a_row, {8, 0, 0}},
                              RingOfCopies{copies_round, {0, 50, 0}, {1, 0, 0}, 360},
                              mirror_of_copies({0, -20})};
  Result<Document> out = document;
  for (const CopyArray& array : arrays)
    if (out.ok()) out = add_live_copies(*out, ids, array);
  return out;
}

Document one_part() {
  return document_from_mesh(bench_torus_mesh(faces_of_a_copy), "Part").value();
}

void copies_placed(benchmark::State& state) {
  const Document document = one_part();
  std::size_t places = 0;
  for (auto _ : state) {
    const auto made = with_copies(document);
    if (!made.ok()) return state.SkipWithError("not placed");
    places = places_of(*made->objects.front()).size();
  }
  state.counters["places"] = double(places);
}

/// The box round all that is seen of them, as the status line tells it, and their area and volume.
void copies_measured(benchmark::State& state) {
  const auto document = with_copies(one_part());
  if (!document.ok()) return state.SkipWithError("not placed");
  const std::shared_ptr<const Object> object = document->objects.front();
  const SurfaceView view = view_of_object(object);
  if (!view.mesh) return state.SkipWithError("no surface");
  const auto box_at = [&](const Similarity& place) {
    Box3 box;
    for (std::size_t v = 0; v < view.mesh->vertex_count(); ++v) {
      const auto& p = view.mesh->vertex(v).position;
      box.extend(place.apply(view.mesh->origin() + Vector3(double(p[0]), double(p[1]), double(p[2]))));
    }
    return box;
  };
  for (auto _ : state) {
    benchmark::DoNotOptimize(box_of_places(*object, box_at));
    benchmark::DoNotOptimize(measure(view.surface).area * double(place_count(*object)));
  }
  state.counters["places"] = double(place_count(*object));
}

// Wall time, as several cores work at once; each reading takes long enough by itself.
BENCHMARK(scan_opened)->Iterations(3)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(scan_framed)->Iterations(10)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(scan_made_ready_for_drawing)->Iterations(3)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(pictures_decoded)->Iterations(3)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(copies_placed)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(copies_measured)->Iterations(3)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hariko

BENCHMARK_MAIN();
