#include "app/commands/patch_evaluation.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "app/commands/vector_json.hpp"
#include "core/analysis/continuity.hpp"
#include "core/analysis/curvature.hpp"
#include "core/analysis/measures.hpp"
#include "core/base/assert.hpp"
#include "core/modeling/attached.hpp"
#include "core/surface/tensor_bezier.hpp"

namespace hariko {

namespace {

using Json = nlohmann::ordered_json;

/// Corners, the middle, a point on a side, and two beside the diagonals.
constexpr std::array<std::array<double, 2>, 8> samples{
    {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}, {0.5, 0}, {0.25, 0.5}, {0.7, 0.2}}};

/// How a patch of the source is written down, and whether the surface has its parameters swapped.
struct WrittenPatch {
  int degree_s = 3, degree_t = 3;
  bool rational = false, flipped = false;
};

std::vector<WrittenPatch> written_patches(const Object& object, const Surface& surface) {
  std::vector<WrittenPatch> out(surface.patch_count());
  const BezierSource* source = object.bezier();
  if (!source) return out;
  const auto& made = static_cast<const BezierPatchSet&>(surface.patches());
  for (Index k = 0; k < surface.patch_count(); ++k) {
    const BezierPatch& patch = (*source->patches)[k];
    out[k] = {patch.degree_s, patch.degree_t, patch.rational(), !(made.patch(k) == patch)};
  }
  return out;
}

Json patch_json(const Surface& surface, Index patch, const WrittenPatch& written) {
  Json points = Json::array(), normals = Json::array(), gauss = Json::array(), mean = Json::array(),
       principal = Json::array();
  for (const auto& [s, t] : samples) {
    const Vector2 parameter = written.flipped ? Vector2(t, s) : Vector2(s, t);
    const PatchPoint at = surface.patches().evaluate(patch, parameter, Order::second);
    points.push_back(vector_json(surface.origin() + at.position));
    const Vector3 normal = surface.normal(patch, parameter);
    normals.push_back(normal.isZero(0) ? Json(nullptr) : vector_json(normal));
    const auto bent = curvature(at);
    gauss.push_back(bent ? Json(bent->gauss) : Json(nullptr));
    mean.push_back(bent ? Json(bent->mean) : Json(nullptr));
    principal.push_back(bent ? Json::array({bent->k1, bent->k2}) : Json(nullptr));
  }
  return {{"degree", {written.degree_s, written.degree_t}},
          {"rational", written.rational},
          {"flipped", written.flipped},
          {"points", points},
          {"normals", normals},
          {"gauss", gauss},
          {"mean", mean},
          {"principal", principal}};
}

}  // namespace

Result<std::string> patch_evaluation_json(const Document& document, const Object& object) {
  HARIKO_ASSERT(object.bezier() || object.patches(), "only objects of patches are evaluated as such");
  const auto built = object_surface(document, object);
  if (!built.ok()) return built.error();
  const Surface& surface = built->surface;
  const std::vector<WrittenPatch> written = written_patches(object, surface);
  Json at = Json::array(), patches = Json::array();
  for (const auto& sample : samples) at.push_back(sample);
  for (Index k = 0; k < surface.patch_count(); ++k) patches.push_back(patch_json(surface, k, written[k]));
  const auto smooth = std::count_if(surface.seams().begin(), surface.seams().end(),
                                    [](const Seam& seam) { return seam.intended != Continuity::g0; });
  const Measures measures = measure(surface);
  const ContinuityReport report = continuity(surface);
  const Json out = {{"kind", kind_of(object.source)},
                    {"seams", surface.seams().size()},
                    {"smooth_seams", smooth},
                    {"border_sides", surface.boundary_sides().size()},
                    {"sample_st", at},
                    {"patches", patches},
                    {"metrics",
                     {{"area", measures.area},
                      {"bend", measures.bending},
                      {"g1", report.largest_normal_jump.value_or(0.0)},
                      {"gap", report.largest_gap}}}};
  return out.dump(1) + "\n";
}

}  // namespace hariko
