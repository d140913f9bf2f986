#include "render/style.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace hariko {
namespace {

Matrix3 rows(const std::array<double, 9>& m) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(m.data());
}

Vector3 linear(const Color& c) {
  const auto one = [](float part) {
    const double x = double(part);
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  };
  return {one(c.r), one(c.g), one(c.b)};
}

/// CIELAB of a linear colour, D65.
Vector3 lab(const Vector3& rgb) {
  const Matrix3 to_xyz = rows({0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505});
  const Vector3 xyz = to_xyz * rgb.cwiseMax(0).cwiseMin(1);
  const auto f = [](double x) { return x > 0.008856 ? std::cbrt(x) : 7.787 * x + 16.0 / 116; };
  const double x = f(xyz.x() / 0.9505), y = f(xyz.y()), z = f(xyz.z() / 1.089);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

TEST(Style, EveryKindOfColourVisionTellsCreasesFromTheSelection) {
  // Normal vision, and protanopia, deuteranopia, tritanopia by Machado, Oliveira and Fernandes (2009).
  const std::array<Matrix3, 4> kinds{
      Matrix3::Identity(),
      rows({0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998}),
      rows({0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881}),
      rows({1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900})};
  for (const Background background : {Background::dark, Background::light}) {
    const gl::Style style = gl::style_of(background);
    for (const Matrix3& seen : kinds) {
      const auto apart = [&](const Color& a, const Color& b) {
        return (lab(seen * linear(a)) - lab(seen * linear(b))).norm();
      };
      constexpr double at_a_glance = 35;  // CIE 1976; 2.3 is just noticeable
      EXPECT_GE(apart(style.crease.paint, style.selected_edge.paint), at_a_glance);
      EXPECT_GE(apart(style.corner.paint, style.selected_point.paint), at_a_glance);
    }
    EXPECT_GE(style.selected_edge.width, 1.6F * style.crease.width) << "and by its width";
  }
}

}  // namespace
}  // namespace hariko
