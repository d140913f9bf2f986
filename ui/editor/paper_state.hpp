#pragma once

// PaperState: the paper model as the window has it: the layout that follows from the document, what is
// pointed at in it, and how far it is folded up.

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "core/document/document.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "core/unfolding/pages/sheet_drawing.hpp"
#include "core/unfolding/unfolding.hpp"
#include "render/camera.hpp"
#include "ui/base/language.hpp"

namespace hariko {

/// The facets of the model, in the document's space, whatever the paper is.
struct PaperFacets {
  PolygonMesh mesh;
  std::vector<PaperVertex> names;
  std::vector<Message> warnings;
};

/// The facets that are unfolded: those larger than the page are cut.
struct PaperMesh {
  std::shared_ptr<const FacetGraph> graph;
  std::vector<PaperVertex> names;
  std::shared_ptr<const PaperFacets> whole;
  std::size_t cut = 0;  ///< facets that are cut
};

/// A paper model laid out. Immutable; made by workers, or at once after an edit.
struct PaperLayout {
  std::shared_ptr<const PaperModel> model;  ///< model that it was made from
  std::shared_ptr<const PaperMesh> mesh;
  Unfolding unfolding;
  SheetDrawing drawing;
  std::vector<char> overlapping;  ///< one for each facet: it, or its piece's tab at it, overlaps something
  std::size_t overlaps = 0;
  std::vector<Index> off_page;  ///< pieces, ascending
  double fitting = 1;           ///< scale at which all pieces fit
  std::vector<Message> messages;
};

/// O(facets log facets).
std::shared_ptr<const PaperLayout> lay_out_paper(std::shared_ptr<const PaperModel> model,
                                                 std::shared_ptr<const PaperMesh> mesh, Unfolding unfolding);

/// Target of the pointer: at most one of the edge and the joint; the facet goes with an edge.
struct PaperHover {
  Index facet = no_index, edge = no_index;
  Index joint = no_index;  ///< its tab or strip
  friend bool operator==(const PaperHover&, const PaperHover&) = default;
};

/// Reasons why the model cannot be unfolded, and where: lines in the document's space.
struct PaperFault {
  std::vector<Message> messages;
  std::vector<std::array<Vector3, 2>> lines;
};

class PaperState {
 public:
  bool shown = false;                          ///< the paper view stands beside the views of the model
  bool in_space = true;                        ///< the views of the model show the paper, folded up
  float folded = 1;                            ///< 0 flat pages .. 1 solid
  bool wants_unfolding = false;                ///< the application is to look for cuts
  bool wants_framing = true;                   ///< all pages in the paper view
  bool pending = false;                        ///< the layout is older than the document
  std::shared_ptr<const PaperMesh> mesh;       ///< mesh of the document's paper model; null until it is there
  std::shared_ptr<const PaperLayout> layout;   ///< null until there is one
  std::shared_ptr<const PaperLayout> dragged;  ///< instead, while a piece is moved by hand
  std::optional<PaperFault> fault;
  Box3 box;  ///< bounds of what the views show of it, the document's space; empty for nothing
  PaperHover hovered;
  Index selected = no_index;  ///< a facet of the selected piece

  /// Layout to be seen now; null when there is none.
  const PaperLayout* visible() const { return dragged ? dragged.get() : layout.get(); }
  std::shared_ptr<const PaperLayout> shared_visible() const { return dragged ? dragged : layout; }
  /// Whether views show the paper instead of the objects.
  bool covers_model() const { return shown && in_space && visible(); }
  /// The selected piece; no_index when there is none.
  Index selected_piece() const;

  /// Layouts of states of the history, so that undo and redo show at once.
  void remember(std::shared_ptr<const PaperLayout> layout);
  std::shared_ptr<const PaperLayout> find(const PaperModel& model, const PaperMesh* mesh) const;
  /// Another document was opened.
  void forget();

 private:
  static constexpr std::size_t most_remembered = 16;
  std::deque<std::shared_ptr<const PaperLayout>> remembered_;
};

}  // namespace hariko
