#include "core/unfolding/pages/page_packer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <tuple>

#include "core/base/index_list.hpp"
#include "core/unfolding/cuts/best_rotation.hpp"
#include "core/unfolding/cuts/random_sequence.hpp"

namespace hariko {

namespace {

using std::numbers::pi;
constexpr std::size_t looked_back = 12;  ///< pages that are tried before a new one is begun

/// Bitmap by rows, lowest first.
struct Bitmap {
  int width = 0, height = 0, words = 0;
  std::vector<std::uint64_t> bits;

  Bitmap(int w, int h)
      : width(w), height(h), words((w + 63) / 64), bits(std::size_t(words) * std::size_t(h)) {}
  std::uint64_t* row(int y) { return bits.data() + std::size_t(y) * std::size_t(words); }
  const std::uint64_t* row(int y) const { return bits.data() + std::size_t(y) * std::size_t(words); }
  void fill(int y, int from, int to) {
    for (int x = from; x <= to; ++x) row(y)[x / 64] |= std::uint64_t{1} << (x % 64);
  }
};

/// Lengths of the longest runs of equal cells in the rows of a bitmap. An item fits nowhere on a page that
/// has fewer rows with long free runs than the item has rows with covered runs: this test alone rejects most
/// pages.
class RowRuns {
 public:
  RowRuns(const Bitmap& cells, bool covered)
      : covered_(covered), longest_(std::size_t(cells.height)), rows_with_(std::size_t(cells.width) + 2, 0) {
    update(cells, 0, cells.height);
  }
  /// Updates the runs after cells of the rows from .. to - 1 have changed.
  void update(const Bitmap& cells, int from, int to) {
    for (int y = from; y < to; ++y) longest_[std::size_t(y)] = longest(cells, y);
    std::fill(rows_with_.begin(), rows_with_.end(), 0);
    for (const int length : longest_) ++rows_with_[std::size_t(length)];
    for (std::size_t length = rows_with_.size() - 1; length-- > 0;)
      rows_with_[length] += rows_with_[length + 1];
  }
  int operator[](int row) const { return longest_[std::size_t(row)]; }
  bool has_room_for(const RowRuns& item) const {
    for (std::size_t length = 1; length < item.rows_with_.size() && item.rows_with_[length] > 0; ++length)
      if (length >= rows_with_.size() || item.rows_with_[length] > rows_with_[length]) return false;
    return true;
  }

 private:
  int longest(const Bitmap& cells, int y) const {
    int best = 0, run = 0;
    for (int x = 0; x < cells.width; ++x) {
      const bool set = (cells.row(y)[x / 64] >> (x % 64)) & 1;
      run = set == covered_ ? run + 1 : 0;
      best = std::max(best, run);
    }
    return best;
  }
  bool covered_;
  std::vector<int> longest_;
  std::vector<int> rows_with_;  ///< [n]: number of rows with a run of at least n cells
};

struct Page {
  Bitmap cells;
  RowRuns free;
  Page(int width, int height) : cells(width, height), free(cells, false) {}
};

struct ItemBox {
  Vector2 low = Vector2::Constant(1e300), high = Vector2::Constant(-1e300);
  void add(const Vector2& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
};

/// Rotated item: its cells, and its box when rotated about its own origin.
struct Turned {
  double angle;
  Vector2 low;  ///< lower left corner of the box; lies half a gap inside cell (0, 0)
  PaperSize size;
  Bitmap cells;
  RowRuns runs;
  std::vector<int> rows;  ///< in the order of comparison: rows with most cells first
};

/// Interval in x of the convex polygon between two heights; nothing where it is empty.
std::optional<std::pair<double, double>> span_between(const std::vector<Vector2>& polygon, double low,
                                                      double high) {
  double from = 1e300, to = -1e300;
  const auto add = [&](double x) {
    from = std::min(from, x);
    to = std::max(to, x);
  };
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if (a.y() >= low && a.y() <= high) add(a.x());
    for (const double y : {low, high})
      if ((a.y() < y) != (b.y() < y)) add(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
  }
  if (from > to) return {};
  return std::pair(from, to);
}

class Packer {
 public:
  Packer(const std::vector<PackItem>& items, const PackOptions& options)
      : items_(items),
        room_{options.page.width - 2 * options.margin, options.page.height - 2 * options.margin},
        options_(options),
        columns_(cell_count(room_.width)),
        rows_(cell_count(room_.height)),
        // Cells over the room plus half a gap all round, so that a box as large as the room fits.
        cell_((room_.width + options.gap) / columns_, (room_.height + options.gap) / rows_) {
    for (std::size_t k = 0; k < items.size(); ++k) turned_.push_back(turns_of(items[k]));
  }

  Packing pack(const std::vector<Index>& order, const CancelToken& cancel) {
    Packing out;
    out.placements.resize(items_.size());
    pages_.clear();
    reached_.clear();
    for (const SheetPolygon& polygon : options_.occupied) block(polygon);
    for (Page& page : pages_) page.free.update(page.cells, 0, page.cells.height);
    std::vector<Index> alone;
    for (const Index item : order) {
      if (cancel.cancelled()) return out;
      if (turned_[item].empty())
        alone.push_back(item);
      else
        out.placements[item] = place(item);
    }
    for (const Index item : alone) {
      out.too_large.push_back(item);
      out.placements[item] = centred(item, static_cast<Index>(pages_.size() + out.too_large.size() - 1));
    }
    std::sort(out.too_large.begin(), out.too_large.end());
    out.page_count = static_cast<Index>(pages_.size() + out.too_large.size());
    return out;
  }

  /// Items by covered area, largest first.
  std::vector<Index> by_size() const {
    std::vector<double> size(items_.size(), 0);
    for (std::size_t k = 0; k < items_.size(); ++k) size[k] = area_of(items_[k]);
    return stable_order(items_.size(), [&](Index a, Index b) { return size[a] > size[b]; });
  }

 private:
  int cell_count(double length) const {
    return std::max(1, static_cast<int>(std::ceil(180 * length / std::max(room_.width, room_.height))));
  }
  static double area_of(const PackItem& item) {
    double sum = 0;
    for (const SheetPolygon& polygon : item.polygons)
      for (std::size_t k = 0; k < polygon.size; ++k) {
        const Vector2 &a = polygon.corners[k], &b = polygon.corners[(k + 1) % polygon.size];
        sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
      }
    return sum;
  }

  /// Direction of the item's greatest extent, by its second moments.
  static double principal_angle(const PackItem& item) {
    Vector2 mean = Vector2::Zero();
    double count = 0, xx = 0, xy = 0, yy = 0;
    for (const SheetPolygon& polygon : item.polygons)
      for (const Vector2& p : polygon.span()) mean += p, ++count;
    mean /= count;
    for (const SheetPolygon& polygon : item.polygons)
      for (const Vector2& p : polygon.span()) {
        const Vector2 d = p - mean;
        xx += d.x() * d.x(), xy += d.x() * d.y(), yy += d.y() * d.y();
      }
    return 0.5 * std::atan2(2 * xy, xx - yy);
  }

  std::vector<Turned> turns_of(const PackItem& item) const {
    std::vector<double> angles;
    if (item.turns) {
      const double principal = principal_angle(item);
      for (int k = 0; k < 16; ++k) angles.push_back(k * pi / 8 - principal);
      angles.push_back(0);
      angles.push_back(pi / 2);
    } else {
      angles = {0, pi / 2};
    }
    std::vector<Turned> out;
    for (const double angle : angles)
      if (auto turned = turn(item, angle)) out.push_back(std::move(*turned));
    if (!out.empty()) return out;
    std::vector<Vector2> points;
    for (const SheetPolygon& polygon : item.polygons)
      points.insert(points.end(), polygon.span().begin(), polygon.span().end());
    if (auto turned = turn(item, best_turn(points, room_).angle)) out.push_back(std::move(*turned));
    return out;
  }

  std::optional<Turned> turn(const PackItem& item, double angle) const {
    const PiecePlacement rotation{0, angle, Vector2::Zero()};
    std::vector<std::vector<Vector2>> polygons;
    ItemBox box;
    for (const SheetPolygon& polygon : item.polygons) {
      polygons.emplace_back();
      for (const Vector2& p : polygon.span()) {
        polygons.back().push_back(rotation.apply(p));
        box.add(polygons.back().back());
      }
    }
    const PaperSize size{box.high.x() - box.low.x(), box.high.y() - box.low.y()};
    const int width = static_cast<int>(std::ceil((size.width + options_.gap) / cell_.x() - 1e-6));
    const int height = static_cast<int>(std::ceil((size.height + options_.gap) / cell_.y() - 1e-6));
    if (width > columns_ || height > rows_) return {};
    Bitmap cells(std::max(1, width), std::max(1, height));
    const double half = options_.gap / 2;
    for (auto& polygon : polygons) {
      for (Vector2& p : polygon) p += Vector2::Constant(half) - box.low;
      mark(cells, polygon, half);
    }
    const RowRuns runs(cells, true);
    Turned out{angle, box.low, size, std::move(cells), runs, {}};
    std::vector<int> count(static_cast<std::size_t>(out.cells.height), 0);
    for (int y = 0; y < out.cells.height; ++y)
      for (int w = 0; w < out.cells.words; ++w)
        count[static_cast<std::size_t>(y)] += __builtin_popcountll(out.cells.row(y)[w]);
    out.rows.resize(count.size());
    std::iota(out.rows.begin(), out.rows.end(), 0);
    std::stable_sort(out.rows.begin(), out.rows.end(), [&](int a, int b) {
      return count[static_cast<std::size_t>(a)] > count[static_cast<std::size_t>(b)];
    });
    return out;
  }

  /// Marks every cell that the polygon is nearer to than `reach`, and some more.
  void mark(Bitmap& cells, const std::vector<Vector2>& polygon, double reach) const {
    ItemBox box;
    for (const Vector2& p : polygon) box.add(p);
    const auto column = [&](double x) {
      return std::clamp(static_cast<int>(std::floor(x / cell_.x())), 0, cells.width - 1);
    };
    const auto row = [&](double y) {
      return std::clamp(static_cast<int>(std::floor(y / cell_.y())), 0, cells.height - 1);
    };
    for (int y = row(box.low.y() - reach); y <= row(box.high.y() + reach); ++y)
      if (const auto span = span_between(polygon, y * cell_.y() - reach, (y + 1) * cell_.y() + reach))
        cells.fill(y, column(span->first - reach), column(span->second + reach));
  }

  static bool free_at(const Bitmap& page, const Turned& item, int x, int y) {
    const int shift = x % 64, first = x / 64;
    for (const int row : item.rows) {
      const std::uint64_t* own = item.cells.row(row);
      const std::uint64_t* there = page.row(y + row);
      for (int w = 0; w < item.cells.words; ++w) {
        if (there[first + w] & (own[w] << shift)) return false;
        if (shift && first + w + 1 < page.words && (there[first + w + 1] & (own[w] >> (64 - shift))))
          return false;
      }
    }
    return true;
  }

  static void occupy(Page& on, const Turned& item, int x, int y) {
    Bitmap& page = on.cells;
    const int shift = x % 64, first = x / 64;
    for (int row = 0; row < item.cells.height; ++row)
      for (int w = 0; w < item.cells.words; ++w) {
        const std::uint64_t own = item.cells.row(row)[w];
        page.row(y + row)[first + w] |= own << shift;
        if (shift && first + w + 1 < page.words) page.row(y + row)[first + w + 1] |= own >> (64 - shift);
      }
    on.free.update(page, y, y + item.cells.height);
  }

  /// Marks the cells of a polygon that is already on a page.
  void block(const SheetPolygon& polygon) {
    while (pages_.size() <= polygon.sheet) pages_.emplace_back(columns_, rows_);
    const double half = options_.gap / 2;
    std::vector<Vector2> corners;
    ItemBox box;
    for (const Vector2& p : polygon.span()) {
      corners.push_back(p + Vector2::Constant(half - options_.margin));
      box.add(corners.back());
    }
    const Vector2 end(columns_ * cell_.x(), rows_ * cell_.y());
    if (box.high.x() + half < 0 || box.high.y() + half < 0 || box.low.x() - half > end.x() ||
        box.low.y() - half > end.y())
      return;
    mark(pages_[polygon.sheet].cells, corners, half);
  }

  struct Spot {
    int x, y;
  };

  /// Lowest free place, then leftmost, whose top does not exceed `limit`.
  static std::optional<Spot> find_spot(const Page& on, const Turned& item, int limit, Spot from) {
    const Bitmap& page = on.cells;
    const int top = std::min(limit, page.height) - item.cells.height;
    if (from.y > top || !on.free.has_room_for(item.runs)) return {};
    const auto has_room_at = [&](int y) {
      return std::all_of(item.rows.begin(), item.rows.end(),
                         [&](int row) { return on.free[y + row] >= item.runs[row]; });
    };
    for (int y = from.y; y <= top; ++y) {
      if (!has_room_at(y)) continue;
      for (int x = y == from.y ? from.x : 0; x + item.cells.width <= page.width; ++x)
        if (free_at(page, item, x, y)) return Spot{x, y};
    }
    return {};
  }

  PiecePlacement place(Index item) {
    // Older pages were tried for many items already.
    for (std::size_t page = pages_.size() > looked_back ? pages_.size() - looked_back : 0;; ++page) {
      if (page == pages_.size()) pages_.emplace_back(columns_, rows_);
      const Turned* best = nullptr;
      Spot spot{};
      int best_top = rows_ + 1;
      for (const Turned& turned : turned_[item]) {
        // Among equal small items, a place that had no room for one has none for the next.
        Spot& reached = reached_[std::tuple(page, turned.cells.width, turned.cells.height)];
        const bool remember = !items_[item].turns;
        const auto found = find_spot(pages_[page], turned, best_top - 1, remember ? reached : Spot{0, 0});
        if (!found) {
          if (remember && best_top > rows_) reached = {0, rows_};
          continue;
        }
        if (remember) reached = *found;
        best = &turned;
        spot = *found;
        best_top = spot.y + turned.cells.height;
      }
      if (!best) continue;
      occupy(pages_[page], *best, spot.x, spot.y);
      PiecePlacement out{static_cast<Index>(page), best->angle, -best->low};
      // Cell (0, 0) begins half a gap before the margin.
      out.offset += Vector2(spot.x * cell_.x() + options_.margin, spot.y * cell_.y() + options_.margin);
      return out;
    }
  }

  PiecePlacement centred(Index item, Index page) const {
    ItemBox box;
    for (const SheetPolygon& polygon : items_[item].polygons)
      for (const Vector2& p : polygon.span()) box.add(p);
    const Vector2 centre(0.5 * options_.page.width, 0.5 * options_.page.height);
    return {page, 0, centre - 0.5 * (box.low + box.high)};
  }

  const std::vector<PackItem>& items_;
  PaperSize room_;
  PackOptions options_;
  int columns_, rows_;
  Vector2 cell_;  ///< width and height of a cell
  std::vector<std::vector<Turned>> turned_;
  std::vector<Page> pages_;
  std::map<std::tuple<std::size_t, int, int>, Spot> reached_;  ///< by page and size of a strip
};

}  // namespace

Packing pack_pages(const std::vector<PackItem>& items, const PackOptions& options,
                   const CancelToken& cancel) {
  if (items.empty()) return {};
  Packer packer(items, options);
  const std::vector<Index> order = packer.by_size();
  Packing best = packer.pack(order, cancel);
  RandomSequence random(1);
  for (int k = 1; k < options.tries && best.page_count > 1 && !cancel.cancelled(); ++k) {
    // Perturbs the order of size: neighbours change places, now and then distant ones.
    std::vector<double> rank(order.size());
    for (std::size_t i = 0; i < rank.size(); ++i)
      rank[i] = double(i) + (0.1 + 0.1 * (k % 4)) * double(rank.size()) * random.unit();
    const auto by_rank = [&](Index a, Index b) { return rank[a] < rank[b]; };
    std::vector<Index> shuffled;
    for (const Index place : stable_order(order.size(), by_rank)) shuffled.push_back(order[place]);
    Packing next = packer.pack(shuffled, cancel);
    if (next.page_count < best.page_count) best = std::move(next);
  }
  return best;
}

}  // namespace hariko
