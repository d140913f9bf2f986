#pragma once

// Smooth skinning: a regular grid whose limit points lie on a virtual surface that blends the sections.

#include <vector>

#include "core/skinning/skin_mesh.hpp"
#include "core/skinning/skin_work.hpp"

namespace hariko {

/// Weights of the sections along the path: cardinal functions of their places.
class BlendWeights {
 public:
  /// `automatic`: linear for two sections, else natural. Closed paths with fewer than three sections: linear.
  BlendWeights(std::vector<double> places, bool closed, Blend blend);
  /// One weight a section; they add up to 1.
  std::vector<double> at(double v) const;

 private:
  std::vector<double> knots_;  ///< with the first one again, a turn later, when closed
  std::size_t sections_;
  bool closed_;
  bool linear_;
  std::vector<std::vector<double>> value_, slope_;  ///< of each section's cardinal function at the knots
};

/// S(u, v) = C(v) + F(v) sum of w_k(v) d_k(phi_k(u)): through every section, which are the designer's.
class VirtualSurface {
 public:
  /// `anchors`: rows of parameters, one a section, increasing, counted from where the sections begin
  /// (`SkinPlan::starts`); phi_k takes their means to them.
  VirtualSurface(const Skin& skin, const SkinPlan& plan, std::vector<std::vector<double>> anchors = {});

  const BlendWeights& weights() const { return weights_; }
  /// Means of the anchors, increasing.
  const std::vector<double>& anchor_places() const { return places_; }
  /// phi_k, from where the section begins.
  double parameter(int section, double u) const;
  /// The point whose parameter on section k is u[k].
  Vector3 point(const std::vector<double>& u, double v) const;
  /// S(u, v).
  Vector3 point(double u, double v) const;

 private:
  const SkinPlan& plan_;
  BlendWeights weights_;
  std::vector<SubdivisionCurve> offsets_;
  bool closed_sections_;
  std::vector<double> places_;
  std::vector<std::vector<double>> anchors_;  ///< [section][anchor], with ends or the periodic continuation
};

/// The anchors of a skin: its own rows, those of its links (method `anchored`), and corners where all
/// sections have as many; counted from where sections begin. Errors: E_LINK_CROSS where they are not in the
/// same order on every section.
Result<std::vector<std::vector<double>>> skin_anchors(const Skin& skin, const SkinPlan& plan);

/// Errors: E_FEW_ROWS, E_LINK_CROSS, E_SKIN_SIZE. O(rows x columns); optimised parameters take their time,
/// and cancelling ends them with the best so far.
Result<SkinMesh> smooth_mesh(const Skin& skin, const SkinPlan& plan, const SkinWork& work = {});

}  // namespace hariko
