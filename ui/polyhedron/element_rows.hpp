#pragma once

// Part of the properties: what can be set on the selected vertices, edges and faces of the active polyhedron,
// and what rows about objects share with it.

#include "ui/editor/selected_items.hpp"
#include "ui/widgets/panels.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

/// The sections of all kinds of elements that are selected. True when there is one.
bool draw_elements(PanelContext& context);

/// The heading of a section about so many, in English: "vertex" or "{0} vertices".
void counted_heading(const PanelContext& context, const char* one, const char* many, std::size_t count);

/// The largest extent of all objects, document's unit; 1 where there is nothing.
double model_size(const Editor& editor);

/// Number of patches, of which degree, and what makes them editable. Draws nothing for other objects.
void patch_section(PanelContext& context, const Object& object);

}  // namespace hariko
