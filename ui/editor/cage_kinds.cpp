// The kinds of objects with a cage: polyhedra, and patches with their control net.

#include "core/document/edits/edit_attachments.hpp"
#include "core/modeling/selection/edge_paths.hpp"
#include "core/modeling/selection/select_convert.hpp"
#include "core/modeling/selection/select_region.hpp"
#include "ui/base/language.hpp"
#include "ui/editor/object_kind.hpp"

namespace hariko {

namespace {

template <class Id>
void keep_existing(std::set<Id>& set, const Polyhedron& polyhedron) {
  std::erase_if(set, [&](const Id& id) { return polyhedron.find(id) == no_index; });
}

class CageKind : public ObjectKind {
 public:
  ElementSelection all(const Object& object, ElementMode mode) const override {
    return select_all(*object.cage(), kind_of(mode));
  }

  ElementSelection existing(const Object& object, ElementSelection selection) const override {
    keep_existing(selection.vertices, *object.cage());
    keep_existing(selection.edges, *object.cage());
    keep_existing(selection.faces, *object.cage());
    return selection;
  }

  ElementSelection converted(const Object& object, const ElementSelection& selection, ElementMode from,
                             ElementMode to) const override {
    const Polyhedron& polyhedron = *object.cage();
    // Corners give what they enclose, larger elements what they touch.
    const Reach reach = from < to ? Reach::inside : Reach::touching;
    return to == ElementMode::vertex ? to_vertices(polyhedron, selection)
           : to == ElementMode::edge ? to_edges(polyhedron, selection, reach)
                                     : to_faces(polyhedron, selection, reach);
  }

  ElementSelection continued(const Object& object, const Element& element, bool ring) const override {
    const Polyhedron& polyhedron = *object.cage();
    if (element.kind != Element::Kind::edge) {
      Selection one;
      one.select({object.id, element}, Selection::How::replace);
      return linked(object, one.of(object.id));
    }
    const EdgeId edge = EdgeId::from_packed(element.id);
    const auto path = ring ? edge_ring(polyhedron, edge) : edge_loop(polyhedron, edge);
    ElementSelection out;
    out.edges.insert(path.begin(), path.end());
    return out;
  }

  ElementSelection linked(const Object& object, const ElementSelection& selection) const override {
    return hariko::linked(*object.cage(), selection);
  }

  Element element_at(const Object& object, Element::Kind kind, Index index) const override {
    const Polyhedron& polyhedron = *object.cage();
    // The surface on the screen may be that of an earlier state and know faces that are gone: they have no
    // index.
    switch (kind) {
      case Element::Kind::vertex:
        if (index < polyhedron.vertex_count()) return element_of(polyhedron.vertex_id(index));
        break;
      case Element::Kind::edge:
        if (index < polyhedron.edge_count()) return element_of(polyhedron.edge_id(index));
        break;
      case Element::Kind::face:
        if (index < polyhedron.face_count()) return element_of(polyhedron.face_id(index));
        break;
      default:
        break;
    }
    return {};
  }

  std::optional<Vector3> place(const Object& object, const Element& element) const override {
    const Polyhedron& polyhedron = *object.cage();
    Selection one;
    one.select({object.id, element}, Selection::How::replace);
    const std::vector<VertexId> vertices = touched_vertices(one.of(object.id), polyhedron);
    if (vertices.empty()) return std::nullopt;
    Vector3 sum = Vector3::Zero();
    for (const VertexId id : vertices) sum += polyhedron.position(polyhedron.find(id));
    return Vector3(object.cage_origin() + sum / static_cast<double>(vertices.size()));
  }

  std::vector<Vector3> extent(const Object& object, const ElementSelection& selection) const override {
    const Polyhedron& polyhedron = *object.cage();
    std::vector<Vector3> out;
    for (const VertexId id : touched_vertices(selection, polyhedron))
      out.push_back(object.cage_origin() + polyhedron.position(polyhedron.find(id)));
    return out;
  }

  Highlights highlights(const Object& object, const ElementSelection& selection,
                        const DisplayPolyhedron&) const override {
    return highlights_of(selection, *object.cage());
  }

  /// Faces are outlined by their edges, too.
  Highlights failed(const Object& object, const Element& element, const DisplayPolyhedron&) const override {
    const Polyhedron& polyhedron = *object.cage();
    const auto number = static_cast<std::uint32_t>(element.id);
    ElementSelection failed;
    if (element.kind == Element::Kind::vertex) failed.vertices.insert(VertexId{number});
    if (element.kind == Element::Kind::edge) failed.edges.insert(EdgeId::from_packed(element.id));
    if (element.kind == Element::Kind::face) {
      failed.faces.insert(FaceId{number});
      if (const Index face = polyhedron.find(FaceId{number}); face != no_index) {
        const auto corners = polyhedron.topology().face_vertices(face);
        for (std::size_t i = 0; i < corners.size(); ++i)
          failed.edges.insert(EdgeId::of(polyhedron.vertex_id(corners[i]),
                                         polyhedron.vertex_id(corners[(i + 1) % corners.size()])));
      }
    }
    return highlights_of(failed, polyhedron);
  }

  ElementsShown elements_shown() const override { return ElementsShown::lines; }
};

class PolyhedronKind final : public CageKind {
 public:
  /// Attached vertices are shown where their sides end, which others may have moved.
  ObjectLines lines(const Document& document, const Object& object, const Object* before,
                    const ObjectLines& drawn) const override {
    const PolyhedronSource& source = *object.polyhedron();
    const bool attached = !source.attachments->empty();
    ObjectLines out;
    if (attached) out.attached = attached_polyhedron(document, object);
    const Polyhedron& shown = attached ? *out.attached : source.polyhedron;
    const PolyhedronSource* old = before ? before->polyhedron() : nullptr;
    if (!old || !drawn.polyhedron || old->origin != source.origin || drawn.attached.has_value() != attached) {
      out.polyhedron = DisplayPolyhedron::build(shown, *source.shaping, source.origin);
      return out;
    }
    const Polyhedron& known = attached ? *drawn.attached : old->polyhedron;
    if (known.shared_topology() != shown.shared_topology()) {
      out.polyhedron = DisplayPolyhedron::build(shown, *source.shaping, source.origin);
      return out;
    }
    out.polyhedron = drawn.polyhedron;
    if (!(known == shown)) out.polyhedron = out.polyhedron->moved(shown);
    if (!(old->shaping == source.shaping)) out.polyhedron = out.polyhedron->shaped(shown, *source.shaping);
    return out;
  }

  /// Vertices that a conversion found are nearly all pinned: nobody drew the curves between them.
  void adjust(const Object& object, const ViewSettings&, SceneObject& shown) const override {
    constexpr std::size_t many = 60;
    const PolyhedronSource& source = *object.polyhedron();
    const std::size_t pins = source.shaping->pin.size();
    shown.quiet_network = pins > many && 10 * pins >= 9 * std::size_t(source.polyhedron.vertex_count());
  }

  void adjust_in_file(const Object&, SceneObject& shown, std::vector<OverlayLine>&) const override {
    shown.show_polyhedron = true;
  }

  bool curves_over_edges() const override { return true; }
  Stretching stretching() const override { return Stretching::indirect; }

  std::string size_text(const Object& object, const Language& tr) const override {
    const Polyhedron& p = *object.cage();
    return fill(
        tr("{0} vertices  {1} edges  {2} faces"),
        {std::to_string(p.vertex_count()), std::to_string(p.edge_count()), std::to_string(p.face_count())});
  }
};

class PatchesKind final : public CageKind {
 public:
  ObjectLines lines(const Document&, const Object& object, const Object* before,
                    const ObjectLines& drawn) const override {
    const PatchSource& patches = *object.patches();
    const PatchSource* old = before ? before->patches() : nullptr;
    const bool same_net = old && drawn.polyhedron && old->origin == patches.origin &&
                          old->net.shared_topology() == patches.net.shared_topology();
    if (!same_net) return {cage_of(object), {}};
    return {old->net == patches.net ? drawn.polyhedron : drawn.polyhedron->moved(patches.net), {}};
  }
  /// Points of the net are taken where it is shown.
  void adjust(const Object&, const ViewSettings&, SceneObject& shown) const override {
    shown.elements_pickable = shown.show_polyhedron;
  }

  Stretching stretching() const override { return Stretching::affine; }

  std::string size_text(const Object& object, const Language& tr) const override {
    const PatchSource& patches = *object.patches();
    return fill(tr("patches: {0} \u00d7 {1}"),
                {std::to_string(patches.columns), std::to_string(patches.rows)});
  }
};

}  // namespace

const ObjectKind& polyhedron_kind() {
  static const PolyhedronKind kind;
  return kind;
}

const ObjectKind& patches_kind() {
  static const PatchesKind kind;
  return kind;
}

}  // namespace hariko
