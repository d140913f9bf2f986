#pragma once

// TestLog: one JSON line for each event, so that a test that drives the real window can wait for it and find
// things on the screen without guessing pixels.

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "app/input/input_queue.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

/// Log of the window for tests.
class TestLog {
 public:
  /// An empty path logs nothing.
  explicit TestLog(const std::filesystem::path& path);

  /// Logs a finished view of an object.
  void rebuilt(ObjectId object, const SurfaceView& view);
  /// Logs an event about a file.
  void file(const char* what, const std::filesystem::path& path);
  /// Counts changes of keys and buttons in the input of the next frame; they are logged once that frame has
  /// handled them.
  void input(const std::vector<InputEvent>& batch);
  /// Logs the processor time until the first frame was drawn, of all threads and including the system's
  /// share, and the number of pictures that the page still waits for.
  void first_frame(const Workbench& workbench);
  /// Logs the changes since the last frame. `idle`: whether the program has nothing left to do.
  void frame(const Editor& editor, const Workbench& workbench, bool idle);

 private:
  void layout(const Workbench& workbench);
  void pointer();
  void hovered(const Editor& editor);
  void taken();
  void frame_times(const FrameTimes& times);
  void vertices(const Editor& editor, const Workbench& workbench);
  void history(const Editor& editor);
  void notices(const Editor& editor);
  void paper(const Editor& editor);
  void commands(const Editor& editor, const Workbench& workbench);

  std::ofstream out_;
  bool on_ = false, idle_ = false;
  std::array<float, 2> pointer_{-1, -1};
  std::uint64_t keys_ = 0, buttons_ = 0;  ///< number of changes so far
  bool taken_ = false;
  std::map<std::string, Marks::Rect> rects_;
  std::size_t position_ = 0;
  std::uint64_t serial_ = ~std::uint64_t{0}, pictures_ = 0, frames_ = 0, commands_run_ = 0;
  bool gesture_ = false, dirty_ = false;
  std::string vertices_line_, paper_line_, selection_, last_notice_, commands_line_, last_note_, hovered_;
};

}  // namespace hariko
