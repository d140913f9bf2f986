#include "core/unfolding/pages/sheet_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/unfolding/pages/label_places.hpp"

namespace hariko {

namespace {

using std::numbers::pi;

/// Angle of a text, turned so that it is never upside down.
double upright(double angle) {
  angle = std::remainder(angle, 2 * pi);
  if (angle > pi / 2 + 1e-9) angle -= pi;
  if (angle <= -pi / 2 - 1e-9) angle += pi;
  return angle;
}

class Draftsman {
 public:
  explicit Draftsman(const Unfolding& unfolding) : u_(unfolding), graph_(*unfolding.graph) {
    out_.page = u_.settings.page;
    out_.page_count = u_.page_count;
    out_.scale = u_.settings.scale;
  }

  SheetDrawing draw() {
    for (Index f = 0; f < graph_.facet_count(); ++f)
      out_.facets.push_back({f, u_.piece_of[f], u_.page_of(f), u_.corners[f]});
    for (Index f = 0; f < graph_.face_count(); ++f) face(f);
    for (Index e = 0; e < graph_.edge_count(); ++e) {
      if (u_.folds[e])
        fold(e);
      else if (graph_.edge(e).border())
        cut_side(e, 0);
    }
    for (Index j = 0; j < u_.joints.size(); ++j) joint(j);
    for (Index p = 0; p < u_.pieces.size(); ++p) name(p);
    for (DrawnText& label : place_labels(labels_, out_.texts))
      text(label.page, label.centre, label.angle, label.height, std::move(label.text));
    for (Index page = 0; page < u_.page_count; ++page) furnish(page);
    if (u_.settings.inside) mirror();
    return std::move(out_);
  }

 private:
  struct Side {
    Index facet, page;
    Vector2 from, to;
    Vector2 along() const { return (to - from).normalized(); }
    Vector2 inward() const { return {-along().y(), along().x()}; }
  };
  Side side(Index e, std::size_t k) const {
    const FacetEdge& edge = graph_.edge(e);
    const FacetCorners& corners = u_.corners[edge.facets[k]];
    return {edge.facets[k], u_.page_of(edge.facets[k]), corners[edge.sides[k]],
            corners[(edge.sides[k] + 1) % 3]};
  }
  void line(SheetLayer layer, Index page, const Vector2& from, const Vector2& to) {
    out_.lines.push_back({layer, page, from, to, false});
  }
  void text(Index page, const Vector2& centre, double angle, double height, std::string words) {
    out_.texts.push_back({page, centre, upright(angle), height, std::move(words)});
  }

  void label(const Side& at, double inset, double height, std::string words, std::vector<Vector2> within) {
    labels_.push_back({at.page, at.from, at.to, inset, height, std::move(words), std::move(within)});
  }
  std::vector<Vector2> polygon_of(Index facet) const {
    return {u_.corners[facet].begin(), u_.corners[facet].end()};
  }

  /// Draws a face whole where its facets lie together, otherwise facet by facet.
  void face(Index f) {
    bool whole = true;
    const Index begin = graph_.first_facet(f), end = graph_.first_facet(f + 1);
    for (Index facet = begin; facet < end; ++facet)
      for (Index side = 0; side < 3; ++side) {
        const Index e = graph_.edge_at(facet, side);
        whole = whole && (u_.folds[e] || graph_.neighbour(facet, side) == no_index ||
                          graph_.face(graph_.neighbour(facet, side)) != f);
      }
    const auto add = [&](Index facet, std::vector<Vector2> corners) {
      out_.faces.push_back({f, u_.piece_of[facet], u_.page_of(facet), std::move(corners)});
    };
    if (!whole) {
      for (Index facet = begin; facet < end; ++facet)
        add(facet, {u_.corners[facet].begin(), u_.corners[facet].end()});
      return;
    }
    std::vector<Vector2> corners;
    for (const auto& [facet, corner] : graph_.face_corners(f)) corners.push_back(u_.corners[facet][corner]);
    add(begin, std::move(corners));
  }

  void fold_line(FoldKind kind, Index page, const Vector2& from, const Vector2& to, bool inner) {
    if (kind == FoldKind::flat) return;
    line(kind == FoldKind::mountain ? SheetLayer::fold_mountain : SheetLayer::fold_valley, page, from, to);
    out_.lines.back().inner_fold = inner;
  }

  void fold(Index e) {
    const FacetEdge& edge = graph_.edge(e);
    if (edge.inner) return;
    const Side at = side(e, 0);
    const FoldKind kind = fold_kind(edge.fold_angle, u_.settings);
    out_.folds.push_back({kind,
                          at.page,
                          {graph_.face(edge.facets[0]), graph_.face(edge.facets[1])},
                          at.from,
                          at.to,
                          edge.fold_angle});
    fold_line(kind, at.page, at.from, at.to, true);
    if (!u_.settings.fold_angles || kind == FoldKind::flat) return;
    const double length = (at.to - at.from).norm(), height = label_height(length);
    if (length < 6 * height) return;
    const auto degrees = std::lround(std::abs(edge.fold_angle) * 180 / pi);
    label(at, 0.9 * height, 0.8 * height, std::to_string(degrees), polygon_of(at.facet));
  }

  void cut_side(Index e, std::size_t k) {
    const Side at = side(e, k);
    line(SheetLayer::cut, at.page, at.from, at.to);
  }

  static double label_height(double length) { return std::clamp(0.12 * length, 1.5, 3.0); }
  static double angle_of(const Vector2& v) { return std::atan2(v.y(), v.x()); }

  /// Height of a facet over one of its sides.
  double depth(const Side& at) const {
    double out = 0;
    for (const Vector2& corner : u_.corners[at.facet])
      out = std::max(out, (corner - at.from).dot(at.inward()));
    return out;
  }

  /// Whether a joint carries the number of its run of strips: the middle one does.
  bool has_number(Index j) const {
    if (u_.run_of[j] == no_index) return true;
    const auto& joints = u_.strip_runs[u_.run_of[j]].joints;
    return joints[joints.size() / 2] == j;
  }
  double length_of(Index j) const { return u_.settings.scale * graph_.edge(u_.joints[j].edge).length; }
  double number_length(Index j) const {
    return u_.run_of[j] == no_index ? length_of(j) : u_.strip_runs[u_.run_of[j]].length;
  }
  /// Distance from the centre of a strip to that of its run; 0 unless the whole run lies end to end.
  double to_middle(Index j) const {
    const StripRun& run = u_.strip_runs[u_.run_of[j]];
    double before = 0;
    for (std::size_t k = 0; run.joints[k] != j; ++k) before += length_of(run.joints[k]);
    for (std::size_t k = 0; k + 1 < run.joints.size(); ++k)
      if (!follows(u_, run.joints[k], run.joints[k + 1])) return 0;
    return 0.5 * run.length - before - 0.5 * length_of(j);
  }

  void joint(Index j) {
    const Joint& joint = u_.joints[j];
    const double height = label_height(length_of(j));
    const bool labelled = number_length(j) >= 2 * height && has_number(j);
    const std::string number = std::to_string(numbered_as(u_, j) + 1);
    for (std::size_t k = 0; k < 2; ++k) {
      const Side at = side(joint.edge, k);
      const bool has_tab =
          joint.tab && joint.tab->facet == at.facet && joint.tab->side == graph_.edge(joint.edge).sides[k];
      if (has_tab)
        tab(joint, at);
      else
        line(SheetLayer::cut, at.page, at.from, at.to);
      // In a flat triangle the number is placed where it is still wide.
      const double inset = std::min(0.9 * height, 0.33 * depth(at));
      if (labelled) label(at, inset, height, number, polygon_of(at.facet));
      if (labelled && has_tab) {
        const auto& c = joint.tab->corners;
        label(at, -0.5 * joint.tab->height, std::min(height, 0.7 * joint.tab->height), number,
              {c.begin(), c.end()});
      }
    }
    if (!joint.tab) strip(j, number, label_height(number_length(j)));
  }

  void tab(const Joint& joint, const Side& at) {
    const auto& c = joint.tab->corners;
    fold_line(fold_kind(graph_.edge(joint.edge).fold_angle, u_.settings), at.page, at.from, at.to, false);
    for (std::size_t k = 1; k < 4; ++k) line(SheetLayer::tab, at.page, c[k], c[(k + 1) % 4]);
  }

  void strip(Index j, const std::string& number, double height) {
    const auto c = strip_corners(u_, j);
    const Index page = u_.strips[j].page;
    const auto& run = u_.strip_runs[u_.run_of[j]].joints;
    const std::size_t place = std::size_t(std::find(run.begin(), run.end(), j) - run.begin());
    const bool goes_on = place + 1 < run.size() && follows(u_, j, run[place + 1]),
               went_on = place > 0 && follows(u_, run[place - 1], j);
    line(SheetLayer::strip, page, c[0], c[1]);
    if (!goes_on) line(SheetLayer::strip, page, c[1], c[2]);
    line(SheetLayer::strip, page, c[2], c[3]);
    if (!went_on) line(SheetLayer::strip, page, c[3], c[0]);
    const Vector2 from = 0.5 * (c[3] + c[0]), to = 0.5 * (c[1] + c[2]);
    line(SheetLayer::strip, page, from, to);
    height = std::min(height, 0.3 * u_.settings.strip_width);
    if (number_length(j) < height || (to - from).norm() < height || !has_number(j)) return;
    const Vector2 aside = to_middle(j) * (to - from).normalized();
    for (const std::size_t k : {std::size_t{0}, std::size_t{2}}) {
      const Vector2 a = c[k] + aside, b = c[k + 1] + aside;
      const Side half{no_index, page, a, b};
      const Vector2 inner = 0.5 * (from + to) - 0.5 * (c[k] + c[k + 1]);
      label(half, 0.5 * inner.dot(half.inward()), height, number, {a, b, b + inner, a + inner});
    }
  }

  void name(Index p) {
    Index largest = u_.pieces[p].facets.front();
    for (const Index facet : u_.pieces[p].facets)
      if (graph_.area(facet) > graph_.area(largest)) largest = facet;
    const FacetCorners& c = u_.corners[largest];
    const double a = (c[2] - c[1]).norm(), b = (c[0] - c[2]).norm(), d = (c[1] - c[0]).norm();
    const double radius = 2 * u_.settings.scale * u_.settings.scale * graph_.area(largest) / (a + b + d);
    const Vector2 centre = (a * c[0] + b * c[1] + d * c[2]) / (a + b + d);
    text(u_.page_of(largest), centre, 0, std::clamp(0.5 * radius, 0.8, 6.0), piece_name(p));
  }

  /// Draws the marks, the page number and the scale bar of a page.
  void furnish(Index page) {
    const PaperSettings& s = u_.settings;
    if (s.margin < 4) return;
    const double right = s.page.width - s.margin, top = s.page.height - s.margin;
    for (const double x : {s.margin, right})
      for (const double y : {s.margin, top}) {
        const double dx = x < s.page.width / 2 ? -2 : 2, dy = y < s.page.height / 2 ? -2 : 2;
        line(SheetLayer::label, page, {x, y}, {x + dx, y});
        line(SheetLayer::label, page, {x, y}, {x, y + dy});
      }
    const double y = 0.4 * s.margin;
    text(page, {right - 8, y}, 0, 2.5, std::to_string(page + 1) + " / " + std::to_string(u_.page_count));
    if (s.page.width - 2 * s.margin < 90) return;
    const double left = s.margin + 4;
    line(SheetLayer::label, page, {left, y}, {left + 50, y});
    for (const double x : {left, left + 50}) line(SheetLayer::label, page, {x, y - 1}, {x, y + 1});
    text(page, {left + 59, y}, 0, 2, "50 mm");
  }

  void mirror() {
    const auto flip = [&](Vector2& p) { p.x() = out_.page.width - p.x(); };
    for (DrawnFacet& facet : out_.facets)
      for (Vector2& corner : facet.corners) flip(corner);
    for (DrawnFace& face : out_.faces)
      for (Vector2& corner : face.corners) flip(corner);
    for (DrawnLine& each : out_.lines) {
      flip(each.from);
      flip(each.to);
      if (each.layer == SheetLayer::fold_mountain)
        each.layer = SheetLayer::fold_valley;
      else if (each.layer == SheetLayer::fold_valley)
        each.layer = SheetLayer::fold_mountain;
    }
    for (DrawnFold& each : out_.folds) {
      flip(each.from);
      flip(each.to);
      each.angle = -each.angle;
      if (each.kind != FoldKind::flat)
        each.kind = each.kind == FoldKind::mountain ? FoldKind::valley : FoldKind::mountain;
    }
    for (DrawnText& each : out_.texts) {
      flip(each.centre);
      each.angle = upright(-each.angle);
    }
  }

  const Unfolding& u_;
  const FacetGraph& graph_;
  SheetDrawing out_;
  std::vector<SideLabel> labels_;
};

}  // namespace

std::string_view to_string(SheetLayer layer) {
  constexpr std::string_view names[] = {"cut", "fold-mountain", "fold-valley", "tab", "label", "strip"};
  return names[static_cast<std::size_t>(layer)];
}

FoldKind fold_kind(double angle, const PaperSettings& settings) {
  if (std::abs(angle) < settings.flat_fold) return FoldKind::flat;
  return angle > 0 ? FoldKind::mountain : FoldKind::valley;
}

SheetDrawing draw_sheets(const Unfolding& unfolding) {
  return Draftsman(unfolding).draw();
}

}  // namespace hariko
