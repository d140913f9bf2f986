#include "ui/base/system_information.hpp"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include "render/renderer.hpp"

namespace hariko {

std::string program_version() {
  return "Hariko " HARIKO_VERSION;
}

std::string system_information() {
  return program_version() + "\n" + describe_gl() + "\nGLFW " + glfwGetVersionString() + "\nDear ImGui " +
         ImGui::GetVersion();
}

}  // namespace hariko
