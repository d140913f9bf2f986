// Commands of the Add menu: primitives to start from. Their numbers can be adjusted right afterwards.

#include <string>

#include "core/document/edits/edits.hpp"
#include "core/modeling/objects/parabolic_grid.hpp"
#include "core/modeling/objects/primitives.hpp"
#include "core/skinning/columns/simple_skin.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/last_operation.hpp"
#include "ui/editor/new_object.hpp"

namespace hariko {

namespace {

const std::string platonic_menu = std::string("Add") + "/" + translatable("Platonic solids");
constexpr double least = min_primitive_length, most = max_primitive_length;

using MakeMesh = std::function<Result<PolygonMesh>(std::span<const OperationNumber>)>;
using MakeSource = std::function<Result<Source>(std::span<const OperationNumber>)>;
/// The numbers to begin with, for an object of about this radius.
using Numbers = std::function<std::vector<OperationNumber>(double radius)>;
/// Puts a shape into the table: id, menu, label, step, help.
using AddShape = std::function<void(const char*, const std::string&, const char*, const char*, const char*,
                                    Numbers, MakeMesh)>;

int count_of(const OperationNumber& number) {
  return static_cast<int>(number.value);
}

OperationNumber length(const char* id, const char* label, double value) {
  return {id, label, value, least, most, false};
}

OperationNumber count(const char* id, const char* label, int value, int low, int high) {
  return {id, label, double(value), double(low), double(high), true};
}

/// Object to be added: its command, its name, the step, its numbers and what they make.
struct NewPrimitive {
  const char *id, *name, *step;
  Numbers numbers;
  MakeSource make;
};

MakeOperation adding(const NewPrimitive& primitive, const Similarity& place, const std::string& name) {
  return [place, name, make = primitive.make](
             const Document& document, std::span<const OperationNumber> chosen) -> Result<OperationResult> {
    Result<Source> source = make(chosen);
    if (!source) return source.error();
    Result<Added> added = add_object(document, name, std::move(source).value(), place);
    if (!added) return added.error();
    return OperationResult{std::move(added).value().document, added->id};
  };
}

std::string name_for_new(const Editor& editor, const NewPrimitive& primitive) {
  return free_name(editor.document(), editor.language(primitive.name));
}

WriteOperation written_primitive(const NewPrimitive& primitive, const Similarity& place,
                                 const std::string& name) {
  return [id = std::string(primitive.id), place, name](std::span<const OperationNumber> numbers) {
    WrittenCommand step{id, written_numbers(numbers)};
    for (WrittenArgument& argument : written_place(place)) step.arguments.push_back(std::move(argument));
    step.arguments.push_back(written("name", name));
    return std::vector{std::move(step)};
  };
}

/// Makes the step; its numbers can be adjusted afterwards. False, with a notice, when it is refused.
bool put_primitive(Editor& editor, const NewPrimitive& primitive, std::vector<OperationNumber> numbers,
                   const Similarity& place, const std::string& name) {
  OperationStep step{primitive.step, std::move(numbers), adding(primitive, place, name), {}};
  step.begin = [primitive](const Editor& now) -> Result<BegunOperation> {
    const Similarity there = place_for_new(now);
    const std::string free = name_for_new(now, primitive);
    return BegunOperation{adding(primitive, there, free), {}, written_primitive(primitive, there, free)};
  };
  step.written = written_primitive(primitive, place, name);
  return editor.last_operation.run(editor, std::move(step));
}

void add_primitive(CommandHost& host, const NewPrimitive& primitive) {
  Editor& editor = host.editor;
  begin_document(editor);
  const bool first = editor.document().objects.empty();
  if (!put_primitive(editor, primitive, primitive.numbers(new_object_radius(editor)), place_for_new(editor),
                     name_for_new(editor, primitive)))
    return;
  if (first)
    editor.wants_framing = true;
  else
    bring_into_sight(editor, editor.selection.active);
}

/// Use in scripts: sizes do not depend on what is there.
ScriptUse in_scripts(CommandHost& host, const NewPrimitive& primitive) {
  const std::vector<OperationNumber> usual = primitive.numbers(first_object_radius(Unit::millimetre));
  ScriptUse use;
  use.arguments = arguments_of(usual);
  add_place_arguments(use.arguments);
  use.arguments.push_back(optional(text_argument("name", translatable("Name"))));
  use.run = [&editor = host.editor, primitive, usual](const Arguments& arguments) {
    begin_document(editor);
    const std::string name = arguments.has("name") ? arguments.text("name") : name_for_new(editor, primitive);
    const Similarity place = given_place(arguments);
    if (!put_primitive(editor, primitive, with_values(usual, arguments), place, name)) return;
    const ObjectId id = editor.selection.active;
    editor.selection.clear_objects();
    editor.selection.select({id, {Element::Kind::object, id.value}}, Selection::How::add);
    editor.selection.active = id;
  };
  return use;
}

MakeSource from_mesh(MakeMesh make) {
  return [make = std::move(make)](std::span<const OperationNumber> chosen) -> Result<Source> {
    Result<PolygonMesh> mesh = make(chosen);
    if (!mesh) return mesh.error();
    Result<PolyhedronSource> source = PolyhedronSource::from_mesh(std::move(mesh).value());
    if (!source) return source.error();
    return Source(as_new(std::move(source).value()));
  };
}

void add_patches(CommandHost& host) {
  const Numbers numbers = [](double r) {
    return std::vector{count("columns", translatable("Columns"), 1, 1, max_net_patches),
                       count("rows", translatable("Rows"), 1, 1, max_net_patches),
                       length("width", translatable("Width"), 2 * r),
                       length("depth", translatable("Depth"), 2 * r),
                       OperationNumber{"arch", translatable("Arch"), 0, 0, most, false}};
  };
  const MakeSource make = [](std::span<const OperationNumber> n) -> Result<Source> {
    Result<PatchSource> source = PatchSource::from_net(
        parabolic_grid(Index(count_of(n[0])), Index(count_of(n[1])), n[2].value, n[3].value, n[4].value));
    if (!source) return source.error();
    return Source(std::move(source).value());
  };
  const NewPrimitive patches{"add.patches", "Bicubic patches", translatable("Add patches"), numbers, make};
  MenuRows(host.table, "Add")
      .add_edit("add.patches", "Bicubic patches",
                "A grid of bicubic patches, flat or arched, whose control points can be moved.",
                [&host, patches] { add_primitive(host, patches); }, {},
                {.contexts = Context::empty, .script = in_scripts(host, patches)});
}

void add_skin(CommandHost& host) {
  const Numbers numbers = [](double r) {
    return std::vector{
        length("length", translatable("Length"), 3 * r), length("width", translatable("Width"), 2 * r),
        length("height", translatable("Height"), r), count("points", translatable("Points"), 7, 3, 200)};
  };
  const MakeSource make = [](std::span<const OperationNumber> n) -> Result<Source> {
    return Source(SkinSource{arched_skin(n[0].value, n[1].value, n[2].value, count_of(n[3])), {}});
  };
  const NewPrimitive skin{"add.skin", "Skin", translatable("Add skin"), numbers, make};
  MenuRows(host.table, "Add")
      .add_edit("add.skin", "Skin", "Two sections on a path, and a surface over them.",
                [&host, skin] { add_primitive(host, skin); }, {},
                {.contexts = Context::empty, .script = in_scripts(host, skin)});
}

void add_solids(const AddShape& add) {
  add(
      "add.box", "Add", "Box", translatable("Add box"), "A box of six faces, or more.",
      [](double r) {
        return std::vector{length("width", translatable("Width"), 2 * r),
                           length("depth", translatable("Depth"), 2 * r),
                           length("height", translatable("Height"), 2 * r),
                           count("segments_x", translatable("Segments X"), 1, 1, max_box_segments),
                           count("segments_y", translatable("Segments Y"), 1, 1, max_box_segments),
                           count("segments_z", translatable("Segments Z"), 1, 1, max_box_segments)};
      },
      [](std::span<const OperationNumber> n) {
        return make_primitive(BoxShape{
            {n[0].value, n[1].value, n[2].value}, {count_of(n[3]), count_of(n[4]), count_of(n[5])}, {}});
      });
  const auto with_sides = [](int sides) {
    return [sides](double r) {
      return std::vector{count("sides", translatable("Sides"), sides, 3, max_primitive_sides),
                         length("radius", translatable("Radius"), r),
                         length("height", translatable("Height"), 2 * r)};
    };
  };
  add("add.prism", "Add", "Prism", translatable("Add prism"), "A prism of any number of sides.",
      with_sides(6), [](std::span<const OperationNumber> n) {
        return make_primitive(PrismShape{count_of(n[0]), n[1].value, n[2].value, {}});
      });
  add("add.pyramid", "Add", "Pyramid", translatable("Add pyramid"), "A pyramid of any number of sides.",
      with_sides(4), [](std::span<const OperationNumber> n) {
        return make_primitive(PyramidShape{count_of(n[0]), n[1].value, n[2].value, {}});
      });
}

void add_platonic(const AddShape& add) {
  const auto solid = [&](const char* id, const char* label, const char* step, const char* help,
                         PlatonicSolid kind) {
    add(
        id, platonic_menu, label, step, help,
        [](double r) { return std::vector{length("radius", translatable("Radius"), r)}; },
        [kind](std::span<const OperationNumber> n) {
          return make_primitive(PlatonicShape{kind, n[0].value, {}});
        });
  };
  solid("add.tetrahedron", "Tetrahedron", translatable("Add tetrahedron"), "Four triangles.",
        PlatonicSolid::tetrahedron);
  solid("add.cube", "Cube", translatable("Add cube"), "Six squares.", PlatonicSolid::cube);
  solid("add.octahedron", "Octahedron", translatable("Add octahedron"), "Eight triangles.",
        PlatonicSolid::octahedron);
  solid("add.dodecahedron", "Dodecahedron", translatable("Add dodecahedron"), "Twelve pentagons.",
        PlatonicSolid::dodecahedron);
  solid("add.icosahedron", "Icosahedron", translatable("Add icosahedron"), "Twenty triangles.",
        PlatonicSolid::icosahedron);
}

void add_round(const AddShape& add) {
  add(
      "add.torus", "Add", "Torus", translatable("Add torus"), "A ring of quads.",
      [](double r) {
        return std::vector{length("ring_radius", translatable("Ring radius"), r),
                           length("tube_radius", translatable("Tube radius"), 0.4 * r),
                           count("segments", translatable("Segments"), 8, 3, max_grid_segments),
                           count("sides", translatable("Sides"), 4, 3, max_grid_segments)};
      },
      [](std::span<const OperationNumber> n) {
        return make_primitive(TorusShape{n[0].value, n[1].value, count_of(n[2]), count_of(n[3]), {}});
      });
  add(
      "add.plane", "Add", "Plane", translatable("Add plane"), "An open sheet of quads on the ground.",
      [](double r) {
        return std::vector{length("width", translatable("Width"), 2 * r),
                           length("depth", translatable("Depth"), 2 * r),
                           count("columns", translatable("Columns"), 3, 1, max_grid_segments),
                           count("rows", translatable("Rows"), 3, 1, max_grid_segments)};
      },
      [](std::span<const OperationNumber> n) {
        return make_primitive(PlaneShape{n[0].value, n[1].value, count_of(n[2]), count_of(n[3])});
      });
  add(
      "add.sphere", "Add", "Sphere", translatable("Add sphere"), "A cage of nearly equal quads on a sphere.",
      [](double r) {
        return std::vector{length("radius", translatable("Radius"), r),
                           count("segments", translatable("Segments"), 2, 1, max_sphere_segments)};
      },
      [](std::span<const OperationNumber> n) {
        return make_primitive(SphereCageShape{n[0].value, count_of(n[1]), {}});
      });
  add(
      "add.icosphere", "Add", "Icosphere", translatable("Add icosphere"), "A cage of triangles on a sphere.",
      [](double r) {
        return std::vector{length("radius", translatable("Radius"), r),
                           count("level", translatable("Level"), 1, 0, max_icosphere_level)};
      },
      [](std::span<const OperationNumber> n) {
        return make_primitive(IcosphereShape{n[0].value, count_of(n[1]), {}});
      });
}

}  // namespace

void add_add_commands(CommandHost& host) {
  const auto add = [&host](const char* id, const std::string& menu, const char* label, const char* step,
                           const char* help, Numbers numbers, MakeMesh make) {
    const NewPrimitive primitive{id, label, step, std::move(numbers), from_mesh(std::move(make))};
    MenuRows(host.table, menu)
        .add_edit(id, label, help, [&host, primitive] { add_primitive(host, primitive); }, {},
                  {.contexts = Context::empty, .script = in_scripts(host, primitive)});
  };
  add_solids(add);
  add_round(add);
  add_platonic(add);
  add_patches(host);
  add_skin(host);
}

}  // namespace hariko
