#include "render/tension_colors.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

constexpr double strong = 20;

}  // namespace

double alpha_place(double alpha) {
  return std::clamp(std::log1p(alpha) / std::log1p(strong), 0.0, 1.0);
}

double beta_place(double beta) {
  return std::clamp(std::log(std::max(beta, 1e-6)) / std::log(strong), -1.0, 1.0);
}

double tension_fraction(double place) {
  if (place == 0) return 0.5;
  return 0.5 + 0.5 * (place < 0 ? -0.35 + 0.50 * place : 0.35 + 0.50 * place);
}

Color tension_color(double place) {
  return color_at(ColorScale::diverging_safe, tension_fraction(place));
}

}  // namespace hariko
