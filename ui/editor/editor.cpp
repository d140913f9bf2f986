#include "ui/editor/editor.hpp"

#include <algorithm>

#include "ui/base/fonts.hpp"
#include "ui/editor/object_kind.hpp"

namespace hariko {

const SurfaceView* Editor::view_of(ObjectId id) const {
  if (!views) return nullptr;
  const auto it = views->find(id);
  return it == views->end() ? nullptr : &it->second;
}

const Job* Editor::cancellable_job() const {
  const auto found = std::ranges::find_if(
      jobs, [](const auto& job) { return job->can_be_cancelled && !job->cancel.cancelled(); });
  return found == jobs.end() ? nullptr : found->get();
}

void Editor::open(Document document, std::optional<std::filesystem::path> file) {
  history = History(std::move(document));
  path = std::move(file);
  read_only = false;
  suggested_name.clear();
  ++documents;
  selection = {};
  selections_ = SelectionMemory();
  selection.prune(history.current());
  hovered.reset();
  has_document = true;
  kept_probe.reset();
  dimensions = {};
  chosen_group = {};
  references.views.clear();
  working_plane = {};
  saved_view.clear();
  // The views start anew; how they are arranged stays.
  layout.views = ViewLayout().views;
  wants_framing = true;
}

void Editor::begin_recording() {
  history.cancel_preview();
  before_recording_ = history;
  recorded_document_ = documents;
  history = history.fork();
  recording = true;
  static_cast<InterfaceState&>(*this) = {};
  selection.prune(history.current());
  notices_.clear();
  guide.leave();
  wants_framing = true;
}

void Editor::end_recording() {
  recording = false;
  if (before_recording_ && recorded_document_ == documents) history.prepend(*std::move(before_recording_));
  before_recording_.reset();
}

std::string Editor::title() const {
  if (path) return path->filename().string();
  return suggested_name.empty() ? std::string(language("Untitled")) : suggested_name;
}

bool Editor::commit(const Result<Document>& result, const Phrase& label) {
  if (!result.ok()) return refuse(result.error());
  const std::uint64_t left = history.serial();
  const ChosenElements chosen{selection, mode};
  return stepped(left, chosen, history.push(without_lost_dimensions(result.value()), label));
}

/// Drops the dimensions whose element a step took away, and says so. Those that have lost nothing but the
/// surface they lie on stay, without a value.
Document Editor::without_lost_dimensions(const Document& next) {
  const Document& before = history.current();
  if ((next.dimensions->empty() && before.dimensions->empty()) || next.objects == before.objects) return next;
  const Document left = *remove_dimensions(next, lost_dimensions(next));
  const std::size_t count = dimensions_that_went(before, left).size();
  if (count > 0)
    notify(Notice::Kind::info, language.counted(count, "1 dimension went with what it measured.",
                                                "{0} dimensions went with what they measured."));
  return left;
}

bool Editor::stepped(std::uint64_t left, const ChosenElements& chosen, bool changed) {
  if (changed) selections_.step(left, chosen, history.oldest_serial());
  selection.prune(history.current());
  return changed;
}

void Editor::tell_script(std::vector<WrittenCommand> steps) {
  told_ = {documents, history.serial(), std::move(steps)};
}

std::span<const WrittenCommand> Editor::told_script() const {
  if (told_.documents != documents || told_.serial != history.serial()) return {};
  return told_.steps;
}

bool Editor::preview(const Result<Document>& result) {
  if (!result.ok()) return refuse(result.error());
  history.preview(result.value());
  return true;
}

bool Editor::commit_preview(const Phrase& label) {
  const std::uint64_t left = history.serial();
  const ChosenElements chosen{selection, mode};
  if (history.in_gesture()) history.preview(without_lost_dimensions(history.shown()));
  return stepped(left, chosen, history.commit_preview(label));
}

void Editor::make(const LongEdit& edit) const {
  if (on_long_edit) return on_long_edit(edit);
  edit.work({}, {})();
}

void Editor::undo() {
  history.cancel_preview();
  if (history.can_undo()) go_to(history.position() - 1);
}

void Editor::redo() {
  history.cancel_preview();
  if (history.can_redo()) go_to(history.position() + 1);
}

void Editor::go_to(std::size_t position) {
  const std::uint64_t left = history.serial();
  if (!history.go_to(position) || history.serial() == left) return;
  selections_.leave(left, {selection, mode});
  if (const ChosenElements* chosen = selections_.find(history.serial())) {
    selection = chosen->selection;
    mode = chosen->mode;
  }
  selection.prune(history.current());
}

void Editor::go_to_step(std::size_t position) {
  if (position > history.labels().size()) return;
  while (history.position() > position) undo();
  while (history.position() < position) redo();
}

void Editor::show(Notice notice) {
  constexpr std::size_t most = 4;
  show_text(notice.text);
  show_text(notice.remedy);
  std::erase_if(notices_, [&](const Notice& shown) { return shown.text == notice.text; });
  notices_.push_back(std::move(notice));
  if (notices_.size() > most) notices_.pop_front();
}

void Editor::show_environment(EnvironmentKind kind) {
  settings.environment.kind = kind;
  view.environment = true;
  view.map.map.reset();
  if (kind == EnvironmentKind::file) environment.reset();
}

void Editor::notify(Notice::Kind kind, std::string text, std::string remedy) {
  if (on_notice) on_notice(kind, text);
  show({kind, std::move(text), std::move(remedy), now});
}

void Editor::notify(const Message& message) {
  // Cancelling is no mistake.
  const Notice::Kind kind = message.code == e_cancelled           ? Notice::Kind::info
                            : message.severity == Severity::error ? Notice::Kind::error
                                                                  : Notice::Kind::warning;
  if (on_notice) on_notice(kind, to_string(message));
  show({kind, language.text_of(message), language.remedy_of(message), now});
}

void Editor::show_text(std::string_view text) {
  if (std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; })) return;
  for (const char32_t point : code_points(text))
    if (needs_japanese_font(point)) shown_characters_.insert(point);
}

bool Editor::notices_expire() const {
  return cursor_note.has_value() || std::ranges::any_of(notices_, [](const Notice& notice) {
           return notice.kind == Notice::Kind::info;
         });
}

void Editor::frame_all(bool at_once) {
  const Camera framed = framed_all(layout.active_view().goal(), viewport);
  at_once ? set_camera(framed) : fly_to(framed);
}

void Editor::frame_at_once(int number, PixelSize size) {
  View& framed = layout.views[static_cast<std::size_t>(number)];
  framed.set(framed_all(framed.goal(), size));
}

Camera Editor::framed_all(const Camera& camera, PixelSize size) const {
  const Box3 box = visible_box();
  if (!box.isEmpty()) return camera.frame(box, size);
  // Room for what a designer begins with.
  constexpr double empty_height = 300;  // mm
  Camera empty = camera;
  empty.target.setZero();
  empty.distance *= empty_height / millimetres_per(document().unit) / camera.view_height();
  return empty;
}

Box3 Editor::selected_box() const {
  Box3 box;
  if (mode == ElementMode::object) {
    for (const ObjectId id : selection.objects())
      if (const Object* object = document().find(id)) box.extend(world_box(*object));
    return box;
  }
  for (const auto& [id, elements] : selection.elements())
    if (const Object* object = document().find(id))
      for (const Vector3& point : object_kind(*object).extent(*object, elements))
        box.extend(object->transform.apply(point));
  return box;
}

void Editor::frame_selection() {
  Box3 box = selected_box();
  if (box.isEmpty()) return frame_all();
  // A single point has no size: keep a fraction of the scene round it.
  const double margin = std::max(0.0, 0.1 * visible_box().diagonal().norm() - 0.5 * box.diagonal().norm());
  box.extend(Vector3(box.min().array() - margin));
  box.extend(Vector3(box.max().array() + margin));
  fly_to(layout.active_view().goal().frame(box, viewport));
}

Box3 Editor::visible_box() const {
  if (paper.covers_model() && !paper.box.isEmpty()) return paper.box;
  Box3 box;
  for (const auto& object : document().objects) {
    if (!object->visible) continue;
    box.extend(world_box(*object));
    const SurfaceView* shown = view_of(object->id);
    if (!shown || !shown->mesh) continue;
    for (const Similarity& place : places_of(*object))
      for (int corner = 0; corner < 8; ++corner) {
        const Vector3 local =
            shown->mesh->origin() + shown->mesh->box().corner(static_cast<Box3::CornerType>(corner));
        box.extend(place.apply(local));
      }
  }
  if (!box.isEmpty() && (!views || views->empty())) {
    // Surfaces that are still to come bulge out of their polyhedra by about this much.
    const Vector3 bulge = 0.08 * box.sizes();
    box = Box3(box.min() - bulge, box.max() + bulge);
  }
  return box;
}

}  // namespace hariko
