#include "ui/editor/selection_size.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <span>

#include "core/geometry/angles.hpp"
#include "ui/base/quantity.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/object_size.hpp"

namespace hariko {

namespace {

constexpr std::size_t curves_a_frame = 2000, patches_a_frame = 500, points_a_frame = 300'000;

std::string length_of_selection(const Editor& editor, double length) {
  return format_quantity(measured_length(editor.document().unit, length), length);
}

/// "1  2.5  3 mm": the numbers have the digits of the largest one.
std::string numbers_text(const Editor& editor, const Vector3& numbers, const char* between) {
  const Quantity last = measured_length(editor.document().unit, numbers.cwiseAbs().maxCoeff());
  Quantity plain = last;
  plain.unit.clear();
  return format_quantity(plain, numbers.x()) + between + format_quantity(plain, numbers.y()) + between +
         format_quantity(last, numbers.z());
}

std::vector<Vector3> places_of(const Editor& editor, const Object& object, const ElementSelection& elements) {
  std::vector<Vector3> out;
  for (const VertexId id : elements.vertices)
    if (const auto place = place_of(editor.document(), {object.id, element_of(id)})) out.push_back(*place);
  return out;
}

/// The corner of the angle of three vertices, 0 .. 2: the one that was selected between the others, where
/// that is known, else the one with the largest angle.
std::size_t corner_of(const Editor& editor, const ElementSelection& elements,
                      std::span<const Vector3> places) {
  const auto& first = editor.selection.first;
  const auto& last = editor.selection.last;
  if (first && last && !(*first == *last)) {
    std::size_t at = 0, between = 3, others = 0;
    for (const VertexId id : elements.vertices) {
      const ElementRef ref{editor.selection.active, element_of(id)};
      ref == * first || ref == * last ? ++others : between = at;
      ++at;
    }
    if (others == 2 && between < 3) return between;
  }
  std::size_t best = 0;
  double largest = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = angle_between(places[(i + 1) % 3] - places[i], places[(i + 2) % 3] - places[i]);
    if (angle > largest) largest = angle, best = i;
  }
  return best;
}

std::string vertices_text(const Editor& editor, const Object& object, const ElementSelection& elements) {
  const Language& tr = editor.language;
  const std::size_t count = elements.vertices.size();
  if (count == 0 || count > points_a_frame) return {};
  const std::vector<Vector3> places = places_of(editor, object, elements);
  if (places.size() != count) return {};
  if (count == 1) return fill(tr("position {0}"), {numbers_text(editor, places[0], "  ")});
  if (count == 2)
    return fill(tr("distance {0}"), {length_of_selection(editor, (places[1] - places[0]).norm())});
  if (count > 3) {
    Box3 box;
    for (const Vector3& place : places) box.extend(place);
    return fill(tr("size {0}"), {numbers_text(editor, box.sizes(), " \u00d7 ")});
  }
  const std::size_t corner = corner_of(editor, elements, places);
  const double radians =
      angle_between(places[(corner + 1) % 3] - places[corner], places[(corner + 2) % 3] - places[corner]);
  Quantity degrees = angle_quantity();
  degrees.decimals = 2;
  return fill(tr("angle {0}"), {format_quantity(degrees, radians * 180 / std::numbers::pi)});
}

/// The surface of a polyhedron, unless it is that of an earlier state.
const SurfaceView* present_surface(const Editor& editor, const Object& object) {
  const SurfaceView* view = object_kind(object).curves_over_edges() ? editor.view_of(object.id) : nullptr;
  const bool present =
      view && view->mesh && !view->error && view->object && view->object->source == object.source;
  return present ? view : nullptr;
}

/// Whether the polyhedron itself is measured: there is no surface, and none is being made.
bool without_surface(const Editor& editor, const Object& object) {
  const SurfaceView* view = editor.view_of(object.id);
  return object.cage() && (!object_kind(object).curves_over_edges() || (view && view->error));
}

double straight_length(const Polyhedron& cage, const ElementSelection& elements) {
  double sum = 0;
  for (const EdgeId& id : elements.edges) {
    const Index a = cage.find(id.low), b = cage.find(id.high);
    if (a != no_index && b != no_index) sum += (cage.position(b) - cage.position(a)).norm();
  }
  return sum;
}

/// Area of faces as fans of triangles round the means of their corners, which is how they are drawn.
double flat_area(const Polyhedron& cage, const ElementSelection& elements) {
  double sum = 0;
  for (const FaceId id : elements.faces) {
    const Index face = cage.find(id);
    if (face == no_index) continue;
    const auto corners = cage.topology().face_vertices(face);
    Vector3 middle = Vector3::Zero();
    for (const Index v : corners) middle += cage.position(v) / double(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector3 a = cage.position(corners[i]) - middle,
                    b = cage.position(corners[(i + 1) % corners.size()]) - middle;
      sum += a.cross(b).norm() / 2;
    }
  }
  return sum;
}

/// The element's own of what a surface has of it: with a live mirror the images follow, as many again.
template <class Part>
std::span<const Part> without_images(const Object& object, const std::vector<Part>& parts) {
  const bool mirrored = object.live_mirror() != nullptr;
  const std::size_t own = mirrored && parts.size() % 2 == 0 ? parts.size() / 2 : parts.size();
  return std::span(parts).first(own);
}

}  // namespace

std::vector<std::shared_ptr<const void>> SelectionSize::parts_of(const Editor& editor) {
  std::vector<std::shared_ptr<const void>> parts;
  const auto add = [&](ObjectId id) {
    const SurfaceView* view = editor.view_of(id);
    parts.push_back(editor.document().find_shared(id));
    parts.push_back(view ? view->mesh : nullptr);
  };
  if (editor.mode != ElementMode::object)
    add(editor.selection.active);
  else
    for (const ObjectId id : editor.selection.objects()) add(id);
  return parts;
}

void SelectionSize::update(const Editor& editor) {
  if (editor.history.in_gesture()) return;
  if (!editor.has_document) {
    *this = {};
    return;
  }
  auto parts = parts_of(editor);
  const bool same = key_ && key_->mode == editor.mode && key_->unit == editor.document().unit &&
                    key_->language == editor.settings.language && key_->parts == parts &&
                    key_->selection == editor.selection;
  if (!same) {
    key_ = Key{editor.mode, editor.document().unit, editor.settings.language, editor.selection,
               std::move(parts)};
    begin(editor);
  }
  if (unfinished()) proceed(editor);
}

void SelectionSize::begin(const Editor& editor) {
  text_.clear();
  curves_.clear();
  patches_.clear();
  objects_.clear();
  box_.setEmpty();
  sum_ = 0;
  if (editor.mode == ElementMode::object)
    return objects_.assign(editor.selection.objects().begin(), editor.selection.objects().end());
  const Object* object = editor.active_object();
  if (!object) return;
  const ElementSelection& elements = editor.selection.of_active();
  scale_ = object->transform.scale;
  const bool vertices = !elements.vertices.empty(), edges = !elements.edges.empty(),
             faces = !elements.faces.empty();
  if (vertices + edges + faces != 1) return;
  if (vertices) text_ = vertices_text(editor, *object, elements);
  if (edges) begin_edges(editor, *object, elements);
  if (faces) begin_faces(editor, *object, elements);
}

const SurfaceElements& SelectionSize::elements_of(const SurfaceView& view) {
  if (indexed_ != view.mesh) {
    index_ = SurfaceElements(view.surface);
    indexed_ = view.mesh;
  }
  surface_ = view.surface;
  return index_;
}

void SelectionSize::begin_edges(const Editor& editor, const Object& object,
                                const ElementSelection& elements) {
  const SurfaceView* view = present_surface(editor, object);
  if (view) {
    const SurfaceElements& index = elements_of(*view);
    for (const EdgeId& id : elements.edges) {
      const std::vector<SideCurve> found = index.curves_over(id);
      const auto own = without_images(object, found);
      curves_.insert(curves_.end(), own.begin(), own.end());
    }
  }
  if (curves_.empty() && without_surface(editor, object))
    text_ = fill(editor.language("length {0}"),
                 {length_of_selection(editor, scale_ * straight_length(*object.cage(), elements))});
}

void SelectionSize::begin_faces(const Editor& editor, const Object& object,
                                const ElementSelection& elements) {
  const SurfaceView* view = present_surface(editor, object);
  if (view) {
    const SurfaceElements& index = elements_of(*view);
    for (const FaceId id : elements.faces) {
      const std::vector<Index> found = index.patches_of(id);
      const auto own = without_images(object, found);
      patches_.insert(patches_.end(), own.begin(), own.end());
    }
  }
  if (!patches_.empty() || !without_surface(editor, object)) return;
  const double area = scale_ * scale_ * flat_area(*object.cage(), elements);
  text_ =
      fill(editor.language("area {0}"), {format_quantity(measured_area(editor.document().unit, area), area)});
}

void SelectionSize::proceed_with_objects(const Editor& editor) {
  std::size_t points = 0;
  while (!objects_.empty() && points < points_a_frame) {
    const ObjectId id = objects_.back();
    objects_.pop_back();
    const Object* object = editor.document().find(id);
    const SurfaceView* view = editor.view_of(id);
    if (object) box_.extend(shown_box(editor, *object));
    if (view && view->mesh) points += view->mesh->patch_count() * view->mesh->vertices_per_patch();
    ++points;
  }
  if (objects_.empty() && !box_.isEmpty())
    text_ = fill(editor.language("size {0}"), {numbers_text(editor, box_.sizes(), " \u00d7 ")});
}

void SelectionSize::proceed(const Editor& editor) {
  if (!objects_.empty()) return proceed_with_objects(editor);
  const std::size_t curves = std::min(curves_.size(), curves_a_frame),
                    patches = std::min(patches_.size(), patches_a_frame);
  for (std::size_t i = curves_.size() - curves; i < curves_.size(); ++i)
    sum_ += curve_length(surface_, curves_[i]);
  sum_ += patch_area(surface_, std::span(patches_).last(patches));
  curves_.resize(curves_.size() - curves);
  patches_.resize(patches_.size() - patches);
  if (unfinished()) return;
  if (curves > 0) text_ = fill(editor.language("length {0}"), {length_of_selection(editor, scale_ * sum_)});
  if (patches > 0) {
    const double area = scale_ * scale_ * sum_;
    text_ = fill(editor.language("area {0}"),
                 {format_quantity(measured_area(editor.document().unit, area), area)});
  }
}

}  // namespace hariko
