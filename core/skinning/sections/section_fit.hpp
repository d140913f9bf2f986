#pragma once

// Exact interpolation of interior sections: where a section's vertices are regular, the surface's curve along
// them has the control points (V- + 4 V + V+) / 6, which are required to be the section's.

#include <vector>

#include "core/skinning/columns/skin_mesh.hpp"

namespace hariko {

/// Interpolation condition at one vertex of a section, with the two vertices beside it across the section.
struct SectionEquation {
  Index vertex = 0, before = 0, after = 0;
  Vector3 target = Vector3::Zero();
};

/// Second divided difference along a line through a vertex, from the means of its neighbours before and
/// after, at these distances (in mean strip lengths).
struct LineBend {
  Index vertex = 0;
  std::vector<Index> before, after;
  double before_distance = 1, after_distance = 1;
  Vector3 own = Vector3::Zero();  ///< target value of the difference
};

/// Second difference V'' of a bend for vertices at these positions.
Vector3 second_difference(const LineBend& bend, const std::vector<Vector3>& positions);

/// Sets V = (6 P - V- - V+) / 4 with the neighbours unchanged. Exact, but dense rows can make dimples.
void fit_sections_locally(std::vector<Vector3>& positions, const std::vector<SectionEquation>& equations);

/// Minimises the sum of h (tension |V - V0|^2 + |V'' - own|^2) over all vertices under the equations, with
/// `held` vertices fixed; V0 are the given positions. No vertex of an equation may be the neighbour in
/// another one. Sparse factorisation, about linear.
void fit_sections_fairly(std::vector<Vector3>& positions, const std::vector<SectionEquation>& equations,
                         const std::vector<LineBend>& bends, const std::vector<char>& held, double tension);

}  // namespace hariko
