#pragma once

// PanelRow: a row of panels that no table of properties has, as its edit is of another kind. Commands name
// it, so that the palette finds it, too.

#include "ui/base/language.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// Row that the panel knows by its id (`point_out`); texts in English.
struct PanelRow {
  const char *id, *label, *help;
  const char* kind;  ///< kind of objects, or what else the row is about; empty for all objects
  /// Whether the row is there. Rows of objects are asked about only where an object is active.
  bool (*there)(const Editor&);
  /// Reason why it is not there.
  const char* otherwise = translatable("The active object does not have this property.");
  bool of_object = true;  ///< nothing for a locked object, or where none is active
};

}  // namespace hariko
