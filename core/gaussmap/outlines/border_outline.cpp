#include "core/gaussmap/outlines/border_outline.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/analysis/curvature.hpp"
#include "core/gaussmap/outlines/resample_loop.hpp"
#include "core/surface/adjacency.hpp"

namespace hariko {
namespace {

using Sides = std::vector<PatchSide>;

Message open_border() {
  return make_error(e_no_border, "The border of the surface does not come round to its beginning.",
                    "Take the outline from an object whose patches meet along whole sides.");
}

/// Joins border sides end to end, each chain from its lowest patch.
Result<std::vector<Sides>> border_chains(const Surface& surface) {
  const Adjacency adjacency(surface);
  const int corners = corner_count(surface.domain());
  const auto end = [&](const PatchSide& side) { return surface.node(side.patch, (side.side + 1) % corners); };
  std::map<Index, PatchSide> from;  // by the node where the side begins
  for (const PatchSide& side : adjacency.boundary()) {
    const bool fresh = from.emplace(surface.node(side.patch, side.side), side).second;
    if (!fresh || !adjacency.seams(side).empty()) return open_border();
  }
  std::vector<Sides> out;
  for (const PatchSide& first : adjacency.boundary()) {
    const Index start = surface.node(first.patch, first.side);
    if (!from.contains(start)) continue;
    Sides chain;
    Index node = start;
    for (auto next = from.find(node); next != from.end(); next = from.find(node)) {
      chain.push_back(next->second);
      node = end(next->second);
      from.erase(next);
    }
    if (node != start) return open_border();
    out.push_back(std::move(chain));
  }
  return out;
}

/// Gaussian curvature of the patch; nothing where it is undefined.
std::optional<double> gauss_at(const Surface& surface, Index patch, const Vector2& parameter) {
  const auto found = curvature(surface.patches().evaluate(patch, parameter, Order::second));
  return found ? std::optional(found->gauss) : std::nullopt;
}

class LoopSampler {
 public:
  LoopSampler(const Surface& surface, const Sides& chain, int density)
      : surface_(surface), chain_(chain), density_(density) {}

  OutlineLoop run() {
    for (std::size_t i = 0; i < chain_.size(); ++i)
      for (int k = 0; k < density_; ++k) add(i, k);
    if (!has_curvature_) loop_.curvature.clear();
    return std::move(loop_);
  }

 private:
  Vector2 parameter(std::size_t side, double fraction) const {
    return side_parameter(surface_.domain(), chain_[side].side, fraction);
  }
  void add(std::size_t i, int k) {
    const Index patch = chain_[i].patch;
    const Vector2 at = parameter(i, grid_fraction(k, density_));
    loop_.points.push_back(surface_.patches().evaluate(patch, at, Order::first).position + surface_.origin());
    loop_.normals.push_back(surface_.normal(patch, at));
    const auto value = k == 0 ? at_corner(i) : gauss_at(surface_, patch, at);
    has_curvature_ = has_curvature_ && value && *value != 0;
    loop_.curvature.push_back(value.value_or(0));
  }
  std::optional<double> at_corner(std::size_t i) const {
    const std::size_t before = (i + chain_.size() - 1) % chain_.size();
    const double step = grid_fraction(1, std::max(2, density_));
    const auto after_value = gauss_at(surface_, chain_[i].patch, parameter(i, step));
    const auto before_value = gauss_at(surface_, chain_[before].patch, parameter(before, 1 - step));
    if (!after_value || !before_value) return {};
    return (*after_value + *before_value) / 2;
  }

  const Surface& surface_;
  const Sides& chain_;
  int density_;
  OutlineLoop loop_;
  bool has_curvature_ = true;
};

}  // namespace

Result<Outline> border_outline(const Surface& surface, BorderSide side, std::size_t least_points) {
  if (surface.patch_count() == 0)
    return make_error(e_no_border, "The object has no surface.",
                      "Choose one that has a surface with a border.");
  auto chains = border_chains(surface);
  if (!chains) return chains.error();
  if (chains->empty())
    return make_error(e_no_border, "The surface is closed: it has no border.",
                      "Delete faces where the border is to be.");
  Outline out;
  bool curved = true;
  for (const Sides& chain : *chains) {
    const auto density = int((std::max<std::size_t>(least_points, 4) + chain.size() - 1) / chain.size());
    OutlineLoop loop = LoopSampler(surface, chain, density).run();
    curved = curved && !loop.curvature.empty();
    out.loops.push_back(side == BorderSide::beyond ? reversed(loop) : std::move(loop));
  }
  if (!curved)
    for (OutlineLoop& loop : out.loops) loop.curvature.clear();
  return out;
}

BorderFill border_fill(OutlineLoop loop) {
  const auto& values = loop.curvature;
  const bool known = !values.empty();
  const bool all_positive = std::all_of(values.begin(), values.end(), [](double value) { return value > 0; });
  const bool all_negative =
      known && std::all_of(values.begin(), values.end(), [](double value) { return value < 0; });
  BorderFill out{{{std::move(loop)}}, new_outline_settings()};
  Outline bare = out.outline;
  bare.loops[0].curvature.clear();
  const std::vector<Message> messages = check_outline(bare, GaussMode::umbilic, CurvatureSign::positive);
  const bool dome = std::none_of(messages.begin(), messages.end(),
                                 [](const Message& message) { return message.code == e_not_convex; });
  if (dome) {
    if (!all_positive) out.outline = bare;
  } else if (all_negative) {
    out.settings.sign = CurvatureSign::negative;
  } else {
    out.settings.mode = GaussMode::position;
  }
  return out;
}

}  // namespace hariko
