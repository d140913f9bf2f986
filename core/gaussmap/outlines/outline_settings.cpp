#include "core/gaussmap/outlines/outline_settings.hpp"

#include "core/gaussmap/control_points.hpp"

namespace hariko {

GaussOptions gauss_options(const OutlineSettings& settings) {
  GaussOptions out;
  out.mode = settings.mode;
  out.sign = settings.sign;
  out.radius = settings.radius;
  out.most_points = settings.most_points;
  out.gap = settings.gap;
  out.mode_replaced = settings.mode_replaced;
  return out;
}

OutlineSettings new_outline_settings() {
  OutlineSettings out;
  out.frames = Frames::metric;
  return out;
}

OutlineSettings usual_settings(const Outline& outline) {
  OutlineSettings out = new_outline_settings();
  out.sign = curvature_sign(outline, CurvatureSign::positive);
  if (outline.has_curvature() && out.sign == CurvatureSign::positive) out.mode = GaussMode::curvature;
  return out;
}

}  // namespace hariko
