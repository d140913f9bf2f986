#pragma once

// Commands on the window itself: files, preferences, rows of the properties, help. The workbench must outlive
// the table.

#include "ui/editor/command_host.hpp"

namespace hariko {

class Workbench;

void add_file_commands(CommandHost& host, Workbench& workbench);
/// Gives them their uses in scripts: files by their paths.
void use_files_in_scripts(CommandHost& host);
/// Taking files whose paths are in the clipboard.
void add_paste_commands(CommandHost& host);
/// Writing what is done as a script.
void add_record_commands(CommandHost& host, Workbench& workbench);
void add_preferences_commands(CommandHost& host, Workbench& workbench);
/// Commands for what stands in the properties, so that the palette finds it by its name.
void add_property_commands(CommandHost& host, Workbench& workbench);
void add_help_commands(CommandHost& host, Workbench& workbench);
/// After all commands are there: what designers who come from elsewhere call them.
void add_other_names(CommandTable& table);

}  // namespace hariko
