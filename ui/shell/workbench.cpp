#include "ui/shell/workbench.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

#include "render/reference_image.hpp"
#include "ui/base/icons.hpp"
#include "ui/base/key_chord.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/measure/dimension_layer.hpp"
#include "ui/outline/outline_handles.hpp"
#include "ui/paper/paper_drawing.hpp"
#include "ui/polyhedron/tension_tool.hpp"
#include "ui/shell/shell_commands.hpp"
#include "ui/skin/skin_tools.hpp"
#include "ui/view/gizmo.hpp"
#include "ui/widgets/beside.hpp"
#include "ui/widgets/items.hpp"

namespace hariko {

namespace {

bool shows_zebra(const Editor& editor) {
  return std::ranges::any_of(editor.document().objects, [&](const auto& object) {
    return object->visible && shown_map(editor.view.map, *object) == SurfaceMap::zebra;
  });
}

/// Layers over the pictures of the views, from above.
std::vector<std::unique_ptr<ViewLayer>> view_layers() {
  std::vector<std::unique_ptr<ViewLayer>> layers;
  layers.push_back(std::make_unique<Gizmo>());
  layers.push_back(std::make_unique<OutlineHandles>());
  layers.push_back(make_paper_layer());
  layers.push_back(std::make_unique<SkinOverlay>());
  layers.push_back(make_gauss_layer());
  layers.push_back(make_dimension_layer());
  layers.push_back(make_tension_numbers());
  return layers;
}

}  // namespace

Workbench::Workbench(Editor& editor, Renderer& renderer, int quick_samples, const Metrics& metrics,
                     ApplicationServices& application)
    : editor_(editor),
      viewport_(editor, renderer, quick_samples, view_layers()),
      metrics_(metrics),
      application_(application),
      host_{commands_, editor_, viewport_, *this, application},
      files_(editor, viewport_, application) {
  add_commands();
}

void Workbench::add_commands() {
  // Commands of a menu stand in the order of these lines.
  add_file_commands(host_, *this);
  add_edit_commands(host_);
  add_paste_commands(host_);
  add_object_commands(host_);
  add_group_commands(host_);
  add_arrange_commands(host_);
  add_record_commands(host_, *this);
  add_preferences_commands(host_, *this);
  add_select_commands(host_);
  add_add_commands(host_);
  add_solid_commands(host_);
  add_outline_commands(host_);
  add_transform_commands(host_);
  add_snap_commands(host_);
  add_mesh_commands(host_);
  add_mesh_cleanup_commands(host_);
  add_reference_commands(host_);
  add_shape_commands(host_);
  add_attach_commands(host_);
  add_patch_commands(host_);
  add_recompute_commands(host_);
  add_skin_commands(host_);
  add_paper_commands(host_);
  add_view_commands(host_);
  add_saved_view_commands(host_);
  add_plane_commands(host_);
  add_analyse_commands(host_);
  add_section_curve_commands(host_);
  add_measure_commands(host_);
  add_start_commands(host_);
  add_language_commands(host_);
  add_help_commands(host_, *this);
  add_property_commands(host_, *this);
  fill_context_menus(commands_);
  add_other_names(commands_);
  // A tool works on the document that it found: whatever changes it ends the tool first.
  commands_.before_run([this](const Command& command) {
    if (watch_.before_command) watch_.before_command();
    found_ = state();
    if (!command.changes_document) return;
    viewport_.cancel_tool();
    if (editor_.history.in_gesture()) editor_.cancel_preview();
  });
  commands_.after_run([this](const Command& command, const CommandTable::Outcome& outcome) {
    if (outcome.ran && made_a_step(command)) editor_.last_operation.take_up_command(editor_, command.id);
    ++command_log_.number;
    command_log_.last = {command.id, outcome};
    if (watch_.after_command) watch_.after_command(command, outcome);
  });
}

Workbench::State Workbench::state() const {
  return {editor_.documents, editor_.history.serial(), editor_.last_operation.count()};
}

/// Whether the command that has just run made a step that is repeated by running it again. Operations that
/// keep their numbers have been taken up already.
bool Workbench::made_a_step(const Command& command) const {
  static constexpr std::array others{"edit.undo", "edit.redo", "edit.repeat", "file.revert"};
  const State now = state();
  return command.changes_document && !command.needs_window && now.document == found_.document &&
         now.serial > found_.serial && now.operations == found_.operations &&
         std::find(others.begin(), others.end(), command.id) == others.end();
}

void Workbench::run_from_key(const Command& command) {
  const std::size_t before = editor_.notices().size();
  const auto outcome = commands_.run(command);
  if (!outcome.ran) return explain_at_pointer(editor_.language.phrase(outcome.reason));
  // An operation that refused says so where the designer looks, too.
  const auto& notices = editor_.notices();
  if (notices.size() > before && notices.back().kind == Notice::Kind::error)
    explain_at_pointer(notices.back().text);
}

void Workbench::explain_at_pointer(const std::string& text) {
  const ImVec2 at = ImGui::GetIO().MousePos;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  // A pointer that left the window is nowhere: the note stands in the middle.
  const bool here = ImGui::IsMousePosValid(&at);
  editor_.cursor_note = CursorNote{text, here ? at.x : screen.x / 2, here ? at.y : screen.y / 2, editor_.now};
}

void Workbench::apply_keys() {
  if (editor_.settings.keys == keys_in_use_) return;
  keys_in_use_ = editor_.settings.keys;
  const Language& tr = editor_.language;
  for (const KeyProblem& problem : commands_.rebind(keys_in_use_)) {
    const Command* command = commands_.find(problem.id);
    const Command* other = commands_.find(problem.other);
    const std::string name = command ? tr(command->label) : problem.id;
    const char* text =
        problem.kind == KeyProblem::Kind::unknown_command
            ? translatable("The key file names a command that does not exist: {0}.")
        : problem.kind == KeyProblem::Kind::not_a_key
            ? translatable("The keys of \u201c{0}\u201d cannot be read: {1}. The default is used.")
        : problem.kind == KeyProblem::Kind::reserved
            ? translatable("\u201c{0}\u201d cannot have {1}: it always cancels.")
            : translatable(
                  "{1} is given to two commands: \u201c{2}\u201d keeps it, \u201c{0}\u201d goes without.");
    editor_.warn({text, {name, problem.keys, other ? tr(other->label) : problem.other}});
  }
}

void Workbench::frame() {
  marks_.clear();
  panel_state_.field_opening = false;
  apply_keys();
  keyboard_.begin_frame(preferences_.is_open());
  PanelContext context{editor_, commands_,    marks_,           metrics_,         panel_state_, samples_,
                       *this,   application_, viewport_.hint(), editor_.language, offers_};
  // Steps that a gesture shows are not done yet.
  if (!editor_.history.in_gesture())
    editor_.guide.look({editor_.history.current(), editor_.exports, shows_zebra(editor_)});
  const float menu = draw_menu_bar(context);
  layout(context, menu);
  for (const auto& step : std::exchange(panel_state_.steps, {})) step();
  // A question about an offer takes the dialog's place until it is answered.
  if (!prompt_.is_open()) offers_dialog_.draw(context);
  context_menu_.draw(context);
  preferences_.draw(context, menu);
  palette_.draw(context, menu);
  cheat_sheet_.draw(context, menu);
  draw_cursor_note(context);
  // Shade at once: nothing is drawn again while nothing happens, so it cannot fade in.
  GImGui->DimBgRatio = 1;
  files_.draw(context);
  prompt_.draw(context);
  keyboard_.end_frame(preferences_.is_open());
  if (watch_.after_frame) watch_.after_frame();
}

void Workbench::layout(PanelContext& context, float menu) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float status = metrics_.px(26), line = metrics_.px(1);
  const float tools = tool_column_width(metrics_, screen.y - menu - status);
  if (!editor_.has_document) {
    const PanelRect all{{0, menu}, screen};
    start_page_.draw(context, all);
    draw_notices(context, all);
    return;
  }
  const float side = std::min(metrics_.px(editor_.settings.side_width), screen.x / 2);
  const float guide = editor_.guide.shown() ? metrics_.px(260) : 0;
  if (guide > 0) draw_guide(context, {{tools, menu}, {tools + guide, screen.y - status}});
  const float meshing = editor_.meshing.open ? metrics_.px(316) : 0;
  const float left = tools + guide;
  if (meshing > 0) draw_meshing(context, {{left, menu}, {left + meshing, screen.y - status}});
  const PanelRect view{{left + meshing, menu}, {screen.x - side - line, screen.y - status}};
  const float list = objects_height(context, screen.y - menu - status);
  const float right = screen.x - side;
  draw_tool_column(context, {{0, menu}, {tools, screen.y - status}});
  const auto hovered = editor_.hovered;
  const bool tool_ran = viewport_.tool_active();
  PanelRect model = view;
  if (editor_.paper.shown)
    model = draw_beside(context, model, "paper.border", paper_split_,
                        [&](const PanelRect& rect) { paper_panel_.draw(context, rect); });
  if (editor_.gauss.shown)
    model = draw_beside(context, model, "gauss.border", gauss_split_, [&](const PanelRect& rect) {
      gauss_panel_.draw(context, editor_.gauss, rect, viewport_.pointed_at());
    });
  viewport_.draw(context, model);
  editor_.paper.box = viewport_.scene().paper() ? viewport_.scene().paper()->box : Box3();
  context_menu_.watch(editor_, model, hovered, tool_ran);
  draw_objects(context, {{right, menu}, {screen.x, menu + list - line}});
  const float bottom = screen.y - status;
  const float history = history_height(context, bottom - menu);
  draw_properties(context, {{right, menu + list}, {screen.x, bottom - history - line}});
  draw_history(context, {{right, bottom - history}, {screen.x, bottom}});
  context.tool_hint = viewport_.hint();
  if (!viewport_.tool_active() && !paper_panel_.hint().empty()) context.tool_hint = paper_panel_.hint();
  if (!viewport_.tool_active() && editor_.gauss.shown && !gauss_panel_.hint().empty())
    context.tool_hint = gauss_panel_.hint();
  if (!viewport_.tool_active() && !editor_.hovered)
    if (const std::string note = status_note(); !note.empty()) context.tool_hint = note;
  status_ = context.tool_hint;
  draw_status_line(context, {{0, screen.y - status}, screen});
  draw_notices(context, model);  // buttons of panels beside it stay free

  drag_border({{right - metrics_.px(3), menu}, {right + metrics_.px(2), screen.y - status}});
  drag_list_end(
      {{right + metrics_.px(2), menu + list - metrics_.px(3)}, {screen.x, menu + list + metrics_.px(2)}},
      menu);
}

void Workbench::drag_list_end(const PanelRect& border, float top) {
  if (begin_panel("##list_end", border, 0, {0, 0}, ImGuiWindowFlags_NoBackground)) {
    const ImVec2 size(border.width(), border.height());
    const bool held = border_area(marks_, "outliner.end", size, ImGuiMouseCursor_ResizeNS);
    float& height = editor_.settings.objects_height;
    if (held && ImGui::IsMouseDragging(0, 1))
      height = std::max(1.0F, (ImGui::GetIO().MousePos.y - top) / metrics_.scale);
    // As its rows need again.
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) height = 0;
  }
  ImGui::End();
}

/// Notes on how things are shown and chosen, before the hints of pointing.
std::string Workbench::status_note() const {
  const auto keys = [&](const char* id) {
    const Command* command = commands_.find(id);
    return command ? command->keys : std::string();
  };
  if (const std::string left_out = left_out_text(editor_, keys("select.through")); !left_out.empty())
    return left_out;
  if (editor_.view.surfaces_only)
    return fill(editor_.language("Surfaces only   {0}: show curves, points and polyhedra again"),
                {keys("view.surfaces_only")});
  return {};
}

void Workbench::drag_border(const PanelRect& border) {
  if (begin_panel("##border", border, 0, {0, 0}, ImGuiWindowFlags_NoBackground)) {
    const ImVec2 size(border.width(), border.height());
    if (border_area(marks_, "properties.border", size, ImGuiMouseCursor_ResizeEW))
      editor_.settings.side_width = std::clamp(
          editor_.settings.side_width - ImGui::GetIO().MouseDelta.x / metrics_.scale, 260.0F, 480.0F);
  }
  ImGui::End();
}

bool Workbench::navigation_key(const KeyChord& chord) {
  const bool plain = !chord.control && !chord.alt;
  const bool busy = prompt_.is_open() || files_.is_open() || offers_dialog_.is_open() || palette_.is_open() ||
                    cheat_sheet_.is_open() || viewport_.tool_active();
  if (!busy && plain && chord.key == Key::f6 && editor_.has_document)
    return keyboard_.next_panel(chord.shift), true;
  const std::vector<std::string> menus = commands_.menus();
  const std::string* menu = nullptr;
  if (!busy && plain && !chord.shift && chord.key == Key::f10)
    menu = &menus.front();
  else if (!busy && !chord.control && !chord.shift &&
           (chord.alt ? !commands_.find(chord) : panel_state_.menu_open && !text_field_active()))
    menu = menu_of_letter(menus, chord.key);
  if (menu) {
    close_popups(false);
    panel_state_.wanted_menu = *menu;
  }
  if (!panel_state_.wanted_menu.empty()) {
    show_keyboard_focus();
    return true;
  }
  return keyboard_.navigates(preferences_.is_open()) && !text_field_active() && keyboard_.item_key(chord);
}

void Workbench::cap(const CapMotion& motion) {
  if (!prompt_.is_open() && !files_.is_open() && !offers_dialog_.is_open() && !palette_.is_open())
    cap_.move(editor_, motion);
}

void Workbench::cap_button(int number) {
  if (prompt_.is_open() || files_.is_open() || offers_dialog_.is_open()) return;
  if (number == 0) palette_.is_open() ? palette_.close() : palette_.open();
  if (number == 1 && !palette_.is_open() && editor_.has_document) commands_.run("view.frame_all");
}

void Workbench::key(const KeyPress& press) {
  const KeyChord& chord = press.chord;
  editor_.cursor_note.reset();
  if (preferences_.key(editor_, commands_, chord)) return;
  if (chord.key == Key::escape) return escape();
  if (palette_.is_open()) return palette_.key(chord);
  if (cheat_sheet_.is_open()) {
    const Command* closing = commands_.find(chord);
    if (closing && closing->id == "help.keys") cheat_sheet_.close();
    return;
  }
  if (!text_field_active() && prompt_.key(chord)) return;
  if (!prompt_.is_open() && navigation_key(chord)) return;
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return;
  // While a field takes text or a dialog is open the keys are theirs.
  if (text_field_active() || field_opening() || files_.is_open() || offers_dialog_.is_open() ||
      prompt_.is_open())
    return;
  if (!editor_.has_document && start_page_.key(chord)) return;
  // A running tool takes its own keys first: axes, numbers, Enter.
  if (viewport_.tool_key(press)) return;
  const Command* command = commands_.find(chord);
  if (!command || paper_panel_.dragging()) return;
  if (viewport_.tool_active() && !command->while_tool_runs) return;
  if (editor_.history.in_gesture() && command->changes_document) return;
  // Keys act in the view under the pointer.
  editor_.layout.activate(editor_.layout.active());
  run_from_key(*command);
}

void Workbench::escape() {
  // A list or menu over a dialog is what Esc closes first.
  if (const auto& popups = GImGui->OpenPopupStack;
      !popups.empty() && popups.back().Window && (popups.back().Window->Flags & ImGuiWindowFlags_Modal) == 0)
    return ImGui::ClosePopupToLevel(popups.Size - 1, true);
  if (!text_field_active() && keyboard_.in_panel()) return keyboard_.leave_panel();
  if (prompt_.is_open()) return prompt_.dismiss();
  if (files_.is_open()) return files_.close();
  if (offers_dialog_.is_open()) return offers_dialog_.close();
  if (palette_.is_open()) return palette_.close();
  if (cheat_sheet_.is_open()) return cheat_sheet_.close();
  // Menus and the lists of fields.
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
    return close_popups(true);
  if (viewport_.cancel_tool()) return;
  if (paper_panel_.cancel_drag(editor_)) return;
  if (editor_.history.in_gesture()) {
    editor_.cancel_preview();
    ImGui::ClearActiveID();  // the slider lets go
    return;
  }
  if (text_field_active()) return;  // the field restores its text
  if (preferences_.is_open()) return preferences_.close();
  if (editor_.dimensions.chosen(editor_)) return editor_.dimensions.choose_none();
  if (!editor_.notices().empty())
    editor_.notices().clear();
  else
    editor_.mode == ElementMode::object ? editor_.selection.clear_objects()
                                        : editor_.selection.clear_elements();
}

void Workbench::guarded(std::function<void()> action) {
  if (!editor_.has_document || !editor_.history.dirty()) return action();
  const Language& tr = editor_.language;
  ask({tr("Unsaved changes"),
       fill(tr("{0} has changes that are not saved."), {editor_.title()}),
       {{tr("Save"), "save", [this, action] { save([this, action] { guarded(action); }); }},
        {tr("Discard"), "discard", action},
        {tr("Cancel"), "cancel", {}}}});
}

void Workbench::open_guarded(const std::filesystem::path& path) {
  guarded([this, path] { application_.open(path); });
}

void Workbench::take_files(const std::vector<std::filesystem::path>& files) {
  std::vector<std::filesystem::path> pictures;
  bool opens = !editor_.has_document;
  for (const std::filesystem::path& file : files) {
    if (is_reference_file(file))
      pictures.push_back(file);
    else if (std::exchange(opens, false) || file.extension() == ".hariko")
      open_guarded(file);
    else
      application_.import_file(file);
  }
  if (!pictures.empty()) application_.add_pictures(pictures);
}

void Workbench::save(std::function<void()> then) {
  if (editor_.path && !editor_.read_only)
    application_.save(*editor_.path, std::move(then));
  else
    files_.save_as(std::move(then));
}

void Workbench::new_document() {
  guarded([this] {
    Document document;
    document.unit = editor_.settings.unit;
    editor_.open(std::move(document), {});
  });
}

void Workbench::offer_recovery() {
  if (editor_.has_document && (offers_.crash || !offers_.recoveries.empty())) show_recoveries();
}

void Workbench::show_samples() {
  offers_dialog_.open(OffersDialog::Kind::samples);
}

void Workbench::quit() {
  guarded([this] {
    const Job* job = editor_.cancellable_job();
    if (!job) return application_.quit();
    const Language& tr = editor_.language;
    ask({tr("Work in progress"),
         fill(tr("{0} is not finished. Leaving now cancels it."), {tr(job->text)}),
         {{tr("Wait"), "wait", {}}, {tr("Leave"), "leave", [this] { application_.quit(); }}}});
  });
}

void Workbench::forget_interface() {
  viewport_.cancel_tool();
  panel_state_ = {};
  preferences_ = {};
  paper_panel_ = {};
  gauss_panel_ = {};
  palette_ = {};
  cheat_sheet_ = {};
  start_page_ = {};
  files_.forget_choices();
  ImGui::ClearActiveID();
  for (ImGuiWindow* window : GImGui->Windows) {
    window->StateStorage.Clear();
    window->Scroll = {0, 0};
  }
}

void Workbench::close_document() {
  guarded([this] {
    editor_.open({}, {});
    editor_.has_document = false;
  });
}

}  // namespace hariko
