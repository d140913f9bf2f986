#pragma once

// Smooth skinning: a regular grid whose limit points lie on a virtual surface that blends the sections.

#include <vector>

#include "core/skinning/columns/skin_context.hpp"
#include "core/skinning/columns/skin_mesh.hpp"

namespace hariko {

/// Weights of the sections along the path: cardinal functions of their places.
class BlendWeights {
 public:
  /// Makes the weights. `automatic`: linear for two sections, else natural. Closed paths with fewer than
  /// three sections: linear.
  BlendWeights(std::vector<double> places, bool closed, Blend blend);
  /// Weights at v, one per section; they add up to 1.
  std::vector<double> at(double v) const;

 private:
  std::vector<double> knots_;  ///< ends with the first one again, a turn later, when closed
  std::size_t sections_;
  bool closed_;
  bool linear_;
  /// Values and slopes of each section's cardinal function at the knots.
  std::vector<std::vector<double>> value_, slope_;
};

/// Virtual surface S(u, v) = C(v) + F(v) sum of w_k(v) d_k(phi_k(u)), which passes through every section.
class VirtualSurface {
 public:
  /// Makes the surface. `anchors`: rows of parameters, one per section, increasing, counted from the starts
  /// of the sections (`SkinPlan::starts`); phi_k maps their means to them.
  VirtualSurface(const Skin& skin, const SkinPlan& plan, std::vector<std::vector<double>> anchors = {});

  const BlendWeights& weights() const { return weights_; }
  /// Means of the anchors, increasing.
  const std::vector<double>& anchor_places() const { return places_; }
  /// Parameter phi_k(u), counted from the start of the section.
  double parameter(int section, double u) const;
  /// Point at v whose parameter on section k is u[k].
  Vector3 point(const std::vector<double>& u, double v) const;
  /// Point S(u, v).
  Vector3 point(double u, double v) const;

 private:
  const SkinPlan& plan_;
  BlendWeights weights_;
  std::vector<SubdivisionCurve> offsets_;
  bool closed_sections_;
  std::vector<double> places_;
  /// [section][anchor], including the ends or the periodic continuation.
  std::vector<std::vector<double>> anchors_;
};

/// Anchors of a skin: its own rows, those of its links (method `anchored`), and corners where all sections
/// have the same number; counted from the starts of the sections. Errors: E_LINK_CROSS where they are not in
/// the same order on every section, E_INDEX where a row has not one parameter per section.
Result<std::vector<std::vector<double>>> skin_anchors(const Skin& skin, const SkinPlan& plan);

/// Makes the control mesh of a smooth or anchored skin. Errors: E_FEW_ROWS, E_SKIN_SIZE, those of
/// `skin_anchors`. O(rows x columns) plus the slow optimisation of parameters; when cancelled, that ends with
/// the best result so far.
Result<SkinMesh> smooth_mesh(const Skin& skin, const SkinPlan& plan, const SkinWork& work = {});

}  // namespace hariko
