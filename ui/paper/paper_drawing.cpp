#include "ui/paper/paper_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/view/navigation.hpp"

namespace hariko {

namespace {

// Paper is white whatever the theme is.
constexpr ImU32 paper_white = IM_COL32(255, 255, 255, 255), paper_shadow = IM_COL32(0, 0, 0, 60),
                margin_grey = IM_COL32(196, 204, 214, 255), facet_fill = IM_COL32(246, 243, 236, 255),
                cut_black = IM_COL32(20, 20, 20, 255), mountain_red = IM_COL32(194, 47, 47, 255),
                valley_blue = IM_COL32(34, 85, 187, 255), tab_grey = IM_COL32(110, 110, 110, 255),
                tab_fill = IM_COL32(232, 232, 228, 255), words = IM_COL32(60, 60, 60, 255),
                hover_blue = IM_COL32(38, 132, 255, 255), wrong_red = IM_COL32(217, 45, 32, 255);
constexpr double dash = 1.6, pause = 1.1;  // mm

struct Pen {
  ImU32 colour;
  double width;  ///< mm
  bool dashed;
};

Pen pen_of(SheetLayer layer) {
  switch (layer) {
    case SheetLayer::fold_mountain:
      return {mountain_red, 0.15, false};
    case SheetLayer::fold_valley:
      return {valley_blue, 0.15, true};
    case SheetLayer::tab:
    case SheetLayer::strip:
      return {tab_grey, 0.15, false};
    case SheetLayer::label:
      return {tab_grey, 0.15, false};
    case SheetLayer::cut:
      break;
  }
  return {cut_black, 0.25, false};
}

class Artist {
 public:
  Artist(ImDrawList& list, const Metrics& metrics, const PaperLayout& layout, const PaperState& state,
         const PageTable& table, const PanelRect& clip)
      : list_(list), metrics_(metrics), layout_(layout), state_(state), table_(table), clip_(clip) {}

  void draw(Index pages) {
    for (Index page = 0; page < pages; ++page) sheet(page);
    const Unfolding& u = layout_.unfolding;
    const Index selected = state_.selected_piece();
    for (Index j = 0; j < u.joints.size(); ++j) joint(j);
    for (const DrawnFacet& each : layout_.drawing.facets) facet(each, each.piece == selected);
    for (const DrawnLine& line : layout_.drawing.lines) stroke(line);
    hovered_edge();
    for (const DrawnText& text : layout_.drawing.texts) write(text);
  }

 private:
  bool visible(const ImVec2& low, const ImVec2& high) const {
    return high.x >= clip_.min.x && low.x <= clip_.max.x && high.y >= clip_.min.y && low.y <= clip_.max.y;
  }
  template <std::size_t N>
  bool visible(const std::array<ImVec2, N>& points) const {
    ImVec2 low = points[0], high = points[0];
    for (const ImVec2& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return visible(low, high);
  }

  void sheet(Index page) {
    const PaperSettings& s = layout_.unfolding.settings;
    const ImVec2 low = table_.to_screen(page, {0, s.page.height}),
                 high = table_.to_screen(page, {s.page.width, 0});
    if (!visible(low, high)) return;
    const float shadow = metrics_.px(3);
    list_.AddRectFilled({low.x + shadow, low.y + shadow}, {high.x + shadow, high.y + shadow}, paper_shadow);
    const bool real = page < layout_.unfolding.page_count;
    list_.AddRectFilled(low, high, real ? paper_white : with_alpha(paper_white, 0.35F));
    if (s.margin > 0)
      list_.AddRect(table_.to_screen(page, {s.margin, s.page.height - s.margin}),
                    table_.to_screen(page, {s.page.width - s.margin, s.margin}), margin_grey);
  }

  void facet(const DrawnFacet& each, bool selected) {
    std::array<ImVec2, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = table_.to_screen(each.page, each.corners[k]);
    if (!visible(p)) return;
    fill3(p, facet_fill);
    const bool off = std::binary_search(layout_.off_page.begin(), layout_.off_page.end(), each.piece);
    if (layout_.overlapping[each.facet]) fill3(p, with_alpha(wrong_red, 0.55F));
    if (off) fill3(p, with_alpha(wrong_red, 0.22F));
    if (selected) fill3(p, with_alpha(hover_blue, 0.16F));
    const FacetGraph& graph = *layout_.unfolding.graph;
    const Index hovered = state_.hovered.facet;
    if (hovered < graph.facet_count() && graph.face(each.facet) == graph.face(hovered) &&
        state_.hovered.joint == no_index)
      fill3(p, with_alpha(hover_blue, 0.28F));
  }
  /// Without ImGui's soft edges, which would show between neighbours.
  void fill3(const std::array<ImVec2, 3>& p, ImU32 colour) {
    const ImDrawListFlags flags = list_.Flags;
    list_.Flags &= ~ImDrawListFlags_AntiAliasedFill;
    list_.AddTriangleFilled(p[0], p[1], p[2], colour);
    list_.Flags = flags;
  }

  void joint(Index j) {
    const auto corners = joint_corners(layout_, j);
    const Index page = joint_page(layout_, j);
    std::array<ImVec2, 4> p;
    for (std::size_t k = 0; k < 4; ++k) p[k] = table_.to_screen(page, corners[k]);
    if (!visible(p)) return;
    list_.AddQuadFilled(p[0], p[1], p[2], p[3], tab_fill);
    if (state_.hovered.joint == j) list_.AddQuadFilled(p[0], p[1], p[2], p[3], with_alpha(hover_blue, 0.5F));
  }

  void stroke(const DrawnLine& line) {
    const Pen pen = pen_of(line.layer);
    const ImVec2 a = table_.to_screen(line.page, line.from), b = table_.to_screen(line.page, line.to);
    if (!visible(std::array{a, b})) return;
    const auto width = static_cast<float>(std::max(double(metrics_.px(1)), pen.width * table_.zoom));
    const double length = std::hypot(double(b.x - a.x), double(b.y - a.y));
    const double period = (dash + pause) * table_.zoom;
    if (!pen.dashed || period < 3 || length > 400 * period) return list_.AddLine(a, b, pen.colour, width);
    const auto at = [&](double distance) {
      const auto t = static_cast<float>(std::min(1.0, distance / length));
      return ImVec2(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y));
    };
    for (double begin = 0; begin < length; begin += period)
      list_.AddLine(at(begin), at(begin + dash * table_.zoom), pen.colour, width);
  }

  /// Both sides of a cut, or the fold.
  void hovered_edge() {
    const Unfolding& u = layout_.unfolding;
    const PaperHover& hover = state_.hovered;
    const Index e = hover.joint < u.joints.size() ? u.joints[hover.joint].edge : hover.edge;
    if (e >= u.graph->edge_count()) return;
    const FacetEdge& edge = u.graph->edge(e);
    for (std::size_t k = 0; k < 2; ++k) {
      if (edge.facets[k] == no_index) continue;
      const FacetCorners& corners = u.corners[edge.facets[k]];
      const Index page = u.page_of(edge.facets[k]);
      list_.AddLine(table_.to_screen(page, as_drawn(layout_, corners[edge.sides[k]])),
                    table_.to_screen(page, as_drawn(layout_, corners[(edge.sides[k] + 1) % 3])), hover_blue,
                    metrics_.px(3));
    }
  }

  void write(const DrawnText& text) {
    const auto size = static_cast<float>(text.height / 0.72 * table_.zoom);
    const ImVec2 middle = table_.to_screen(text.page, text.centre);
    const float reach = size * static_cast<float>(text.text.size());
    if (size < metrics_.px(6) ||
        !visible({middle.x - reach, middle.y - reach}, {middle.x + reach, middle.y + reach}))
      return;
    ImFont* font = ImGui::GetFont();
    const ImVec2 extent = font->CalcTextSizeA(size, 1e9F, 0, text.text.c_str());
    const int first = list_.VtxBuffer.Size;
    list_.AddText(font, size, {middle.x - extent.x / 2, middle.y - extent.y / 2}, words, text.text.c_str());
    const auto c = static_cast<float>(std::cos(text.angle)), s = static_cast<float>(std::sin(text.angle));
    for (int i = first; i < list_.VtxBuffer.Size; ++i) {
      ImVec2& p = list_.VtxBuffer[i].pos;
      const float x = p.x - middle.x, y = p.y - middle.y;
      p = {middle.x + c * x + s * y, middle.y - s * x + c * y};
    }
  }

  ImDrawList& list_;
  const Metrics& metrics_;
  const PaperLayout& layout_;
  const PaperState& state_;
  const PageTable& table_;
  const PanelRect& clip_;
};

}  // namespace

Index PageTable::columns_for(const PaperSize& page, Index pages, double aspect) {
  const double wanted = std::sqrt(pages * aspect * page.height / page.width);
  return std::clamp(static_cast<Index>(std::lround(wanted)), Index{1}, std::max<Index>(1, pages));
}

Vector2 PageTable::upper_left(Index number) const {
  const double column = number % columns, row = number / columns;  // NOLINT: whole rows
  return corner + zoom * Vector2(column * (page.width + gap), row * (page.height + gap));
}

ImVec2 PageTable::to_screen(Index number, const Vector2& p) const {
  const Vector2 at = upper_left(number) + zoom * Vector2(p.x(), page.height - p.y());
  return {static_cast<float>(at.x()), static_cast<float>(at.y())};
}

Vector2 PageTable::to_page(Index number, const Vector2& pixel) const {
  const Vector2 p = (pixel - upper_left(number)) / zoom;
  return {p.x(), page.height - p.y()};
}

Index PageTable::page_near(const Vector2& pixel, Index pages) const {
  Index best = 0;
  double least = 1e300;
  for (Index number = 0; number < pages; ++number) {
    const Vector2 p = to_page(number, pixel);
    const Vector2 inside(std::clamp(p.x(), 0.0, page.width), std::clamp(p.y(), 0.0, page.height));
    const double distance = (p - inside).squaredNorm();
    if (distance < least) best = number, least = distance;
  }
  return best;
}

Vector2 PageTable::size(Index pages) const {
  const Index rows = (std::max<Index>(1, pages) + columns - 1) / columns;
  return {columns * (page.width + gap) - gap, rows * (page.height + gap) - gap};
}

void draw_paper(ImDrawList& list, const Metrics& metrics, const PaperLayout& layout, const PaperState& state,
                const PageTable& table, Index pages, const PanelRect& clip) {
  Artist(list, metrics, layout, state, table, clip).draw(pages);
}

Vector2 as_drawn(const PaperLayout& layout, const Vector2& p) {
  const PaperSettings& s = layout.unfolding.settings;
  return s.inside ? Vector2(s.page.width - p.x(), p.y()) : p;
}

std::array<Vector2, 4> joint_corners(const PaperLayout& layout, Index joint) {
  const auto& tab = layout.unfolding.joints[joint].tab;
  std::array<Vector2, 4> out = tab ? tab->corners : strip_corners(layout.unfolding, joint);
  for (Vector2& corner : out) corner = as_drawn(layout, corner);
  return out;
}

Index joint_page(const PaperLayout& layout, Index joint) {
  const auto& tab = layout.unfolding.joints[joint].tab;
  return tab ? layout.unfolding.page_of(tab->facet) : layout.unfolding.strips[joint].page;
}

PieceBox box_of(const PaperLayout& layout, Index piece) {
  PieceBox out{layout.unfolding.pieces[piece].placement.page, Vector2::Constant(1e300),
               Vector2::Constant(-1e300)};
  const auto extend = [&](const Vector2& p) {
    out.low = out.low.cwiseMin(p);
    out.high = out.high.cwiseMax(p);
  };
  for (const Index facet : layout.unfolding.pieces[piece].facets)
    for (const Vector2& corner : layout.unfolding.corners[facet]) extend(as_drawn(layout, corner));
  return out;
}

namespace {

constexpr double hover_reach = 5;  // design pixels

class PaperLayer final : public ViewLayer {
 public:
  bool hover(const ToolContext& context, const Vector2& pixel) override {
    const PaperSolid* paper = context.scene.paper();
    if (!paper) return false;
    const Editor& editor = context.editor;
    const double reach = hover_reach * editor.pixel_scale * editor.camera().pixel_length(editor.viewport);
    context.editor.paper.hovered = paper_under(*paper, context.projector().ray(pixel), reach);
    here_ = true;
    return true;
  }

  void leave(const ToolContext& context) override {
    if (std::exchange(here_, false)) context.editor.paper.hovered = {};
  }

  std::optional<std::unique_ptr<Tool>> press(const ToolContext& context, const PointerEvent& press) override {
    PaperState& state = context.editor.paper;
    if (!context.scene.paper() || press.button != PointerButton::left || state.hovered.facet == no_index ||
        navigation_of(context.editor, press))
      return {};
    state.selected = state.hovered.facet;
    return std::optional<std::unique_ptr<Tool>>(nullptr);
  }

 private:
  bool here_ = false;  ///< the paper's hovered part is hovered in the views
};

}  // namespace

std::unique_ptr<ViewLayer> make_paper_layer() {
  return std::make_unique<PaperLayer>();
}

}  // namespace hariko
