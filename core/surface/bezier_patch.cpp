#include "core/surface/bezier_patch.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

std::string named(std::size_t number) {
  return "Patch " + std::to_string(number + 1);
}

}  // namespace

std::optional<Message> check_patch(const BezierPatch& patch, std::size_t number) {
  const auto valid = [](int degree) { return degree >= 1 && degree <= max_bezier_degree; };
  if (!valid(patch.degree_s) || !valid(patch.degree_t))
    return make_error(e_patch_degree,
                      named(number) + " has degree " + std::to_string(patch.degree_s) + " by " +
                          std::to_string(patch.degree_t) + ".",
                      "Degrees from 1 to " + std::to_string(max_bezier_degree) + " are accepted.");
  const std::size_t count = std::size_t(patch.degree_s + 1) * std::size_t(patch.degree_t + 1);
  if (patch.points.size() != count)
    return make_error(e_patch_points,
                      named(number) + " has " + std::to_string(patch.points.size()) + " control points.",
                      "Its degree needs " + std::to_string(count) + ".");
  // Limit that keeps differences and products of coordinates finite.
  constexpr double limit = 1e100;
  const bool finite = std::all_of(patch.points.begin(), patch.points.end(), [](const Vector3& p) {
    return p.allFinite() && p.lpNorm<Eigen::Infinity>() <= limit;
  });
  if (!finite)
    return make_error(e_patch_points,
                      named(number) + " has a control point that is not a number, or too large.",
                      "Correct its coordinates.");
  if (patch.weights.empty()) return std::nullopt;
  const bool positive = patch.weights.size() == count &&
                        std::all_of(patch.weights.begin(), patch.weights.end(),
                                    [](double w) { return std::isfinite(w) && w >= 1e-12 && w <= 1e12; });
  if (!positive)
    return make_error(e_patch_weights,
                      named(number) + " has a weight that is not positive, or too few of them.",
                      "Every control point needs a positive weight.");
  return std::nullopt;
}

BezierPatch flipped(const BezierPatch& patch) {
  BezierPatch out;
  out.degree_s = patch.degree_t;
  out.degree_t = patch.degree_s;
  for (int j = 0; j <= out.degree_t; ++j)
    for (int i = 0; i <= out.degree_s; ++i) {
      out.points.push_back(patch.points[patch.index(j, i)]);
      if (patch.rational()) out.weights.push_back(patch.weights[patch.index(j, i)]);
    }
  return out;
}

}  // namespace hariko
