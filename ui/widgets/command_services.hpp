#pragma once

// CommandServices: what commands and panels ask of the window beyond the document: questions and dialogs
// about files.

#include <filesystem>
#include <string>

#include "ui/widgets/prompt.hpp"

namespace hariko {

class CommandServices {
 public:
  virtual ~CommandServices() = default;

  /// Asks something that cannot be undone.
  virtual void ask(Prompt::Request request) = 0;
  /// Opens a file, whatever kind it is, after asking about unsaved work.
  virtual void open_guarded(const std::filesystem::path& path) = 0;

  // Each opens its dialog.
  virtual void export_pages() = 0;
  virtual void export_sections() = 0;
  virtual void add_picture() = 0;
  virtual void replace_picture(ObjectId picture) = 0;
  virtual void unpack_picture(ObjectId picture) = 0;
  /// `missing`: the name of the file that is looked for, printable.
  virtual void find_pictures(const std::string& missing) = 0;
  virtual void choose_environment() = 0;
};

}  // namespace hariko
