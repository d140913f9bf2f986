#pragma once

#include <string>

namespace hariko {

/// "Hariko 1.2.3"
std::string program_version();
/// Facts for a report about a mistake, in English whatever the language: versions of the program and of what
/// it stands on, and the graphics driver. Needs a current OpenGL context.
std::string system_information();

}  // namespace hariko
