#pragma once

// SelectionSize: how large what is selected is, for the status line. Large selections are measured by and by.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/modeling/measuring/surface_curves.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// Size of what is selected of the active object: position of one vertex, distance of two, angle of three,
/// size of the box round more; total length of edges, area of faces; in object mode the size of the chosen
/// objects together. Edges and faces of polyhedra are measured on the surface, or on the cage where the
/// surface cannot be made. In the document's space.
class SelectionSize {
 public:
  /// Measures what is not measured yet, a part of a large selection; begins anew where the selection or what
  /// it is part of is another. Rests during gestures.
  void update(const Editor& editor);
  /// "distance 100 mm"; empty where nothing is to be told, or not yet.
  const std::string& text() const { return text_; }
  /// Whether another `update` has work to do.
  bool unfinished() const { return !curves_.empty() || !patches_.empty() || !objects_.empty(); }

 private:
  /// All that the text depends on. Pointers keep what they point to alive, so that a new value has another
  /// address.
  struct Key {
    ElementMode mode = ElementMode::vertex;
    Unit unit = Unit::millimetre;
    std::string language;
    Selection selection;
    std::vector<std::shared_ptr<const void>> parts;
  };
  static std::vector<std::shared_ptr<const void>> parts_of(const Editor& editor);
  void begin(const Editor& editor);
  void begin_edges(const Editor& editor, const Object& object, const ElementSelection& elements);
  void begin_faces(const Editor& editor, const Object& object, const ElementSelection& elements);
  void proceed(const Editor& editor);
  void proceed_with_objects(const Editor& editor);
  const SurfaceElements& elements_of(const SurfaceView& view);

  std::optional<Key> key_;
  std::string text_;
  std::shared_ptr<const DisplayMesh> indexed_;  ///< mesh whose surface `index_` is of
  SurfaceElements index_;
  Surface surface_;  ///< surface of the curves and patches
  std::vector<SideCurve> curves_;
  std::vector<Index> patches_;
  std::vector<ObjectId> objects_;
  Box3 box_;
  double sum_ = 0, scale_ = 1;
};

}  // namespace hariko
