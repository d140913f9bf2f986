// The kinds of objects that are made of points and curves: outlines with their loops, skins with sections and
// paths. Points are selected as vertices: those of an outline by their numbers, those of a skin by their ids.

#include <algorithm>

#include "core/gaussmap/outlines/edit_outline.hpp"
#include "ui/base/icons.hpp"
#include "ui/base/language.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/object_lines.hpp"
#include "ui/editor/skin_view.hpp"

namespace hariko {

namespace {

class PointKind : public ObjectKind {
 public:
  std::string describe(const ElementSelection& selection, const Language& tr) const override {
    const std::size_t count = selection.vertices.size();
    if (count == 0) return ObjectKind::describe(selection, tr);
    return tr.counted(count, "1 point", "{0} points");
  }
};

class OutlineKind final : public PointKind {
 public:
  ElementSelection all(const Object& object, ElementMode mode) const override {
    ElementSelection out;
    if (mode != ElementMode::vertex) return out;
    for (Index i = 0; i < object.outline()->outline->point_count(); ++i)
      out.vertices.insert(out.vertices.end(), VertexId{i});
    return out;
  }

  Element element_at(const Object& object, Element::Kind kind, Index index) const override {
    if (kind != Element::Kind::vertex || index >= object.outline()->outline->point_count()) return {};
    return element_of(VertexId{index});
  }

  std::optional<Vector3> place(const Object& object, const Element& element) const override {
    const Outline& outline = *object.outline()->outline;
    if (element.kind != Element::Kind::vertex || element.id >= outline.point_count()) return std::nullopt;
    const OutlinePoint at = outline_point(outline, static_cast<Index>(element.id));
    return outline.loops[at.loop].points[at.place];
  }

  bool has_elements(ElementMode mode) const override { return mode == ElementMode::vertex; }

  ElementSelection continued(const Object& object, const Element& element, bool) const override {
    ElementSelection one;
    if (element.kind == Element::Kind::vertex)
      one.vertices.insert(VertexId{static_cast<std::uint32_t>(element.id)});
    return linked(object, one);
  }

  /// All points of the loops.
  ElementSelection linked(const Object& object, const ElementSelection& selection) const override {
    const Outline& outline = *object.outline()->outline;
    std::set<Index> numbers;
    for (const VertexId id : selection.vertices)
      if (id.value < outline.point_count()) numbers.insert(id.value);
    ElementSelection out;
    for (const Index number : whole_loops(outline, numbers)) out.vertices.insert(VertexId{number});
    return out;
  }

  ElementsShown elements_shown() const override { return ElementsShown::lines; }

  ObjectLines lines(const Document&, const Object& object, const Object* before,
                    const ObjectLines& drawn) const override {
    const OutlineSource* old = before ? before->outline() : nullptr;
    if (old && old->outline == object.outline()->outline) return drawn;
    return {lines_of(*object.outline()->outline), {}};
  }

  Highlights highlights(const Object& object, const ElementSelection& selection,
                        const DisplayPolyhedron&) const override {
    Highlights out;
    const std::size_t count = object.outline()->outline->point_count();
    for (const VertexId id : selection.vertices)
      if (id.value < count) out.vertices.push_back(id.value);
    return out;
  }

  Highlights failed(const Object& object, const Element& element,
                    const DisplayPolyhedron& lines) const override {
    ElementSelection failed;
    if (element.kind == Element::Kind::vertex)
      failed.vertices.insert(VertexId{static_cast<std::uint32_t>(element.id)});
    return highlights(object, failed, lines);
  }

  /// The points inside were found, the loops alone are drawn.
  void adjust(const Object&, const ViewSettings&, SceneObject& shown) const override {
    shown.quiet_network = true;
  }

  void adjust_in_file(const Object&, SceneObject& shown, std::vector<OverlayLine>&) const override {
    shown.show_network = false;
    shown.show_polyhedron = true;
  }
};

class SkinKind final : public PointKind {
 public:
  ElementSelection all(const Object& object, ElementMode) const override {
    ElementSelection out;
    for (const auto& curve : points_of_curves(*object.skin()->skin))
      out.vertices.insert(curve.begin(), curve.end());
    return out;
  }

  /// All points of the sections, of the path and of the second rail that have selected ones.
  ElementSelection linked(const Object& object, const ElementSelection& selection) const override {
    ElementSelection out;
    for (const auto& curve : points_of_curves(*object.skin()->skin))
      if (std::ranges::any_of(curve, [&](VertexId id) { return selection.vertices.contains(id); }))
        out.vertices.insert(curve.begin(), curve.end());
    return out;
  }

  std::optional<Vector3> place(const Object& object, const Element& element) const override {
    if (element.kind != Element::Kind::vertex) return std::nullopt;
    return skin_point(*object.skin()->skin, static_cast<std::uint32_t>(element.id));
  }

  /// Control points and where the curve is at them.
  std::vector<Vector3> extent(const Object& object, const ElementSelection& selection) const override {
    std::vector<Vector3> out;
    for (const SkinView::Handle& handle : view_of(*object.skin()->skin, nullptr).handles)
      if (handle.kind != SkinView::Handle::Kind::place && selection.vertices.contains(VertexId{handle.id}))
        out.push_back(handle.position);
    return out;
  }

  ElementsShown elements_shown() const override { return ElementsShown::layer; }

  /// Sections and paths at all places, in the colours of the window.
  void adjust_in_file(const Object& object, SceneObject& shown,
                      std::vector<OverlayLine>& lines) const override {
    shown.show_network = false;
    const SkinView view = view_of(*object.skin()->skin, nullptr);
    const std::vector<Similarity> places = places_of(object);
    const auto add = [&](const std::vector<Vector3>& curve, const char* colour, float width) {
      for (const Similarity& place : places)
        for (std::size_t i = 0; i + 1 < curve.size(); ++i)
          lines.push_back(
              {place.apply(curve[i]), place.apply(curve[i + 1]), color_from_hex(colour), width, false});
    };
    for (const auto& path : view.paths) add(path, "#4aa3df", 2);
    for (const SkinView::Section& section : view.sections) add(section.curve, "#3dbb6c", 3);
  }

 private:
  /// The points of each section, of the path and of the second rail.
  static std::vector<std::vector<VertexId>> points_of_curves(const Skin& skin) {
    std::vector<std::vector<VertexId>> out;
    for (const SkinSection& section : skin.sections) {
      out.emplace_back();
      for (const SectionPoint& point : section.points) out.back().push_back(VertexId{point.id});
    }
    const auto add_path = [&](const SubdivisionCurve& path, std::uint32_t ids) {
      out.emplace_back();
      for (int i = 0; i < path.size(); ++i) out.back().push_back(VertexId{ids + std::uint32_t(i)});
    };
    add_path(skin.path, path_point_ids);
    if (skin.second_rail) add_path(*skin.second_rail, rail_point_ids);
    return out;
  }
};

}  // namespace

const ObjectKind& outline_kind() {
  static const OutlineKind kind;
  return kind;
}

const ObjectKind& skin_kind() {
  static const SkinKind kind;
  return kind;
}

// The kinds of objects without elements: facets of reference meshes and control nets of Bezier patches, whose
// lines are only looked at, and pictures.

namespace {

class MeshKind final : public ObjectKind {
 public:
  ObjectLines lines(const Document&, const Object& object, const Object* before,
                    const ObjectLines& drawn) const override {
    const MeshSource* old = before ? before->mesh() : nullptr;
    if (old && *old == *object.mesh()) return drawn;
    return {lines_of(*object.mesh()), {}};
  }
  const char* list_icon() const override { return icon::mesh; }
  Stretching stretching() const override { return Stretching::affine; }
};

class BezierKind final : public ObjectKind {
 public:
  ObjectLines lines(const Document&, const Object& object, const Object* before,
                    const ObjectLines& drawn) const override {
    const BezierSource* old = before ? before->bezier() : nullptr;
    if (old && *old == *object.bezier()) return drawn;
    return {lines_of(*object.bezier()), {}};
  }
  void adjust(const Object&, const ViewSettings&, SceneObject& shown) const override {
    shown.elements_pickable = shown.show_polyhedron;
  }
  Stretching stretching() const override { return Stretching::affine; }
  std::string size_text(const Object& object, const Language& tr) const override {
    return fill(tr("patches: {0}"), {std::to_string(object.bezier()->patches->size())});
  }
};

class PictureKind final : public ObjectKind {
 public:
  const char* list_icon() const override { return icon::picture; }
  bool is_backdrop() const override { return true; }
};

}  // namespace

const ObjectKind& mesh_kind() {
  static const MeshKind kind;
  return kind;
}

const ObjectKind& bezier_kind() {
  static const BezierKind kind;
  return kind;
}

const ObjectKind& picture_kind() {
  static const PictureKind kind;
  return kind;
}

}  // namespace hariko
