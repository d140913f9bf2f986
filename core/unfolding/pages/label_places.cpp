#include "core/unfolding/pages/label_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include "core/unfolding/cuts/convex_overlap.hpp"

namespace hariko {

namespace {

/// Width of digits and height of lines, relative to the height of capitals; a little more than in the
/// writers' fonts.
constexpr double digit_width = 0.85, line_height = 1.25;
constexpr double cell = 8;  ///< mm

/// Occupied boxes, hashed by the cells of the pages that they touch.
class TakenBoxes {
 public:
  bool free(Index page, const std::array<Vector2, 4>& box) const {
    bool out = true;
    each_cell(page, box, [&](const Key& key) {
      const auto found = cells_.find(key);
      if (found == cells_.end()) return;
      for (const std::size_t other : found->second) out = out && !overlaps(box, boxes_[other], 0);
    });
    return out;
  }
  void add(Index page, const std::array<Vector2, 4>& box) {
    boxes_.push_back(box);
    each_cell(page, box, [&](const Key& key) { cells_[key].push_back(boxes_.size() - 1); });
  }

 private:
  using Key = std::tuple<Index, int, int>;
  template <class Visit>
  static void each_cell(Index page, const std::array<Vector2, 4>& box, const Visit& visit) {
    Vector2 low = box[0], high = box[0];
    for (const Vector2& p : box) low = low.cwiseMin(p), high = high.cwiseMax(p);
    for (int x = int(std::floor(low.x() / cell)); x <= int(std::floor(high.x() / cell)); ++x)
      for (int y = int(std::floor(low.y() / cell)); y <= int(std::floor(high.y() / cell)); ++y)
        visit(Key{page, x, y});
  }

  std::vector<std::array<Vector2, 4>> boxes_;
  std::map<Key, std::vector<std::size_t>> cells_;
};

bool inside(const std::array<Vector2, 4>& box, const std::vector<Vector2>& polygon) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2 &a = polygon[k], side = polygon[(k + 1) % polygon.size()] - a;
    for (const Vector2& p : box)
      if (side.x() * (p - a).y() - side.y() * (p - a).x() < -1e-9) return false;
  }
  return true;
}

DrawnText placed(const SideLabel& label, double along, double share) {
  const Vector2 way = label.to - label.from, unit = way.normalized(), left(-unit.y(), unit.x());
  DrawnText text;
  text.page = label.page;
  text.height = share * label.height;
  // Smaller numbers are closer to their side.
  text.centre = label.from + along * way + share * label.inset * left;
  text.angle = std::atan2(unit.y(), unit.x());
  text.text = label.text;
  return text;
}

std::optional<DrawnText> free_place(const SideLabel& label, const TakenBoxes& taken) {
  // Tries places from the middle towards both ends, alternating.
  constexpr int steps = 8;
  constexpr double least_share = 1.0 / 3, shrinking = 0.85;
  for (const bool keeps_within : {true, false})
    for (double share = 1; share >= least_share; share *= shrinking)
      for (int k = 0; k <= 2 * steps; ++k) {
        const double along = 0.5 + (k % 2 == 0 ? 0.5 : -0.5) * double((k + 1) / 2) / (steps + 1);
        const DrawnText text = placed(label, along, share);
        const auto box = box_of(text);
        if ((!keeps_within || inside(box, label.within)) && taken.free(label.page, box)) return text;
      }
  return {};
}

}  // namespace

std::array<Vector2, 4> box_of(const DrawnText& text) {
  const Vector2 along(std::cos(text.angle), std::sin(text.angle)), up(-along.y(), along.x());
  const Vector2 x =
      0.5 * digit_width * text.height * double(std::max<std::size_t>(1, text.text.size())) * along;
  const Vector2 y = 0.5 * line_height * text.height * up;
  return {text.centre - x - y, text.centre + x - y, text.centre + x + y, text.centre - x + y};
}

std::vector<DrawnText> place_labels(const std::vector<SideLabel>& labels,
                                    const std::vector<DrawnText>& taken) {
  TakenBoxes boxes;
  for (const DrawnText& text : taken) boxes.add(text.page, box_of(text));
  std::vector<std::size_t> order(labels.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return (labels[a].to - labels[a].from).squaredNorm() < (labels[b].to - labels[b].from).squaredNorm();
  });
  std::vector<DrawnText> out(labels.size());
  for (const std::size_t i : order) {
    out[i] = free_place(labels[i], boxes).value_or(placed(labels[i], 0.5, 1));
    boxes.add(out[i].page, box_of(out[i]));
  }
  return out;
}

}  // namespace hariko
