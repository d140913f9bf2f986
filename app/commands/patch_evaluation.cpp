#include "app/commands/evaluation.hpp"

#include <algorithm>
#include <array>

#include "core/analysis/continuity.hpp"
#include "core/analysis/curvature.hpp"
#include "core/analysis/measures.hpp"
#include "core/base/assert.hpp"
#include "core/base/text/json_writer.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "core/surface/tensor_bezier.hpp"

namespace hariko {

namespace {

/// Sampled parameters: corners, the middle, a point on a side, and two beside the diagonals.
constexpr std::array<std::array<double, 2>, 8> square_samples{
    {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}, {0.5, 0}, {0.25, 0.5}, {0.7, 0.2}}};

/// Form of a patch in the source, and whether the surface has its parameters swapped.
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

void write_patch(JsonWriter& json, const Surface& surface, Index patch, const WrittenPatch& written) {
  struct Sample {
    Vector3 position;
    std::optional<Vector3> normal;
    std::optional<Curvature> bent;
  };
  std::vector<Sample> at;
  for (const auto& [s, t] : square_samples) {
    const Vector2 parameter = written.flipped ? Vector2(t, s) : Vector2(s, t);
    const PatchPoint point = surface.patches().evaluate(patch, parameter, Order::second);
    const Vector3 normal = surface.normal(patch, parameter);
    at.push_back({surface.origin() + point.position, normal.isZero(0) ? std::nullopt : std::optional(normal),
                  curvature(point)});
  }
  json.object([&] {
    json.member("degree", {written.degree_s, written.degree_t});
    json.member("rational", written.rational);
    json.member("flipped", written.flipped);
    json.list("points", at, [&](const Sample& sample) { json.value(sample.position); });
    json.list("normals", at, [&](const Sample& sample) { json.value(sample.normal); });
    json.list("gauss", at, [&](const Sample& sample) {
      sample.bent ? json.value(sample.bent->gauss) : json.value(nullptr);
    });
    json.list("mean", at, [&](const Sample& sample) {
      sample.bent ? json.value(sample.bent->mean) : json.value(nullptr);
    });
    json.list("principal", at, [&](const Sample& sample) {
      sample.bent ? json.value({sample.bent->k1, sample.bent->k2}) : json.value(nullptr);
    });
  });
}

}  // namespace

Result<std::string> patch_evaluation_json(const Document& document, const Object& object) {
  HARIKO_ASSERT(object.bezier() || object.patches(), "only objects of patches are evaluated as such");
  const auto built = object_surface(document, object);
  if (!built.ok()) return built.error();
  const Surface& surface = built->surface;
  const std::vector<WrittenPatch> written = written_patches(object, surface);
  const auto smooth = std::ranges::count_if(surface.seams(),
                                            [](const Seam& seam) { return seam.intended != Continuity::g0; });
  const Measures measures = measure(surface);
  const ContinuityReport report = continuity(surface);
  JsonWriter json(1);
  json.object([&] {
    json.member("kind", kind_of(object.source));
    json.member("seams", surface.seams().size());
    json.member("smooth_seams", smooth);
    json.member("border_sides", surface.boundary_sides().size());
    json.member("sample_st", square_samples);
    json.array("patches", [&] {
      for (Index k = 0; k < surface.patch_count(); ++k) write_patch(json, surface, k, written[k]);
    });
    json.object("metrics", [&] {
      json.member("area", measures.area);
      json.member("bend", measures.bending);
      json.member("g1", report.largest_normal_jump.value_or(0.0));
      json.member("gap", report.largest_gap);
    });
  });
  return json.take() + "\n";
}

}  // namespace hariko
