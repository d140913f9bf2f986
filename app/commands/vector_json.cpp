#include "app/commands/vector_json.hpp"

#include <nlohmann/json.hpp>

namespace hariko {

nlohmann::ordered_json vector_json(const Vector3& v) {
  return nlohmann::ordered_json::array({v.x(), v.y(), v.z()});
}

}  // namespace hariko
