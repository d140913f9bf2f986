#pragma once

#include "ui/editor/command_host.hpp"

namespace hariko {

/// The Skin menu. The host must outlive the table.
void add_skin_commands(CommandHost& host);

}  // namespace hariko
