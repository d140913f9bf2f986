#include "core/exchange/gltf/gltf_skin.hpp"

#include <nlohmann/json.hpp>

#include "core/exchange/text_scanner.hpp"

namespace hariko {

using Json = nlohmann::json;

namespace {

constexpr int most_sets = 64;  // sets of four joints a point

/// Matrix of a row, stored by columns.
AffineMap matrix_of(const GltfAccessor& matrices, std::uint64_t row) {
  AffineMap out;
  const auto at = [&](int line, int column) {
    return gltf_number(matrices, row, static_cast<std::size_t>(4 * column + line));
  };
  for (int column = 0; column < 3; ++column)
    for (int line = 0; line < 3; ++line) out.linear(line, column) = at(line, column);
  out.shift = {at(0, 3), at(1, 3), at(2, 3)};
  return out;
}

}  // namespace

bool GltfSkin::bend(const Json& attributes, const std::string& place, GltfBuffers& buffers,
                    GltfFields& fields, std::vector<Vector3>& points) const {
  std::vector<Vector3> moved(points.size(), Vector3::Zero());
  std::vector<double> sum(points.size(), 0);
  for (int set = 0; set < most_sets; ++set) {
    const std::string joints_name = "JOINTS_" + std::to_string(set),
                      weights_name = "WEIGHTS_" + std::to_string(set);
    if (set > 0 && !find(attributes, joints_name.c_str())) break;
    const std::uint64_t joints_number = fields.needed(attributes, joints_name.c_str(), place),
                        weights_number = fields.needed(attributes, weights_name.c_str(), place);
    if (fields.error()) return false;
    const GltfAccessor joints = buffers.accessor(joints_number, "VEC4"),
                       weights = buffers.accessor(weights_number, "VEC4");
    if (fields.error()) return false;
    if (joints.count != points.size() || weights.count != points.size())
      return fields.fail(place, quote(joints_name) + " has another number of rows than the positions.");
    if (joints.component != GltfComponent::uint8 && joints.component != GltfComponent::uint16)
      return fields.fail(joints.place, "Joints are unsigned whole numbers of 8 or 16 bits.");
    for (std::size_t v = 0; v < points.size(); ++v)
      for (std::size_t k = 0; k < 4; ++k) {
        const double weight = gltf_number(weights, v, k);
        if (!(weight > 0)) continue;
        const auto joint = static_cast<std::size_t>(gltf_number(joints, v, k));
        if (joint >= joints_.size())
          return fields.fail(joints.place, "Row " + std::to_string(v) + " names joint " +
                                               std::to_string(joint) + ", but the skin has " +
                                               std::to_string(joints_.size()) + ", counted from 0.");
        moved[v] += weight * joints_[joint](points[v]);
        sum[v] += weight;
      }
  }
  // Points without weights follow the first joint.
  for (std::size_t v = 0; v < points.size(); ++v)
    points[v] = sum[v] > 0 ? Vector3(moved[v] / sum[v]) : joints_.front()(points[v]);
  return true;
}

std::optional<GltfSkin> gltf_skin(const Json& skin, const std::string& place,
                                  const std::map<std::uint64_t, AffineMap>& places, GltfBuffers& buffers,
                                  GltfFields& fields, SceneCollector& collector) {
  const auto joints = fields.wholes(skin, "joints", place);
  if (joints.empty()) fields.fail(place, "It has no joints.");
  if (const auto error = collector.reserve(joints.size(), 0)) fields.fail(*error);
  const auto number = fields.whole(skin, "inverseBindMatrices", place);
  if (fields.error()) return {};
  std::optional<GltfAccessor> matrices;
  if (number) {
    matrices = buffers.accessor(*number, "MAT4");
    if (!fields.error() && matrices->component != GltfComponent::float32)
      fields.fail(matrices->place, "Matrices are floats.");
    if (!fields.error() && matrices->count < joints.size())
      fields.fail(matrices->place, "It has fewer matrices than the skin has joints.");
    if (fields.error()) return {};
  }
  std::vector<AffineMap> out;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const auto at = places.find(joints[k]);
    if (at == places.end()) {
      fields.fail(place, "Its joint " + std::to_string(joints[k]) + " is no node of the scene.");
      return {};
    }
    out.push_back(matrices ? at->second.after(matrix_of(*matrices, k)) : at->second);
  }
  return GltfSkin(std::move(out));
}

}  // namespace hariko
