#include "app/input/test_log.hpp"

#include <epoxy/gl.h>
#include <imgui.h>
#include <sys/resource.h>

#include <algorithm>

#include "core/base/text/json_writer.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/selected_items.hpp"

namespace hariko {

namespace {

/// Line {"event": NAME, ...} with the members that `body` writes.
template <class Body>
std::string event_line(const char* name, Body&& body) {
  JsonWriter json;
  json.object([&] {
    json.member("event", name);
    body(json);
  });
  return json.take();
}

/// Writes "id": {"vertex": [x, y, depth], ...} for objects with vertices, points or solids, that tests may
/// point at.
void write_pixels(JsonWriter& json, const Object& object, const Projector& projector, ImVec2 corner) {
  constexpr std::size_t most = 300;
  if (object.cage() && object.cage()->vertex_count() > most) return;
  const ObjectKind& kind = object_kind(object);
  const auto ids = kind.all(object, ElementMode::vertex).vertices;
  if (ids.empty() || ids.size() > most) return;
  json.object(std::to_string(object.id.value), [&] {
    for (const VertexId id : ids) {
      const auto place = kind.place(object, element_of(id));
      const auto pixel = place ? projector.project(object.transform.apply(*place)) : std::nullopt;
      if (pixel)
        json.member(std::to_string(id.value), {corner.x + pixel->x(), corner.y + pixel->y(), pixel->z()});
    }
  });
}

void write_paper(JsonWriter& json, const PaperState& paper) {
  json.member("shown", paper.shown);
  json.member("pending", paper.pending);
  json.member("error", paper.fault ? std::optional(paper.fault->messages.front().code.name) : std::nullopt);
  const PaperLayout* layout = paper.visible();
  if (!layout) return;
  const Unfolding& u = layout->unfolding;
  const auto facet_or_null = [](Index facet) {
    return facet == no_index ? std::nullopt : std::optional(facet);
  };
  json.member("facets", u.graph->facet_count());
  json.member("pieces", u.pieces.size());
  json.member("pages", u.page_count);
  json.member("joints", u.joints.size());
  json.member("strips", strip_count(u));
  json.member("overlaps", layout->overlaps);
  json.member("off_page", layout->off_page.size());
  json.member("folded", paper.folded);
  json.member("selected", facet_or_null(paper.selected_piece()));
  json.member("hovered", facet_or_null(paper.hovered.facet));
  json.list("places", u.pieces, [&](const PaperPiece& piece) {
    json.array([&] {
      json.value(piece.placement.page);
      for (const double x : {piece.placement.angle, piece.placement.offset.x(), piece.placement.offset.y()})
        json.value(x);
    });
  });
}

}  // namespace

TestLog::TestLog(const std::filesystem::path& path) {
  if (path.empty()) return;
  out_.open(path);
  on_ = out_.is_open();
}

void TestLog::rebuilt(ObjectId object, const SurfaceView& view) {
  if (!on_) return;
  out_ << event_line("rebuild", [&](JsonWriter& json) {
    json.member("object", object.value);
    json.member("quality", view.quality == Quality::final ? "final" : "drag");
    json.member("milliseconds", view.milliseconds);
    json.member("error", view.error ? std::optional(view.error->code.name) : std::nullopt);
  }) << std::endl;
}

void TestLog::file(const char* what, const std::filesystem::path& path) {
  if (!on_) return;
  out_ << event_line(what, [&](JsonWriter& json) { json.member("path", path.string()); }) << std::endl;
}

void TestLog::input(const std::vector<InputEvent>& batch) {
  for (const InputEvent& event : batch) {
    if (event.kind == InputEvent::Kind::key && !event.repeated) ++keys_, taken_ = true;
    if (event.kind == InputEvent::Kind::button) ++buttons_, taken_ = true;
  }
}

void TestLog::first_frame(const Workbench& workbench) {
  if (!on_) return;
  glFinish();  // a software renderer draws in threads of its own
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  const auto milliseconds = [](const timeval& time) {
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
  };
  const auto missing = std::ranges::count_if(
      workbench.samples(), [](const Sample& sample) { return sample.wanted && !sample.picture.texture; });
  out_ << event_line("first_frame", [&](JsonWriter& json) {
    json.member("cpu_ms", milliseconds(used.ru_utime) + milliseconds(used.ru_stime));
    json.member("user_ms", milliseconds(used.ru_utime));
    json.member("pictures_missing", static_cast<std::size_t>(missing));
  }) << std::endl;
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
  hovered(editor);
  taken();
  pictures_ = workbench.viewport().pictures_drawn();
  if (idle && !idle_) frame_times(editor.frame_times);
  if (idle && !idle_)
    out_ << event_line("idle", [&](JsonWriter& json) {
      json.member("frames", frames_);
      json.member("pictures", pictures_);
    }) << std::endl;
  idle_ = idle;
}

/// Logs the pointer. Input is taken in order: once the pointer has arrived, everything before it was handled,
/// too.
void TestLog::pointer() {
  if (!ImGui::IsMousePosValid()) return;
  const ImVec2 at = ImGui::GetIO().MousePos;
  if (std::array{at.x, at.y} == pointer_) return;
  pointer_ = {at.x, at.y};
  out_ << event_line("pointer", [&](JsonWriter& json) { json.member("at", pointer_); }) << std::endl;
}

void TestLog::hovered(const Editor& editor) {
  const std::string text = editor.hovered ? to_string(editor.hovered->element) : std::string();
  if (text == hovered_) return;
  hovered_ = text;
  out_ << event_line("hovered", [&](JsonWriter& json) { json.member("element", text); }) << std::endl;
}

void TestLog::taken() {
  if (!std::exchange(taken_, false)) return;
  out_ << event_line("input", [&](JsonWriter& json) {
    json.member("keys", keys_);
    json.member("buttons", buttons_);
  }) << std::endl;
}

void TestLog::frame_times(const FrameTimes& times) {
  if (!times.visible) return;
  out_ << event_line("frame_times", [&](JsonWriter& json) {
    json.member("frames", times.samples().size());
    json.member("ours", {times.ours(0.5), times.ours(0.95)});
    json.member("renderer", {times.renderer(0.5), times.renderer(0.95)});
    json.member("total", {times.total(0.5), times.total(0.95)});
    json.member("latency", {times.latency(0.5), times.latency(0.95)});
  }) << std::endl;
}

void TestLog::layout(const Workbench& workbench) {
  if (workbench.marks().all() == rects_) return;
  rects_ = workbench.marks().all();
  out_ << event_line("layout", [&](JsonWriter& json) {
    json.object("rects", [&] {
      for (const auto& [name, rect] : rects_) json.member(name, {rect.x, rect.y, rect.width, rect.height});
    });
  }) << std::endl;
}

void TestLog::vertices(const Editor& editor, const Workbench& workbench) {
  if (!editor.has_document) return;
  const Projector projector(editor.camera(), editor.viewport);
  const ImVec2 corner = workbench.viewport().rect().min;
  std::string line = event_line("vertices", [&](JsonWriter& json) {
    json.object("objects", [&] {
      for (const auto& object : editor.document().objects) write_pixels(json, *object, projector, corner);
    });
  });
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
  out_ << event_line("document", [&](JsonWriter& json) {
    json.member("label", editor.history.undo_label());
    json.member("position", editor.history.position());
    json.member("serial", serial_);
    json.member("gesture", gesture_);
    json.member("dirty", dirty_);
    json.member("selection", selection_);
  }) << std::endl;
}

void TestLog::paper(const Editor& editor) {
  std::string text = event_line("paper", [&](JsonWriter& json) { write_paper(json, editor.paper); });
  if (text == paper_line_) return;
  paper_line_ = std::move(text);
  out_ << paper_line_ << std::endl;
}

void TestLog::notices(const Editor& editor) {
  const std::string text = editor.notices().empty() ? std::string() : editor.notices().back().text;
  if (text == last_notice_) return;
  last_notice_ = text;
  out_ << event_line("notice", [&](JsonWriter& json) { json.member("text", text); }) << std::endl;
}

void TestLog::commands(const Editor& editor, const Workbench& workbench) {
  std::string line = event_line("commands", [&](JsonWriter& json) {
    json.list("table", workbench.commands().all(), [&](const Command& command) {
      json.object([&] {
        json.member("id", command.id);
        json.member("menu", command.menu);
        json.member("label", editor.language(command.label));
        json.member("help", editor.language(command.help));
        json.member("keys", command.keys);
      });
    });
  });
  if (line != commands_line_) out_ << line << std::endl;
  commands_line_ = std::move(line);
  const std::string note = editor.cursor_note ? editor.cursor_note->text : std::string();
  if (note != last_note_)
    out_ << event_line("cursor", [&](JsonWriter& json) { json.member("text", note); }) << std::endl;
  last_note_ = note;
  const CommandLog& log = workbench.command_log();
  if (log.number == commands_run_) return;
  commands_run_ = log.number;
  out_ << event_line("command", [&](JsonWriter& json) {
    json.member("id", log.last.first);
    json.member("ran", log.last.second.ran);
    json.member("reason", log.last.second.reason);
  }) << std::endl;
}

}  // namespace hariko
