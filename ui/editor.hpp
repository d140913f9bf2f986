#pragma once

// Editor: the state that panels, tools and commands share. One per window.

#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/document/edits.hpp"
#include "core/document/history.hpp"
#include "render/scene.hpp"
#include "ui/language.hpp"
#include "ui/selection.hpp"
#include "ui/settings.hpp"
#include "ui/surface_view.hpp"

namespace hariko {

/// A sentence shown over the viewport. Those of errors stay until they are dismissed.
struct Notice {
  enum class Kind { info, warning, error };
  Kind kind = Kind::info;
  std::string text, remedy;
  double shown_at = 0;
  static constexpr double info_seconds = 4;
};

/// How the viewport shows things: not part of the document.
struct ViewSettings {
  ZebraSettings zebra;
  bool x_ray = false;
  bool grid = true;
};

class Editor {
 public:
  History history;
  Selection selection;
  ElementMode mode = ElementMode::vertex;
  std::optional<ElementRef> hovered;
  ViewSettings view;
  Settings settings;
  Language language;  ///< the catalogue of settings.language

  /// False while the start page shows.
  bool has_document = false;
  bool wants_framing = false;                 ///< as soon as the viewport's size is known
  std::optional<std::filesystem::path> path;  ///< of the document on disk

  /// Written by the application each frame.
  double now = 0;                                          ///< steady clock, seconds
  const std::map<ObjectId, SurfaceView>* views = nullptr;  ///< surfaces that are ready
  std::map<ObjectId, double> stale_since;                  ///< objects whose surface is being rebuilt
  std::string job;                                         ///< long work in progress: "Saving car.hariko"
  PixelSize viewport{1, 1};                                ///< framebuffer pixels

  const Document& document() const { return history.shown(); }
  const Object* active_object() const { return document().find(selection.active); }
  const SurfaceView* view_of(ObjectId id) const;

  /// Replaces everything by another document, which counts as saved, and frames it.
  void open(Document document, std::optional<std::filesystem::path> file);
  /// The name to show: the file's, or "Untitled".
  std::string title() const;

  /// Makes one step, or says why not. True when the document changed.
  bool commit(const Result<Document>& result, const std::string& label);
  /// Shows a document without making a step: see History. False, with a notice, on an error.
  bool preview(const Result<Document>& result);
  bool commit_preview(const std::string& label);
  void cancel_preview() { history.cancel_preview(); }
  void undo();
  void redo();

  void notify(Notice::Kind kind, std::string text, std::string remedy = {});
  void notify(const Message& message);
  std::deque<Notice>& notices() { return notices_; }
  const std::deque<Notice>& notices() const { return notices_; }
  /// Whether a notice shows that goes away by itself.
  bool notices_expire() const;

  /// The camera now, eased while a view change is under way.
  Camera camera() const;
  /// At once; ends a view change.
  void set_camera(const Camera& camera);
  /// In 180 ms.
  void fly_to(const Camera& camera);
  bool flying() const { return now < flight_start_ + flight_seconds; }
  static constexpr double flight_seconds = 0.18;
  /// Frames everything that is visible, or the selection.
  void frame_all(bool at_once = false);
  void frame_selection();

 private:
  Box3 visible_box() const;

  std::deque<Notice> notices_;
  Camera from_, to_ = Camera::standard(StandardView::iso);
  double flight_start_ = -1;
};

/// World box of an object's polyhedron or mesh.
Box3 world_box(const Object& object);

}  // namespace hariko
