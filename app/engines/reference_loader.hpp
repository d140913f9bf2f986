#pragma once

// ReferenceLoader: decodes the displayed reference pictures, off the main thread, and frees the others.

#include <functional>
#include <map>
#include <string>
#include <utility>

#include "app/engines/work_lane.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// Loader of reference pictures. For the main thread.
class ReferenceLoader {
 public:
  ReferenceLoader(Editor& editor, std::function<void()> wake);

  /// Requests pictures that the document shows and that are not decoded, and frees pictures that it no longer
  /// shows. Hidden pictures use no memory; only the existence of their files is checked once. When everything
  /// is known, missing files are reported once.
  void sync();
  std::size_t publish() { return lane_.publish(); }
  bool idle() const { return lane_.idle(); }
  void wait() { lane_.wait(); }

 private:
  /// File path, or address of packed bytes.
  using Key = std::pair<std::string, const std::string*>;
  struct Entry {
    ReferenceView view;
    Shared<std::string> bytes;  ///< keeps the address unique
    WorkLane::Key job = 0;      ///< 0: none yet
    bool shown = false;         ///< decoded, or being decoded
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
  WorkLane lane_;  ///< last: its thread stops before the other members are destroyed
};

}  // namespace hariko
