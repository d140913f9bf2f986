// Mesh files of a million triangles, read and written, beside assimp in the same run. Rows come in pairs:
// ours, then assimp's. Files lie in the folder for temporary files, so what is written has been through the
// file system.
//   hariko_exchange_bench

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <filesystem>

#include "bench/models.hpp"
#include "core/exchange/mesh_file.hpp"

namespace hariko {
namespace {

constexpr std::int64_t triangles = 1'000'000;
constexpr int repeats = 5;

/// Format under its names here and in assimp, and how assimp is asked for points that triangles share, which
/// is what our readers give: OBJ and PLY have indices that it may keep, STL has none.
struct Format {
  const char* ending;
  const char* assimp_id;
  unsigned reading;
};
constexpr Format formats[] = {
    {"obj", "objnomtl", aiProcess_JoinIdenticalVertices},
    {"stl", "stlb", aiProcess_JoinIdenticalVertices},
    {"ply", "plyb", 0},
};

/// A folder for the files of one run.
class ScratchFolder {
 public:
  ScratchFolder()
      : path_(std::filesystem::temp_directory_path() /
              ("hariko_exchange_bench." + std::to_string(::getpid()))) {
    std::filesystem::create_directory(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::filesystem::path file(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

TriangleMesh million_triangles() {
  const PolygonMesh quads = bench_torus_mesh(triangles / 2);
  TriangleMesh mesh;
  mesh.positions = quads.positions;
  for (std::size_t f = 0; f < quads.face_count(); ++f) {
    const auto quad = quads.face(f);
    mesh.triangles.push_back({quad[0], quad[1], quad[2]});
    mesh.triangles.push_back({quad[0], quad[2], quad[3]});
  }
  return mesh;
}

void count(benchmark::State& state, const std::filesystem::path& path, std::size_t read_vertices) {
  const auto bytes = static_cast<double>(std::filesystem::file_size(path));
  state.counters["MB"] = bytes / 1e6;
  state.counters["MB/s"] =
      benchmark::Counter(bytes * double(state.iterations()) / 1e6, benchmark::Counter::kIsRate);
  if (read_vertices > 0) state.counters["vertices"] = double(read_vertices);
}

void write_ours(benchmark::State& state, const TriangleMesh& mesh, const std::filesystem::path& path) {
  const NamedTriangles named[] = {{"torus", &mesh}};
  for (auto _ : state)
    if (!write_mesh_file(path, named).ok()) return state.SkipWithError("not written");
  count(state, path, 0);
}

void read_ours(benchmark::State& state, const std::filesystem::path& path) {
  std::size_t vertices = 0;
  for (auto _ : state) {
    const Result<ImportedMesh> read = read_mesh_file(path);
    if (!read.ok()) return state.SkipWithError("not read");
    vertices = read->mesh.positions.size();
  }
  count(state, path, vertices);
}

/// Writes what assimp has read from `source`, so that its exporter begins with a scene of its own.
void write_assimp(benchmark::State& state, const Format& format, const std::filesystem::path& source,
                  const std::filesystem::path& path) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(source.string(), aiProcess_JoinIdenticalVertices);
  if (scene == nullptr) return state.SkipWithError("no scene");
  for (auto _ : state) {
    Assimp::Exporter exporter;
    if (exporter.Export(scene, format.assimp_id, path.string()) != aiReturn_SUCCESS)
      return state.SkipWithError("not written");
  }
  count(state, path, 0);
}

void read_assimp(benchmark::State& state, const std::filesystem::path& path, unsigned reading) {
  std::size_t vertices = 0;
  for (auto _ : state) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path.string(), reading);
    if (scene == nullptr) return state.SkipWithError("not read");
    vertices = scene->mMeshes[0]->mNumVertices;
  }
  count(state, path, vertices);
}

void add(const std::string& name, const std::function<void(benchmark::State&)>& run) {
  benchmark::RegisterBenchmark(name.c_str(), run)
      ->Iterations(1)
      ->Repetitions(repeats)
      ->ReportAggregatesOnly()
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

void add_all(const TriangleMesh& mesh, const ScratchFolder& folder) {
  for (const Format& format : formats) {
    const std::string name = format.ending;
    const std::filesystem::path ours = folder.file("ours." + name), theirs = folder.file("assimp." + name);
    add("write/" + name + "/hariko",
        [&mesh, ours](benchmark::State& state) { write_ours(state, mesh, ours); });
    // Both read the same file, the one that was just written.
    add("read/" + name + "/hariko", [ours](benchmark::State& state) { read_ours(state, ours); });
    add("read/" + name + "/assimp",
        [ours, &format](benchmark::State& state) { read_assimp(state, ours, format.reading); });
    if (format.reading != 0)
      add("read/" + name + "/assimp_unjoined",
          [ours](benchmark::State& state) { read_assimp(state, ours, 0); });
    add("write/" + name + "/assimp",
        [ours, theirs, &format](benchmark::State& state) { write_assimp(state, format, ours, theirs); });
  }
}

}  // namespace
}  // namespace hariko

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  const hariko::ScratchFolder folder;
  const hariko::TriangleMesh mesh = hariko::million_triangles();
  hariko::add_all(mesh, folder);
  benchmark::RunSpecifiedBenchmarks();
}
