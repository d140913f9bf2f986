#pragma once

#include "ui/editor/command_host.hpp"

namespace hariko {

/// Taking objects of patches apart and putting them together. The host must outlive the table.
void add_patch_commands(CommandHost& host);

}  // namespace hariko
