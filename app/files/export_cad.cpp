#include "app/files/export_cad.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <optional>
#include <utility>

#include "app/files/export_surfaces.hpp"
#include "app/files/left_out.hpp"
#include "app/files/walled_surface.hpp"
#include "core/base/files/file_io.hpp"
#include "core/cad/cad_measure.hpp"
#include "core/cad/reversed_model.hpp"
#include "core/exchange/mesh_file.hpp"

namespace hariko {

namespace {

/// Fraction of the time for making the surfaces and their faces, roughly.
constexpr double modelling = 0.7;
/// Number of sampled places along a side of each rectangle between knots, for measured distances.
constexpr int samples = 4;

CadUnit cad_unit(Unit unit) {
  switch (unit) {
    case Unit::centimetre:
      return CadUnit::centimetre;
    case Unit::metre:
      return CadUnit::metre;
    case Unit::inch:
      return CadUnit::inch;
    default:
      return CadUnit::millimetre;
  }
}

/// Moves a model from object space to the file's, in millimetres. Mirror images keep their outside.
void place(CadModel& model, const Similarity& transform, double factor) {
  const auto move = [&](Vector3& p) { p = factor * transform.apply_to_vector(p); };
  model.origin = factor * transform.apply(model.origin);
  const double lengths = factor * transform.length_scale();
  model.size *= lengths;
  for (Vector3& vertex : model.vertices) move(vertex);
  for (CadEdge& edge : model.edges) {
    for (Vector3& p : edge.curve.points) move(p);
    edge.deviation *= lengths;
  }
  for (CadFace& face : model.faces)
    for (Vector3& p : face.surface.points) move(p);
  if (transform.mirrors()) model = reversed(std::move(model));
}

/// Options for an object that is `scale` times as large in the file.
CadModelOptions options_of(const CadChoices& choices, double scale, double unit) {
  const CadGrade grade = grade_of(choices.quality);
  CadModelOptions out;
  const bool own = choices.tolerance > 0;
  out.tolerance = (own ? choices.tolerance : grade.millimetres / unit) / scale;
  out.share = own ? 0 : grade.share;
  out.angle = choices.angle > 0 ? choices.angle : grade.angle;
  out.exact = choices.exact;
  out.whole_faces = choices.whole_faces;
  return out;
}

struct MadeObject {
  CadModel model;
  CadObjectReport report;
  MeshColour colour{};
};

Message named_error(Message error, const Object& object) {
  if (!(error.code == e_cancelled)) error.text = object.name + ": " + error.text;
  return error;
}

Message cancelled() {
  return make_error(e_cancelled, "The export was cancelled.");
}

/// Makes the model of an object in its own space, with its report.
Result<MadeObject> make_object(const Document& document, const Object& object, const CadChoices& choices,
                               const Wall& wall, const CancelToken& cancel, const Progress& progress) {
  const auto built = walled_surface(document, object, wall, FoldedWalls::refuse, cancel);
  if (cancel.cancelled()) return cancelled();
  if (!built.ok()) return built.error();
  progress.report(0.2);
  const double own_scale = object.transform.scale;
  const CadModelOptions options =
      options_of(choices, own_scale * choices.scale, millimetres_per(document.unit));
  auto model = make_cad_model(built->surface, options, cancel, progress.part(0.2, 0.8));
  if (!model.ok()) return named_error(model.error(), object);
  MadeObject out{std::move(model).value(), {}, colour_of(object)};
  const CadMeasure measure = measure_cad(built->surface, out.model, samples, cancel);
  if (cancel.cancelled()) return cancelled();
  const double scale = own_scale * choices.scale;
  const double tolerance = std::max(options.tolerance, options.share * out.model.size);
  CadObjectReport& report = out.report;
  report.name = object.name;
  report.warnings = built->warnings;
  report.faces = out.model.faces.size();
  report.edges = out.model.edges.size();
  report.exact = measure.exact;
  if (choices.exact && report.exact < report.faces) report.not_exact = why_not_exact(built->surface);
  report.control_points = measure.control_points;
  report.closed = out.model.closed();
  report.distance = scale * measure.largest;
  report.tolerance = scale * tolerance;
  report.angle = options.angle;
  report.normal_jump = measure.normal_jump;
  report.curvature = out.model.curvature;
  report.curvature_jump = measure.curvature_jump;
  report.unreached = std::size_t(
      std::ranges::count_if(measure.distances, [&](double distance) { return distance > tolerance; }));
  return out;
}

/// Box round all control points, in mm.
Eigen::AlignedBox3d cad_box(const CadModel& model) {
  Eigen::AlignedBox3d out;
  for (const CadFace& face : model.faces)
    for (const Vector3& p : face.surface.points) out.extend(model.origin + p);
  return out;
}

/// Largest coordinate of all control points, in mm.
double largest_coordinate(const CadModel& model) {
  const Eigen::AlignedBox3d box = cad_box(model);
  return box.isEmpty() ? 0 : std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

/// Moves the middle of the box of all models to zero; returns where it was, in mm. Models are relative to
/// their origins, so no digits are lost.
Vector3 move_cad_to_zero(std::vector<MadeObject>& made) {
  Eigen::AlignedBox3d box;
  for (const MadeObject& one : made) box.extend(cad_box(one.model));
  if (box.isEmpty()) return Vector3::Zero();
  const Vector3 middle = box.center();
  for (MadeObject& one : made) one.model.origin -= middle;
  return middle;
}

/// Rounding of the largest coordinate, in mm: half of the last of the eleven digits that the kernel writes
/// into IGES.
double iges_rounding(const CadModel& model, Unit unit) {
  const double largest = largest_coordinate(model);
  if (!(largest > 0)) return 0;
  const double millimetres = millimetres_per(unit);
  return 0.5 * std::pow(10, std::floor(std::log10(largest / millimetres)) - 10) * millimetres;
}

/// E_FILE_DIGITS where rounding in the file would exceed the allowed distance of faces.
std::optional<Message> check_iges_digits(const MadeObject& made, const Document& document,
                                         const CadChoices& choices) {
  const double rounding = iges_rounding(made.model, choices.unit);
  if (rounding <= made.report.tolerance * millimetres_per(document.unit)) return {};
  return make_error(e_file_digits,
                    made.report.name + ": IGES holds eleven digits, which moves points by up to " +
                        rounded_text(rounding, 3) + " mm so far from zero: more than the tolerance.",
                    "Move the model to zero, write STEP, or choose a larger tolerance.");
}

/// Largest length from zero, in mm, at which the kernel's shapes hold: it joins what is nearer than 1e-7 mm,
/// and a point on a spline is a sum of some rounded products.
constexpr double farthest_for_kernel = 1e-7 / (8 * std::numeric_limits<double>::epsilon());

/// E_FILE_DIGITS for shapes that the kernel refuses where doubles so far from zero are too coarse for it. It
/// names the farthest object.
std::optional<Message> check_kernel_digits(const std::vector<MadeObject>& made) {
  const auto farthest =
      std::max_element(made.begin(), made.end(), [](const MadeObject& a, const MadeObject& b) {
        return largest_coordinate(a.model) < largest_coordinate(b.model);
      });
  if (farthest == made.end()) return {};
  const double largest = largest_coordinate(farthest->model);
  if (!(largest > farthest_for_kernel)) return {};
  Eigen::AlignedBox3d all;
  for (const MadeObject& one : made) all.extend(cad_box(one.model));
  const bool moving_helps = all.sizes().maxCoeff() / 2 <= farthest_for_kernel;
  return make_error(e_file_digits,
                    farthest->report.name + ": So far from zero, numbers in the file are " +
                        rounded_text(largest * std::numeric_limits<double>::epsilon(), 3) +
                        " mm apart, and faces of a closed shape have to meet to 0.0000001 mm.",
                    moving_helps
                        ? "Move the model to zero; on the command line --origin zero does that for the file."
                        : "Move the object nearer to the others, or hide it and export it by itself, moved "
                          "to zero (--origin zero).");
}

/// Models of all visible objects; at least one.
Result<std::vector<MadeObject>> make_objects(const Document& document, const CadChoices& choices,
                                             const Wall& wall, const CancelToken& cancel,
                                             const Progress& progress) {
  std::vector<MadeObject> made;
  const auto count = static_cast<double>(document.objects.size());
  double number = 0;
  for (const auto& object : document.objects) {
    const Progress part = progress.part(number / count, (number + 1) / count);
    ++number;
    if (!object->visible || !object->has_surface()) continue;
    auto one = make_object(document, *object, choices, wall, cancel, part);
    if (!one.ok()) return one.error();
    if (one->model.faces.empty()) continue;
    const std::vector<Similarity> places = places_of(*object);
    for (std::size_t k = 0; k < places.size(); ++k) {
      made.push_back(*one);
      made.back().report.name = name_of_place(*object, k);
      if (k > 0) made.back().report.warnings.clear();
      place(made.back().model, places[k], choices.scale * millimetres_per(document.unit));
    }
  }
  if (!made.empty()) return made;
  if (const std::size_t facets = visible_reference_objects(document); facets > 0)
    return make_error(e_no_surface,
                      "STEP and IGES hold smooth faces, and what is visible are reference facets (objects: " +
                          std::to_string(facets) + ").",
                      "Write STL, OBJ, PLY, 3MF or glTF, which hold facets.");
  return make_error(e_no_surface, "There is no visible surface to export.", "Show an object or import one.");
}

}  // namespace

Result<CadExportReport> export_cad(const Document& document, const std::filesystem::path& path,
                                   const CadChoices& choices, const std::string& time,
                                   const CancelToken& cancel, const Progress& progress, const Wall& wall) {
  if (const auto missing = why_no_cad_files()) return *missing;
  const auto format = cad_format_of(path);
  if (!format) return make_error(e_format_unknown, "The name must end in " + std::string(cad_endings) + ".");
  auto made = make_objects(document, choices, wall, cancel, progress.part(0, modelling));
  if (!made.ok()) return made.error();
  const Vector3 moved = choices.to_zero ? move_cad_to_zero(made.value()) : Vector3(Vector3::Zero());
  if (*format == CadFormat::iges)
    for (const MadeObject& one : *made)
      if (auto wrong = check_iges_digits(one, document, choices)) return *wrong;
  std::vector<CadObject> objects;
  for (const MadeObject& one : *made) objects.push_back({one.report.name, &one.model, one.colour});
  CadFileOptions options;
  options.format = *format == CadFormat::step_ap214 && choices.ap242 ? CadFormat::step_ap242 : *format;
  options.unit = cad_unit(choices.unit);
  options.time = time;
  auto file = make_cad_file(objects, options, cancel, progress.part(modelling, 0.95));
  if (!file.ok() ? file.error().code == e_cad_kernel : !file->report.valid)
    if (auto wrong = check_kernel_digits(*made)) return *wrong;
  if (!file.ok()) return file.error();
  if (const auto done = write_file_atomic(path, file->bytes); !done.ok()) return done.error();
  CadExportReport report;
  for (const MadeObject& one : *made) report.objects.push_back(one.report);
  report.file = file->report;
  report.bytes = file->bytes.size();
  report.moved = moved / millimetres_per(choices.unit);
  progress.report(1);
  return report;
}

Result<CadTotals> count_cad(const Document& document, const CadChoices& choices, const CancelToken& cancel,
                            const Wall& wall) {
  const auto made = make_objects(document, choices, wall, cancel, {});
  if (!made.ok()) return made.error();
  std::vector<CadObjectReport> reports;
  for (const MadeObject& one : *made) reports.push_back(one.report);
  CadTotals out = totals(reports);
  out.left_out = visible_reference_objects(document);
  return out;
}

CadTotals totals(std::span<const CadObjectReport> objects) {
  CadTotals out;
  for (const CadObjectReport& object : objects) {
    out.faces += object.faces;
    out.exact += object.exact;
    out.unreached += object.unreached;
    out.distance = std::max(out.distance, object.distance);
    out.normal_jump = std::max(out.normal_jump, object.normal_jump);
    out.control_points += object.control_points;
    out.curvature = out.curvature || object.curvature;
    out.curvature_jump = std::max(out.curvature_jump, object.curvature_jump);
  }
  return out;
}

std::vector<Message> warnings_of(const CadExportReport& report) {
  std::vector<Message> out;
  for (const CadObjectReport& object : report.objects) {
    out.insert(out.end(), object.warnings.begin(), object.warnings.end());
    if (object.unreached > 0)
      out.push_back(
          make_warning(w_cad_tolerance,
                       object.name + ": " + std::to_string(object.unreached) +
                           " faces are farther from the surface than the tolerance.",
                       "Look for folds and needle-like patches there, or choose a larger tolerance."));
    if (object.normal_jump > object.angle && object.exact < object.faces)
      out.push_back(make_warning(
          w_cad_angle, object.name + ": Along smooth edges normals jump by more than was asked for.",
          "Look for folds and needle-like patches there, or choose a larger angle."));
  }
  if (!report.file.valid)
    out.push_back(make_warning(w_cad_invalid, "OpenCASCADE's own check does not accept the written shape.",
                               "Look for folds in the surface, or choose a smaller tolerance."));
  if (report.file.changed_names > 0)
    out.push_back(make_warning(
        w_cad_names,
        "IGES has names of unaccented Latin letters only: " + std::to_string(report.file.changed_names) +
            " names have \"_\" in the place of others.",
        "Export as STEP to keep the names."));
  return out;
}

std::string header_time() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  localtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &parts);
  return text;
}

}  // namespace hariko
