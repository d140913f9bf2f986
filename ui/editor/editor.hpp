#pragma once

// Editor: the state that panels, tools and commands share. One per window.

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "core/document/edits/edits.hpp"
#include "core/document/history/history.hpp"
#include "core/document/object_box.hpp"
#include "core/exchange/repair/mesh_import.hpp"
#include "render/scene.hpp"
#include "ui/base/frame_times.hpp"
#include "ui/base/job.hpp"
#include "ui/base/language.hpp"
#include "ui/base/language_files.hpp"
#include "ui/base/recompute.hpp"
#include "ui/base/references.hpp"
#include "ui/base/settings.hpp"
#include "ui/editor/chosen_group.hpp"
#include "ui/editor/command_arguments.hpp"
#include "ui/editor/dimension_view.hpp"
#include "ui/editor/gauss_view.hpp"
#include "ui/editor/guide.hpp"
#include "ui/editor/last_operation.hpp"
#include "ui/editor/meshing.hpp"
#include "ui/editor/paper_state.hpp"
#include "ui/editor/section_curves.hpp"
#include "ui/editor/selection.hpp"
#include "ui/editor/selection_memory.hpp"
#include "ui/editor/surface_view.hpp"
#include "ui/editor/transform_settings.hpp"
#include "ui/editor/view_layout.hpp"
#include "ui/editor/view_map.hpp"
#include "ui/editor/working_plane.hpp"

namespace hariko {

/// A sentence shown over the viewport. Those of errors stay until they are dismissed.
struct Notice {
  enum class Kind { info, warning, error };
  Kind kind = Kind::info;
  std::string text, remedy;
  double shown_at = 0;
  static constexpr double info_seconds = 4;
};

/// Reason of a refusal, shown where the pointer was.
struct CursorNote {
  std::string text;    ///< in the language of the interface
  float x = 0, y = 0;  ///< window pixels
  double shown_at = 0;
  static constexpr double seconds = 3;
};

/// Settings of the viewport, which are not part of the document.
struct ViewSettings {
  ViewMap map;  ///< on all surfaces at once
  bool surfaces_only =
      false;  ///< for judging: no curves, points, polyhedra, handles or marks of the selection
  ZebraSettings zebra;
  bool environment = false;       ///< reflects the settings' environment in what is shaded
  ContinuityTolerance tolerance;  ///< tolerance of the marks of continuity
  struct Section {
    bool shown = false, flipped = false;
    int axis = 0;       ///< 0, 1, 2: x, y, z
    double offset = 0;  ///< along the axis, world coordinates
  } section;
  double x_ray_strength = 0.3;  ///< strength of hidden lines, 0.05 .. 1
  bool x_ray = false;
  bool bodies = true;  ///< solids show translucent through the surface round them
  bool grid = true;
  bool dimensions = true;
};

/// Settings of selecting by pointing.
struct SelectSettings {
  bool lasso = false;    ///< drags beside elements draw a lasso instead of a box
  bool through = false;  ///< clicks take also what is hidden, and in perspective boxes and lassos
  /// Boxes and lassos take also what is hidden in views in parallel projection, where one draws round all
  /// that lies behind each other.
  bool through_parallel = true;
  bool regions_through(bool parallel) const { return parallel ? through_parallel : through; }
};

/// Hidden elements that a box or a lasso did not take: to be told as long as the selection is what it made.
struct LeftOut {
  std::size_t count = 0;
  Selection selection;
};

/// The last click on an element: one more at the same place takes what lies behind.
struct LastClick {
  Vector2 pixel = Vector2::Zero();
  std::size_t index = 0;  ///< among the elements there, nearest first
};

/// State of a script that is being recorded.
struct ScriptProgress {
  std::size_t steps = 0;
  std::size_t left_out = 0;  ///< edits without a command
};

/// State of the interface beside the document: what is selected, how it is looked at, what panels show. No
/// file keeps it, and a recording and its replay both begin with a fresh one.
struct InterfaceState {
  Selection selection;
  ElementMode mode = ElementMode::vertex;
  ChosenGroup chosen_group;
  std::optional<ElementRef> hovered;
  ViewSettings view;
  ViewLayout layout;
  std::string saved_view;      ///< name of the one that was gone to or saved last; empty for none
  WorkingPlane working_plane;  ///< in which tools draw and place
  TransformSettings transform;
  SelectSettings selecting;
  std::optional<LastClick> last_click;
  std::optional<LeftOut> left_out;
  Recompute recompute;
  DimensionView dimensions;                ///< with their values; `update` brings them up to date
  std::optional<SurfacePoint> kept_probe;  ///< its readings stay on the screen and follow the surface
  LastOperation last_operation;
  Meshing meshing;
  MeshImport mesh_import;
  PaperState paper;
  GaussView gauss;
  SectionCurves sections;
  std::optional<CursorNote> cursor_note;
  bool rename_wanted = false;  ///< the list of objects makes the active one's name a field
};

/// Facts of the present frame, which the application writes.
struct FrameFacts {
  double now = 0;                                          ///< steady clock, seconds
  std::vector<std::shared_ptr<const Job>> jobs;            ///< long work in progress, oldest first
  const std::map<ObjectId, SurfaceView>* views = nullptr;  ///< surfaces that are ready
  std::map<ObjectId, double> stale_since;                  ///< objects whose surface is being rebuilt
  PixelSize viewport{1, 1};                                ///< the active view, framebuffer pixels
  double pixel_scale = 1;                                  ///< framebuffer pixels per design pixel
};

/// The session: the document with its history and its file, settings and notices.
class Editor : public InterfaceState, public FrameFacts {
 public:
  History history;
  Settings settings;
  FrameTimes frame_times;
  Language language;                    ///< the catalogue of settings.language
  std::vector<LanguageFile> languages;  ///< choices beside English
  References references;                ///< the pixels of reference pictures
  /// Levels of the environment of the settings, while the view shows it; null until they are there.
  std::shared_ptr<const EnvironmentLevels> environment;

  /// False while the start page shows.
  bool has_document = false;
  Guide guide;                                     ///< the guided first model
  int exports = 0;                                 ///< files exported since the program began
  bool recording = false;                          ///< writes what the user does as a replay
  std::optional<ScriptProgress> script_recording;  ///< while commands are written as a script
  bool wants_framing = false;                      ///< frames all views, as soon as their sizes are known
  std::optional<std::filesystem::path> path;       ///< file of the document on disk
  bool read_only = false;                          ///< the file at `path` is not to be overwritten
  std::string suggested_name;                      ///< name of a document without a path, for its first save
  std::uint64_t documents = 0;                     ///< number of opened ones; names the one that is open

  const Document& document() const { return history.shown(); }
  const Object* active_object() const { return document().find(selection.active); }
  const SurfaceView* view_of(ObjectId id) const;

  /// The oldest of the jobs that can be cancelled and was not yet; null when there is none.
  const Job* cancellable_job() const;

  /// Replaces everything by another document, which counts as saved, and frames it.
  void open(Document document, std::optional<std::filesystem::path> file);
  /// Resets the editor to what a recording and its replay begin with: nothing selected, tools and views as
  /// after opening.
  void begin_recording();
  /// Puts the steps from before the recording back.
  void end_recording();
  /// The name to show: the file's, or "Untitled" in the language of the interface.
  std::string title() const;

  /// Makes one step, or says why not. True when the document changed.
  bool commit(const Result<Document>& result, const Phrase& label);
  /// Shows a document without making a step: see History. False, with a notice, on an error.
  bool preview(const Result<Document>& result);
  bool commit_preview(const Phrase& label);
  void cancel_preview() { history.cancel_preview(); }
  /// Makes an edit that takes long: by `on_long_edit` where that is set, else at once.
  void make(const LongEdit& edit) const;
  /// Has an edit made beside the event loop: by the application of a window. Empty in scripts.
  std::function<void(const LongEdit&)> on_long_edit;
  /// With the selection that the state was left with.
  void undo();
  void redo();
  /// Undoes or redoes up to a state of the history.
  void go_to_step(std::size_t position);
  /// To a state of the history, as undo and redo do.
  void go_to(std::size_t position);

  /// Says how a script makes the step that has just been made: by tools and fields, which have no command
  /// or whose command needs the pointer.
  void tell_script(std::vector<WrittenCommand> steps);
  /// Commands that express the step to the present state; empty where none were given.
  std::span<const WrittenCommand> told_script() const;

  /// Shows an environment in the place of the view's map, and makes it that of the settings. A file is read
  /// anew.
  void show_environment(EnvironmentKind kind);

  void notify(Notice::Kind kind, std::string text, std::string remedy = {});
  /// Notices in English, shown in the language of the interface.
  void inform(const Phrase& text) { notify(Notice::Kind::info, language(text)); }
  void warn(const Phrase& text, const char* remedy = "") {
    notify(Notice::Kind::warning, language(text), *remedy ? language(remedy) : "");
  }
  void notify(const Message& message);
  /// The same; false, for what fails with it.
  bool refuse(const Message& message) { return notify(message), false; }
  /// Told of every notice, messages in English with their codes: for a log. May be empty.
  std::function<void(Notice::Kind, const std::string& text)> on_notice;
  std::deque<Notice>& notices() { return notices_; }
  const std::deque<Notice>& notices() const { return notices_; }
  /// Takes up the characters of a text from elsewhere (names of files, of objects in messages): fonts are
  /// loaded for what is shown, whatever the language of the interface.
  void show_text(std::string_view text);
  const std::set<char32_t>& shown_characters() const { return shown_characters_; }
  /// Whether a notice shows that goes away by itself.
  bool notices_expire() const;

  /// The camera of the active view now, eased while a change is under way.
  Camera camera() const { return layout.active_view().camera(now); }
  /// At once; ends a flight.
  void set_camera(const Camera& camera) { layout.active_view().set(camera); }
  void fly_to(const Camera& camera) { layout.active_view().fly_to(camera, now); }
  bool flying() const { return layout.flying(now); }
  /// Frames everything that is visible, or the selection, in the active view.
  void frame_all(bool at_once = false);
  /// Frames everything in any view.
  void frame_at_once(int view, PixelSize size);
  void frame_selection();
  /// World box of what is selected, empty when nothing is.
  Box3 selected_box() const;

 private:
  Box3 visible_box() const;
  Camera framed_all(const Camera& camera, PixelSize size) const;
  void show(Notice notice);
  bool stepped(std::uint64_t left, const ChosenElements& chosen, bool changed);
  Document without_lost_dimensions(const Document& next);

  /// Steps of a script, and the state that they lead to.
  struct ToldScript {
    std::uint64_t documents = 0, serial = 0;
    std::vector<WrittenCommand> steps;
  };

  SelectionMemory selections_;
  ToldScript told_;
  std::optional<History> before_recording_;
  std::uint64_t recorded_document_ = 0;  ///< `documents` when the recording began
  std::deque<Notice> notices_;
  std::set<char32_t> shown_characters_;  ///< beyond Latin, Greek and Cyrillic
};

}  // namespace hariko
