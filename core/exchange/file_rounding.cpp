#include "core/exchange/file_rounding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/geometry/angles.hpp"
#include "core/geometry/triangle.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

namespace {

/// Displacement relative to the size: above `ruinous` the shape is ruined, below `harmless` it is as good as
/// the format allows.
constexpr double ruinous = 1e-4, harmless = 1e-6;
/// Height of a facet relative to its longest side, below which it counts as having had no area.
constexpr double needle = 1e-9;

constexpr const char* way_out =
    "Move the model to zero as it is written (--origin zero, \"move to zero\" in the dialog), or write OBJ, "
    "PLY, "
    "3MF or glTF.";

/// Positions after writing and reading, relative to the unrounded origin.
std::vector<Vector3> rounded_positions(const std::vector<Vector3>& positions, const Vector3& origin,
                                       const FileNumbers& numbers) {
  // The origin of local floats is written in double precision.
  const Vector3 from = numbers.kind == FileNumbers::Kind::floats ? origin : Vector3(Vector3::Zero());
  std::vector<Vector3> out;
  out.reserve(positions.size());
  for (const Vector3& position : positions) {
    const Vector3 whole = from + position;
    out.push_back(whole.unaryExpr([&](double x) { return numbers.rounded(x); }) - from);
  }
  return out;
}

/// Whether two different corners of the facet become equal.
bool collapses(const std::vector<Vector3>& rounded, const std::vector<Vector3>& positions, Index a, Index b) {
  return rounded[a] == rounded[b] && positions[a] != positions[b];
}
bool collapses(const std::vector<Vector3>& rounded, const std::vector<Vector3>& positions, Index a, Index b,
               Index c) {
  return collapses(rounded, positions, a, b) || collapses(rounded, positions, b, c) ||
         collapses(rounded, positions, c, a);
}

class Measure {
 public:
  Measure(const std::vector<Vector3>& positions, const Vector3& origin, const FileNumbers& numbers)
      : positions_(positions), rounded_(rounded_positions(positions, origin, numbers)) {}

  void take(Index a, Index b, Index c) {
    const std::array corners{a, b, c};
    for (const Index v : corners) {
      out_.distance = std::max(out_.distance, (rounded_[v] - positions_[v]).norm());
      box_.extend(positions_[v]);
    }
    const auto area = [&](const std::vector<Vector3>& p) { return area_vector(p[a], p[b], p[c]); };
    const Vector3 was = area(positions_), is = area(rounded_);
    const double longest = std::max({(positions_[b] - positions_[a]).squaredNorm(),
                                     (positions_[c] - positions_[b]).squaredNorm(),
                                     (positions_[a] - positions_[c]).squaredNorm()});
    if (collapses(rounded_, positions_, a, b, c)) ++out_.left_out;
    if (!(was.norm() > needle * longest)) return;
    if (!(is.norm() > 0))
      ++out_.collapsed;
    else
      out_.turn = std::max(out_.turn, angle_between(was, is));
  }

  FileRounding done() {
    if (!box_.isEmpty()) out_.size = box_.diagonal().norm();
    return out_;
  }

 private:
  const std::vector<Vector3>& positions_;
  const std::vector<Vector3> rounded_;
  Eigen::AlignedBox3d box_;
  FileRounding out_;
};

std::string facet_count(std::size_t count) {
  return counted(count, " facet", " facets");
}

}  // namespace

FileRounding rounding_of(const TriangleMesh& mesh, const FileNumbers& numbers) {
  if (numbers.kind == FileNumbers::Kind::exact) return {};
  Measure measure(mesh.positions, mesh.origin, numbers);
  for (const auto& [a, b, c] : mesh.triangles) measure.take(a, b, c);
  return measure.done();
}

FileRounding rounding_of(const PolygonMesh& mesh, const FileNumbers& numbers) {
  if (numbers.kind == FileNumbers::Kind::exact) return {};
  std::vector<Vector3> positions = mesh.positions;
  const Vector3 origin = origin_for(positions);
  for (Vector3& position : positions) position -= origin;
  Measure measure(positions, origin, numbers);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 2; k < face.size(); ++k) measure.take(face[0], face[k - 1], face[k]);
  }
  return measure.done();
}

TriangleMesh without_collapsed(const TriangleMesh& mesh, const FileNumbers& numbers) {
  const std::vector<Vector3> rounded = rounded_positions(mesh.positions, mesh.origin, numbers);
  TriangleMesh out = mesh;
  out.triangles.clear();
  out.normal_triangles.clear();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (collapses(rounded, mesh.positions, a, b, c)) continue;
    out.triangles.push_back(mesh.triangles[t]);
    if (!mesh.normal_triangles.empty()) out.normal_triangles.push_back(mesh.normal_triangles[t]);
  }
  return out;
}

double largest_rounding(const Eigen::AlignedBox3d& box, const FileNumbers& numbers) {
  if (numbers.kind == FileNumbers::Kind::exact || box.isEmpty()) return 0;
  const bool absolute = numbers.kind == FileNumbers::Kind::floats;
  const Vector3 farthest =
      absolute ? Vector3(box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs())) : Vector3(box.sizes());
  // Rounding to float is off by at most half of the last digit, a relative error of 2^-24.
  constexpr double share = 0.5 * std::numeric_limits<float>::epsilon();
  return share * farthest.norm();
}

bool ruins(const FileRounding& rounding, const double* allowed) {
  return rounding.distance > (allowed ? *allowed : ruinous * rounding.size) ||
         (rounding.collapsed > 0 && rounding.distance > harmless * rounding.size);
}

Message digits_error(const FileRounding& rounding, std::string_view name) {
  const std::string moves = std::string(name) +
                            ": this format holds 7 to 8 digits, which moves vertices by up to " +
                            rounded_text(rounding.distance, 3);
  return make_error(e_file_digits,
                    rounding.collapsed == 0
                        ? moves + " so far from zero."
                        : moves + " so far from zero, and flattens " + facet_count(rounding.collapsed) + ".",
                    way_out);
}

Message turn_error(const FileRounding& rounding, std::string_view name) {
  return make_error(e_file_digits,
                    std::string(name) + ": this format holds 7 to 8 digits, which turns facets by up to " +
                        rounded_text(rounding.turn * 180 / std::numbers::pi, 3) +
                        " degrees: more than the angle that was asked for leaves.",
                    way_out);
}

bool coarse(const FileRounding& rounding, const double* allowed) {
  return rounding.collapsed > 0 || (!allowed && rounding.distance > harmless * rounding.size);
}

Message digits_warning(const FileRounding& rounding, std::string_view name) {
  const std::string moves = std::string(name) +
                            ": this format holds 7 to 8 digits, which moves vertices by up to " +
                            rounded_text(rounding.distance, 3);
  return make_warning(w_file_digits,
                      rounding.collapsed == 0 ? moves + "."
                                              : moves + ", and leaves out or flattens " +
                                                    facet_count(rounding.collapsed) + ", smaller than that.",
                      way_out);
}

}  // namespace hariko
