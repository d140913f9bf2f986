#pragma once

// Luminance of a point under each of several lights.

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/approximation/mesh_options.hpp"

namespace hariko {

/// Luminance by a model, with its directions normalised.
class Brightness {
 public:
  explicit Brightness(const LuminanceModel& model) : model_(model) {
    std::vector<Vector3> lights = model.lights;
    if (lights.empty())
      for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) lights.push_back(sign * Vector3::Unit(axis));
    const Vector3 view = model.view.normalized();
    for (const Vector3& light : lights) {
      const Vector3 l = light.normalized(), half = l + view;
      lamps_.push_back({l, half.norm() > 1e-9 ? Vector3(half.normalized()) : Vector3::Zero()});
    }
  }

  std::size_t lights() const { return lamps_.size(); }
  /// Luminance under one of the lights, by `LuminanceModel`.
  double of(const Vector3& unit_normal, std::size_t light) const {
    const Lamp& lamp = lamps_[light];
    return model_.diffuse * std::max(unit_normal.dot(lamp.light), 0.0) +
           model_.specular * std::pow(std::max(unit_normal.dot(lamp.half), 0.0), model_.shininess);
  }

 private:
  struct Lamp {
    Vector3 light, half;
  };
  LuminanceModel model_;
  std::vector<Lamp> lamps_;
};

}  // namespace hariko
