#pragma once

// Part of the properties: what can be set on the selected vertices, edges and faces of the active polyhedron,
// and what rows about objects share with it.

#include <array>

#include "ui/editor/selected_items.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

/// The sections of all kinds of elements that are selected. True when there is one.
bool draw_elements(PanelContext& context);

/// The heading of a section about so many, in English: "vertex" or "{0} vertices".
void counted_heading(const PanelContext& context, const char* one, const char* many, std::size_t count);

/// Three fields with one unit, called X, Y and Z.
std::array<FieldSpec, 3> axis_specs(const std::array<const char*, 3>& ids, const std::string& step,
                                    const Quantity& quantity);

/// The largest extent of all objects, document's unit; 1 where there is nothing.
double model_size(const Editor& editor);

}  // namespace hariko
