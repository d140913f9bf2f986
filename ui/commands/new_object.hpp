#pragma once

// What commands that make objects share.

#include <string>

#include "ui/editor.hpp"

namespace hariko {

/// An empty document where the start page shows.
void begin_document(Editor& editor);
/// Half the extent of a new object: a hand's breadth in an empty document, else in proportion to what is
/// there; 1, 2 or 5 times a power of ten.
double new_object_radius(const Editor& editor);
/// A name that no object has yet: "Box", "Box 2", ...
std::string free_name(const Document& document, const std::string& name);

}  // namespace hariko
