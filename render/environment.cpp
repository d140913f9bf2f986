#include "render/environment.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

constexpr double lobe_texels = 1.6;  // half the width of a lobe in texels of its level
constexpr double lobe_reach = 3.5;   // in half widths, where a lobe is cut off

/// Share of the sphere that a texel of a row has.
double texel_share(int row, int rows, int columns) {
  return (std::cos(std::numbers::pi * row / rows) - std::cos(std::numbers::pi * (row + 1) / rows)) /
         (2 * columns);
}

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Vector3 mixed(const Vector3& a, const Vector3& b, double t) {
  return a + t * (b - a);
}

/// Share of a rectangle of light that a direction meets: its middle is a unit direction, `size` half its
/// sides as slopes, along the horizon and up.
double light_box(const Vector3& d, const Vector3& middle, const Vector2& size) {
  const double along = d.dot(middle);
  if (along <= 0) return 0;
  const Vector3 side = std::abs(middle.z()) > 0.999 ? Vector3::UnitX() : Vector3::UnitZ();
  const Vector3 across = side.cross(middle).normalized(), up = middle.cross(across);
  constexpr double blur = 0.03;
  const double x = std::abs(d.dot(across)) / along, y = std::abs(d.dot(up)) / along;
  return (1 - smooth_step(size.x() - blur, size.x() + blur, x)) *
         (1 - smooth_step(size.y() - blur, size.y() + blur, y));
}

/// Three soft boxes in a grey room: key from the upper left, a strip at the right, a wide one overhead.
Vector3 studio_light(const Vector3& d) {
  const Vector3 floor(0.12, 0.117, 0.114), wall(0.24, 0.25, 0.27);
  Vector3 out = mixed(floor, wall, smooth_step(-0.15, 0.15, d.z()));
  out += light_box(d, Vector3(-0.62, -0.55, 0.56).normalized(), {0.55, 0.40}) * Vector3(3.6, 3.5, 3.4);
  out += light_box(d, Vector3(0.90, -0.40, 0.20).normalized(), {0.16, 0.85}) * Vector3(2.2, 2.35, 2.5);
  out += light_box(d, Vector3(0.0, 0.35, 0.94).normalized(), {0.70, 0.30}) * Vector3(2.4, 2.4, 2.4);
  return out;
}

/// Seven tubes along y under a dark ceiling, at the height 1 over the eye.
Vector3 tube_light(const Vector3& d) {
  constexpr double spacing = 0.5, half_width = 0.10, half_length = 2.5, blur = 0.03;
  constexpr double outermost = 3;
  const Vector3 room = Vector3::Constant(0.10 + 0.05 * smooth_step(-0.2, 0.2, -d.z()));
  if (d.z() < 0.05) return room;
  const double x = d.x() / d.z(), y = d.y() / d.z();
  const double tube = std::clamp(std::round(x / spacing), -outermost, outermost);
  const double lit = (1 - smooth_step(half_width - blur, half_width + blur, std::abs(x - tube * spacing))) *
                     (1 - smooth_step(half_length - blur, half_length + blur, std::abs(y)));
  return room + lit * Vector3(3.3, 3.4, 3.5);
}

/// Dark ground under a sky that is brightest above a sharp horizon.
Vector3 horizon_light(const Vector3& d) {
  const Vector3 ground = mixed(Vector3(0.10, 0.09, 0.08), Vector3(0.05, 0.047, 0.045), std::max(-d.z(), 0.0));
  const double height = std::max(d.z(), 0.0);
  const Vector3 sky = mixed(Vector3(1.10, 1.08, 1.04), Vector3(0.30, 0.42, 0.62), std::sqrt(height));
  return mixed(ground, sky, smooth_step(-0.02, 0.02, d.z()));
}

/// Overcast sky of the CIE: three times as bright overhead as at the horizon, over ground that sends a fifth
/// of it back.
Vector3 overcast_light(const Vector3& d) {
  const Vector3 ground = Vector3::Constant(0.16);
  const Vector3 sky = (1 + 2 * std::max(d.z(), 0.0)) / 3 * Vector3(0.98, 1.0, 1.03);
  return mixed(ground, sky, smooth_step(-0.04, 0.04, d.z()));
}

Vector3 light_of(EnvironmentKind kind, const Vector3& d) {
  switch (kind) {
    case EnvironmentKind::studio:
      return studio_light(d);
    case EnvironmentKind::tubes:
      return tube_light(d);
    case EnvironmentKind::horizon:
      return horizon_light(d);
    case EnvironmentKind::overcast:
      return overcast_light(d);
    case EnvironmentKind::file:
      break;
  }
  HARIKO_ASSERT(false, "files have no formula");
  return Vector3::Zero();
}

/// Picture of half the size, by means of solid angles.
RadianceImage halved_radiance(const RadianceImage& image) {
  RadianceImage out(image.width / 2, image.height / 2);
  for (int y = 0; y < out.height; ++y) {
    const double upper = texel_share(2 * y, image.height, 1), lower = texel_share(2 * y + 1, image.height, 1);
    for (int x = 0; x < out.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const double above = double(image.at(2 * x, 2 * y)[c]) + double(image.at(2 * x + 1, 2 * y)[c]);
        const double below =
            double(image.at(2 * x, 2 * y + 1)[c]) + double(image.at(2 * x + 1, 2 * y + 1)[c]);
        out.at(x, y)[c] = static_cast<float>((upper * above + lower * below) / (2 * (upper + lower)));
      }
  }
  return out;
}

/// Texels of a row round a column, with their weights.
struct LobeRow {
  int row = 0;
  std::vector<std::pair<int, double>> parts;  ///< distance in columns, and weight
};

/// Rows that a lobe round the texels of row `to` reaches. The lobe is that of von Mises and Fisher,
/// exp(k (cos - 1)).
std::vector<LobeRow> lobe_rows(int to, const RadianceImage& image, double width) {
  const double concentration = 1 / (width * width), reach = std::min(lobe_reach * width, std::numbers::pi);
  const double a = std::numbers::pi * (to + 0.5) / image.height, least = std::cos(reach);
  std::vector<LobeRow> out;
  for (int from = 0; from < image.height; ++from) {
    const double b = std::numbers::pi * (from + 0.5) / image.height;
    if (std::abs(a - b) > reach) continue;
    const double share = texel_share(from, image.height, image.width);
    LobeRow& row = out.emplace_back(LobeRow{from, {}});
    for (int x = 0; x < image.width; ++x) {
      const double turn = 2 * std::numbers::pi * x / image.width;
      const double between = std::cos(a) * std::cos(b) + std::sin(a) * std::sin(b) * std::cos(turn);
      if (between >= least) row.parts.emplace_back(x, share * std::exp(concentration * (between - 1)));
    }
  }
  return out;
}

/// Picture averaged over a lobe round each direction.
RadianceImage lobed(const RadianceImage& image, double width) {
  RadianceImage out(image.width, image.height);
  for (int y = 0; y < image.height; ++y) {
    const std::vector<LobeRow> rows = lobe_rows(y, image, width);
    double total = 0;
    for (const LobeRow& row : rows)
      for (const auto& [column, weight] : row.parts) total += weight;
    for (int x = 0; x < image.width; ++x) {
      std::array<double, 3> sum{};
      for (const LobeRow& row : rows)
        for (const auto& [column, weight] : row.parts) {
          const Radiance& from = image.at((x + column) % image.width, row.row);
          for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * double(from[c]);
        }
      for (std::size_t c = 0; c < 3; ++c) out.at(x, y)[c] = static_cast<float>(sum[c] / total);
    }
  }
  return out;
}

}  // namespace

Vector3 environment_direction(double u, double v) {
  const double turn = 2 * std::numbers::pi * (u - 0.5), down = std::numbers::pi * v;
  return {std::sin(down) * std::sin(turn), std::sin(down) * std::cos(turn), std::cos(down)};
}

std::array<double, 3> mean_radiance(const RadianceImage& image) {
  std::array<double, 3> mean{};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        mean[c] += texel_share(y, image.height, image.width) * double(image.at(x, y)[c]);
  return mean;
}

RadianceImage environment_picture(EnvironmentKind kind) {
  constexpr int samples = 3;  // along each side of a texel, so that edges of lights have no steps
  RadianceImage out(environment_width, environment_height);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      Vector3 sum = Vector3::Zero();
      for (int i = 0; i < samples * samples; ++i) {
        const double u = x + (i % samples + 0.5) / samples, v = y + (i / samples + 0.5) / samples;
        sum += light_of(kind, environment_direction(u / out.width, v / out.height));
      }
      for (std::size_t c = 0; c < 3; ++c)
        out.at(x, y)[c] = static_cast<float>(sum[Eigen::Index(c)] / (samples * samples));
    }
  return out;
}

std::size_t EnvironmentLevels::bytes() const {
  std::size_t sum = 0;
  for (const RadianceImage& level : levels) sum += level.pixels.size() * sizeof(Radiance);
  return sum;
}

double lobe_width(int level) {
  return level == 0 ? 0 : lobe_texels * std::numbers::pi / (environment_height >> level);
}

EnvironmentLevels environment_levels(RadianceImage picture) {
  HARIKO_ASSERT(picture.width == environment_width && picture.height == environment_height,
                "environments are reduced before they are filtered");
  EnvironmentLevels out;
  RadianceImage half = picture;
  out.levels.push_back(std::move(picture));
  for (int level = 1; level < environment_level_count; ++level) {
    half = halved_radiance(half);
    out.levels.push_back(lobed(half, lobe_width(level)));
  }
  return out;
}

Matrix3 Environment::axes() const {
  const double angle = std::remainder(turn, 360.0) * std::numbers::pi / 180;
  Matrix3 out = Matrix3::Identity();
  out(0, 0) = out(1, 1) = std::cos(angle);
  out(0, 1) = std::sin(angle);
  out(1, 0) = -std::sin(angle);
  return out;
}

}  // namespace hariko
