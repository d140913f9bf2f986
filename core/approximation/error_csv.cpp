// Error maps as comma-separated values.

#include <charconv>
#include <numbers>
#include <optional>

#include "core/approximation/error_map.hpp"

namespace hariko {

namespace {

constexpr double to_degrees = 180 / std::numbers::pi;

class CsvLines {
 public:
  explicit CsvLines(std::string_view object) {
    object_ = '"';
    for (const char c : object) object_ += c == '"' ? "\"\"" : std::string(1, c);
    object_ += '"';
  }
  void head() {
    text_ +=
        "object,kind,number,facet,x,y,z,distance,mesh_distance,normal_angle_degrees,fold_angle_degrees\n";
  }
  struct Values {
    std::optional<float> distance, mesh_distance, normal_angle, fold_angle;
  };
  void line(const char* kind, std::size_t number, std::optional<std::size_t> facet, const Vector3& place,
            const Values& values) {
    text_ += object_;
    text_ += ',';
    text_ += kind;
    text_ += ',' + std::to_string(number) + ',';
    if (facet) text_ += std::to_string(*facet);
    for (int axis = 0; axis < 3; ++axis) add(place[axis]);
    add(values.distance, 1);
    add(values.mesh_distance, 1);
    add(values.normal_angle, to_degrees);
    add(values.fold_angle, to_degrees);
    text_ += '\n';
  }
  std::string take() { return std::move(text_); }

 private:
  /// Appends the shortest text that reads back as the same number, with a decimal point in every locale.
  template <class Number>
  void add(Number value) {
    char digits[40];
    const auto [end, status] = std::to_chars(std::begin(digits), std::end(digits), value);
    text_ += ',';
    text_.append(digits, end);
  }
  void add(const std::optional<float>& value, double unit) {
    if (value)
      add(static_cast<float>(double(*value) * unit));
    else
      text_ += ',';
  }

  std::string object_, text_;
};

}  // namespace

std::string error_csv(const MeshErrorMap& map, const TriangleMesh& mesh, const Vector3& surface_origin,
                      std::string_view object, bool with_head) {
  CsvLines lines(object);
  if (with_head) lines.head();
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& t = mesh.triangles[f];
    const Vector3 middle =
        (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3 + mesh.origin;
    lines.line("facet", f, f, middle,
               {map.distance.facets[f], map.mesh_distance.facets[f], map.normal_angle.facets[f],
                map.fold_angle.facets[f]});
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    lines.line("vertex", v, std::nullopt, mesh.positions[v] + mesh.origin,
               {{}, map.mesh_distance.points[v], {}, map.fold_angle.points[v]});
  for (std::size_t s = 0; s < map.samples.size(); ++s)
    lines.line("sample", s, map.samples[s].facet, map.samples[s].position + surface_origin,
               {map.distance.points[s], {}, map.normal_angle.points[s], {}});
  return lines.take();
}

}  // namespace hariko
