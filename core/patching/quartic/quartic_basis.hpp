#pragma once

// Basis functions of the extended quartic triangle (Kuriyama 1991, equations (8) and (12)).

#include <array>
#include <cstddef>

#include <Eigen/Core>

namespace hariko {

inline constexpr std::size_t quartic_control_count = 18;

/// Control points of a patch, in this order everywhere. The superscript of an inner point names the variable
/// that vanishes on the edge it serves. Corner u = 1 is the split point; v = 1 and w = 1 are the ends of the
/// face's side.
namespace quartic {
enum Control : std::size_t {
  d400,
  d040,
  d004,
  d310,
  d220,
  d130,
  d031,
  d022,
  d013,
  d103,
  d202,
  d301,
  d211w,
  d211v,
  d121w,
  d121u,
  d112v,
  d112u
};
inline constexpr std::array<const char*, quartic_control_count> control_names{
    "400", "040", "004", "310",  "220",  "130",  "031",  "022",  "013",
    "103", "202", "301", "211w", "211v", "121w", "121u", "112v", "112u"};
}  // namespace quartic

/// Values and derivatives of the 18 functions at one point, in the homogeneous variables (u, v, w): a
/// directional derivative along d with d.sum() == 0 is gradient . d, a second one d . hessian . d.
struct QuarticBasis {
  std::array<double, quartic_control_count> value;
  Eigen::Matrix<double, quartic_control_count, 3> gradient;
  std::array<Eigen::Matrix3d, quartic_control_count> hessian;
};

/// Basis functions at u, v, w >= 0 with u + v + w = 1. At a corner the second derivatives of the two inner
/// functions that belong to it depend on the direction; there both get those of the mean direction (a = b =
/// 1/2 in kuriyama.md section 4.5).
QuarticBasis quartic_basis(double u, double v, double w);

}  // namespace hariko
