#pragma once

// Setting properties by numbers and words, as scripts do it.

#include "ui/editor/command_host.hpp"

namespace hariko {

/// Gives the commands on properties their uses in scripts: values for all chosen objects that have the
/// property, as one step. Words are those of the file format. The host must outlive the table.
void use_properties_in_scripts(CommandHost& host);

}  // namespace hariko
