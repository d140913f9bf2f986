#include "app/window/failure_dialog.hpp"

#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "app/start_program.hpp"

namespace hariko {

void report_failure(const Message& error) {
  std::string text = error.text;
  if (!error.remedy.empty()) text += "\n" + error.remedy;
  std::cerr << text << std::endl;
  const bool desktop = std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY");
  if (!desktop || isatty(STDERR_FILENO)) return;
  if (start_program({"zenity", "--error", "--no-markup", "--title=Hariko", "--text=" + text})) return;
  if (start_program({"kdialog", "--title", "Hariko", "--error", text})) return;
  start_program({"xmessage", "-center", text});
}

}  // namespace hariko
