#include "app/commands/outline_evaluation.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/document/format_names.hpp"
#include "core/gaussmap/control_points.hpp"

namespace hariko {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const std::vector<Vector3>& vectors) {
  Json out = Json::array();
  for (const Vector3& v : vectors) out.push_back({v.x(), v.y(), v.z()});
  return out;
}

/// JSON has no number for infinity: a flat point's curvature may be anything.
Json to_json(const std::vector<double>& values) {
  Json out = Json::array();
  for (const double value : values) out.push_back(std::isfinite(value) ? Json(value) : Json(nullptr));
  return out;
}

Json to_json(const std::vector<Message>& messages) {
  Json out = Json::array();
  for (const Message& message : messages) {
    const std::string element = to_string(message.element);
    out.push_back({{"code", std::string(message.code.name)},
                   {"element", element.empty() ? Json(nullptr) : Json(element)},
                   {"text", message.remedy.empty() ? message.text : message.text + " " + message.remedy}});
  }
  return out;
}

}  // namespace

Result<std::string> outline_json(const OutlineSource& source) {
  const auto found = control_points(*source.outline, gauss_options(source.settings));
  if (!found) return found.error();
  const ControlPoints& points = *found;
  Json loops = Json::array(), triangles = Json::array(), boundary = Json::array();
  for (const OutlineLoop& loop : source.outline->loops) loops.push_back(loop.points.size());
  for (const auto& [a, b, c] : points.triangles) triangles.push_back({a, b, c});
  for (Index i = 0; i < points.points.size(); ++i) boundary.push_back(i < points.boundary_count);
  const CurvatureSign sign = curvature_sign(*source.outline, source.settings.sign);
  const Json out = {{"method", detail::name_of(source.settings.mode, detail::gauss_names)},
                    {"curvature_sign", detail::name_of(sign, detail::sign_names)},
                    {"radius", source.settings.radius},
                    {"loops", loops},
                    {"inserted", points.points.size() - points.boundary_count},
                    {"gap", points.gap},
                    {"iterations", points.iterations},
                    {"clamped", points.clamped_count},
                    {"points", to_json(points.points)},
                    {"normals", to_json(points.normals)},
                    {"h", to_json(points.support)},
                    {"K", to_json(points.curvature)},
                    {"triangles", triangles},
                    {"boundary", boundary},
                    {"messages", to_json(points.messages)}};
  return out.dump(1) + "\n";
}

}  // namespace hariko
