// Pasting: files whose paths are in the clipboard are taken as if they had been dropped on the window.

#include <imgui.h>

#include <algorithm>
#include <cstdlib>

#include "core/base/files/file_ending.hpp"
#include "core/base/files/pasted_paths.hpp"
#include "render/reference_image.hpp"
#include "ui/files/file_dialogs.hpp"
#include "ui/shell/shell_commands.hpp"
#include "ui/widgets/application_services.hpp"

namespace hariko {

namespace {

constexpr Code e_paste_nothing{"E_PASTE_NOTHING"};

/// Whether the name is that of a picture, a document or a model. CAD files count where they cannot be read,
/// too: the import says what is missing.
bool names_file_to_take(const std::filesystem::path& path) {
  const std::vector<std::string> endings = openable_endings(true);
  return is_reference_file(path) ||
         std::find(endings.begin(), endings.end(), lower_ending(path)) != endings.end();
}

void paste_files(CommandHost& host) {
  const char* text = ImGui::GetClipboardText();
  const char* home = std::getenv("HOME");
  const auto files = pasted_paths(text ? text : "", home ? home : "", names_file_to_take);
  if (!files) return host.editor.notify(files.error());
  if (files->empty())
    return host.editor.notify(
        make_error(e_paste_nothing, "The clipboard names no picture, model or document.",
                   "Copy such a file in a file manager, or its path, and paste again."));
  host.application.drop_files(*files);
}

}  // namespace

void add_paste_commands(CommandHost& host) {
  host.table.add({.id = "edit.paste",
                  .menu = "Edit",
                  .label = "Paste files",
                  .help = "Take the pictures and models whose paths are in the clipboard, as if they were "
                          "dropped on the window.",
                  .keys = "Ctrl+V",
                  .changes_document = true,
                  .needs_window = true,
                  .run = [&host] { paste_files(host); },
                  .contexts = Context::empty});
}

}  // namespace hariko
