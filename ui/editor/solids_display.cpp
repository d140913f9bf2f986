#include "ui/editor/solids_display.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/document/edits/edit_solids.hpp"
#include "core/document/object_box.hpp"
#include "core/envelope/scene_symmetry.hpp"
#include "core/geometry/tolerant_hull.hpp"
#include "ui/base/language.hpp"
#include "ui/editor/editor.hpp"
#include "ui/editor/object_kind.hpp"

namespace hariko {

namespace {

constexpr int round_sides = 32;  ///< sides of circles
constexpr int quarter = round_sides / 4;
constexpr int tube_sides = 16;

/// Appends the solids one after the other.
class DisplayBuilder {
 public:
  explicit DisplayBuilder(const Vector3& origin) : out_(std::make_shared<DisplayPolyhedron>()) {
    out_->origin = origin;
  }

  void add(const Solid& solid) {
    solid_ = &solid;
    turn_ = solid_rotation(solid.rotation);
    switch (solid.kind) {
      case SolidKind::box:
        return add_box();
      case SolidKind::sphere:
        return add_ball(0);
      case SolidKind::capsule:
        return add_ball(0.5 * solid.length);
      case SolidKind::cylinder:
        return add_prism(round_sides, quarter);
      case SolidKind::prism:
        return add_prism(int(solid.sides), 1);
      case SolidKind::cone:
        return add_pyramid(round_sides, quarter);
      case SolidKind::pyramid:
        return add_pyramid(int(solid.sides), 1);
      case SolidKind::torus:
        return add_torus();
      case SolidKind::polyhedron:
        return add_hull();
    }
  }

  std::shared_ptr<const DisplayPolyhedron> finish() {
    out_->edge_kinds.assign(out_->edges.size(), EdgeKind::plain);
    return std::move(out_);
  }

 private:
  Index point(const Vector3& local) {
    const Vector3 at = solid_->position + turn_ * solid_->scale.cwiseProduct(local) - out_->origin;
    out_->positions.push_back({float(at.x()), float(at.y()), float(at.z())});
    out_->vertex_ids.push_back({solid_->id});
    out_->box.extend(at);
    return Index(out_->positions.size() - 1);
  }
  void face(std::initializer_list<Index> corners) { face(std::vector<Index>(corners)); }
  void face(const std::vector<Index>& corners) {
    out_->face_vertices.insert(out_->face_vertices.end(), corners.begin(), corners.end());
    out_->face_offsets.push_back(Index(out_->face_vertices.size()));
    out_->face_ids.push_back({solid_->id});
  }
  void edge(Index a, Index b) { out_->edges.push_back({a, b}); }
  void closed(const std::vector<Index>& loop) {
    for (std::size_t k = 0; k < loop.size(); ++k) edge(loop[k], loop[(k + 1) % loop.size()]);
  }

  std::vector<Index> ring(int count, double radius, double z) {
    std::vector<Index> out;
    for (int k = 0; k < count; ++k) {
      const double a = 2 * std::numbers::pi * k / count;
      out.push_back(point({radius * std::cos(a), radius * std::sin(a), z}));
    }
    return out;
  }
  /// Quads between two rings of the same number of points.
  void band(const std::vector<Index>& low, const std::vector<Index>& high) {
    for (std::size_t k = 0; k < low.size(); ++k) {
      const std::size_t next = (k + 1) % low.size();
      face({low[k], low[next], high[next], high[k]});
    }
  }

  void add_box() {
    const Vector3 h = 0.5 * solid_->size;
    std::vector<Index> low, high;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      low.push_back(point({x * h.x(), y * h.y(), -h.z()}));
      high.push_back(point({x * h.x(), y * h.y(), h.z()}));
    }
    close(low, high, 1);
  }
  void add_prism(int sides, int step) {
    const auto low = ring(sides, solid_->radius, -0.5 * solid_->height);
    close(low, ring(sides, solid_->radius, 0.5 * solid_->height), step);
  }
  /// Bottom, top and sides; every `step`-th line along the side.
  void close(const std::vector<Index>& low, const std::vector<Index>& high, int step) {
    band(low, high);
    face(high);
    face(std::vector<Index>(low.rbegin(), low.rend()));
    closed(low);
    closed(high);
    for (std::size_t k = 0; k < low.size(); k += std::size_t(step)) edge(low[k], high[k]);
  }
  /// The centroid, a quarter of the height above the base, is the solid's place.
  void add_pyramid(int sides, int step) {
    const auto low = ring(sides, solid_->radius, -0.25 * solid_->height);
    const Index apex = point({0, 0, 0.75 * solid_->height});
    for (std::size_t k = 0; k < low.size(); ++k) {
      face({low[k], low[(k + 1) % low.size()], apex});
      if (k % std::size_t(step) == 0) edge(low[k], apex);
    }
    face(std::vector<Index>(low.rbegin(), low.rend()));
    closed(low);
  }
  /// A ball, its halves moved apart along z.
  void add_ball(double apart) {
    const double r = solid_->radius;
    std::vector<std::vector<Index>> rings;
    for (int k = 1; k <= 2 * quarter - 1; ++k) {
      const double a = std::numbers::pi * (double(k) / (2 * quarter) - 0.5);
      const auto add_ring = [&](double shift) {
        rings.push_back(ring(round_sides, r * std::cos(a), r * std::sin(a) + shift));
      };
      if (k == quarter) {
        add_ring(-apart);
        closed(rings.back());
        if (apart == 0) continue;
        add_ring(apart);
        closed(rings.back());
      } else {
        add_ring(k < quarter ? -apart : apart);
      }
    }
    const Index south = point({0, 0, -r - apart}), north = point({0, 0, r + apart});
    for (std::size_t k = 0; k + 1 < rings.size(); ++k) band(rings[k], rings[k + 1]);
    for (std::size_t k = 0; k < rings[0].size(); ++k) {
      const std::size_t next = (k + 1) % rings[0].size();
      face({rings.front()[next], rings.front()[k], south});
      face({rings.back()[k], rings.back()[next], north});
      if (k % quarter != 0) continue;
      edge(south, rings.front()[k]);
      edge(rings.back()[k], north);
      for (std::size_t j = 0; j + 1 < rings.size(); ++j) edge(rings[j][k], rings[j + 1][k]);
    }
  }
  void add_torus() {
    std::vector<std::vector<Index>> rings;
    for (int k = 0; k < tube_sides; ++k) {
      const double a = 2 * std::numbers::pi * k / tube_sides;
      rings.push_back(
          ring(round_sides, solid_->radius + solid_->tube * std::cos(a), solid_->tube * std::sin(a)));
      if (k % (tube_sides / 4) == 0) closed(rings.back());
    }
    for (std::size_t k = 0; k < rings.size(); ++k) {
      const auto& next = rings[(k + 1) % rings.size()];
      band(rings[k], next);
      for (std::size_t i = 0; i < rings[k].size(); i += quarter) edge(rings[k][i], next[i]);
    }
  }
  void add_hull() {
    Vector3 low = solid_->points[0], high = low;
    for (const Vector3& p : solid_->points) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const TolerantHull hull = tolerant_hull(solid_->points, 1e-9 * (high - low).norm());
    std::vector<Index> number(solid_->points.size(), no_index);
    for (const Index v : hull.vertices) number[v] = point(solid_->points[v]);
    for (const auto& t : hull.triangles) {
      face({number[t[0]], number[t[1]], number[t[2]]});
      for (std::size_t i = 0; i < 3; ++i)
        if (t[i] < t[(i + 1) % 3]) edge(number[t[i]], number[t[(i + 1) % 3]]);
    }
  }

  std::shared_ptr<DisplayPolyhedron> out_;
  const Solid* solid_ = nullptr;
  Matrix3 turn_ = Matrix3::Identity();
};

}  // namespace

std::shared_ptr<const DisplayPolyhedron> display_of(const SolidsSource& source) {
  const auto& solids = source.input->solids;
  Eigen::AlignedBox3d box;
  const std::vector<Solid> images = images_of(*source.input);
  for (const Solid& solid : solids) box.extend(box_of(solid));
  for (const Solid& solid : images) box.extend(box_of(solid));
  DisplayBuilder builder(box.isEmpty() ? Vector3(Vector3::Zero()) : Vector3(box.center()));
  std::vector<const Solid*> ordered;
  for (const Solid& solid : solids) ordered.push_back(&solid);
  for (const Solid& solid : images) ordered.push_back(&solid);
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const Solid* a, const Solid* b) { return a->id < b->id; });
  for (const Solid* solid : ordered) builder.add(*solid);
  return builder.finish();
}

Highlights highlights_of_solids(const DisplayPolyhedron& display, const std::set<VertexId>& ids) {
  Highlights out;
  if (ids.empty()) return out;
  for (Index e = 0; e < display.edges.size(); ++e)
    if (ids.contains(display.vertex_ids[display.edges[e][0]])) out.edges.push_back(e);
  for (Index f = 0; f < display.face_count(); ++f)
    if (ids.contains(VertexId{display.face_ids[f].value})) out.faces.push_back(f);
  return out;
}

// The kind of objects made of solids, each selected as a vertex with its id.

namespace {

class SolidsKind final : public ObjectKind {
 public:
  ElementSelection all(const Object& object, ElementMode) const override {
    ElementSelection all;
    for (const Solid& solid : object.solids()->input->solids) all.vertices.insert(VertexId{solid.id});
    return all;
  }

  ElementSelection converted(const Object&, const ElementSelection& selection, ElementMode,
                             ElementMode) const override {
    return selection;
  }

  std::string describe(const ElementSelection& selection, const Language& tr) const override {
    const std::size_t count = selection.vertices.size();
    if (count == 0) return ObjectKind::describe(selection, tr);
    return tr.counted(count, "1 solid", "{0} solids");
  }

  std::string title(const Element& element, const Language& tr) const override {
    return fill(tr("Solid {0}"), {std::to_string(element.id)});
  }

  std::optional<Vector3> place(const Object& object, const Element& element) const override {
    const Solid* solid = find_solid(object, static_cast<std::uint32_t>(element.id));
    return solid ? std::optional<Vector3>(solid->position) : std::nullopt;
  }

  std::vector<Vector3> extent(const Object& object, const ElementSelection& selection) const override {
    std::vector<Vector3> out;
    for (const VertexId id : selection.vertices)
      if (const Solid* solid = find_solid(object, id.value))
        for (int corner = 0; corner < 8; ++corner)
          out.push_back(box_of(*solid).corner(static_cast<Box3::CornerType>(corner)));
    return out;
  }

  ObjectLines lines(const Document&, const Object& object, const Object* before,
                    const ObjectLines& drawn) const override {
    const SolidsSource* old = before ? before->solids() : nullptr;
    if (old && *old == *object.solids()) return drawn;
    return {display_of(*object.solids()), {}};
  }

  Highlights highlights(const Object&, const ElementSelection& selection,
                        const DisplayPolyhedron& lines) const override {
    return highlights_of_solids(lines, selection.vertices);
  }

  const char* why_not_linked() const override {
    return translatable("Solids are not connected with each other. Shift+click takes one more.");
  }

  ElementsShown elements_shown() const override { return ElementsShown::bodies; }

  std::vector<ObjectBody> bodies(const Object& object) const override {
    std::vector<ObjectBody> out;
    for (const Solid& solid : object.solids()->input->solids)
      out.push_back(
          {element_of(VertexId{solid.id}), display_of(SolidsSource{EnvelopeInput{{solid}, {}}, {}})});
    return out;
  }

  /// They lie inside of their surface.
  void adjust(const Object& object, const ViewSettings& view, SceneObject& shown) const override {
    if (view.surfaces_only) return;
    shown.x_ray = true;
    shown.show_points = false;
    shown.show_bodies = view.bodies && shown.show_polyhedron;
    shown.faint_bodies = object.locked;
  }

  void adjust_in_file(const Object&, SceneObject& shown, std::vector<OverlayLine>&) const override {
    shown.show_network = shown.show_points = false;
    shown.show_polyhedron = shown.show_bodies = shown.x_ray = true;
  }

  /// The plane of symmetry as a frame round the solids, in the colour of its axis.
  std::vector<OverlayLine> guides(const Object& object) const override {
    std::vector<OverlayLine> out;
    if (!object.visible || !object.display.polyhedron) return out;
    const SymmetryPlane plane = object.solids()->input->settings.symmetry;
    if (plane == SymmetryPlane::none) return out;
    Object straight = object;
    straight.transform = Similarity{};
    const Box3 box = box_at_own_place(straight);
    if (box.isEmpty()) return out;
    const auto axis = static_cast<Eigen::Index>(plane) - 1, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double margin = 0.08 * box.sizes().maxCoeff();
    Color color = color_from_hex(std::array{"#e5484d", "#46a758", "#3e82f7"}[static_cast<std::size_t>(axis)]);
    color.a = 0.8F;
    const auto corner = [&](bool far_u, bool far_v) {
      Vector3 at = Vector3::Zero();
      at[u] = far_u ? box.max()[u] + margin : box.min()[u] - margin;
      at[v] = far_v ? box.max()[v] + margin : box.min()[v] - margin;
      return Vector3(object.transform.apply(at));
    };
    const std::array corners{corner(false, false), corner(true, false), corner(true, true),
                             corner(false, true)};
    for (std::size_t i = 0; i < 4; ++i) out.push_back({corners[i], corners[(i + 1) % 4], color, 1.6F, false});
    return out;
  }
};

}  // namespace

const ObjectKind& solids_kind() {
  static const SolidsKind kind;
  return kind;
}

}  // namespace hariko
