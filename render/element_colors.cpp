#include "render/element_colors.hpp"

#include <algorithm>
#include <array>
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

namespace {

/// Colour of a patch: neighbouring numbers have distant hues (golden angle), patches of one source element
/// alternate in lightness.
std::array<std::uint8_t, 3> patch_color(std::uint64_t element, std::uint32_t side) {
  const double turn = 0.6180339887498949 * static_cast<double>(element % 100'000);
  const double hue = 6 * (turn - std::floor(turn));
  const double value = side % 2 == 0 ? 0.80 : 0.70, saturation = 0.42;
  std::array<std::uint8_t, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double k = std::fmod(5.0 - 2.0 * static_cast<double>(i) + hue, 6.0);
    const double level = value - value * saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0);
    out[i] = static_cast<std::uint8_t>(std::lround(255 * level));
  }
  return out;
}

}  // namespace

std::vector<std::uint8_t> patch_color_bytes(const SceneObject& object) {
  const DisplayMesh& mesh = *object.mesh;
  std::vector<std::uint8_t> out(std::size_t(mesh.patch_count()) * 4, 0);
  if (object.map == SurfaceMap::patches)
    for (Index p = 0; p < mesh.patch_count(); ++p) {
      const Provenance& from = mesh.provenance(p);
      const auto color = patch_color(from.element.id, from.side);
      std::copy(color.begin(), color.end(), out.begin() + static_cast<std::ptrdiff_t>(4 * std::size_t(p)));
    }
  for (const Index p : object.hovered_patches)
    if (p < mesh.patch_count()) out[4 * std::size_t(p) + 3] = 128;
  for (const Index p : object.selected_patches)
    if (p < mesh.patch_count()) out[4 * std::size_t(p) + 3] = 255;
  return out;
}

}  // namespace hariko
