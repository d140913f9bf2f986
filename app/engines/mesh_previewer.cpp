#include "app/engines/mesh_previewer.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "app/files/walled_surface.hpp"
#include "core/approximation/approximate.hpp"
#include "core/approximation/decimation/decimate.hpp"
#include "core/approximation/error_map.hpp"
#include "core/document/object_shape.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "core/surface/facets.hpp"

namespace hariko {

namespace {

constexpr WorkLane::Key only_mesh = 0;

}  // namespace

MeshPreviewer::MeshPreviewer(Editor& editor, std::function<void()> wake, std::function<void()> published)
    : editor_(editor), published_(std::move(published)), lane_(std::move(wake)) {}

void MeshPreviewer::forget() {
  lane_.cancel(only_mesh);
  object_.reset();
  editor_.meshing.job.reset();
  editor_.meshing.result.reset();
  editor_.meshing.stopped = false;
}

void MeshPreviewer::sync() {
  Meshing& meshing = editor_.meshing;
  if (!meshing.open || !editor_.has_document) {
    if (object_ || meshing.result) forget();
    return;
  }
  if (meshing.stopped && meshing.job) {
    lane_.cancel(only_mesh);
    meshing.job.reset();
  }
  // Lengths are chosen when the panel is drawn for the first time.
  if (meshing.stopped || meshing.size == 0 || editor_.history.in_gesture()) return;
  const auto object = meshed_object(editor_.document(), editor_.selection.active);
  if (!object) return forget();
  if (object == object_ && meshing.settings == settings_) return;
  object_ = object;
  settings_ = meshing.settings;
  const auto job = std::make_shared<const Job>(Job{"", true, CancelToken::make(), Progress::make()});
  meshing.job = job;
  lane_.submit(
      only_mesh,
      [this, job, object, settings = settings_,
       document = editor_.document()](const CancelToken& cancel) -> WorkLane::Publication {
        auto result = std::make_shared<const MeshingResult>(
            preview_mesh(document, object, settings, cancel, job->progress));
        return [this, job, result] {
          if (editor_.meshing.job == job) editor_.meshing.job.reset();
          editor_.meshing.result = result;
          published_();
        };
      },
      WorkLane::Running::cancel);
}

namespace {

constexpr int preview_bins = 40;
constexpr double to_degrees = 180 / std::numbers::pi;
/// Numbers of facets above which fewer samples are taken along a facet's side: finer detail is not visible.
constexpr std::size_t many_facets = 4000, most_facets = 20'000;

/// Object to mesh: a surface, or the facets of a reference mesh.
struct Subject {
  Surface surface;
  std::optional<TriangleMesh> dense;
};

Result<Subject> subject_of(const Document& document, const Object& object, const CancelToken& cancel) {
  Subject out;
  if (is_faceted(object)) {
    out.dense = triangles_of(*object.mesh());
    out.surface = facets_of(*object.mesh());
    return out;
  }
  auto built = object_surface(document, object, cancel);
  if (!built.ok()) return built.error();
  out.surface = std::move(built).value().surface;
  return out;
}

/// Error quantity, with its factor to the displayed unit and its tolerance.
struct Shown {
  const ErrorField& field;
  bool at_samples;  ///< points of the field are the map's samples
  double unit;
  std::optional<double> tolerance;  ///< in the displayed unit
  std::optional<double> bound;
};

/// Largest value, rounded up to two digits.
double rounded_up(double value) {
  if (!(value > 0)) return 1;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit) * unit;
}

MeshErrors errors_of(const Surface& facets, const MeshErrorMap& map, int density, const Shown& shown) {
  MeshErrors out;
  const ErrorField& field = shown.field;
  out.largest = field.largest * shown.unit;
  out.mean = field.mean * shown.unit;
  out.bound = shown.bound;
  out.place = field.place;
  out.limited = shown.tolerance.has_value();
  out.range = {0, shown.tolerance ? *shown.tolerance : rounded_up(out.largest)};
  const auto limit = static_cast<float>(out.range.high * (1 + 1e-6));
  const auto count = static_cast<std::size_t>(GridPattern{Domain::triangle, density}.point_count());
  const bool by_samples = shown.at_samples && !map.facet_samples.empty();
  auto values = std::make_shared<std::vector<float>>(field.facets.size() * count);
  std::vector<float> all;
  for (std::size_t f = 0; f < field.facets.size(); ++f) {
    const float largest = field.facets[f] * static_cast<float>(shown.unit);
    out.beyond += largest > limit;
    all.push_back(largest);
    for (std::size_t i = 0; i < count; ++i) {
      const float value =
          by_samples ? field.points[map.facet_samples[f] + i] * static_cast<float>(shown.unit) : largest;
      (*values)[f * count + i] = value > limit ? std::numeric_limits<float>::quiet_NaN() : value;
    }
  }
  out.histogram = histogram(all, out.range, preview_bins);
  DisplayOptions options;
  options.density = density;
  options.map = [values](const Surface&, std::span<const Index> patches, const GridPattern& pattern,
                         std::span<float> result) {
    const auto n = static_cast<std::size_t>(pattern.point_count());
    for (std::size_t k = 0; k < patches.size(); ++k)
      std::copy_n(values->begin() + std::ptrdiff_t(patches[k] * n), n,
                  result.begin() + std::ptrdiff_t(k * n));
  };
  out.mesh = DisplayMesh::build(facets, options);
  return out;
}

/// Preview of an object. `limits`: settings whose tolerances bound the colours.
Result<MeshPreview> preview_of(const Subject& subject, double scale, const MeshingSettings& settings,
                               const MeshingSettings& limits, const CancelToken& cancel,
                               const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const MeshOptions options = settings.options(scale);
  auto made = subject.dense ? decimate(*subject.dense, options, cancel, progress.part(0, 0.6))
                            : approximate(subject.surface, options, cancel, progress.part(0, 0.6));
  if (!made.ok()) return made.error();
  MeshPreview out;
  out.facets = made->mesh.triangles.size();
  out.vertices = made->mesh.positions.size();
  out.reached = made->reached();
  out.warnings = made->warnings;
  out.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  ErrorMapOptions how;
  how.density = out.facets < many_facets ? 4 : out.facets < most_facets ? 2 : 1;
  const auto map =
      mesh_error_map(subject.surface, made->mesh, made->parts, how, cancel, progress.part(0.6, 0.95));
  if (!map.ok()) return map.error();
  const std::vector<Element> sources(out.facets);
  const Surface facets =
      facet_surface(made->mesh.origin, made->mesh.positions, made->mesh.triangles, sources);
  DisplayOptions plain;
  plain.density = 1;
  out.mesh = DisplayMesh::build(facets, plain);
  const auto tolerance = [&](MeshCriterion criterion) {
    const auto& own = limits.of(criterion);
    return own.on ? std::optional(own.value) : std::nullopt;
  };
  const auto bound = [&](const CriterionErrors& errors, double unit) {
    return errors.certified ? std::optional(errors.bound * unit) : std::nullopt;
  };
  out.errors = {errors_of(facets, *map, how.density,
                          {map->distance, true, scale, tolerance(MeshCriterion::distance),
                           bound(made->distance, scale)}),
                errors_of(facets, *map, how.density,
                          {map->normal_angle, true, to_degrees, tolerance(MeshCriterion::normal),
                           bound(made->normal_angle, to_degrees)}),
                errors_of(facets, *map, 1,
                          {map->fold_angle, false, to_degrees, tolerance(MeshCriterion::fold),
                           bound(made->fold_angle, to_degrees)})};
  out.edges = facet_lines(made->mesh.origin, made->mesh.positions, made->mesh.triangles,
                          std::max(map->distance.largest, map->mesh_distance.largest));
  if (cancel.cancelled()) return make_error(e_cancelled, "The meshing was cancelled.");
  return out;
}

/// Settings with one criterion alone, for the paper's comparison of meshes.
MeshingSettings alone(const MeshingSettings& settings, MeshCriterion criterion) {
  MeshingSettings out = settings;
  for (auto& tolerance : out.tolerances) tolerance.on = false;
  out.of(criterion).on = true;
  return out;
}

}  // namespace

MeshingResult preview_mesh(const Document& document, const std::shared_ptr<const Object>& object,
                           const MeshingSettings& settings, const CancelToken& cancel,
                           const Progress& progress) {
  MeshingResult out;
  out.object = object;
  out.settings = settings;
  auto subject = subject_of(document, *object, cancel);
  if (!subject.ok()) {
    out.error = subject.error();
    return out;
  }
  const double scale = object->transform.scale;
  const double part = settings.compare ? 1.0 / 3 : 1;
  auto made = preview_of(*subject, scale, settings, settings, cancel, progress.part(0, part));
  if (!made.ok()) {
    out.error = made.error();
    return out;
  }
  out.mesh = std::move(made).value();
  if (!settings.compare) return out;
  std::array<MeshPreview, 2> pair;
  // Both meshes share the colours, whatever criterion made them.
  MeshingSettings limits = settings;
  limits.of(MeshCriterion::distance).on = limits.of(MeshCriterion::normal).on = true;
  const std::array criteria{MeshCriterion::distance, MeshCriterion::normal};
  for (std::size_t k = 0; k < 2; ++k) {
    auto one = preview_of(*subject, scale, alone(settings, criteria[k]), limits, cancel,
                          progress.part(double(k + 1) / 3, double(k + 2) / 3));
    if (!one.ok()) {
      out.error = one.error();
      return out;
    }
    pair[k] = std::move(one).value();
  }
  out.compared = std::move(pair);
  return out;
}

}  // namespace hariko
