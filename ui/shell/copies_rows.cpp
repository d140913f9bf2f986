#include "ui/shell/copies_rows.hpp"

#include <algorithm>
#include <functional>
#include <variant>

#include "core/document/edits/edit_copies.hpp"
#include "ui/base/theme.hpp"
#include "ui/polyhedron/element_rows.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

constexpr const char* live_copies_step = translatable("Live copies");

template <class Kind>
const Kind* outermost_array(const Object& object) {
  return object.copies->empty() ? nullptr : std::get_if<Kind>(&object.copies->back());
}

template <class Kind>
bool all_have_array(const Objects& objects) {
  return std::ranges::all_of(objects,
                             [](const auto& object) { return outermost_array<Kind>(*object) != nullptr; });
}

/// Changes the outermost arrays of objects, all of which are of one kind.
template <class Kind>
Result<Document> change_outermost(const Document& document, const Objects& objects,
                                  const std::function<void(const Object&, Kind&)>& change) {
  Result<Document> result = document;
  for (const auto& object : objects) {
    const Object* found = result ? result->find(object->id) : nullptr;
    if (!found || !outermost_array<Kind>(*found)) continue;
    LiveCopies copies = *found->copies;
    change(*found, std::get<Kind>(copies.back()));
    result = set_copies(*result, object->id, std::move(copies));
  }
  return result;
}

template <class Kind>
void copies_count_row(PanelContext& context, const Objects& objects) {
  const Quantity count = whole_quantity(least_places, most_places, least_places);
  value_row(context,
            {"copies_count", "Total count", "How many places the array has, the object's own included",
             live_copies_step, count},
            common<double>(objects,
                           [](const auto& object) { return double(outermost_array<Kind>(*object)->count); }),
            [objects, count](const Document& document, const ValueChange& change) {
              return change_outermost<Kind>(document, objects, [&](const Object&, Kind& array) {
                array.count = static_cast<int>(change.apply(count, array.count));
              });
            });
}

/// Steps along the objects' own axes, in the document's unit.
void copies_step_row(PanelContext& context, const Objects& objects) {
  const Quantity length = length_quantity(context.editor.document().unit, model_size(context.editor));
  std::array<std::optional<double>, 3> steps;
  for (int axis = 0; axis < 3; ++axis)
    steps[static_cast<std::size_t>(axis)] = common<double>(objects, [&](const auto& object) {
      return outermost_array<RowOfCopies>(*object)->step[axis] * object->transform.scale;
    });
  vector_row(context,
             {{"copies_step.x", "copies_step.y", "copies_step.z"},
              "Step",
              "From place to place, along the object's own axes",
              live_copies_step,
              length},
             steps, [objects, length](const Document& document, int axis, const ValueChange& change) {
               return change_outermost<RowOfCopies>(
                   document, objects, [&](const Object& object, RowOfCopies& row) {
                     const double scale = object.transform.scale;
                     row.step[axis] = change.apply(length, row.step[axis] * scale) / scale;
                   });
             });
}

void copies_angle_row(PanelContext& context, const Objects& objects) {
  Quantity angle = angle_quantity();
  angle.low = -360;
  angle.high = 360;
  angle.standard = 360;
  value_row(
      context,
      {"copies_angle", "Angle", "From the first place to the last; a full turn spaces them evenly round",
       live_copies_step, angle},
      common<double>(objects,
                     [](const auto& object) { return outermost_array<RingOfCopies>(*object)->degrees; }),
      [objects, angle](const Document& document, const ValueChange& change) {
        return change_outermost<RingOfCopies>(document, objects, [&](const Object&, RingOfCopies& ring) {
          ring.degrees = change.apply(angle, ring.degrees);
        });
      });
}

/// Distance of the plane from the object's own zero, along its normal, in the document's unit.
double distance_of_plane(const Object& object, const MirrorOfCopies& mirror) {
  return mirror.normal.stableNormalized().dot(mirror.point) * object.transform.scale;
}

void copies_plane_row(PanelContext& context, const Objects& objects) {
  const Quantity length = length_quantity(context.editor.document().unit, model_size(context.editor));
  value_row(context,
            {"copies_plane", "Distance", "From the object's own zero to the plane of its mirror image",
             live_copies_step, length},
            common<double>(objects,
                           [](const auto& object) {
                             return distance_of_plane(*object, *outermost_array<MirrorOfCopies>(*object));
                           }),
            [objects, length](const Document& document, const ValueChange& change) {
              return change_outermost<MirrorOfCopies>(
                  document, objects, [&](const Object& object, MirrorOfCopies& mirror) {
                    const double distance = change.apply(length, distance_of_plane(object, mirror));
                    mirror.point = distance / object.transform.scale * mirror.normal.stableNormalized();
                  });
            });
}

}  // namespace

void copies_rows(PanelContext& context, const Objects& objects) {
  if (objects.empty() ||
      std::ranges::any_of(objects, [](const auto& object) { return object->copies->empty(); }))
    return;
  std::size_t places = 0;
  for (const auto& object : objects) places += place_count(*object);
  coloured_lines(palette().dim_text,
                 fill(context.tr("Live copies: {0} places in all"), {std::to_string(places)}));
  if (all_have_array<RowOfCopies>(objects)) {
    copies_count_row<RowOfCopies>(context, objects);
    copies_step_row(context, objects);
  } else if (all_have_array<RingOfCopies>(objects)) {
    copies_count_row<RingOfCopies>(context, objects);
    copies_angle_row(context, objects);
  } else if (all_have_array<MirrorOfCopies>(objects)) {
    copies_plane_row(context, objects);
  }
}

}  // namespace hariko
