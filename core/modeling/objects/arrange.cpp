#include "core/modeling/objects/arrange.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "core/document/edits/edit_support.hpp"
#include "core/geometry/angles.hpp"
#include "core/modeling/objects/mirrored_source.hpp"
#include "core/modeling/objects/transformation.hpp"

namespace hariko {

namespace {

constexpr double full_turn = 360;
constexpr double degrees_per_radian = 180 / std::numbers::pi;
/// Arc lengths that are no more than rounding, relative to the curve's length or to the number of steps.
constexpr double least_room = 1e-9;
/// Distances that are no more than rounding, relative to the coordinates.
constexpr double rounding_share = 16 * std::numeric_limits<double>::epsilon();

Message nothing_to_arrange() {
  return make_error(e_no_objects, "No object is selected.", "Select one or more objects.");
}

Message wrong_count(int count) {
  return make_error(e_array_count, "There cannot be " + std::to_string(count) + " places.",
                    "Use from 2 to 10,000 places, the object's own included.");
}

/// Transforms one object without the rest of the document: copies of the document for each of thousands of
/// objects would take time with the square of their number.
Result<Object> transformed_alone(const Object& object, const Transformation& transformation,
                                 const Vector3& pivot) {
  Document alone;
  alone.objects.push_back(std::make_shared<const Object>(object));
  const auto done = transform_object(alone, object.id, transformation, pivot);
  if (!done) return done.error();
  return *done->objects.front();
}

/// Turns of the places of a curve against the first.
std::vector<Eigen::Quaterniond> turns_along(std::span<const ArcLengthCurve::Place> places,
                                            CurveTurning turning) {
  std::vector<Eigen::Quaterniond> out(places.size(), Eigen::Quaterniond::Identity());
  if (turning == CurveTurning::with_curve)
    for (std::size_t i = 1; i < places.size(); ++i)
      out[i] = Eigen::Quaterniond(Matrix3(places[i].frame * places[0].frame.transpose())).normalized();
  if (turning != CurveTurning::upright) return out;
  constexpr double least_level = 1e-6;
  std::optional<Vector3> first, last;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vector3 tangent = places[i].frame.col(2);
    const Vector3 level(tangent.x(), tangent.y(), 0);
    if (level.norm() > least_level) last = level;
    if (last && !first) first = last;
    if (!last) continue;
    const double angle = signed_angle(*first, *last, Vector3::UnitZ());
    out[i] = Eigen::AngleAxisd(angle, Vector3::UnitZ());
  }
  return out;
}

std::vector<ArcLengthCurve::Place> places_along(const ArcLengthCurve& curve, std::span<const double> ways) {
  std::vector<ArcLengthCurve::Place> out;
  for (const double way : ways) out.push_back(curve.at(way));
  return out;
}

/// Moves objects of a document, which must be there, by the same way.
Result<Document> moved_all(const Document& document, std::span<const ObjectId> objects, const Vector3& way) {
  Document out = document;
  const std::set<ObjectId> moved(objects.begin(), objects.end());
  Transformation move;
  move.translation = way;
  for (auto& object : out.objects) {
    if (!moved.contains(object->id)) continue;
    auto done = transformed_alone(*object, move, Vector3::Zero());
    if (!done) return done.error();
    object = std::make_shared<const Object>(std::move(done).value());
  }
  return out;
}

/// Rotation that takes the object's rotation to that of its image. The reflection in the plane after one
/// across the own axis `own` is a rotation by twice the angle between the two normals.
Eigen::Quaterniond rotation_of_image(const Eigen::Quaterniond& rotation, Axis own, const Vector3& normal) {
  Vector3 along = rotation * Vector3(Vector3::Unit(index_of(own)));
  if (along.dot(normal) < 0) along = -along;
  Eigen::Quaterniond turn;
  turn.w() = along.dot(normal);
  turn.vec() = along.cross(normal);
  return (turn * rotation).normalized();
}

/// Own axis that is nearest to the normal, of equal ones the first: so the placement turns least.
Axis nearest_own_axis(const Eigen::Quaterniond& rotation, const Vector3& normal) {
  const Vector3 own = rotation.conjugate() * normal;
  Axis best = Axis::x;
  for (const Axis axis : {Axis::y, Axis::z})
    if (std::abs(own[index_of(axis)]) > std::abs(own[index_of(best)]) + 1e-12) best = axis;
  return best;
}

Result<Object> image_of(const Object& object, const MirrorPlane& plane) {
  const Axis own = nearest_own_axis(object.transform.rotation, plane.normal());
  auto source = mirrored_source(object, own);
  if (!source) return source.error();
  Object image = object;
  image.source = std::move(source).value();
  image.transform.rotation = rotation_of_image(object.transform.rotation, own, plane.normal());
  image.transform.translation = plane.image(object.transform.translation);
  const auto placed = detail::checked_transform(image.transform);
  if (!placed) return placed.error();
  image.transform = *placed;
  // The source is reflected, and what stands at its places goes along.
  Matrix3 reflection = Matrix3::Identity();
  reflection(index_of(own), index_of(own)) = -1;
  image.copies = mapped(*object.copies, reflection);
  return image;
}

/// Own axis across which a source is reflected for a place that mirrors, so that the placement turns least
/// against `own`; of equal ones the first.
Axis axis_of_image(const Similarity& own, const Similarity& mirrored) {
  const auto nearness = [&](Axis axis) {
    const Similarity place = place_of_reflected(mirrored, static_cast<int>(index_of(axis)));
    return std::abs((own.rotation.conjugate() * place.rotation).w());
  };
  Axis best = Axis::x;
  for (const Axis axis : {Axis::y, Axis::z})
    if (nearness(axis) > nearness(best) + 1e-12) best = axis;
  return best;
}

/// The object at one of its places alone, with a reflected source where the place mirrors.
Result<Object> object_at_place(const Object& object, const Similarity& place) {
  Object out = object;
  out.transform = place;
  if (place.mirrors()) {
    const Axis own = axis_of_image(object.transform, place);
    auto source = mirrored_source(object, own);
    if (!source) return source.error();
    out.source = std::move(source).value();
    out.transform = place_of_reflected(place, static_cast<int>(index_of(own)));
  }
  const auto placed = detail::checked_transform(out.transform);
  if (!placed) return placed.error();
  out.transform = *placed;
  return out;
}

/// Moves objects along an axis, each by its own distance.
Result<Document> moved_along(const Document& document, const std::map<ObjectId, double>& distances,
                             Axis axis) {
  Document out = document;
  std::size_t found = 0;
  for (auto& object : out.objects) {
    const auto distance = distances.find(object->id);
    if (distance == distances.end()) continue;
    ++found;
    if (distance->second == 0) continue;
    Transformation move;
    move.translation = distance->second * Vector3::Unit(index_of(axis));
    auto moved = transformed_alone(*object, move, Vector3::Zero());
    if (!moved) return moved.error();
    object = std::make_shared<const Object>(std::move(moved).value());
  }
  if (found == distances.size()) return out;
  for (const auto& [id, distance] : distances)
    if (!document.find(id)) return detail::unknown_object(id);
  return out;
}

Result<Done> check_sized(const Document& document, std::span<const SizedObject> objects, std::size_t least,
                         const char* too_few) {
  if (objects.size() < least)
    return make_error(e_few_objects, too_few, "Choose more objects. Press 4 and click them with Shift.");
  for (const SizedObject& sized : objects) {
    if (!sized.box.isEmpty() && sized.box.min().allFinite() && sized.box.max().allFinite()) continue;
    const Object* object = document.find(sized.id);
    if (!object) return detail::unknown_object(sized.id);
    return make_error(e_object_extent, "The object \"" + object->name + "\" has no extent.",
                      "Leave it out of the selection.", element_of(sized.id));
  }
  return Done{};
}

/// Distance by which a side of a box at `from` is to move to `to`; zero where that is but rounding.
double distance_to_move(const Eigen::AlignedBox3d& box, Axis axis, double from, double to) {
  const Eigen::Index along = index_of(axis);
  const double size = std::max({std::abs(box.min()[along]), std::abs(box.max()[along]), std::abs(to)});
  return std::abs(to - from) <= rounding_share * size ? 0 : to - from;
}

double place_of_side(const Eigen::AlignedBox3d& box, Axis axis, BoxSide side) {
  const double low = box.min()[index_of(axis)], high = box.max()[index_of(axis)];
  if (side == BoxSide::minimum) return low;
  return side == BoxSide::maximum ? high : low + (high - low) / 2;
}

}  // namespace

Result<CopyArray> row_of_copies(int count, const Vector3& step) {
  if (count < least_places || count > most_places) return wrong_count(count);
  if (!step.allFinite() || step.isZero(0))
    return make_error(e_array_step, "The copies would lie on each other.",
                      "Use a step that is not zero along all axes.");
  return CopyArray(RowOfCopies{count, step});
}

Result<AddedObjects> array_in_row(const Document& document, std::span<const ObjectId> objects, int count,
                                  const Vector3& step) {
  if (objects.empty()) return nothing_to_arrange();
  if (const auto row = row_of_copies(count, step); !row) return row.error();
  return duplicate_objects(document, objects, static_cast<std::size_t>(count - 1),
                           [&](const Object& copy, std::size_t number) {
                             Transformation move;
                             move.translation = static_cast<double>(number) * step;
                             return transformed_alone(copy, move, Vector3::Zero());
                           });
}

Result<CopyArray> ring_of_copies(int count, const RingAxis& axis, double degrees) {
  if (count < least_places || count > most_places) return wrong_count(count);
  const double length = axis.direction.stableNorm();
  if (!(length > 0) || !std::isfinite(length) || !axis.point.allFinite())
    return make_error(e_array_axis, "The axis has no direction.", "Use a direction that is not zero.");
  if (degrees == 0 || !(std::abs(degrees) <= full_turn))
    return make_error(e_array_angle, "The copies cannot be turned by this angle.",
                      "Use an angle from -360 to 360 degrees that is not zero.");
  return CopyArray(RingOfCopies{count, axis.point, axis.direction / length, degrees});
}

Result<AddedObjects> array_around_axis(const Document& document, std::span<const ObjectId> objects, int count,
                                       const RingAxis& axis, double degrees) {
  if (objects.empty()) return nothing_to_arrange();
  if (const auto ring = ring_of_copies(count, axis, degrees); !ring) return ring.error();
  const Vector3 direction = axis.direction / axis.direction.stableNorm();
  const bool closed = std::abs(degrees) == full_turn;
  const double parts = closed ? count : count - 1;
  return duplicate_objects(document, objects, static_cast<std::size_t>(count - 1),
                           [&](const Object& copy, std::size_t number) {
                             Transformation turn;
                             turn.axis = direction;
                             turn.degrees = degrees * static_cast<double>(number) / parts;
                             return transformed_alone(copy, turn, axis.point);
                           });
}

Result<std::vector<double>> ways_along(const ArcLengthCurve& curve, const CurveLayout& layout) {
  if (!layout.spacing && (layout.count < least_places || layout.count > most_places))
    return wrong_count(layout.count);
  const double length = curve.length();
  if (!std::isfinite(layout.offset) || (!curve.closed() && layout.offset < 0))
    return make_error(e_array_offset, "The first place would lie before the curve's beginning.",
                      "Use an offset that is not below zero.");
  const double room = curve.closed() ? length : length - layout.offset;
  if (!(room > least_room * length))
    return make_error(e_curve_short, "The curve is shorter than the offset.",
                      "Use a smaller offset or spacing, or a longer curve.");
  double step = room / (curve.closed() ? layout.count : layout.count - 1);
  double count = layout.count;
  if (layout.spacing) {
    step = *layout.spacing;
    if (!(step > 0) || !std::isfinite(step))
      return make_error(e_array_spacing, "The copies would lie on each other.",
                        "Use a spacing that is above zero.");
    const double steps = room / step;
    count = curve.closed() ? std::ceil(steps * (1 - least_room)) : std::floor(steps * (1 + least_room)) + 1;
    if (count < least_places)
      return make_error(e_curve_short, "The curve is shorter than the spacing.",
                        "Use a smaller offset or spacing, or a longer curve.");
    if (count > most_places)
      return make_error(e_array_spacing, "More than 10,000 copies would fit on the curve.",
                        "Use a larger spacing.");
  }
  std::vector<double> out;
  for (int i = 0; i < static_cast<int>(count); ++i) out.push_back(layout.offset + i * step);
  if (!curve.closed()) out.back() = std::min(out.back(), length);
  return out;
}

Result<AddedObjects> array_along_curve(const Document& document, std::span<const ObjectId> objects,
                                       const ArcLengthCurve& curve, const CurveLayout& layout) {
  if (objects.empty()) return nothing_to_arrange();
  const auto ways = ways_along(curve, layout);
  if (!ways) return ways.error();
  const std::vector<ArcLengthCurve::Place> places = places_along(curve, *ways);
  const auto turns = turns_along(places, layout.turning);
  const Vector3 pivot = layout.carried.value_or(places[0].position);
  auto added =
      duplicate_objects(document, objects, places.size() - 1, [&](const Object& copy, std::size_t number) {
        const Eigen::AngleAxisd turn(turns[number]);
        Transformation change;
        change.axis = turn.axis();
        change.degrees = turn.angle() * degrees_per_radian;
        change.translation = places[number].position - pivot;
        return transformed_alone(copy, change, pivot);
      });
  if (!added || !layout.carried) return added;
  auto moved = moved_all(added->document, objects, places[0].position - pivot);
  if (!moved) return moved.error();
  return AddedObjects{std::move(moved).value(), std::move(added->ids)};
}

Result<Document> live_copies_along_curve(const Document& document, std::span<const ObjectId> objects,
                                         const ArcLengthCurve& curve, const CurveLayout& layout) {
  if (objects.empty()) return nothing_to_arrange();
  const auto ways = ways_along(curve, layout);
  if (!ways) return ways.error();
  const std::vector<ArcLengthCurve::Place> places = places_along(curve, *ways);
  const auto turns = turns_along(places, layout.turning);
  const Vector3 first = places[0].position;
  auto begun =
      layout.carried ? moved_all(document, objects, first - *layout.carried) : Result<Document>(document);
  if (!begun) return begun;
  ListOfCopies list;
  for (std::size_t k = 1; k < places.size(); ++k)
    list.places.push_back({turns[k], 1, places[k].position - turns[k] * first});
  return add_live_copies(*begun, objects, list);
}

CopyArray mirror_of_copies(const MirrorPlane& plane) {
  return MirrorOfCopies{plane.point(), plane.normal()};
}

Result<AddedObjects> copies_to_objects(const Document& document, std::span<const ObjectId> objects) {
  AddedObjects out{document, {}};
  for (const ObjectId id : objects) {
    const std::shared_ptr<const Object> object = out.document.find_shared(id);
    if (!object) return detail::unknown_object(id);
    if (object->copies->empty()) continue;
    auto single = set_copies(out.document, id, {});
    if (!single) return single.error();
    const std::vector<Similarity> places = places_of(*object);
    auto added = duplicate_objects(
        *single, std::span(&id, 1), places.size() - 1,
        [&](const Object& copy, std::size_t number) { return object_at_place(copy, places[number]); });
    if (!added) return added.error();
    out.document = std::move(added->document);
    out.ids.insert(out.ids.end(), added->ids.begin(), added->ids.end());
  }
  if (out.ids.empty())
    return make_error(e_no_live_copies, "What is chosen has no live copies.",
                      "Choose an object with live copies.");
  return out;
}

Result<AddedObjects> mirrored_copies(const Document& document, std::span<const ObjectId> objects,
                                     const MirrorPlane& plane) {
  if (objects.empty()) return nothing_to_arrange();
  for (const ObjectId id : objects) {
    const Object* object = document.find(id);
    if (object && !can_be_mirrored(*object))
      return make_error(e_no_mirror_image, "The object \"" + object->name + "\" has no mirror image.",
                        "Leave it out of the selection.", element_of(id));
  }
  return duplicate_objects(document, objects, 1,
                           [&](const Object& copy, std::size_t) { return image_of(copy, plane); });
}

Result<Document> align_objects(const Document& document, std::span<const SizedObject> objects, ObjectId fixed,
                               Axis axis, BoxSide side) {
  if (const auto checked = check_sized(document, objects, 2, "Aligning takes two objects."); !checked)
    return checked.error();
  const auto rule = std::find_if(objects.begin(), objects.end(),
                                 [&](const SizedObject& object) { return object.id == fixed; });
  HARIKO_ASSERT(rule != objects.end(), "the fixed object is one of those that are aligned");
  const double place = place_of_side(rule->box, axis, side);
  std::map<ObjectId, double> distances;
  for (const SizedObject& object : objects)
    if (!(object.id == fixed))
      distances[object.id] = distance_to_move(object.box, axis, place_of_side(object.box, axis, side), place);
  return moved_along(document, distances, axis);
}

Result<Document> distribute_objects(const Document& document, std::span<const SizedObject> objects,
                                    Axis axis) {
  if (const auto checked = check_sized(document, objects, 3, "Distributing takes three objects."); !checked)
    return checked.error();
  std::vector<const SizedObject*> order;
  for (const SizedObject& object : objects) order.push_back(&object);
  std::stable_sort(order.begin(), order.end(), [&](const SizedObject* a, const SizedObject* b) {
    return place_of_side(a->box, axis, BoxSide::centre) < place_of_side(b->box, axis, BoxSide::centre);
  });
  const Eigen::Index along = index_of(axis);
  const std::span inner(order.begin() + 1, order.end() - 1);
  const double begin = order.front()->box.max()[along], end = order.back()->box.min()[along];
  double filled = 0;
  for (const SizedObject* object : inner) filled += object->box.sizes()[along];
  const double gap = (end - begin - filled) / static_cast<double>(order.size() - 1);
  std::map<ObjectId, double> distances;
  double place = begin;
  for (const SizedObject* object : inner) {
    place += gap;
    distances[object->id] = distance_to_move(object->box, axis, object->box.min()[along], place);
    place += object->box.sizes()[along];
  }
  return moved_along(document, distances, axis);
}

}  // namespace hariko
