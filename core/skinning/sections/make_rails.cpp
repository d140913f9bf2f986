#include "core/skinning/sections/make_rails.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/ids.hpp"
#include "core/skinning/columns/skin_plan.hpp"
#include "core/skinning/columns/smooth.hpp"
#include "core/skinning/skin_messages.hpp"

namespace hariko {

using namespace detail;

Result<SkinEdit> make_rails(const Skin& skin) {
  SkinEdit edit{skin, 0, {}, {}, {}};
  edit.skin.frame = FrameMode::two_rail;
  if (skin.second_rail) return accepted(skin, std::move(edit));
  const auto plan = plan_skin(skin);
  if (!plan) return plan.error();
  for (const SkinSection& section : skin.sections)
    if (section.closed || section.size() < 2)
      return make_error(e_rail, "Rails run along the ends of open sections; there are others.",
                        "Open the sections first.", element_of(VertexId{section.points.front().id}));
  const VirtualSurface surface(skin, *plan);
  const int spans = skin.path.spans(), factor = (skin.strip_count() + spans - 1) / spans;
  std::vector<Vector3> first, last;
  std::vector<char> sharp;
  for (int i = 0; i < spans * factor + (skin.path.closed ? 0 : 1); ++i) {
    const double v = double(i) / (spans * factor);
    first.push_back(surface.point(0, v));
    last.push_back(surface.point(1, v));
    sharp.push_back(i % factor == 0 && skin.path.is_sharp(i / factor % skin.path.size()));
  }
  edit.skin.path = curve_through(std::move(first), skin.path.closed, sharp);
  edit.skin.second_rail = curve_through(std::move(last), skin.path.closed, std::move(sharp));
  for (SkinSection& section : edit.skin.sections) {
    section.reference.reset();  // it was on the old path
    for (const auto& [point, rail] : {std::pair(&section.points.front(), &edit.skin.path),
                                      std::pair(&section.points.back(), &*edit.skin.second_rail)}) {
      const Vector3 on_rail = evaluate(*rail, section.v).position;
      edit.deviation = std::max(edit.deviation, (point->position - on_rail).norm());
      point->position = on_rail;
    }
  }
  return accepted(skin, std::move(edit));
}

}  // namespace hariko
