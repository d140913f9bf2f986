#include "app/commands/evaluation.hpp"

#include "core/base/text/json_writer.hpp"
#include "core/document/words.hpp"
#include "core/gaussmap/control_points.hpp"

namespace hariko {

namespace {

void write_message(JsonWriter& json, const Message& message) {
  const std::string element = to_string(message.element);
  json.object([&] {
    json.member("code", message.code.name);
    json.member("element", element.empty() ? std::nullopt : std::optional(element));
    json.member("text", message.remedy.empty() ? message.text : message.text + " " + message.remedy);
  });
}

}  // namespace

Result<std::string> outline_json(const OutlineSource& source) {
  const auto found = control_points(*source.outline, gauss_options(source.settings));
  if (!found) return found.error();
  const ControlPoints& points = *found;
  const CurvatureSign sign = curvature_sign(*source.outline, source.settings.sign);
  JsonWriter json(1);
  json.object([&] {
    json.member("method", enum_word(source.settings.mode));
    json.member("curvature_sign", enum_word(sign));
    json.member("radius", source.settings.radius);
    json.list("loops", source.outline->loops,
              [&](const OutlineLoop& loop) { json.value(loop.points.size()); });
    json.member("inserted", points.points.size() - points.boundary_count);
    json.member("gap", points.gap);
    json.member("iterations", points.iterations);
    json.member("clamped", points.clamped_count);
    json.member("points", points.points);
    json.member("normals", points.normals);
    json.member("h", points.support);
    json.member("K", points.curvature);  // null at flat points, where it is undetermined
    json.member("triangles", points.triangles);
    json.array("boundary", [&] {
      for (Index i = 0; i < points.points.size(); ++i) json.value(i < points.boundary_count);
    });
    json.list("messages", points.messages, [&](const Message& message) { write_message(json, message); });
  });
  return json.take() + "\n";
}

}  // namespace hariko
