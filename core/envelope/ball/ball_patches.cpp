#include "core/envelope/ball/ball_patches.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/index_list.hpp"
#include "core/base/parallel.hpp"
#include "core/envelope/closed_surface.hpp"
#include "core/geometry/angles.hpp"

namespace hariko {

namespace {

/// Side with the field of directions across it to its left, in the surface's tangent planes.
struct Ribbon {
  Quintic curve;
  std::array<Vector3, 4> across;  ///< cubic Bezier

  Ribbon turned() const { return {reversed(curve), {-across[3], -across[2], -across[1], -across[0]}}; }
};

/// Tangent at a, as long as the circular arc over the chord with this direction.
Vector3 arc_tangent(const Vector3& chord, const Vector3& normal) {
  const Vector3 flat = chord - chord.dot(normal) * normal;
  const double cosine = std::clamp(flat.norm() / chord.norm(), 0.3, 1.0);
  const double angle = std::acos(cosine);
  const double stretch = angle > 1e-6 ? angle / (std::sin(angle) * cosine) : 1;
  return stretch * flat;
}

Ribbon ribbon_between(const SplineField& field, const Vector3& a, const LevelCurvature& at_a,
                      const Vector3& b, const LevelCurvature& at_b) {
  const Vector3 chord = b - a, ta = arc_tangent(chord, at_a.normal), tb = arc_tangent(chord, at_b.normal);
  Ribbon out;
  out.curve = {a,
               a + ta / 5,
               a + 0.4 * ta + at_a.along(ta) / 20 * at_a.normal,
               b - 0.4 * tb + at_b.along(tb) / 20 * at_b.normal,
               b - tb / 5,
               b};
  std::array<Vector3, 4> at;
  for (std::size_t i = 0; i < 4; ++i) {
    const double t = double(i) / 3;
    Vector3 normal = i == 0 ? at_a.normal : at_b.normal;
    if (i == 1 || i == 2)
      normal = field.at(projected(field, value_at(out.curve, t), 2, 0.25 * chord.norm()))
                   .gradient.stableNormalized();
    at[i] = normal.cross(derivative_at(out.curve, t));
  }
  out.across = {at[0], (-5 * at[0] + 18 * at[1] - 9 * at[2] + 2 * at[3]) / 6,
                (2 * at[0] - 9 * at[1] + 18 * at[2] - 5 * at[3]) / 6, at[3]};
  return out;
}

/// Product of (a (1 - t) + b t) and a Bezier curve.
template <std::size_t N>
std::array<Vector3, N + 1> times_linear(const std::array<Vector3, N>& curve, double a, double b) {
  std::array<Vector3, N + 1> out;
  for (std::size_t i = 0; i <= N; ++i) {
    out[i] = Vector3::Zero();
    if (i < N) out[i] += double(N - i) / double(N) * a * curve[i];
    if (i > 0) out[i] += double(i) / double(N) * b * curve[i - 1];
  }
  return out;
}

/// Derivatives into the patch along a side, in its tangent planes, that equal `start` and `end` at the
/// corners.
Quintic inward_field(const Ribbon& side, const Vector3& start, const Vector3& end) {
  std::array<Vector3, 5> rate;
  for (std::size_t i = 0; i < 5; ++i) rate[i] = 5 * (side.curve[i + 1] - side.curve[i]);
  const auto share = [](const Vector3& of, const Vector3& along) {
    const double square = along.squaredNorm();
    return square > 0 ? of.dot(along) / square : 0.0;
  };
  const auto across =
      times_linear(times_linear(side.across, share(start, side.across[0]), share(end, side.across[3])), 1, 1);
  const auto along = times_linear(rate, share(start, rate[0]), share(end, rate[4]));
  Quintic out;
  for (std::size_t i = 0; i < 6; ++i) out[i] = across[i] + along[i];
  return out;
}

/// Curvature of the surface at the places of a side where the curvature across it is matched.
using SideForms = std::array<LevelCurvature, bend_places.size()>;

/// Patch of a quad: its sides counter-clockwise, the derivatives into it, and the surface's curvature along
/// them.
HermitePatch patch_between(std::array<Quintic, 4> sides, std::array<Quintic, 4> inwards,
                           const std::array<SideForms, 4>& forms) {
  HermitePatch out = HermitePatch::from_loop(sides, inwards);
  for (std::size_t side = 0; side < 4; ++side) {
    std::array<Vector3, 3> wanted = seconds_across(HermitePatch::from_loop(sides, inwards));
    for (std::size_t i = 0; i < 3; ++i) {
      const LevelCurvature& form = forms[side][i];
      const Vector3 across = value_at(inwards[0], bend_places[i]);
      wanted[i] = (form.along(across) - wanted[i].dot(form.normal)) * form.normal;
    }
    out.bend[side] = bend_through(wanted);
    // The next side comes first.
    std::rotate(sides.begin(), sides.begin() + 1, sides.end());
    std::rotate(inwards.begin(), inwards.begin() + 1, inwards.end());
  }
  return out;
}

/// Calls each(patch, positions, normals) with a grid of points on every patch, in parallel.
template <class Each>
void for_patch_grids(const HermitePatchSet& patches, const GridPattern& pattern, const Each& each) {
  const auto count = std::size_t(pattern.point_count());
  parallel_for(patches.patch_count(), 8, [&](std::size_t begin, std::size_t end) {
    const std::vector<Index> numbers = ascending_indices(end - begin, Index(begin));
    std::vector<Vector3> positions(numbers.size() * count), normals(numbers.size() * count);
    patches.evaluate_grid(numbers, pattern, positions, normals);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      each(begin + k, std::span<const Vector3>(positions).subspan(k * count, count),
           std::span<const Vector3>(normals).subspan(k * count, count));
  });
}

}  // namespace

std::shared_ptr<const HermitePatchSet> ball_patches(const SplineField& field, const BallCage& cage) {
  std::vector<LevelCurvature> forms(cage.positions.size());
  parallel_for(forms.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) forms[v] = level_curvature(field, cage.positions[v]);
  });
  const FaceSides sides = sides_of(cage.quads, cage.positions.size());
  std::vector<Ribbon> ribbons(sides.ends.size());
  std::vector<SideForms> forms_along(ribbons.size());
  parallel_for(ribbons.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      const auto [a, b] = sides.ends[s];
      ribbons[s] = ribbon_between(field, cage.positions[a], forms[a], cage.positions[b], forms[b]);
      for (std::size_t i = 0; i < bend_places.size(); ++i)
        forms_along[s][i] = level_curvature(field, value_at(ribbons[s].curve, bend_places[i]));
    }
  });
  std::vector<HermitePatch> out(cage.quads.size());
  parallel_for(out.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t q = begin; q < end; ++q) {
      const auto& quad = cage.quads[q];
      std::array<Ribbon, 4> loop;
      std::array<Quintic, 4> curves, inwards;
      std::array<SideForms, 4> along;
      for (std::size_t i = 0; i < 4; ++i) {
        const Index side = sides.of_face[q][i];
        const bool onwards = quad[i] < quad[(i + 1) % 4];
        loop[i] = onwards ? ribbons[side] : ribbons[side].turned();
        along[i] = forms_along[side];
        if (!onwards) std::swap(along[i].front(), along[i].back());
        curves[i] = loop[i].curve;
      }
      for (std::size_t i = 0; i < 4; ++i) {
        const Quintic &before = curves[(i + 3) % 4], &after = curves[(i + 1) % 4];
        inwards[i] = inward_field(loop[i], 5 * (before[4] - before[5]), 5 * (after[1] - after[0]));
      }
      out[q] = patch_between(curves, inwards, along);
    }
  });
  return std::make_shared<const HermitePatchSet>(std::move(out));
}

std::vector<PatchFit> patch_fits(const SplineField& field, const HermitePatchSet& patches, int intervals) {
  std::vector<PatchFit> out(patches.patch_count());
  for_patch_grids(patches, {Domain::square, intervals},
                  [&](std::size_t q, std::span<const Vector3> positions, std::span<const Vector3> normals) {
                    PatchFit& fit = out[q];
                    for (std::size_t i = 0; i < positions.size(); ++i) {
                      const FieldPoint at = field.at(positions[i]);
                      const double slope = at.gradient.norm();
                      const double away = slope > 0 ? at.value / slope : 0;
                      fit.outward = std::max(fit.outward, away);
                      fit.inward = std::max(fit.inward, -away);
                      const Vector3 wanted = slope > 0 ? Vector3(at.gradient / slope) : normals[i];
                      fit.least_agreement = std::min(fit.least_agreement, normals[i].dot(wanted));
                    }
                  });
  return out;
}

std::vector<PatchTurn> patch_turns(const SplineField& field, const HermitePatchSet& patches, int intervals) {
  const GridPattern pattern{Domain::square, intervals};
  std::vector<PatchTurn> out(patches.patch_count());
  for_patch_grids(patches, pattern,
                  [&](std::size_t q, std::span<const Vector3> positions, std::span<const Vector3> normals) {
                    std::vector<Vector3> of_field(positions.size());
                    for (std::size_t i = 0; i < positions.size(); ++i) {
                      const Vector3 gradient = field.at(positions[i]).gradient;
                      const double slope = gradient.norm();
                      of_field[i] = slope > 0 ? Vector3(gradient / slope) : normals[i];
                    }
                    const auto angle = [&](int i, int j, int k, int l) {
                      return angle_between(of_field[std::size_t(pattern.index(i, j))],
                                           of_field[std::size_t(pattern.index(k, l))]);
                    };
                    PatchTurn turn{};
                    for (int line = 0; line <= intervals; ++line) {
                      double u = 0, v = 0;
                      for (int i = 0; i < intervals; ++i)
                        u += angle(i, line, i + 1, line), v += angle(line, i, line, i + 1);
                      turn = {std::max(turn[0], u), std::max(turn[1], v)};
                    }
                    out[q] = turn;
                  });
  return out;
}

Surface ball_surface(const SplineField& field, const BallCage& cage,
                     std::shared_ptr<const HermitePatchSet> patches, const Vector3& origin) {
  std::vector<ClosedPatch> places;
  for (Index q = 0; q < cage.quads.size(); ++q) {
    ClosedPatch place{cage.quads[q], {element_of(FaceId{q}), 0}, {}};
    for (std::size_t k = 0; k < 4; ++k)
      place.sources[k] = element_of(EdgeId::of(VertexId{place.nodes[k]}, VertexId{place.nodes[(k + 1) % 4]}));
    places.push_back(place);
  }
  std::vector<Vector3> normals(cage.positions.size());
  parallel_for(normals.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      normals[v] = field.at(cage.positions[v]).gradient.stableNormalized();
  });
  return closed_surface(origin, std::move(patches), places, std::move(normals));
}

}  // namespace hariko
