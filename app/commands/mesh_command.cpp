#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/commands/document_input.hpp"
#include "app/commands/file_options.hpp"
#include "app/files/export_surfaces.hpp"
#include "app/files/mesh_surfaces.hpp"
#include "core/base/file_io.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/exchange/number_text.hpp"

namespace hariko {

namespace {

using Json = nlohmann::ordered_json;

constexpr double to_degrees = 180 / std::numbers::pi;

Json json_of(const CriterionErrors& errors, double unit) {
  if (!errors.measured) return nullptr;
  return {{"measured", errors.largest * unit},
          {"mean", errors.mean * unit},
          {"bound", errors.certified ? Json(errors.bound * unit) : Json(nullptr)}};
}

Json json_of(const ErrorField& field, const Vector3& origin, double unit) {
  const Vector3 place = origin + field.place;
  return {{"largest", field.largest * unit},
          {"mean", field.mean * unit},
          {"facet", field.facet == no_index ? Json(nullptr) : Json(field.facet)},
          {"place", {place.x(), place.y(), place.z()}}};
}

Json json_of_map(const MeshedObject& object) {
  if (!object.errors) return nullptr;
  const MeshErrorMap& map = *object.errors;
  const Vector3& origin = object.surface_origin;
  return {{"distance", json_of(map.distance, origin, 1)},
          {"mesh_distance", json_of(map.mesh_distance, origin, 1)},
          {"normal_angle", json_of(map.normal_angle, origin, to_degrees)},
          {"fold_angle", json_of(map.fold_angle, origin, to_degrees)}};
}

Json json_of(const MeshedObject& object) {
  const MeshApproximation& result = object.result;
  Json warnings = Json::array();
  for (const Message& warning : result.warnings)
    warnings.push_back({{"code", std::string(warning.code.name)}, {"text", warning.text}});
  return {{"name", object.name},
          {"facets", result.mesh.triangles.size()},
          {"vertices", result.mesh.positions.size()},
          {"distance", json_of(result.distance, 1)},
          {"normal_angle", json_of(result.normal_angle, to_degrees)},
          {"fold_angle", json_of(result.fold_angle, to_degrees)},
          {"luminance", json_of(result.luminance, 1)},
          {"longest_edge", result.longest_edge},
          {"smallest_angle", result.smallest_angle * to_degrees},
          {"unreached", result.unreached},
          {"errors", json_of_map(object)},
          {"warnings", warnings}};
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
  const auto failed = [&](const Message& error) {
    report(arguments.file.string(), error);
    return exit_failed;
  };
  const MeshRequest request{arguments.options, !arguments.errors.empty(), true};
  const auto read = read_document_or_report(arguments.file, arguments.construction);
  if (!read) return exit_failed;
  const auto document = with_only(*read, arguments.file_arguments.only);
  if (!document.ok()) return failed(document.error());
  const auto meshed = mesh_surfaces(*document, request);
  if (!meshed.ok()) return failed(meshed.error());
  const double meshing = watch.lap();
  std::vector<NamedTriangles> named;
  for (const MeshedObject& object : *meshed)
    named.push_back({object.name, &object.result.mesh, object.colour});
  if (const auto done =
          write_mesh_file(arguments.out, named, write_options(*document, arguments.file_arguments.choices));
      !done.ok())
    return failed(done.error());
  if (!arguments.errors.empty()) {
    const auto done = write_file_atomic(arguments.errors, error_text(*meshed));
    if (!done.ok()) return failed(done.error());
  }
  const double writing = watch.lap();
  for (const MeshedObject& object : *meshed)
    for (const Message& warning : object.result.warnings) report(arguments.file.string(), warning);
  if (!arguments.json) {
    std::string text;
    for (const MeshedObject& object : *meshed) text += text_of(object);
    text += "  " + number(std::round(meshing)) + " ms\n";
    return print(text) ? exit_fine : exit_failed;
  }
  Json out = {{"objects", Json::array()}};
  std::size_t facets = 0;
  for (const MeshedObject& object : *meshed) {
    out["objects"].push_back(json_of(object));
    facets += object.result.mesh.triangles.size();
  }
  out["facets"] = facets;
  out["milliseconds"] = {{"mesh", meshing}, {"write", writing}};
  return print(out.dump(2) + "\n") ? exit_fine : exit_failed;
}

}  // namespace hariko
