#include "core/approximation/mesh_options.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace hariko {

namespace {

struct Limits {
  const char* name;
  double least, most;
};

std::optional<Message> check(const std::optional<double>& tolerance, const Limits& limits) {
  if (!tolerance) return std::nullopt;
  const std::string name = limits.name;
  if (!(*tolerance > 0) || !std::isfinite(*tolerance))
    return make_error(e_mesh_tolerance, "The tolerance must be positive (" + name + ").",
                      "Give a number above zero.");
  if (*tolerance < limits.least)
    return make_error(e_mesh_tolerance, "The tolerance is below the numerical accuracy (" + name + ").",
                      "Give a larger one.");
  if (*tolerance >= limits.most)
    return make_error(e_mesh_tolerance, "The tolerance is too large (" + name + ").", "Give a smaller one.");
  return std::nullopt;
}

}  // namespace

std::optional<Message> check_criteria(const MeshCriteria& criteria, double size) {
  if (!criteria.any())
    return make_error(e_mesh_nothing, "There is no tolerance to satisfy.",
                      "Set a distance, an angle or another criterion.");
  constexpr double accuracy = 1e-7, relative = 1e-6, none = 1e300, pi = std::numbers::pi;
  for (const auto& [tolerance, limits] :
       {std::pair{criteria.distance, Limits{"distance", accuracy * size, none}},
        std::pair{criteria.normal_angle, Limits{"normal angle", relative, pi / 2}},
        std::pair{criteria.fold_angle, Limits{"fold angle", relative, pi}},
        std::pair{criteria.luminance, Limits{"luminance", relative, none}},
        std::pair{criteria.max_edge, Limits{"edge length", accuracy * size, none}},
        std::pair{criteria.min_angle, Limits{"smallest angle", relative, pi / 3}}})
    if (auto error = check(tolerance, limits)) return error;
  if (!criteria.luminance) return std::nullopt;
  const LuminanceModel& model = criteria.luminance_model;
  bool valid = model.view.allFinite() && model.view.norm() > 0 && std::isfinite(model.diffuse) &&
               std::isfinite(model.specular) && std::isfinite(model.shininess) && model.shininess >= 1;
  for (const Vector3& light : model.lights) valid = valid && light.allFinite() && light.norm() > 0;
  if (!valid)
    return make_error(e_mesh_tolerance, "A light or the view has no direction, or the shininess is below 1.",
                      "Correct the lights.");
  return std::nullopt;
}

}  // namespace hariko
