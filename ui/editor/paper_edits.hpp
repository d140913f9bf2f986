#pragma once

// Edits of the document by the paper view and its panel, each as one step.

#include <functional>
#include <string>

#include "core/unfolding/unfolding.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// Paper model to begin with: the visible objects, a distance that suits their size, and a scale at which
/// they are 50 to 500 mm large.
PaperModel default_paper(const Document& document);
/// Paper model of the document, or the one that a new one begins with.
PaperModel paper_of(const Document& document);
/// The same without cuts and places: cheap to copy.
PaperModel paper_choices_of(const Document& document);

/// The document with changed settings. Where lengths on paper change all is packed anew.
Document with_paper_settings(const Document& document, const std::function<void(PaperModel&)>& change);

/// Makes an edited layout a step; it shows at once. A refusal is said.
bool commit_paper(Editor& editor, const Result<Unfolding>& edited, const std::string& label);

/// Joins or splits the pieces at an edge, whichever can be.
void toggle_edge(Editor& editor, Index edge);
/// Puts the tab of a joint on the other side, or a strip in its place; of a strip, a tab where there is room.
void flip_tab(Editor& editor, Index joint);
/// A strip instead of the tab, whatever the room.
void use_strip(Editor& editor, Index joint);

/// All pieces as large as the page allows.
void scale_to_fit(Editor& editor);

}  // namespace hariko
