#include "app/failure_dialog.hpp"

#include <spawn.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

extern "C" char** environ;

namespace hariko {

namespace {

bool started(std::initializer_list<std::string> command) {
  std::vector<std::string> words(command);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  return posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) == 0;
}

}  // namespace

void report_failure(const Message& error) {
  std::string text = error.text;
  if (!error.remedy.empty()) text += "\n" + error.remedy;
  std::cerr << text << std::endl;
  const bool desktop = std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY");
  if (!desktop || isatty(STDERR_FILENO)) return;
  if (started({"zenity", "--error", "--no-markup", "--title=Hariko", "--text=" + text})) return;
  if (started({"kdialog", "--title", "Hariko", "--error", text})) return;
  started({"xmessage", "-center", text});
}

}  // namespace hariko
