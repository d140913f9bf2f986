#include "core/exchange/gltf/gltf_instances.hpp"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

namespace hariko {

using Json = nlohmann::json;

std::optional<std::vector<AffineMap>> gltf_instances(const Json& instances, const std::string& place,
                                                     GltfBuffers& buffers, GltfFields& fields,
                                                     SceneCollector& collector) {
  const Json* attributes = find(instances, "attributes");
  if (!attributes) fields.fail(place, "Its instances have no \"attributes\".");
  std::optional<std::uint64_t> count;
  const auto rows = [&](const char* name, const char* type) -> std::optional<GltfAccessor> {
    if (fields.error()) return {};
    const auto number = fields.whole(*attributes, name, place);
    if (!number) return {};
    GltfAccessor out = buffers.accessor(*number, type);
    if (!fields.error() && count.value_or(out.count) != out.count)
      fields.fail(place, "The attributes of its instances differ in their number.");
    count = out.count;
    return out;
  };
  const auto shifts = rows("TRANSLATION", "VEC3"), turns = rows("ROTATION", "VEC4"),
             scales = rows("SCALE", "VEC3");
  if (!fields.error() && !count) fields.fail(place, "Its instances have no places.");
  if (fields.error()) return {};
  if (const auto error = collector.reserve(*count, 0)) {
    fields.fail(*error);
    return {};
  }
  std::vector<AffineMap> out(*count);
  for (std::size_t k = 0; k < out.size(); ++k) {
    const auto number = [&](const GltfAccessor& of, std::size_t column) {
      return gltf_number(of, k, column);
    };
    if (turns) {
      const Eigen::Quaterniond turn(number(*turns, 3), number(*turns, 0), number(*turns, 1),
                                    number(*turns, 2));
      if (!(turn.norm() > 1e-6)) {
        fields.fail(place, "The rotation of instance " + std::to_string(k) + " is none.");
        return {};
      }
      out[k].linear = turn.normalized().toRotationMatrix();
    }
    if (scales)
      out[k].linear *= Vector3(number(*scales, 0), number(*scales, 1), number(*scales, 2)).asDiagonal();
    if (shifts) out[k].shift = {number(*shifts, 0), number(*shifts, 1), number(*shifts, 2)};
  }
  return out;
}

}  // namespace hariko
