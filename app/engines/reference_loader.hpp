#pragma once

// ReferenceLoader: decodes the reference pictures that show, off the main thread, and forgets the others.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "app/engines/work_lane.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// For the main thread.
class ReferenceLoader {
 public:
  ReferenceLoader(Editor& editor, std::function<void()> wake);

  /// Asks for what the document shows and has not yet, and lets go of what it shows no more. Hidden pictures
  /// cost no memory; of their files it is found out once whether they are there. When all is known, files
  /// that are missing are told once.
  void sync();
  std::size_t publish() { return lane_.publish(); }
  bool idle() const { return lane_.idle(); }
  void wait() { lane_.wait(); }

 private:
  /// A file, or bytes of the document by their address.
  using Key = std::pair<std::string, const std::string*>;
  struct Entry {
    ReferenceView view;
    Shared<std::string> bytes;  ///< keeps the address its own
    WorkLane::Key job = 0;      ///< 0: none yet
    bool shown = false;         ///< decoded, or to be
    bool told = false;
  };
  static Key key_of(const PictureSource& source);
  void request(const Key& key, Entry& entry);
  void show();
  void tell_missing();

  Editor& editor_;
  std::map<Key, Entry> entries_;
  std::uint64_t document_ = 0;  ///< Editor::documents at the last `sync`
  WorkLane::Key next_ = 1;
  WorkLane lane_;  ///< last: its thread stops before the rest goes
};

}  // namespace hariko
