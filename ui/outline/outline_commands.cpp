// Commands of the Outline menu: loops drawn, taken from borders, their points and normals, and the polyhedron
// that they become.

#include "core/document/edits/edits.hpp"
#include "core/gaussmap/outlines/border_outline.hpp"
#include "core/modeling/surfacing/convert_object.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/new_object.hpp"
#include "ui/editor/outlines.hpp"
#include "ui/outline/outline_handles.hpp"
#include "ui/view/view_panes.hpp"
#include "ui/view/viewport.hpp"

namespace hariko {

namespace {

WhyNot needs_outline(const Editor& editor) {
  return only_if(
      needs_object(editor), [&editor] { return active_outline(editor) != nullptr; },
      translatable("The chosen object is not an outline. Choose one in the list of objects."));
}

WhyNot needs_points(const Editor& editor) {
  return only_if(
      needs_outline(editor), [&editor] { return !selected_points(editor, *active_outline(editor)).empty(); },
      translatable("No points are selected. Press 1 and click one."));
}

WhyNot needs_surface(const Editor& editor) {
  return only_if(
      needs_object(editor),
      [&editor] {
        const SurfaceView* view = editor.view_of(editor.selection.active);
        return editor.active_object()->has_surface() && view && view->surface.patch_count() > 0;
      },
      translatable("The chosen object has no surface."));
}

void draw_outline(CommandHost& host) {
  Editor& editor = host.editor;
  if (!editor.has_document) {
    Document document;
    document.unit = editor.settings.unit;
    editor.open(std::move(document), std::nullopt);
  }
  host.viewport.start_modal(make_loop_tool());
}

/// An outline of each border of the active surface, whose surface goes on across it.
void outline_from_border(Editor& editor) {
  const Object& object = *editor.active_object();
  const auto border = border_outline(editor.view_of(object.id)->surface, BorderSide::beyond);
  if (!border) return editor.notify(border.error());
  Document document = editor.history.current();
  ObjectId last;
  for (const OutlineLoop& loop : border->loops) {
    BorderFill fill = border_fill(loop);
    OutlineSource source;
    source.outline = std::move(fill.outline);
    source.settings = fill.settings;
    auto added = add_object(document, free_name(document, object.name + " " + editor.language("border")),
                            std::move(source), object.transform);
    if (!added) return editor.notify(added.error());
    document = std::move(added->document);
    last = added->id;
  }
  if (!editor.commit(document, translatable("Outline from border"))) return;
  editor.selection.clear_elements();
  editor.selection.active = last;
}

void insert_points(Editor& editor) {
  const Object& object = *active_outline(editor);
  const std::set<Index> chosen = selected_points(editor, object);
  ElementSelection made;
  Index before = 0;
  for (const Index number : chosen) made.vertices.insert(VertexId{number + ++before});
  const bool done = change_outline(
      editor,
      [&](const Outline& outline) -> Result<Outline> {
        Outline out = outline;
        // From the last one on, so that the numbers of the others stay.
        for (auto number = chosen.rbegin(); number != chosen.rend(); ++number) {
          auto more = with_point_after(out, *number);
          if (!more) return more;
          out = *std::move(more);
        }
        return out;
      },
      translatable("Insert points"));
  if (done) editor.selection.select(object.id, made, Selection::How::replace);
}

void resample(Editor& editor, LoopMeasure measure, const char* step) {
  const Outline& outline = *active_outline(editor)->outline()->outline;
  if (outline.loops.empty()) return;
  const std::size_t count =
      std::max<std::size_t>(4, (outline.point_count() + outline.loops.size() / 2) / outline.loops.size());
  if (change_outline(
          editor, [&](const Outline& old) { return resampled(old, count, measure); }, step))
    editor.selection.clear_elements();
}

void add_drawing(CommandHost& host, MenuRows& rows) {
  Editor& editor = host.editor;
  MenuRows(host.table, "Add")
      .add_edit("add.outline", "Outline",
                "Draw a closed loop on the working plane or on a surface; a smooth surface fills it.",
                [&host] { draw_outline(host); }, {},
                {.separator_before = true, .needs_window = true, .contexts = Context::empty});
  rows.add_edit("outline.add_loop", "Add loop",
                "Draw another loop of the outline: the surface has a hole there.",
                [&host] { host.viewport.start_modal(make_loop_tool(host.editor.selection.active)); },
                needs_outline(editor), {.needs_window = true});
  rows.add_edit(
      "outline.from_border", "Outline from border",
      "Make outlines of the borders of the chosen object's surface, with its normals; new surfaces go on "
      "from there.",
      [&editor] { outline_from_border(editor); }, needs_surface(editor));
}

void show_sphere(Editor& editor) {
  editor.gauss.shown = !editor.gauss.shown;
  change_room_of_views(editor, editor.gauss.shown);
}

void add_sphere(Editor& editor, MenuRows& rows) {
  rows.add(
      "outline.sphere", "Gauss sphere",
      "Show the normals of the outline on a sphere beside the model, with the sites inside.",
      [&editor] { show_sphere(editor); },
      [&editor, outline = needs_outline(editor)] { return editor.gauss.shown ? Reason() : outline(); },
      {.separator_before = true, .checked = [&editor] { return editor.gauss.shown; }});
}

void add_points(Editor& editor, MenuRows& rows) {
  rows.next_group();
  rows.add_edit(
      "outline.insert_points", "Insert points", "One more point after each selected one.",
      [&editor] { insert_points(editor); }, needs_points(editor));
  rows.add_edit(
      "outline.select_loops", "Select whole loops", "Select all points of the loops that have selected ones.",
      [&editor] {
        const Object& object = *active_outline(editor);
        ElementSelection chosen;
        for (const Index number : whole_loops(*object.outline()->outline, selected_points(editor, object)))
          chosen.vertices.insert(VertexId{number});
        editor.selection.select(object.id, chosen, Selection::How::replace);
      },
      needs_points(editor));
  rows.add_edit(
      "outline.resample", "Resample by normals", "Even steps of the normals along each loop.",
      [&editor] { resample(editor, LoopMeasure::gauss_arc, translatable("Resample by normals")); },
      needs_outline(editor));
  rows.add_edit(
      "outline.resample_length", "Resample by length", "Even steps of length along each loop.",
      [&editor] { resample(editor, LoopMeasure::arc, translatable("Resample by length")); },
      needs_outline(editor));
}

void add_normals(Editor& editor, MenuRows& rows) {
  rows.next_group();
  rows.add_edit(
      "outline.spread", "Spread normals",
      "The normals of the selected points go smoothly along their loops, all other ones are replaced.",
      [&editor] {
        const std::set<Index> chosen = selected_points(editor, *active_outline(editor));
        change_outline(
            editor,
            [&](const Outline& outline) -> Result<Outline> { return with_spread_normals(outline, chosen); },
            translatable("Spread normals"));
      },
      needs_points(editor));
  rows.add_edit(
      "outline.turn", "Turn inside out", "The other side of the surface becomes the outer one.",
      [&editor] {
        change_outline(
            editor, [](const Outline& outline) -> Result<Outline> { return turned_inside_out(outline); },
            translatable("Turn inside out"));
      },
      needs_outline(editor));
  rows.add_edit(
      "outline.forget_curvature", "Forget curvature", "Use the points and normals alone.",
      [&editor] {
        const Object& object = *active_outline(editor);
        OutlineSettings settings = object.outline()->settings;
        settings.sign = curvature_sign(*object.outline()->outline, settings.sign);
        if (settings.mode != GaussMode::position) settings.mode = GaussMode::umbilic;
        auto changed =
            edit_outline(editor.history.current(), object.id, [](const Outline& outline) -> Result<Outline> {
              Outline out = outline;
              for (OutlineLoop& loop : out.loops) loop.curvature.clear();
              return out;
            });
        if (changed) changed = set_outline_settings(*changed, object.id, settings);
        editor.commit(changed, translatable("Forget curvature"));
      },
      [&editor, outline = needs_outline(editor)]() -> Reason {
        if (auto reason = outline()) return reason;
        for (const OutlineLoop& loop : active_outline(editor)->outline()->outline->loops)
          if (!loop.curvature.empty()) return {};
        return translatable("The outline has no curvature.");
      });
}

}  // namespace

void add_outline_commands(CommandHost& host) {
  Editor& editor = host.editor;
  MenuRows rows(host.table, translatable("Outline"));
  add_drawing(host, rows);
  add_points(editor, rows);
  add_normals(editor, rows);
  add_sphere(editor, rows);
  host.table.use_in_scripts("outline.from_border", {.looks_at_surfaces = true});
  rows.next_group();
  rows.add_edit(
      "outline.convert", "Convert to polyhedron",
      "The control points become a polyhedron whose vertices and normals can be edited; the surface stays.",
      [&editor] {
        const ObjectId id = editor.selection.active;
        if (editor.commit(convert_outline(editor.history.current(), id),
                          translatable("Convert to polyhedron")))
          editor.selection.prune(editor.document());
      },
      needs_outline(editor), {.contexts = Context::object});
}

}  // namespace hariko
