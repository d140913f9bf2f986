#include "app/failure_dialog.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

extern "C" char** environ;

namespace hariko {

namespace {

/// Without our streams: whoever reads them must not wait for the message to be closed.
bool started(std::initializer_list<std::string> command) {
  std::vector<std::string> words(command);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  pid_t child = 0;
  const int result = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return result == 0;
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
