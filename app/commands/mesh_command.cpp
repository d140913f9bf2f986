#include <numbers>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/commands/document_input.hpp"
#include "app/commands/export_report.hpp"
#include "app/files/export_surfaces.hpp"
#include "app/files/left_out.hpp"
#include "app/files/mesh_surfaces.hpp"
#include "core/base/files/file_io.hpp"
#include "core/base/text/json_writer.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/exchange/number_text.hpp"

namespace hariko {

namespace {

constexpr double to_degrees = 180 / std::numbers::pi;

void write(JsonWriter& json, const CriterionErrors& errors, double unit) {
  if (!errors.measured) return json.value(nullptr);
  json.object([&] {
    json.member("measured", errors.largest * unit);
    json.member("mean", errors.mean * unit);
    json.member("bound", errors.certified ? std::optional(errors.bound * unit) : std::nullopt);
  });
}

void write(JsonWriter& json, const ErrorField& field, const Vector3& origin, double unit) {
  json.object([&] {
    json.member("largest", field.largest * unit);
    json.member("mean", field.mean * unit);
    json.member("facet", field.facet == no_index ? std::nullopt : std::optional(field.facet));
    json.member("place", Vector3(origin + field.place));
  });
}

void write_map(JsonWriter& json, const MeshedObject& object) {
  if (!object.errors) return json.value(nullptr);
  const MeshErrorMap& map = *object.errors;
  const auto field = [&](const char* name, const ErrorField& errors, double unit) {
    json.key(name);
    write(json, errors, object.surface_origin, unit);
  };
  json.object([&] {
    field("distance", map.distance, 1);
    field("mesh_distance", map.mesh_distance, 1);
    field("normal_angle", map.normal_angle, to_degrees);
    field("fold_angle", map.fold_angle, to_degrees);
  });
}

std::vector<Message> warnings_of_mesh(const MeshedObject& object) {
  std::vector<Message> out = object.warnings;
  out.insert(out.end(), object.result.warnings.begin(), object.result.warnings.end());
  return out;
}

void write(JsonWriter& json, const MeshedObject& object) {
  const MeshApproximation& result = object.result;
  const auto criterion = [&](const char* name, const CriterionErrors& errors, double unit) {
    json.key(name);
    write(json, errors, unit);
  };
  json.object([&] {
    json.member("name", object.name);
    json.member("facets", result.mesh.triangles.size());
    json.member("vertices", result.mesh.positions.size());
    criterion("distance", result.distance, 1);
    criterion("normal_angle", result.normal_angle, to_degrees);
    criterion("fold_angle", result.fold_angle, to_degrees);
    criterion("luminance", result.luminance, 1);
    json.member("longest_edge", result.longest_edge);
    json.member("smallest_angle", result.smallest_angle * to_degrees);
    json.member("unreached", result.unreached);
    json.key("errors");
    write_map(json, object);
    json.list("warnings", warnings_of_mesh(object), [&](const Message& warning) {
      json.object([&] {
        json.member("code", warning.code.name);
        json.member("text", warning.text);
      });
    });
  });
}

std::string report_json(const std::vector<MeshedObject>& objects, const WrittenMeshes& written,
                        double meshing, double writing) {
  std::size_t facets = 0;
  for (const MeshedObject& object : objects) facets += object.result.mesh.triangles.size();
  for (const FileRounding& rounding : written.rounding) facets -= rounding.left_out;
  double farthest = 0;
  for (const FileRounding& rounding : written.rounding) farthest = std::max(farthest, rounding.distance);
  JsonWriter json(2);
  json.object([&] {
    json.list("objects", objects, [&](const MeshedObject& object) { write(json, object); });
    json.member("facets", facets);
    json.member("rounding", farthest);
    json.member("moved", written.moved);
    json.object("milliseconds", [&] {
      json.member("mesh", meshing);
      json.member("write", writing);
    });
  });
  return json.take() + "\n";
}

std::string number(double value) {
  std::string out;
  append_real(out, value);
  return out;
}

void add_line(std::string& out, const char* name, const CriterionErrors& errors, double unit) {
  if (!errors.measured) return;
  out += std::string("  ") + name + ": largest " + number(errors.largest * unit) + ", mean " +
         number(errors.mean * unit);
  out += errors.certified ? ", certainly at most " + number(errors.bound * unit) : ", sampled";
  out += '\n';
}

std::string text_of(const MeshedObject& object) {
  const MeshApproximation& result = object.result;
  std::string out = object.name + ": " + std::to_string(result.mesh.triangles.size()) + " facets, " +
                    std::to_string(result.mesh.positions.size()) + " vertices\n";
  add_line(out, "distance", result.distance, 1);
  add_line(out, "normal angle (degrees)", result.normal_angle, to_degrees);
  add_line(out, "fold angle (degrees)", result.fold_angle, to_degrees);
  add_line(out, "luminance", result.luminance, 1);
  return out;
}

std::string error_text(const std::vector<MeshedObject>& objects) {
  std::string out;
  for (const MeshedObject& object : objects)
    if (object.errors)
      out += error_csv(*object.errors, object.result.mesh, object.surface_origin, object.name, out.empty());
  return out;
}

}  // namespace

int run_mesh(const MeshArguments& arguments) {
  Stopwatch watch;
  const auto read = read_document_or_report(arguments.file, arguments.construction);
  if (!read) return exit_failed;
  const auto document = with_only(*read, arguments.file_arguments.only);
  if (!document.ok()) return failure(arguments.file, document.error());
  const WriteOptions options = write_options(*document, arguments.file_arguments.choices);
  const MeshRequest request{arguments.options, !arguments.errors.empty(), true,
                            file_digits(*document, arguments.out, options), arguments.file_arguments.wall};
  auto meshed = [&] {
    const ProgressLine line(arguments.out, "meshing");
    return mesh_surfaces(*document, request, {}, line.progress());
  }();
  if (!meshed.ok()) return failure(arguments.file, meshed.error());
  const double meshing = watch.lap();
  std::vector<NamedTriangles> named;
  for (const MeshedObject& object : *meshed) named.push_back(object.named());
  const auto written = [&] {
    const ProgressLine line(arguments.out, "writing");
    return write_mesh_file(arguments.out, named, options);
  }();
  if (!written.ok()) return failure(arguments.file, written.error());
  for (std::size_t i = 0; i < named.size(); ++i) meshed.value()[i].add(written->rounding[i]);
  if (!arguments.errors.empty()) {
    const auto done = write_file_atomic(arguments.errors, error_text(*meshed));
    if (!done.ok()) return failure(arguments.file, done.error());
  }
  const double writing = watch.lap();
  for (const Message& warning : left_out_of_triangles(*document)) report(arguments.file.string(), warning);
  for (const Message& warning : written->warnings) report(arguments.file.string(), warning);
  for (const MeshedObject& object : *meshed)
    for (const Message& warning : warnings_of_mesh(object)) report(arguments.file.string(), warning);
  if (!arguments.json) {
    std::string text;
    for (const MeshedObject& object : *meshed) text += text_of(object);
    text += moved_text(written->moved);
    text += "  " + number(std::round(meshing)) + " ms\n";
    return print(text) ? exit_fine : exit_failed;
  }
  return print(report_json(*meshed, *written, meshing, writing)) ? exit_fine : exit_failed;
}

}  // namespace hariko
