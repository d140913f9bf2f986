#pragma once

// FailingLayer: a file layer that fails at a given call, or at every call from it on.

#include <algorithm>
#include <cerrno>
#include <string>

#include "core/base/files/file_io.hpp"

namespace hariko::test {

/// Passes calls on to the system until call number `failing` (from 0), which fails with `error_number`.
/// Writes are cut into pieces, so that a failure may come in the middle. With `dead` every later call fails
/// too, which leaves the disk as after a crash or the removal of a drive.
class FailingLayer final : public FileLayer {
 public:
  FailingLayer(int failing, int error_number, bool dead = false, std::size_t piece = 7)
      : failing_(failing), error_(error_number), dead_(dead), piece_(piece) {}
  int calls() const { return calls_; }
  int renames() const { return renames_; }

  int create(const std::string& path, unsigned mode) override {
    return fails() ? -error_ : system_.create(path, mode);
  }
  int set_mode(int descriptor, unsigned mode) override {
    return fails() ? -error_ : system_.set_mode(descriptor, mode);
  }
  std::int64_t write(int descriptor, const char* data, std::size_t size) override {
    return fails() ? -error_ : system_.write(descriptor, data, std::min(size, piece_));
  }
  int sync(int descriptor) override { return fails() ? -error_ : system_.sync(descriptor); }
  int close(int descriptor) override {
    const int result = system_.close(descriptor);  // a failing close closes nevertheless
    return fails() ? -error_ : result;
  }
  int rename(const std::string& from, const std::string& to) override {
    if (fails()) return -error_;
    ++renames_;
    return system_.rename(from, to);
  }
  int remove(const std::string& path) override { return fails() ? -error_ : system_.remove(path); }
  int open_directory(const std::string& path) override {
    return fails() ? -error_ : system_.open_directory(path);
  }

 private:
  bool fails() {
    const int call = calls_++;
    return call == failing_ || (dead_ && call > failing_);
  }
  SystemFileLayer system_;
  int failing_, error_;
  bool dead_;
  std::size_t piece_;
  int calls_ = 0, renames_ = 0;
};

}  // namespace hariko::test
