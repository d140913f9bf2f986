#include "ui/outline/gauss_panel.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/angles.hpp"

namespace hariko {

namespace {

/// Beyond this many sites cells are smaller than their lines are wide.
constexpr Index most_cells = 4000;
constexpr double arc_step = 0.08;  // radians a straight piece

class SphereArtist {
 public:
  SphereArtist(ImDrawList& list, const Metrics& metrics, const GaussView& view, const SpherePlace& place,
               const SphereHighlights& highlights)
      : list_(list), metrics_(metrics), view_(view), place_(place), highlights_(highlights) {}

  void draw() {
    ball();
    for (const bool front : {false, true}) {
      front_ = front;
      if (view_.sphere->mesh && view_.sphere->mesh->site_count() <= most_cells) mesh(*view_.sphere->mesh);
      for (const auto& loop : view_.sphere->loops) image(loop);
      if (view_.sphere->mesh) sites(*view_.sphere->mesh);
      if (highlights_.pointed) cross(*highlights_.pointed);
    }
  }

 private:
  ImU32 faded(ImU32 colour, float alpha) const { return with_alpha(colour, front_ ? alpha : 0.28F * alpha); }
  bool here(const Vector3& direction) const { return (place_.depth(direction) >= 0) == front_; }

  void ball() {
    list_.AddCircleFilled(place_.centre, place_.radius, palette().field, 128);
    for (int axis = 0; axis < 3; ++axis)
      for (const bool front : {false, true}) {
        front_ = front;
        const Vector3 u = Vector3::Unit((axis + 1) % 3), w = Vector3::Unit((axis + 2) % 3);
        Vector3 from = u;
        for (int i = 1; i <= 96; ++i) {
          const double t = 2 * std::numbers::pi * i / 96;
          const Vector3 to = std::cos(t) * u + std::sin(t) * w;
          if (here(from + to))
            list_.AddLine(place_.to_screen(from), place_.to_screen(to), faded(palette().dim_text, 0.22F),
                          metrics_.px(1));
          from = to;
        }
      }
    list_.AddCircle(place_.centre, place_.radius, palette().separator, 128, metrics_.px(1.5F));
  }

  /// The shorter arc between two directions, as far as it lies on the side that is being drawn.
  void arc(const Vector3& a, const Vector3& b, ImU32 colour, float width) {
    const double angle = angle_between(a, b);
    const int pieces = std::clamp(static_cast<int>(std::ceil(angle / arc_step)), 1, 64);
    Vector3 from = a;
    for (int i = 1; i <= pieces; ++i) {
      const double t = double(i) / pieces;
      const Vector3 to =
          i == pieces ? b : Vector3((std::sin((1 - t) * angle) * a + std::sin(t * angle) * b).normalized());
      if (here(from + to))
        list_.AddLine(place_.to_screen(from), place_.to_screen(to), colour, metrics_.px(width));
      from = to;
    }
  }

  /// Cells are star-shaped round their sites.
  void fill(const SphereMesh& mesh, Index site, ImU32 colour) {
    if (!here(mesh.site(site))) return;
    const std::vector<Vector3> cell = mesh.cell(site);
    const ImVec2 middle = place_.to_screen(mesh.site(site));
    for (std::size_t k = 0; k < cell.size(); ++k)
      list_.AddTriangleFilled(middle, place_.to_screen(cell[k]),
                              place_.to_screen(cell[(k + 1) % cell.size()]), colour);
  }

  void mesh(const SphereMesh& mesh) {
    if (const auto newest = view_.newest()) fill(mesh, *newest, faded(palette().good, 0.35F));
    for (const Index site : highlights_.selected)
      if (site < mesh.site_count()) fill(mesh, site, faded(palette().accent, 0.35F));
    if (view_.has(highlights_.hovered)) fill(mesh, *highlights_.hovered, faded(palette().hot, 0.4F));
    if (view_.triangles)
      for (const SphereMesh::Triangle& triangle : mesh.triangles())
        for (std::size_t k = 0; k < 3; ++k) {
          const Index a = triangle[k], b = triangle[(k + 1) % 3];
          const bool loop = mesh.is_boundary(a) && mesh.next(a) == b;
          if (a < b && !loop) arc(mesh.site(a), mesh.site(b), faded(palette().dim_text, 0.45F), 1);
        }
    if (!view_.cells) return;
    for (Index site = 0; site < mesh.site_count(); ++site) {
      // The cell with the smaller number of both sides of an edge draws it.
      const auto& ring = mesh.ring(site);
      const std::size_t count = ring.triangles.size();
      for (std::size_t k = 0; k < ring.neighbours.size(); ++k) {
        const Index other = ring.neighbours[k];
        if (site > other) continue;
        const bool chain = mesh.is_boundary(site);
        const auto middle = [&] { return Vector3((mesh.site(site) + mesh.site(other)).normalized()); };
        const Vector3 from =
            chain && k == 0 ? middle() : mesh.centres()[ring.triangles[(k + count - 1) % count]];
        const Vector3 to = chain && k == count ? middle() : mesh.centres()[ring.triangles[k % count]];
        arc(from, to, faded(palette().secondary, 0.75F), 1.2F);
      }
    }
  }

  void image(const std::vector<Vector3>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i)
      arc(loop[i], loop[(i + 1) % loop.size()], faded(palette().text, 0.9F), 2);
    if (loop.empty()) return;
    // Direction in which the loop runs.
    const Vector3 &a = loop[0], &b = loop[1 % loop.size()];
    const Vector3 middle = (a + b).normalized();
    if (!here(middle)) return;
    const ImVec2 from = place_.to_screen(a), to = place_.to_screen(b), at = place_.to_screen(middle);
    const float x = to.x - from.x, y = to.y - from.y, length = std::hypot(x, y);
    if (length < metrics_.px(3)) return;
    const float s = metrics_.px(6) / length;
    list_.AddTriangleFilled({at.x + s * x, at.y + s * y}, {at.x - s * (x - y) / 2, at.y - s * (y + x) / 2},
                            {at.x - s * (x + y) / 2, at.y - s * (y - x) / 2}, faded(palette().text, 1));
  }

  void sites(const SphereMesh& mesh) {
    const auto newest = view_.newest();
    for (Index i = 0; i < mesh.site_count(); ++i) {
      if (!here(mesh.site(i))) continue;
      const bool hot = highlights_.hovered == i, chosen = highlights_.selected.contains(i);
      const ImU32 colour = hot           ? palette().hot
                           : chosen      ? palette().accent
                           : newest == i ? palette().good
                                         : palette().text;
      const ImVec2 at = place_.to_screen(mesh.site(i));
      const float radius = metrics_.px(hot || chosen || newest == i ? 4.2F
                                       : mesh.is_boundary(i)        ? 2.8F
                                                                    : 2.2F);
      if (mesh.is_boundary(i))
        list_.AddRectFilled({at.x - radius, at.y - radius}, {at.x + radius, at.y + radius}, faded(colour, 1));
      else
        list_.AddCircleFilled(at, radius, faded(colour, 1));
    }
  }

  void cross(const Vector3& direction) {
    if (!here(direction)) return;
    const ImVec2 at = place_.to_screen(direction);
    const float r = metrics_.px(6);
    list_.AddLine({at.x - r, at.y}, {at.x + r, at.y}, faded(palette().hot, 1), metrics_.px(1.6F));
    list_.AddLine({at.x, at.y - r}, {at.x, at.y + r}, faded(palette().hot, 1), metrics_.px(1.6F));
  }

  ImDrawList& list_;
  const Metrics& metrics_;
  const GaussView& view_;
  const SpherePlace& place_;
  const SphereHighlights& highlights_;
  bool front_ = true;
};

}  // namespace

void draw_gauss_sphere(ImDrawList& list, const Metrics& metrics, const GaussView& view,
                       const SpherePlace& place, const SphereHighlights& highlights) {
  SphereArtist(list, metrics, view, place, highlights).draw();
}

std::optional<Index> site_under(const GaussView& view, const SpherePlace& place, ImVec2 pixel, float reach) {
  if (!view.sphere || !view.sphere->mesh) return {};
  std::optional<Index> out;
  float least = reach;
  const std::vector<Vector3>& sites = view.sphere->mesh->sites();
  for (Index i = 0; i < sites.size(); ++i) {
    if (place.depth(sites[i]) < 0) continue;
    const ImVec2 at = place.to_screen(sites[i]);
    const float distance = std::hypot(at.x - pixel.x, at.y - pixel.y);
    if (distance > least) continue;
    least = distance;
    out = i;
  }
  return out;
}

namespace {

constexpr double arrow_pixels = 46;  // design pixels
constexpr std::size_t most_edges = 6000;

class GaussOverlay {
 public:
  GaussOverlay(const Editor& editor, const GaussView& view, const Projector& projector, ImDrawList& list,
               ImVec2 corner, const Metrics& metrics)
      : editor_(editor),
        view_(view),
        transform_(view.object->transform),
        projector_(projector),
        list_(list),
        corner_(corner),
        metrics_(metrics) {}

  void draw() const {
    if (view_.made_step) polyhedron();
    if (const auto newest = view_.newest()) site(*newest, palette().good);
    if (view_.has(view_.selected)) site(*view_.selected, palette().accent);
    if (view_.has(view_.hovered)) site(*view_.hovered, palette().hot);
  }

 private:
  std::optional<ImVec2> at(const Vector3& world) const {
    const auto pixel = projector_.project(world);
    if (!pixel || pixel->head<2>().cwiseAbs().maxCoeff() > 1e5) return {};
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    return ImVec2(corner_.x + static_cast<float>(pixel->x()) / scale.x,
                  corner_.y + static_cast<float>(pixel->y()) / scale.y);
  }
  void line(const Vector3& a, const Vector3& b, ImU32 colour, float width) const {
    const auto from = at(a), to = at(b);
    if (from && to) list_.AddLine(*from, *to, colour, metrics_.px(width));
  }

  /// The control points that there are so far.
  void polyhedron() const {
    const ControlPoints& points = *view_.sphere->points;
    if (points.triangles.size() > most_edges / 3) return;
    const auto world = [&](Index i) { return transform_.apply(points.points[i]); };
    for (const auto& triangle : points.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        line(world(triangle[k]), world(triangle[(k + 1) % 3]), with_alpha(palette().secondary, 0.45F), 1);
    for (Index i = points.boundary_count; i < points.points.size(); ++i)
      if (const auto p = at(world(i))) list_.AddCircleFilled(*p, metrics_.px(2.6F), palette().secondary);
  }

  /// The control point, its normal, and the facet of its tangent plane.
  void site(Index number, ImU32 colour) const {
    const ControlPoints& points = *view_.sphere->points;
    std::vector<ImVec2> facet;
    for (const Vector3& corner : tangent_facet(*view_.sphere, number)) {
      const auto p = at(transform_.apply(corner));
      if (!p) {
        facet.clear();
        break;
      }
      facet.push_back(*p);
    }
    const Vector3 point = transform_.apply(points.points[number]);
    if (const auto middle = at(point); middle && facet.size() >= 3)
      for (std::size_t k = 0; k < facet.size(); ++k)
        list_.AddTriangleFilled(*middle, facet[k], facet[(k + 1) % facet.size()], with_alpha(colour, 0.22F));
    if (facet.size() >= 3)
      list_.AddPolyline(facet.data(), static_cast<int>(facet.size()), with_alpha(colour, 0.9F),
                        ImDrawFlags_Closed, metrics_.px(1.5F));
    const double length = arrow_pixels * editor_.pixel_scale * projector_.pixel_length_at(point);
    line(point, point + length * (transform_.rotation * points.normals[number]), colour, 2.2F);
    if (const auto p = at(point)) {
      list_.AddCircleFilled(*p, metrics_.px(5), with_alpha(palette().window, 0.7F));
      list_.AddCircleFilled(*p, metrics_.px(4), colour);
    }
  }

  const Editor& editor_;
  const GaussView& view_;
  const Similarity& transform_;
  const Projector& projector_;
  ImDrawList& list_;
  ImVec2 corner_;
  const Metrics& metrics_;
};

class GaussLayer final : public ViewLayer {
 public:
  void draw(const ToolContext& context, const LayerPane& pane) override {
    const Editor& editor = context.editor;
    const GaussView& view = editor.gauss;
    if (!view.shown || !view.sphere || !view.sphere->points || !view.object || editor.paper.covers_model())
      return;
    const Object* object = editor.active_object();
    // While a new sphere is being made, the old one belongs to the outline as it was.
    if (!object || object->id != view.object->id || !object->visible) return;
    const ToolOverlay& overlay = pane.overlay;
    GaussOverlay(editor, view, pane.projector, overlay.list, overlay.corner, overlay.metrics).draw();
  }
};

}  // namespace

std::unique_ptr<ViewLayer> make_gauss_layer() {
  return std::make_unique<GaussLayer>();
}

}  // namespace hariko
