#pragma once

// CommandServices: what commands of the workspaces ask of the window and of the application beyond the
// document: questions, dialogs about files, work that goes on beside.

#include <string>
#include <vector>

#include "ui/widgets/prompt.hpp"

namespace hariko {

class CommandServices {
 public:
  virtual ~CommandServices() = default;

  /// Asks something that cannot be undone.
  virtual void ask(Prompt::Request request) = 0;
  /// Makes a polyhedron of a skin's or of solids' surface.
  virtual void convert(ObjectId object) = 0;
  /// Adds a section to a skin, taken from its surface at a place of the path, 0 .. 1.
  virtual void add_section(ObjectId skin, double place) = 0;

  // Each opens its dialog.
  virtual void export_pages() = 0;
  virtual void add_picture() = 0;
  virtual void replace_picture(ObjectId picture) = 0;
  virtual void unpack_picture(ObjectId picture) = 0;
  /// `missing`: the name of the file that is looked for, printable.
  virtual void find_pictures(const std::string& missing) = 0;
  /// Takes linked pictures into the document.
  virtual void pack_pictures(const std::vector<ObjectId>& pictures) = 0;
};

}  // namespace hariko
