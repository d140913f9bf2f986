#include "core/skinning/columns/simple_skin.hpp"

#include "core/base/assert.hpp"
#include "core/skinning/columns/skin_plan.hpp"
#include "core/skinning/sections/section_direction.hpp"

namespace hariko {

Skin arched_skin(double length, double width, double height, int points) {
  HARIKO_ASSERT(points >= 3, "an arch has three points");
  Skin skin;
  constexpr int path_points = 5;
  for (int i = 0; i < path_points; ++i)
    skin.path.points.push_back(Vector3(length * (double(i) / (path_points - 1) - 0.5), 0, 0));
  for (const int k : {0, 1}) {
    SkinSection section;
    section.id = std::uint32_t(k);
    section.v = k;
    for (int i = 0; i < points; ++i) {
      const double t = 2.0 * i / (points - 1) - 1;
      section.points.push_back({std::uint32_t(k * points + i),
                                Vector3(length * (k - 0.5), width / 2 * t, height * (1 - t * t) / (k + 1)),
                                false});
    }
    skin.sections.push_back(section);
  }
  return skin;
}

Result<Skin> skin_between(const SubdivisionCurve& path, const SubdivisionCurve& first,
                          const SubdivisionCurve& last) {
  Skin skin;
  skin.path = path;
  std::uint32_t next = 0;
  for (const SubdivisionCurve* curve : {&first, &last}) {
    SkinSection section;
    section.id = std::uint32_t(skin.sections.size());
    section.v = skin.sections.empty() ? 0 : path.closed ? 0.5 : 1;
    section.closed = curve->closed;
    for (int i = 0; i < curve->size(); ++i)
      section.points.push_back({next++, curve->points[std::size_t(i)], curve->is_sharp(i)});
    skin.sections.push_back(std::move(section));
  }
  if (const auto plan = plan_skin(skin); !plan) return plan.error();
  return turn_sections(std::move(skin));
}

}  // namespace hariko
