#include "app/test_log.hpp"

#include <imgui.h>

#include <nlohmann/json.hpp>

#include "ui/selection_text.hpp"

namespace hariko {

using Json = nlohmann::ordered_json;

TestLog::TestLog(const std::filesystem::path& path) {
  if (path.empty()) return;
  out_.open(path);
  on_ = out_.is_open();
}

void TestLog::rebuilt(ObjectId object, const SurfaceView& view) {
  if (!on_) return;
  Json line{{"event", "rebuild"},
            {"object", object.value},
            {"quality", view.quality == Quality::final ? "final" : "drag"},
            {"milliseconds", view.milliseconds}};
  line["error"] = view.error ? Json(std::string(view.error->code.name)) : Json();
  out_ << line.dump() << std::endl;
}

void TestLog::file(const char* what, const std::filesystem::path& path) {
  if (on_) out_ << Json{{"event", what}, {"path", path.string()}}.dump() << std::endl;
}

void TestLog::input(const std::vector<InputEvent>& batch) {
  for (const InputEvent& event : batch) {
    if (event.kind == InputEvent::Kind::key && !event.repeated) ++keys_, taken_ = true;
    if (event.kind == InputEvent::Kind::button) ++buttons_, taken_ = true;
  }
}

void TestLog::frame(const Editor& editor, const Workbench& workbench, bool idle) {
  if (!on_) return;
  ++frames_;
  layout(workbench);
  vertices(editor, workbench);
  history(editor);
  notices(editor);
  paper(editor);
  commands(editor, workbench);
  pointer();
  taken();
  pictures_ = workbench.viewport().pictures_drawn();
  if (idle && !idle_) frame_times(editor.frame_times);
  if (idle && !idle_)
    out_ << Json{{"event", "idle"}, {"frames", frames_}, {"pictures", pictures_}}.dump() << std::endl;
  idle_ = idle;
}

/// Input is taken in order: who sees the pointer arrive knows that all before it was taken, too.
void TestLog::pointer() {
  if (!ImGui::IsMousePosValid()) return;
  const ImVec2 at = ImGui::GetIO().MousePos;
  if (std::array{at.x, at.y} == pointer_) return;
  pointer_ = {at.x, at.y};
  out_ << Json{{"event", "pointer"}, {"at", pointer_}}.dump() << std::endl;
}

void TestLog::taken() {
  if (!std::exchange(taken_, false)) return;
  out_ << Json{{"event", "input"}, {"keys", keys_}, {"buttons", buttons_}}.dump() << std::endl;
}

void TestLog::frame_times(const FrameTimes& times) {
  if (!times.visible) return;
  Json line{{"event", "frame_times"}};
  line["frames"] = times.samples().size();
  line["ours"] = {times.ours(0.5), times.ours(0.95)};
  line["renderer"] = {times.renderer(0.5), times.renderer(0.95)};
  line["total"] = {times.total(0.5), times.total(0.95)};
  line["latency"] = {times.latency(0.5), times.latency(0.95)};
  out_ << line.dump() << std::endl;
}

void TestLog::layout(const Workbench& workbench) {
  if (workbench.marks().all() == rects_) return;
  rects_ = workbench.marks().all();
  Json rects = Json::object();
  for (const auto& [name, rect] : rects_) rects[name] = {rect.x, rect.y, rect.width, rect.height};
  out_ << Json{{"event", "layout"}, {"rects", rects}}.dump() << std::endl;
}

void TestLog::vertices(const Editor& editor, const Workbench& workbench) {
  if (!editor.has_document) return;
  const Projector projector(editor.camera(), editor.viewport);
  const ImVec2 corner = workbench.viewport().rect().min;
  Json objects = Json::object();
  for (const auto& object : editor.document().objects) {
    const PolyhedronSource* source = object->polyhedron();
    constexpr Index most = 300;
    Json pixels = Json::object();
    const auto add = [&](std::uint32_t id, const Vector3& local) {
      if (const auto pixel = projector.project(object->transform.apply(local)))
        pixels[std::to_string(id)] = {corner.x + pixel->x(), corner.y + pixel->y(), pixel->z()};
    };
    if (const SolidsSource* solids = object->solids()) {
      for (const Solid& solid : solids->input->solids) add(solid.id, solid.position);
      objects[std::to_string(object->id.value)] = std::move(pixels);
      continue;
    }
    if (!source || source->polyhedron.vertex_count() > most) continue;
    for (Index v = 0; v < source->polyhedron.vertex_count(); ++v)
      add(source->polyhedron.vertex_id(v).value, source->origin + source->polyhedron.position(v));
    objects[std::to_string(object->id.value)] = std::move(pixels);
  }
  std::string line = Json{{"event", "vertices"}, {"objects", objects}}.dump();
  if (line == vertices_line_) return;
  vertices_line_ = std::move(line);
  out_ << vertices_line_ << std::endl;
}

void TestLog::history(const Editor& editor) {
  const std::string selection = describe_in(editor.has_document ? editor.active_object() : nullptr,
                                            editor.selection.of_active(), Language());
  if (editor.history.serial() == serial_ && editor.history.position() == position_ &&
      editor.history.in_gesture() == gesture_ && selection == selection_ && editor.history.dirty() == dirty_)
    return;
  serial_ = editor.history.serial();
  position_ = editor.history.position();
  gesture_ = editor.history.in_gesture();
  dirty_ = editor.history.dirty();
  selection_ = selection;
  out_ << Json{{"event", "document"},
               {"label", editor.history.undo_label()},
               {"position", editor.history.position()},
               {"serial", serial_},
               {"gesture", gesture_},
               {"dirty", dirty_},
               {"selection", selection_}}
              .dump()
       << std::endl;
}

void TestLog::paper(const Editor& editor) {
  const PaperLayout* layout = editor.paper.visible();
  Json line{{"event", "paper"}, {"shown", editor.paper.shown}, {"pending", editor.paper.pending}};
  line["error"] =
      editor.paper.fault ? Json(std::string(editor.paper.fault->messages.front().code.name)) : Json();
  if (layout) {
    const Unfolding& u = layout->unfolding;
    line["facets"] = u.graph->facet_count();
    line["pieces"] = u.pieces.size();
    line["pages"] = u.page_count;
    line["joints"] = u.joints.size();
    line["strips"] = strip_count(u);
    line["overlaps"] = layout->overlaps;
    line["off_page"] = layout->off_page.size();
    line["folded"] = editor.paper.folded;
    line["selected"] =
        editor.paper.selected_piece() == no_index ? Json() : Json(editor.paper.selected_piece());
    line["hovered"] = editor.paper.hovered.facet == no_index ? Json() : Json(editor.paper.hovered.facet);
    line["places"] = Json::array();
    for (const PaperPiece& piece : u.pieces)
      line["places"].push_back({piece.placement.page, piece.placement.angle, piece.placement.offset.x(),
                                piece.placement.offset.y()});
  }
  std::string text = line.dump();
  if (text == paper_line_) return;
  paper_line_ = std::move(text);
  out_ << paper_line_ << std::endl;
}

void TestLog::notices(const Editor& editor) {
  const std::string text = editor.notices().empty() ? std::string() : editor.notices().back().text;
  if (text == last_notice_) return;
  last_notice_ = text;
  out_ << Json{{"event", "notice"}, {"text", text}}.dump() << std::endl;
}

void TestLog::commands(const Editor& editor, const Workbench& workbench) {
  Json table = Json::array();
  for (const Command& command : workbench.commands().all())
    table.push_back({{"id", command.id},
                     {"menu", command.menu},
                     {"label", editor.language(command.label)},
                     {"help", editor.language(command.help)},
                     {"keys", command.keys}});
  std::string line = Json{{"event", "commands"}, {"table", table}}.dump();
  if (line != commands_line_) out_ << line << std::endl;
  commands_line_ = std::move(line);
  const std::string note = editor.cursor_note ? editor.cursor_note->text : std::string();
  if (note != last_note_) out_ << Json{{"event", "cursor"}, {"text", note}}.dump() << std::endl;
  last_note_ = note;
  const CommandLog& log = workbench.command_log();
  if (log.number == commands_run_) return;
  commands_run_ = log.number;
  out_ << Json{{"event", "command"},
               {"id", log.last.first},
               {"ran", log.last.second.ran},
               {"reason", log.last.second.reason}}
              .dump()
       << std::endl;
}

}  // namespace hariko
