// Prints what surfaces over cages are like: one row for each OBJ file, equal frames beside frames by measure.
// hariko_frames_table [--target] FILE.obj ...

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/analysis/continuity.hpp"
#include "core/analysis/measures.hpp"
#include "core/patching/polyhedron_surface.hpp"

namespace hariko {
namespace {

constexpr int steps = 12;  ///< samples along a patch's sides

/// Plain "v" and "f" lines; what follows a slash is left out.
PolygonMesh read_obj(const std::string& name) {
  std::ifstream file(name);
  PolygonMesh mesh;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Vector3 p;
      words >> p.x() >> p.y() >> p.z();
      mesh.positions.push_back(p);
    } else if (kind == "f") {
      std::vector<Index> face;
      for (std::string corner; words >> corner;) face.push_back(Index(std::stoul(corner)) - 1);
      mesh.add_face(face);
    }
  }
  return mesh;
}

struct Row {
  double bending = 0, largest_curvature = 0, volume = 0, beyond = 0, jump = 0, normal_jump = 0;
  int folded = 0;
};

/// The larger absolute principal curvature.
double curvature(const PatchPoint& p, const Vector3& normal) {
  const double e = p.ds.dot(p.ds), f = p.ds.dot(p.dt), g = p.dt.dot(p.dt);
  const double l = p.dss.dot(normal), m = p.dst.dot(normal), n = p.dtt.dot(normal);
  const double area = e * g - f * f;
  if (!(area > 0)) return 0;
  const double mean = (e * n - 2 * f * m + g * l) / (2 * area), gauss = (l * n - m * m) / area;
  return std::abs(mean) + std::sqrt(std::max(0.0, mean * mean - gauss));
}

void sample(const Surface& surface, Index patch, const Eigen::AlignedBox3d& box, Row& row) {
  std::vector<std::vector<Vector3>> normals(steps + 1);
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps - i; ++j) {
      const PatchPoint point =
          surface.patches().evaluate(patch, {double(i) / steps, double(j) / steps}, Order::second);
      const Vector3 normal = point.ds.cross(point.dt).stableNormalized();
      normals[std::size_t(i)].push_back(normal);
      for (int axis = 0; axis < 3; ++axis)
        row.beyond = std::max(
            {row.beyond, point.position[axis] - box.max()[axis], box.min()[axis] - point.position[axis]});
      if (i > 0 && j > 0 && i + j < steps)
        row.largest_curvature = std::max(row.largest_curvature, curvature(point, normal));
    }
  bool folds = false;
  for (std::size_t i = 0; i < normals.size(); ++i)
    for (std::size_t j = 0; i + j < steps; ++j)
      folds = folds || normals[i][j].dot(normals[i][j + 1]) < 0 || normals[i][j].dot(normals[i + 1][j]) < 0;
  row.folded += folds ? 1 : 0;
}

Row row_of(const Polyhedron& polyhedron, Mode mode, Frames frames) {
  PolyhedronSurfaceInput input{polyhedron, {}, mode, Vector3::Zero()};
  input.frames = frames;
  const auto made = PolyhedronSurfacer().rebuild(input);
  Row row;
  if (!made) {
    std::printf("%s\n", to_string(made.error()).c_str());
    return row;
  }
  const Measures measures = measure(made->surface);
  const ContinuityReport report = continuity(made->surface);
  row.bending = measures.bending;
  row.volume = measures.volume.value_or(0);
  row.jump = report.rms_curvature_jump.value_or(0);
  row.normal_jump = report.largest_normal_jump.value_or(0);
  Eigen::AlignedBox3d box;
  for (const Vector3& p : polyhedron.positions()) box.extend(p);
  for (Index patch = 0; patch < made->surface.patches().patch_count(); ++patch)
    sample(made->surface, patch, box, row);
  return row;
}

int run(const std::vector<std::string>& arguments) {
  Mode mode = Mode::fair;
  std::printf("%-20s %s\n", "cage",
              "bend | largest curvature | volume | beyond the box | jump | folded | G1 (equal / by measure)");
  for (const std::string& argument : arguments) {
    if (argument == "--target") {
      mode = Mode::target;
      continue;
    }
    const auto polyhedron = Polyhedron::build(read_obj(argument));
    if (!polyhedron) {
      std::printf("%s: %s\n", argument.c_str(), to_string(polyhedron.error()).c_str());
      return 1;
    }
    const Row a = row_of(*polyhedron, mode, Frames::equal), b = row_of(*polyhedron, mode, Frames::metric);
    std::printf(
        "%-20s %.2f / %.2f | %.2f / %.2f | %.2f / %.2f | %.3f / %.3f | %.3f / %.3f | %d / %d | %.0e / %.0e\n",
        std::filesystem::path(argument).stem().c_str(), a.bending, b.bending, a.largest_curvature,
        b.largest_curvature, a.volume, b.volume, a.beyond, b.beyond, a.jump, b.jump, a.folded, b.folded,
        a.normal_jump, b.normal_jump);
  }
  return 0;
}

}  // namespace
}  // namespace hariko

int main(int count, char** arguments) {
  return hariko::run(std::vector<std::string>(arguments + 1, arguments + count));
}
