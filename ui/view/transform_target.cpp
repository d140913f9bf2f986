#include "ui/view/transform_target.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <set>
#include <variant>

#include "core/base/disjoint_sets.hpp"
#include "core/document/edits/edit_attachments.hpp"
#include "core/document/edits/edit_solids.hpp"
#include "core/document/edits/edits.hpp"
#include "core/modeling/objects/edit_modeling.hpp"
#include "core/modeling/objects/transform_solid.hpp"
#include "core/modeling/surfacing/local_edit.hpp"
#include "core/skinning/edit/edit_path.hpp"
#include "core/skinning/edit/edit_section.hpp"
#include "core/skinning/sections/section_frame.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/outlines.hpp"
#include "ui/editor/skin_edits.hpp"
#include "ui/editor/skin_view.hpp"

namespace hariko {

namespace {

Vector3 mean(const std::vector<Vector3>& points) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& point : points) sum += point;
  return sum / static_cast<double>(std::max<std::size_t>(1, points.size()));
}

Vector3 world(const Object& object, Index vertex) {
  return object.transform.apply(object.cage_origin() + object.cage()->position(vertex));
}

/// For each of the vertices (ascending) a number that those share which selected elements connect.
std::vector<Index> islands(const std::vector<VertexId>& vertices, const Polyhedron& polyhedron,
                           const ElementSelection& elements) {
  DisjointSets connected(vertices.size());
  const auto place = [&](VertexId id) {
    const auto it = std::lower_bound(vertices.begin(), vertices.end(), id);
    return it != vertices.end() && *it == id ? static_cast<Index>(it - vertices.begin()) : no_index;
  };
  const auto join = [&](VertexId a, VertexId b) {
    const Index i = place(a), j = place(b);
    if (i != no_index && j != no_index) connected.join(i, j);
  };
  for (const EdgeId& edge : elements.edges) join(edge.low, edge.high);
  for (const FaceId id : elements.faces) {
    const auto corners = polyhedron.topology().face_vertices(polyhedron.find(id));
    for (const Index v : corners) join(polyhedron.vertex_id(corners.front()), polyhedron.vertex_id(v));
  }
  if (elements.vertices.size() > 1)
    for (Index e = 0; e < polyhedron.edge_count(); ++e) {
      const EdgeId edge = polyhedron.edge_id(e);
      if (elements.vertices.contains(edge.low) && elements.vertices.contains(edge.high))
        join(edge.low, edge.high);
    }
  std::vector<Index> island(vertices.size());
  for (Index i = 0; i < vertices.size(); ++i) island[i] = connected.find(i);
  return island;
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return count == 1 ? std::string(one) : std::to_string(count) + " " + many;
}

}  // namespace

TransformTarget TransformTarget::of(const Editor& editor) {
  TransformTarget target;
  target.document_ = editor.history.current();
  if (editor.mode == ElementMode::object) {
    for (const ObjectId id : selected_objects(editor))
      if (const Object& object = *target.document_.find(id); object.visible && !object.locked)
        target.add_object(object);
    target.what_ = counted(target.parts_.size(), "object", "objects");
  } else {
    for (const auto& [id, elements] : editor.selection.elements()) {
      target.document_ = with_seen_ends(target.document_, id);
      const Object* object = target.document_.find(id);
      if (!object || !object->visible || object->locked) continue;
      target.add_selected(*object, elements);
    }
    const bool solids =
        std::ranges::all_of(target.parts_, [](const Part& part) { return !part.solids.empty(); });
    target.what_ = solids ? counted(target.selected_.size(), "solid", "solids")
                          : counted(target.selected_.size(), "vertex", "vertices");
  }
  if (target.empty()) return target;
  target.choose_pivot(editor);
  if (const Object* active = target.document_.find(editor.selection.active))
    target.local_frame_ = active->transform.rotation.toRotationMatrix();
  target.choose_planes();
  if (editor.transform.local_edit && editor.mode == ElementMode::vertex) target.freeze();
  return target;
}

TransformTarget TransformTarget::of_objects(const Editor& editor, Document document,
                                            std::span<const ObjectId> objects) {
  TransformTarget target;
  target.document_ = std::move(document);
  for (const ObjectId id : objects)
    if (const Object* object = target.document_.find(id)) target.add_object(*object);
  target.what_ = counted(target.parts_.size(), "object", "objects");
  if (target.empty()) return target;
  target.choose_pivot(editor);
  target.local_frame_ = target.parts_.front().transform.rotation.toRotationMatrix();
  return target;
}

void TransformTarget::freeze() {
  for (Part& part : parts_)
    if (part.tangents)
      part.frozen = freeze_tangents(*part.tangents, vertices_around(*part.polyhedron, part.vertices));
  if (parts_.size() != 1 || parts_[0].vertices.size() != 1 || !parts_[0].frozen || !*parts_[0].frozen) return;
  const Part& part = parts_[0];
  const Pin* pin = (*part.frozen)->shaping->pin.find(part.vertices[0]);
  if (!pin || pin->kind != Pin::Kind::tangents || pin->vectors.size() < 2) return;
  const Matrix3 turn = part.transform.rotation.toRotationMatrix();
  const Vector3 first = part.transform.scale * turn * pin->vectors[0],
                second = part.transform.scale * turn * pin->vectors[1];
  const Vector3 normal = first.cross(second);
  if (!(normal.norm() > 1e-12 * first.norm() * second.norm())) return;  // no plane to show
  tangents_ = {first, second};
  local_frame_ << first.normalized(), normal.cross(first).normalized(), normal.normalized();
}

std::string TransformTarget::describe() const {
  return what_;
}

void TransformTarget::add_object(const Object& object) {
  Part part;
  part.object = object.id;
  part.whole = true;
  part.transform = object.transform;
  const Box3 box = world_box(object);
  part.pivot = box.isEmpty() ? object.transform.translation : Vector3(box.center());
  selected_.push_back(part.pivot);
  parts_.push_back(std::move(part));
}

void TransformTarget::add_selected(const Object& object, const ElementSelection& elements) {
  struct Adding {
    TransformTarget& target;
    const Object& object;
    const ElementSelection& elements;
    void operator()(const PolyhedronSource& source) const { target.add_elements(object, elements, &source); }
    void operator()(const PatchSource&) const { target.add_elements(object, elements, nullptr); }
    void operator()(const SolidsSource&) const { target.add_solids(object, elements); }
    void operator()(const SkinSource& source) const {
      target.add_points(object, elements, nullptr, &*source.skin);
    }
    void operator()(const OutlineSource& source) const {
      target.add_points(object, elements, &*source.outline, nullptr);
    }
    // Without elements.
    void operator()(const MeshSource&) const {}
    void operator()(const BezierSource&) const {}
    void operator()(const PictureSource&) const {}
    void operator()(const UnknownSource&) const {}
  };
  std::visit(Adding{*this, object, elements}, object.source);
}

void TransformTarget::add_elements(const Object& object, const ElementSelection& elements,
                                   const PolyhedronSource* tangents) {
  const Polyhedron& cage = *object.cage();
  Part part;
  part.object = object.id;
  part.transform = object.transform;
  part.origin = object.cage_origin();
  part.polyhedron = &cage;
  part.tangents = tangents;
  part.vertices = touched_vertices(elements, cage);
  part.selected = part.vertices.size();
  for (const VertexId id : part.vertices) {
    const Index v = cage.find(id);
    part.start.push_back(cage.position(v));
    selected_.push_back(world(object, v));
  }
  part.weight.assign(part.selected, 1);
  parts_.push_back(std::move(part));
}

void TransformTarget::add_solids(const Object& object, const ElementSelection& elements) {
  Part part;
  part.object = object.id;
  part.transform = object.transform;
  for (const VertexId id : elements.vertices)
    if (const Solid* solid = find_solid(object, id.value)) {
      part.solids.push_back(*solid);
      selected_.push_back(object.transform.apply(solid->position));
    }
  if (!part.solids.empty()) parts_.push_back(std::move(part));
}

void TransformTarget::add_points(const Object& object, const ElementSelection& elements,
                                 const Outline* outline, const Skin* skin) {
  Part part;
  part.object = object.id;
  part.transform = object.transform;
  part.outline = outline;
  part.skin = skin;
  for (const VertexId id : elements.vertices)
    if (const auto at = object_kind(object).place(object, element_of(id))) {
      part.vertices.push_back(id);
      part.start.push_back(*at);
      selected_.push_back(object.transform.apply(*at));
    }
  if (part.vertices.empty()) return;
  part.selected = part.vertices.size();
  part.weight.assign(part.selected, 1);
  parts_.push_back(std::move(part));
}

void TransformTarget::choose_pivot(const Editor& editor) {
  const PivotMode mode = editor.transform.pivot;
  pivot_ = mean(selected_);
  if (mode == PivotMode::box_centre) {
    Box3 box;
    for (const Vector3& point : selected_) box.extend(point);
    for (const Part& part : parts_)
      if (part.whole) box.extend(world_box(*document_.find(part.object)));
    pivot_ = box.center();
  }
  if (mode == PivotMode::active && editor.selection.last)
    pivot_ = place_of(document_, *editor.selection.last).value_or(pivot_);
  for (Part& part : parts_) {
    if (part.whole && mode != PivotMode::individual) part.pivot = pivot_;
    const Vector3 local = part.transform.inverse().apply(pivot_) - part.origin;
    part.pivots.assign(part.vertices.size() + part.solids.size(), local);
  }
  if (mode == PivotMode::individual) choose_own_pivots(editor);
}

void TransformTarget::choose_own_pivots(const Editor& editor) {
  for (Part& part : parts_) {
    if (part.whole) continue;
    for (std::size_t i = 0; i < part.solids.size(); ++i) part.pivots[i] = part.solids[i].position;
    if (!part.polyhedron) continue;
    const auto island = islands(part.vertices, *part.polyhedron, editor.selection.of(part.object));
    std::map<Index, std::vector<Vector3>> points;
    for (std::size_t i = 0; i < island.size(); ++i) points[island[i]].push_back(part.start[i]);
    for (std::size_t i = 0; i < island.size(); ++i) part.pivots[i] = mean(points[island[i]]);
  }
}

bool TransformTarget::stands(ObjectId object, VertexId vertex) const {
  for (const Part& part : parts_) {
    if (part.object != object) continue;
    if (part.whole) return false;
    return std::find(part.vertices.begin(), part.vertices.end(), vertex) == part.vertices.end();
  }
  return true;
}

bool TransformTarget::changes(ObjectId object) const {
  return std::ranges::any_of(parts_, [&](const Part& part) { return part.object == object; });
}

void TransformTarget::follow(double radius, Falloff kind) {
  for (Part& part : parts_) {
    if (part.whole || part.frozen) continue;          // a local edit moves nothing else
    if (!part.polyhedron && !part.outline) continue;  // solids and points of skins move alone
    part.vertices.resize(part.selected);
    part.start.resize(part.selected);
    part.weight.resize(part.selected);
    part.pivots.resize(part.selected);
    if (!(radius > 0)) continue;
    if (part.outline) {
      follow_along(part, radius, kind);
      continue;
    }
    const Polyhedron& polyhedron = *part.polyhedron;
    if (part.distance.empty()) {
      std::vector<Index> given;
      for (const VertexId id : part.vertices) given.push_back(polyhedron.find(id));
      part.distance = distances_from(polyhedron, given);
    }
    const Vector3 pivot = part.transform.inverse().apply(pivot_) - part.origin;
    for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
      const double weight = falloff(kind, part.distance[v] * part.transform.scale / radius);
      const bool chosen = std::binary_search(
          part.vertices.begin(), part.vertices.begin() + static_cast<std::ptrdiff_t>(part.selected),
          polyhedron.vertex_id(v));
      if (weight <= 0 || chosen) continue;
      part.vertices.push_back(polyhedron.vertex_id(v));
      part.start.push_back(polyhedron.position(v));
      part.weight.push_back(weight);
      part.pivots.push_back(pivot);
    }
  }
}

/// Points of the outline that follow by their distance along the loop.
void TransformTarget::follow_along(Part& part, double radius, Falloff kind) {
  if (part.distance.empty()) {
    std::set<Index> given;
    for (const VertexId id : part.vertices) given.insert(id.value);
    part.distance = distances_along(*part.outline, given);
  }
  const Vector3 pivot = part.transform.inverse().apply(pivot_);
  for (Index number = 0; number < part.distance.size(); ++number) {
    const double weight = falloff(kind, part.distance[number] * part.transform.scale / radius);
    if (weight <= 0 || part.distance[number] == 0) continue;
    const OutlinePoint at = outline_point(*part.outline, number);
    part.vertices.push_back(VertexId{number});
    part.start.push_back(part.outline->loops[at.loop].points[at.place]);
    part.weight.push_back(weight);
    part.pivots.push_back(pivot);
  }
}

std::vector<TransformTarget::Follower> TransformTarget::followers() const {
  std::vector<Follower> result;
  for (const Part& part : parts_)
    for (std::size_t i = part.selected; i < part.vertices.size(); ++i)
      result.push_back({part.transform.apply(part.origin + part.start[i]), part.weight[i]});
  return result;
}

Result<Document> TransformTarget::apply(const Document& document, const Transformation& transformation,
                                        bool along_local_axes) const {
  Result<Document> result = document;
  for (const Part& part : parts_) {
    if (!result) return result;
    if (part.whole) {
      result = transform_object(*result, part.object, transformation, part.pivot);
      continue;
    }
    const Transformation local = transformation.in_space_of(part.transform);
    if (!part.solids.empty()) {
      result = apply_to_solids(*result, part, local);
      continue;
    }
    if (part.skin) {
      result = apply_to_skin(*result, part, local, in_planes_ && along_local_axes);
      continue;
    }
    if (part.frozen || part.outline) {
      result = part.outline ? apply_to_points(*result, part, local) : apply_locally(*result, part, local);
      continue;
    }
    std::vector<Vector3> positions(part.vertices.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
      positions[i] = local.apply(part.start[i], part.pivots[i], part.weight[i]);
    result = move_vertices(*result, part.object, part.vertices, positions);
  }
  return result;
}

Result<Document> TransformTarget::apply_to_solids(const Document& document, const Part& part,
                                                  const Transformation& local) {
  return change_envelope(document, part.object, [&](EnvelopeInput& input) {
    for (std::size_t i = 0; i < part.solids.size(); ++i)
      for (Solid& solid : input.solids)
        if (solid.id == part.solids[i].id) solid = transformed(part.solids[i], local, part.pivots[i]);
  });
}

/// The path carries the sections; chosen points of these then go where they are transformed to.
Result<Document> TransformTarget::apply_to_skin(const Document& document, const Part& part,
                                                const Transformation& local, bool in_planes) {
  std::vector<MovedPathPoint> path;
  std::vector<MovedPoint> points;
  for (std::size_t i = 0; i < part.vertices.size(); ++i) {
    Transformation own = local;
    if (in_planes) {
      const Matrix3& turn = part.turns[i];
      own.translation = turn * local.translation;
      own.axis = turn * local.axis;
      own.frame = turn * local.frame;
    }
    const Vector3 to = own.apply(part.start[i], part.pivots[i], part.weight[i]);
    const std::uint32_t id = part.vertices[i].value;
    if (!is_path_point(id)) {
      points.push_back({id, to});
      continue;
    }
    const bool rail = id >= rail_point_ids;
    path.push_back({rail ? PathCurve::second_rail : PathCurve::path,
                    static_cast<int>(id - (rail ? rail_point_ids : path_point_ids)), to});
  }
  if (path.empty()) return with_skin(document, part.object, move_section_points(*part.skin, points));
  auto carried = move_path_points(*part.skin, path);
  if (carried && !points.empty()) carried = move_section_points(carried->skin, points);
  return with_skin(document, part.object, carried);
}

/// Moves points; their normals go along with the loop, and with a rotation.
Result<Document> TransformTarget::apply_to_points(const Document& document, const Part& part,
                                                  const Transformation& local) {
  return edit_outline(document, part.object, [&](const Outline& outline) -> Result<Outline> {
    std::vector<Index> numbers;
    std::vector<Vector3> places, normals;
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
      numbers.push_back(part.vertices[i].value);
      places.push_back(local.apply(part.start[i], part.pivots[i], part.weight[i]));
      const OutlinePoint at = outline_point(outline, numbers.back());
      normals.push_back(local.linear(part.weight[i]) * outline.loops[at.loop].normals[at.place]);
    }
    const Outline moved = with_points(outline, numbers, places);
    const bool turns = local.degrees != 0 && local.factors == Vector3::Ones();
    return turns ? with_normals(moved, numbers, normals) : moved;
  });
}

/// Moves the vertices, or turns and stretches their tangents where they stand.
Result<Document> TransformTarget::apply_locally(const Document& document, const Part& part,
                                                const Transformation& local) const {
  if (!*part.frozen) return part.frozen->error();
  const bool moves = local.only_translates();
  const Matrix3 linear = local.linear();
  if (!moves && !(std::abs(linear.determinant()) > 1e-12))
    return make_error(e_transform_invalid, "Tangents cannot be scaled to nothing.",
                      "Scale by another number.");
  const auto fixed =
      edit_polyhedron(document, part.object, [&](const PolyhedronSource&) -> Result<EditResult> {
        if (moves) return EditResult{**part.frozen, {}};
        return EditResult{with_turned_tangents(**part.frozen, part.vertices, linear), {}};
      });
  if (!fixed) return fixed.error();
  if (!moves) return fixed->document;
  std::vector<Vector3> positions;
  for (const Vector3& start : part.start) positions.push_back(start + local.translation);
  return move_vertices(fixed->document, part.object, part.vertices, positions);
}

std::vector<ObjectId> selected_objects(const Editor& editor) {
  const Document& document = editor.document();
  std::vector<ObjectId> result;
  if (editor.mode != ElementMode::object) {
    if (editor.active_object()) result.push_back(editor.selection.active);
    return result;
  }
  for (const ObjectId id : editor.selection.objects())
    if (document.find(id)) result.push_back(id);
  return result;
}

std::vector<ObjectId> active_and_selected(const Editor& editor) {
  std::vector<ObjectId> objects = selected_objects(editor);
  const auto active = std::find(objects.begin(), objects.end(), editor.selection.active);
  if (active != objects.end()) std::rotate(objects.begin(), active, active + 1);
  return objects;
}

void TransformTarget::choose_planes() {
  const auto of_sections = [](const Part& part) {
    return part.skin &&
           std::ranges::none_of(part.vertices, [](VertexId id) { return is_path_point(id.value); });
  };
  if (!std::ranges::all_of(parts_, of_sections)) return;
  std::optional<Matrix3> first, axes;  // in the document's space
  int count = 0;
  for (Part& part : parts_) {
    const Matrix3 place = part.transform.rotation.toRotationMatrix();
    part.turns.assign(part.vertices.size(), Matrix3::Identity());
    std::vector<Vector3> middles = part.pivots;
    for (const SkinSection& section : part.skin->sections) {
      std::vector<std::size_t> chosen;
      std::vector<Vector3> points;
      for (std::size_t i = 0; i < part.vertices.size(); ++i)
        if (find_point(section, part.vertices[i].value) >= 0) {
          chosen.push_back(i);
          points.push_back(part.start[i]);
        }
      if (chosen.empty()) continue;
      const Vector3 direction = place * section_direction_of_view(*part.skin, section);
      axes = axes ? carried_axes(*axes, direction) : upright_axes(direction);
      if (!first) first = axes;
      ++count;
      Vector3 middle = Vector3::Zero();
      for (const Vector3& point : points) middle += point / double(points.size());
      for (const std::size_t i : chosen) {
        part.turns[i] = place.transpose() * *axes * first->transpose() * place;
        middles[i] = middle;
      }
    }
    // One section has the pivot that was chosen.
    if (count > 1 || parts_.size() > 1) part.pivots = std::move(middles);
  }
  if (!first) return;
  local_frame_ = *first;
  in_planes_ = true;
}

}  // namespace hariko
