#include "ui/view/axis_gizmo.hpp"

#include <algorithm>

namespace hariko {

namespace {

constexpr float reach = 0.76F;          ///< distance of the balls' centres from the middle, in radii
constexpr double facing_depth = 0.999;  ///< from which on a ball counts as facing the viewer

/// The axis colours of the look, mixed with the background as far as a ball is away.
ImU32 colour_at_depth(int axis, double depth, float alpha = 1) {
  const ImVec4 ground = ImGui::ColorConvertU32ToFloat4(palette().window),
               own = ImGui::ColorConvertU32ToFloat4(axis_colour(axis));
  const float share = 0.70F + 0.30F * static_cast<float>(depth);
  return ImGui::ColorConvertFloat4ToU32({ground.x + share * (own.x - ground.x),
                                         ground.y + share * (own.y - ground.y),
                                         ground.z + share * (own.z - ground.z), alpha});
}

double squared_distance(ImVec2 a, ImVec2 b) {
  const double x = double(a.x) - double(b.x), y = double(a.y) - double(b.y);
  return x * x + y * y;
}

}  // namespace

StandardView side_of_axis(int axis, bool positive) {
  constexpr std::array<std::array<StandardView, 2>, 3> sides{{{StandardView::left, StandardView::right},
                                                              {StandardView::front, StandardView::back},
                                                              {StandardView::bottom, StandardView::top}}};
  return sides[static_cast<std::size_t>(axis)][positive ? 1 : 0];
}

AxisGizmo::AxisGizmo(const Camera& camera, ImVec2 middle, float radius) : middle_(middle), radius_(radius) {
  const Matrix3 to_camera = camera.orientation.conjugate().toRotationMatrix();
  for (int i = 0; i < 6; ++i) {
    const Vector3 at = (i % 2 == 0 ? 1 : -1) * to_camera.col(i / 2);
    balls_[static_cast<std::size_t>(i)] = {
        i / 2, i % 2 == 0, {reach * static_cast<float>(at.x()), -reach * static_cast<float>(at.y())}, at.z()};
  }
  std::stable_sort(balls_.begin(), balls_.end(),
                   [](const Ball& a, const Ball& b) { return a.depth < b.depth; });
}

ImVec2 AxisGizmo::centre_of(const Ball& ball) const {
  return {middle_.x + radius_ * ball.offset.x, middle_.y + radius_ * ball.offset.y};
}

bool AxisGizmo::holds(ImVec2 point) const {
  return squared_distance(point, middle_) <= double(radius_) * double(radius_);
}

const AxisGizmo::Ball* AxisGizmo::ball_at(ImVec2 point) const {
  const double reach_squared = 1.2 * double(ball_radius()) * double(ball_radius());
  for (auto ball = balls_.rbegin(); ball != balls_.rend(); ++ball)
    if (squared_distance(point, centre_of(*ball)) <= reach_squared) return &*ball;
  return nullptr;
}

std::optional<StandardView> AxisGizmo::side_at(ImVec2 point) const {
  const Ball* ball = ball_at(point);
  if (!ball) return std::nullopt;
  const bool faces = ball->depth > facing_depth;
  return side_of_axis(ball->axis, ball->positive != faces);
}

void AxisGizmo::draw(ImDrawList& list, std::optional<ImVec2> pointer, bool lit) const {
  if (lit) list.AddCircleFilled(middle_, radius_, IM_COL32(255, 255, 255, 26), 48);
  const Ball* hovered = pointer ? ball_at(*pointer) : nullptr;
  constexpr std::array<const char*, 3> letters{"X", "Y", "Z"};
  for (const Ball& ball : balls_) {
    const ImVec2 centre = centre_of(ball);
    const float size = ball_radius() * (0.94F + 0.06F * static_cast<float>(ball.depth));
    const ImU32 colour = colour_at_depth(ball.axis, ball.depth);
    const bool under = hovered == &ball;
    if (ball.positive) {
      list.AddLine(middle_, centre, colour, 0.045F * radius_);
      list.AddCircleFilled(centre, size, colour, 28);
    } else {
      list.AddCircleFilled(centre, size, colour_at_depth(ball.axis, ball.depth, 0.28F), 28);
      list.AddCircle(centre, size - 0.5F, colour, 28, 0.03F * radius_);
    }
    if (under) list.AddCircle(centre, size, IM_COL32_WHITE, 28, 0.04F * radius_);
    if (!ball.positive && !under) continue;
    const std::string text = std::string(ball.positive ? "" : "-") + letters[std::size_t(ball.axis)];
    ImFont* font = ImGui::GetFont();
    const float height = 0.30F * radius_;
    const ImVec2 extent = font->CalcTextSizeA(height, 1e6F, 0, text.c_str());
    list.AddText(font, height, {centre.x - extent.x / 2, centre.y - extent.y / 2},
                 under || !ball.positive ? IM_COL32_WHITE : IM_COL32(16, 17, 19, 255), text.c_str());
  }
}

}  // namespace hariko
