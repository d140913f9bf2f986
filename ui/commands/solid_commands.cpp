// Commands of the Solids menu: solids round which a surface goes. They are added to the active object where
// it is made of solids, else they begin a new one. Their numbers can be adjusted right afterwards.

#include <algorithm>

#include "core/document/edit_solids.hpp"
#include "core/modeling/primitives.hpp"
#include "ui/commands/command_host.hpp"
#include "ui/commands/new_object.hpp"
#include "ui/operations.hpp"

namespace hariko {

namespace {

using Numbers = std::vector<OperationNumber>;
using MakeSolid = std::function<Solid(std::span<const OperationNumber>)>;

struct NewSolid {
  const char *id, *label, *step, *help;
  std::function<Numbers(double radius)> numbers;  ///< to begin with
  MakeSolid make;
};

OperationNumber length(const char* id, const char* label, double value) {
  return {id, label, value, min_primitive_length, max_primitive_length, false};
}

Solid of_kind(SolidKind kind) {
  Solid solid;
  solid.kind = kind;
  return solid;
}

const Object* active_solids(const Editor& editor) {
  const Object* active = editor.has_document ? editor.active_object() : nullptr;
  return active && active->solids() && !active->locked ? active : nullptr;
}

/// Selects solids of an object, which shows where they can be seen.
void select_solids(Editor& editor, ObjectId object, std::span<const std::uint32_t> ids) {
  if (editor.mode == ElementMode::object) editor.mode = ElementMode::vertex;
  ElementSelection solids;
  for (const std::uint32_t id : ids) solids.vertices.insert(VertexId{id});
  editor.selection.clear_objects();
  editor.selection.select(object, solids, Selection::How::replace);
  editor.selection.active = object;
}

/// Beside the solids that are there: half of it stands out on the right.
void add_to(Editor& editor, const Object& object, const NewSolid& shape, double radius) {
  Eigen::AlignedBox3d box;
  for (const Solid& solid : object.solids()->input->solids) box.extend(box_of(solid));
  const Vector3 centre = box.center();
  const Vector3 place(box.max().x(), centre.y(), centre.z());
  const std::uint32_t id = next_solid_id(*object.solids()->input);
  const auto add = [object = object.id, place, make = shape.make](
                       const Document& document,
                       std::span<const OperationNumber> chosen) -> Result<OperationResult> {
    Solid solid = make(chosen);
    solid.position = place;
    auto added = add_solid(document, object, std::move(solid));
    if (!added) return added.error();
    return OperationResult{std::move(added).value(), object};
  };
  const ObjectId target = object.id;
  if (editor.last_operation.run(editor, shape.step, shape.numbers(radius / object.transform.scale), add))
    select_solids(editor, target, std::array{id});
}

void begin_with(Editor& editor, const NewSolid& shape, double radius) {
  const bool first = editor.document().objects.empty();
  Similarity place;
  if (!first) place.translation = editor.camera().target;
  const auto add = [place, name = free_name(editor.document(), editor.language(translatable("Solids"))),
                    make = shape.make](const Document& document,
                                       std::span<const OperationNumber> chosen) -> Result<OperationResult> {
    EnvelopeInput input;
    input.solids.push_back(make(chosen));
    if (const auto checked = check_envelope(input); !checked) return checked.error();
    auto added = add_object(document, name, SolidsSource{std::move(input), {}}, place);
    if (!added) return added.error();
    return OperationResult{std::move(added).value().document, added->id};
  };
  if (!editor.last_operation.run(editor, shape.step, shape.numbers(radius), add)) return;
  select_solids(editor, editor.selection.active, std::array{std::uint32_t(0)});
  if (first) editor.wants_framing = true;
}

void place(Editor& editor, const NewSolid& shape) {
  begin_document(editor);
  const double radius = new_object_radius(editor);
  if (const Object* object = active_solids(editor))
    add_to(editor, *object, shape, radius);
  else
    begin_with(editor, shape, radius);
}

/// Copies of the selected solids, moved to the right by their width and selected.
void duplicate_solids(Editor& editor) {
  const ObjectId object = editor.selection.active;
  std::vector<std::uint32_t> copies;
  const std::set<VertexId> selected = editor.selection.of(object).vertices;
  const auto result = change_envelope(editor.history.current(), object, [&](EnvelopeInput& input) {
    Eigen::AlignedBox3d box;
    for (const Solid& solid : input.solids)
      if (selected.contains(VertexId{solid.id})) box.extend(box_of(solid));
    const std::vector<Solid> before = input.solids;
    for (Solid solid : before) {
      if (!selected.contains(VertexId{solid.id})) continue;
      solid.id = next_solid_id(input);
      solid.position.x() += box.sizes().x();
      copies.push_back(solid.id);
      input.solids.push_back(std::move(solid));
    }
  });
  if (editor.commit(result, copies.size() == 1
                                ? translatable("Duplicate solid")
                                : fill("Duplicate {0} solids", {std::to_string(copies.size())})))
    select_solids(editor, object, copies);
}

std::vector<NewSolid> plain_solids() {
  return {
      {"solid.box", translatable("Box"), translatable("Add box"), "A box round which the surface goes.",
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
      {"solid.sphere", translatable("Sphere"), translatable("Add sphere"),
       "A ball round which the surface goes.",
       [](double r) { return Numbers{length("radius", translatable("Radius"), r)}; },
       [](std::span<const OperationNumber> n) {
         Solid solid = of_kind(SolidKind::sphere);
         solid.radius = n[0].value;
         return solid;
       }},
      {"solid.capsule", translatable("Capsule"), translatable("Add capsule"),
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
      {"solid.torus", translatable("Torus"), translatable("Add torus"),
       "A ring round which the surface goes.",
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
NewSolid upright(const char* id, const char* label, const char* step, const char* help, SolidKind kind) {
  const bool sided = kind == SolidKind::prism || kind == SolidKind::pyramid;
  return {id,
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

std::vector<NewSolid> all_solids() {
  std::vector<NewSolid> out = plain_solids();
  out.push_back(upright("solid.cylinder", translatable("Cylinder"), translatable("Add cylinder"),
                        "A cylinder round which the surface goes.", SolidKind::cylinder));
  out.push_back(upright("solid.cone", translatable("Cone"), translatable("Add cone"),
                        "A cone round which the surface goes.", SolidKind::cone));
  out.push_back(upright("solid.prism", translatable("Prism"), translatable("Add prism"),
                        "A prism round which the surface goes.", SolidKind::prism));
  out.push_back(upright("solid.pyramid", translatable("Pyramid"), translatable("Add pyramid"),
                        "A pyramid round which the surface goes.", SolidKind::pyramid));
  return out;
}

}  // namespace

void add_solid_commands(CommandHost& host) {
  Editor& editor = host.editor;
  for (NewSolid& shape : all_solids()) {
    const char *id = shape.id, *label = shape.label, *help = shape.help;
    host.table.add({id, "Solids", label, help, "", "", true, false,
                    [&editor, shape = std::move(shape)] { place(editor, shape); }});
  }
  host.table.add({"solid.duplicate", "Solids", "Duplicate solid", "Copy the selected solids to their right.",
                  "", "", true, true, [&editor] { duplicate_solids(editor); },
                  [&editor, object = needs_object(editor)]() -> Reason {
                    if (auto reason = object()) return reason;
                    const Object& active = *editor.active_object();
                    if (active.solids() && editor.mode != ElementMode::object &&
                        !editor.selection.of(active.id).empty())
                      return {};
                    return translatable("No solid is selected. Click one.");
                  }});
}

}  // namespace hariko
