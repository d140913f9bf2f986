#include "ui/solids/new_solids.hpp"

#include <array>

#include "core/document/edits/edit_solids.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "core/modeling/objects/primitives.hpp"
#include "ui/editor/new_object.hpp"

namespace hariko {

namespace {

using Numbers = std::vector<OperationNumber>;

OperationNumber length(const char* id, const char* label, double value) {
  return {id, label, value, min_primitive_length, max_primitive_length, false};
}

Solid of_kind(SolidKind kind) {
  Solid solid;
  solid.kind = kind;
  return solid;
}

std::vector<NewSolid> plain_solids() {
  return {
      {"box", translatable("Box"), translatable("Add box"), "A box round which the surface goes.",
       [](double r) {
         return Numbers{length("width", translatable("Width"), 2 * r),
                        length("depth", translatable("Depth"), 2 * r),
                        length("height", translatable("Height"), 2 * r)};
       },
       [](std::span<const OperationNumber> n) {
         Solid solid = of_kind(SolidKind::box);
         solid.size = {n[0].value, n[1].value, n[2].value};
         return solid;
       }},
      {"sphere", translatable("Sphere"), translatable("Add sphere"), "A ball round which the surface goes.",
       [](double r) { return Numbers{length("radius", translatable("Radius"), r)}; },
       [](std::span<const OperationNumber> n) {
         Solid solid = of_kind(SolidKind::sphere);
         solid.radius = n[0].value;
         return solid;
       }},
      {"capsule", translatable("Capsule"), translatable("Add capsule"),
       "A rod with round ends round which the surface goes.",
       [](double r) {
         return Numbers{length("radius", translatable("Radius"), 0.5 * r),
                        length("length", translatable("Length"), 2 * r)};
       },
       [](std::span<const OperationNumber> n) {
         Solid solid = of_kind(SolidKind::capsule);
         solid.radius = n[0].value;
         solid.length = n[1].value;
         return solid;
       }},
      {"torus", translatable("Torus"), translatable("Add torus"), "A ring round which the surface goes.",
       [](double r) {
         return Numbers{length("ring_radius", translatable("Ring radius"), r),
                        length("tube_radius", translatable("Tube radius"), 0.3 * r)};
       },
       [](std::span<const OperationNumber> n) {
         Solid solid = of_kind(SolidKind::torus);
         solid.radius = n[0].value;
         solid.tube = n[1].value;
         return solid;
       }},
  };
}

/// Solids of a radius and a height; prisms and pyramids have sides, too.
NewSolid upright(const char* name, const char* label, const char* step, const char* help, SolidKind kind) {
  const bool sided = kind == SolidKind::prism || kind == SolidKind::pyramid;
  return {name,
          label,
          step,
          help,
          [sided, kind](double r) {
            Numbers out{length("radius", translatable("Radius"), r),
                        length("height", translatable("Height"), 2 * r)};
            if (sided)
              out.push_back({"sides", translatable("Sides"), kind == SolidKind::prism ? 6.0 : 4.0, 3,
                             double(max_solid_sides), true});
            return out;
          },
          [sided, kind](std::span<const OperationNumber> n) {
            Solid solid = of_kind(kind);
            solid.radius = n[0].value;
            solid.height = n[1].value;
            if (sided) solid.sides = static_cast<std::uint32_t>(n[2].value);
            return solid;
          }};
}

/// The document with a new object of one solid.
Result<Added> added_solids(const Editor& editor, const Solid& solid, const Similarity& place) {
  const Document& document = editor.history.current();
  EnvelopeInput input;
  input.solids.push_back(solid);
  choose_ball(input);
  if (const auto checked = check_envelope(input); !checked) return checked.error();
  return add_object(document, free_name(document, editor.language(translatable("Solids"))),
                    SolidsSource{std::move(input), {}}, place, solids_display());
}

}  // namespace

std::vector<NewSolid> new_solids() {
  std::vector<NewSolid> out = plain_solids();
  out.push_back(upright("cylinder", translatable("Cylinder"), translatable("Add cylinder"),
                        "A cylinder round which the surface goes.", SolidKind::cylinder));
  out.push_back(upright("cone", translatable("Cone"), translatable("Add cone"),
                        "A cone round which the surface goes.", SolidKind::cone));
  out.push_back(upright("prism", translatable("Prism"), translatable("Add prism"),
                        "A prism round which the surface goes.", SolidKind::prism));
  out.push_back(upright("pyramid", translatable("Pyramid"), translatable("Add pyramid"),
                        "A pyramid round which the surface goes.", SolidKind::pyramid));
  return out;
}

const Object* active_solids(const Editor& editor) {
  const Object* active = editor.has_document ? editor.active_object() : nullptr;
  return active && active->solids() && !active->locked ? active : nullptr;
}

void select_solids(Editor& editor, ObjectId object, std::span<const std::uint32_t> ids) {
  if (editor.mode == ElementMode::object) editor.mode = ElementMode::vertex;
  ElementSelection solids;
  for (const std::uint32_t id : ids) solids.vertices.insert(VertexId{id});
  editor.selection.clear_objects();
  editor.selection.select(object, solids, Selection::How::replace);
  editor.selection.active = object;
}

bool add_new_solid(Editor& editor, const NewSolid& shape, std::vector<OperationNumber> numbers,
                   std::function<Solid(Solid)> put, const Similarity& place) {
  // Its numbers are those of the selected solid: they can be changed at any time, not only right afterwards.
  const Document& document = editor.history.current();
  const Solid solid = put(shape.make(numbers));
  if (const Object* object = active_solids(editor)) {
    const ObjectId target = object->id;
    const std::uint32_t id = next_solid_id(*object->solids()->input);
    if (!editor.commit(add_solid(document, target, solid), shape.step)) return false;
    select_solids(editor, target, std::array{id});
    return true;
  }
  const bool first = document.objects.empty();
  const auto added = added_solids(editor, solid, place);
  if (!added) return editor.notify(added.error()), false;
  if (!editor.commit(added->document, shape.step)) return false;
  select_solids(editor, added->id, std::array{std::uint32_t(0)});
  if (first) editor.wants_framing = true;
  return true;
}

Result<Document> with_new_solid(const Editor& editor, const Solid& solid) {
  const Document& document = editor.history.current();
  if (const Object* object = active_solids(editor)) return add_solid(document, object->id, solid);
  auto added = added_solids(editor, solid, {});
  if (!added) return added.error();
  return std::move(added).value().document;
}

}  // namespace hariko
