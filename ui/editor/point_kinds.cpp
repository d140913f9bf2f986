// The kinds of objects that are made of points and curves: outlines with their loops, skins with sections and
// paths. Points are selected as vertices: those of an outline by their numbers, those of a skin by their ids.

#include <algorithm>

#include "core/gaussmap/outlines/edit_outline.hpp"
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
    return count == 1 ? std::string(tr("1 point")) : fill(tr("{0} points"), {std::to_string(count)});
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

  ElementSelection existing(const Object& object, ElementSelection selection) const override {
    const std::size_t count = object.outline()->outline->point_count();
    std::erase_if(selection.vertices, [&](VertexId id) { return id.value >= count; });
    selection.edges.clear();
    selection.faces.clear();
    return selection;
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
};

class SkinKind final : public PointKind {
 public:
  /// The points of all sections and those of the path and of the second rail.
  ElementSelection all(const Object& object, ElementMode) const override {
    const Skin& skin = *object.skin()->skin;
    ElementSelection out;
    for (const SkinSection& section : skin.sections)
      for (const SectionPoint& point : section.points) out.vertices.insert(VertexId{point.id});
    const auto add_path = [&](const SubdivisionCurve& path, std::uint32_t ids) {
      for (int i = 0; i < path.size(); ++i) out.vertices.insert(VertexId{ids + std::uint32_t(i)});
    };
    add_path(skin.path, path_point_ids);
    if (skin.second_rail) add_path(*skin.second_rail, rail_point_ids);
    return out;
  }

  ElementSelection existing(const Object& object, ElementSelection selection) const override {
    std::erase_if(selection.vertices,
                  [&](VertexId id) { return !skin_point(*object.skin()->skin, id.value); });
    selection.edges.clear();
    selection.faces.clear();
    return selection;
  }

  std::optional<Vector3> place(const Object& object, const Element& element) const override {
    if (element.kind != Element::Kind::vertex) return std::nullopt;
    return skin_point(*object.skin()->skin, static_cast<std::uint32_t>(element.id));
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

}  // namespace hariko
