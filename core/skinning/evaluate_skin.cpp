#include "core/skinning/evaluate_skin.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <set>

#include "core/skinning/columns/pleat.hpp"
#include "core/skinning/columns/smooth.hpp"
#include "core/skinning/skin_messages.hpp"

namespace hariko {

namespace {

std::string number(int k) {
  return std::to_string(k + 1);
}

void warn_spacing(const Skin& skin, std::vector<Message>& out) {
  const bool natural = skin.smooth.blend == Blend::natural ||
                       (skin.smooth.blend == Blend::automatic && skin.section_count() > 2);
  if (skin.method == SkinMethod::pleat || !natural) return;
  double least = 2, most = 0;
  for (int k = 0; k < skin.strip_count(); ++k) {
    const int next = (k + 1) % skin.section_count();
    const double length =
        skin.sections[std::size_t(next)].v + (next <= k ? 1 : 0) - skin.sections[std::size_t(k)].v;
    least = std::min(least, length), most = std::max(most, length);
  }
  if (most > 4 * least)
    out.push_back(make_warning(w_spacing, "The sections are spaced very unevenly: the surface may swing out.",
                               "Add sections in the long strips, or use the blend hermite."));
}

void warn_inexact(const SkinMesh& mesh, const Skin& skin, std::vector<Message>& out) {
  if (skin.method != SkinMethod::pleat || skin.pleat.fit == SectionFit::none || mesh.inexact.empty()) return;
  const auto [k, i] = mesh.inexact.front();
  const std::size_t count = mesh.inexact.size();
  out.push_back(make_warning(w_section_not_exact,
                             "The surface does not follow section " + number(k) + " exactly at " +
                                 std::to_string(count) +
                                 (count == 1 ? " point." : " points of interior sections."),
                             "Turn collars on, or raise the density of rows.",
                             element_of(VertexId{skin.sections[std::size_t(k)].points[std::size_t(i)].id})));
}

/// Warns about neighbouring faces folded onto each other.
void warn_fold(const SkinMesh& skin_mesh, std::vector<Message>& out) {
  const PolygonMesh& mesh = skin_mesh.control.mesh;
  std::vector<Vector3> normals;
  std::map<std::pair<Index, Index>, std::size_t> half_edges;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    Vector3 area = Vector3::Zero();
    for (std::size_t i = 0; i < face.size(); ++i) {
      area += mesh.positions[face[i]].cross(mesh.positions[face[(i + 1) % face.size()]]);
      half_edges[{face[i], face[(i + 1) % face.size()]}] = f;
    }
    normals.push_back(area.stableNormalized());
  }
  std::set<std::pair<Index, Index>> sharp;
  for (const auto& crease : skin_mesh.control.creases) sharp.insert({crease.a, crease.b});
  for (const auto& [edge, f] : half_edges) {
    const auto other = half_edges.find({edge.second, edge.first});
    if (edge.first > edge.second || other == half_edges.end() || sharp.contains(edge)) continue;
    if (!(normals[f].dot(normals[other->second]) < -0.2)) continue;
    const Vector3 at = (mesh.positions[edge.first] + mesh.positions[edge.second]) / 2;
    char place[96];
    std::snprintf(place, sizeof place, "(%.4g, %.4g, %.4g)", at.x(), at.y(), at.z());
    out.push_back(make_warning(w_skin_fold, std::string("The mesh folds over near ") + place + ".",
                               "Move the sections apart, or change their correspondences there."));
    return;
  }
}

/// Warns about lines that run round the path rather than along it.
void warn_twist(const Skin& skin, const SkinPlan& plan, std::vector<Message>& out) {
  for (std::size_t s = 0; s < plan.strips.size(); ++s) {
    const PlannedStrip& strip = plan.strips[s];
    // In the path's frames, so that bends of the path do not count as twist.
    const double distance = (plan.frames.position(skin.sections[std::size_t(strip.b)].v) -
                             plan.frames.position(skin.sections[std::size_t(strip.a)].v))
                                .norm();
    double scale = 1;
    if (plan.frames.mode() == FrameMode::two_rail) scale = plan.frames.frame(strip.v0).col(0).norm();
    double sum = 0;
    for (const PointPair& line : strip.lines) {
      const Vector3 across = plan.offsets[std::size_t(strip.b)][std::size_t(line.b)] -
                             plan.offsets[std::size_t(strip.a)][std::size_t(line.a)];
      sum += std::atan2(scale * across.norm(), distance) / double(strip.lines.size());
    }
    if (sum > std::numbers::pi / 3)
      out.push_back(make_warning(w_twist,
                                 "The lines between sections " + number(strip.a) + " and " + number(strip.b) +
                                     " run round the path.",
                                 "Shift the seam of one of them, or turn its direction round.",
                                 element_of(VertexId{skin.sections[std::size_t(strip.b)].points[0].id})));
  }
}

}  // namespace

Result<SkinResult> evaluate_skin(const Skin& skin, const SkinWork& work) {
  auto plan = plan_skin(skin);
  if (!plan) return plan.error();
  auto mesh = skin.method == SkinMethod::pleat ? pleat_mesh(skin, *plan) : smooth_mesh(skin, *plan, work);
  if (work.cancel.cancelled()) return make_error(e_cancelled, "Skinning was cancelled.");
  if (!mesh) return mesh.error();
  SkinResult out{skin, *std::move(plan), *std::move(mesh), {}};
  warn_spacing(skin, out.warnings);
  warn_inexact(out.mesh, skin, out.warnings);
  warn_fold(out.mesh, out.warnings);
  warn_twist(skin, out.plan, out.warnings);
  return out;
}

Result<SkinSurface> SkinSurfacer::surface(const Skin& skin, const Vector3& origin, const SkinWork& work) {
  SkinWork own = work;
  own.columns = &columns_;
  auto result = evaluate_skin(skin, own);
  if (!result) return result.error();
  const ControlMesh& control = result->mesh.control;
  if (!topology_ || !same_topology(topology_->mesh(), control)) {
    auto made = SubdivisionTopology::make(control);
    if (!made) return made.error();
    topology_ = *made;
  }
  for (const Vector3& p : control.mesh.positions)
    if (!p.allFinite())
      return make_error(e_control_mesh, "A control point is not a finite number.",
                        "The sections are too large: make them smaller.");
  Surface surface = subdivision_surface(origin, topology_, control.mesh.positions,
                                        std::make_shared<const SkinResult>(*result));
  SkinSurface out{*std::move(result), std::move(surface)};
  for (Message& warning : out.result.warnings) {
    if (warning.code != w_section_not_exact) continue;
    double miss = 0;
    for (const SectionMiss& m : section_misses(skin, out.result.mesh, out.surface))
      miss = std::max(miss, m.largest);
    char text[64];
    std::snprintf(text, sizeof text, " It misses by up to %.3g.", miss);
    warning.text += text;
  }
  return out;
}

std::vector<SectionMiss> section_misses(const Skin& skin, const SkinMesh& mesh, const Surface& surface) {
  constexpr int density = 32;
  const SubdivisionPatchSet& patches = *subdivision_patches(surface);
  const SubdivisionTopology& topology = patches.topology();
  std::vector<SectionMiss> out;
  for (int k = 0; k < skin.section_count(); ++k) {
    const SubdivisionCurve curve = skin.sections[std::size_t(k)].curve();
    const auto& row = mesh.section_rows[std::size_t(k)];
    SectionMiss miss;
    const bool own_points = skin.method == SkinMethod::pleat;
    if (own_points) miss.same_parameter = 0;
    double squares = 0;
    int count = 0;
    const std::size_t edges = curve.size() < 2 ? 0 : row.size() - (curve.closed ? 0 : 1);
    for (std::size_t e = 0; e < edges; ++e) {
      const Index a = row[e], b = row[(e + 1) % row.size()];
      auto sides = topology.edge_sides(a, b);
      const bool backwards = sides.empty();
      if (backwards) sides = topology.edge_sides(b, a);
      for (std::size_t part = 0; part < sides.size(); ++part)
        for (int i = 0; i <= density; ++i) {
          const PatchSide side = sides[part];
          const Vector3 p =
              patches
                  .evaluate(side.patch, side_parameter(Domain::square, side.side, grid_fraction(i, density)),
                            Order::first)
                  .position;
          const double distance = nearest_point(curve, p).distance;
          miss.largest = std::max(miss.largest, distance);
          squares += distance * distance, ++count;
          if (!own_points) continue;
          double x = (double(part) + double(i) / density) / double(sides.size());
          if (backwards) x = 1 - x;
          const double u = (double(e) + x) / curve.spans();
          miss.same_parameter = std::max(miss.same_parameter, (p - evaluate(curve, u).position).norm());
        }
    }
    if (count > 0) miss.root_mean_square = std::sqrt(squares / count);
    out.push_back(miss);
  }
  return out;
}

}  // namespace hariko
