// Temporary files that a killed writer left behind go; those of living ones, and files of others, stay.

#include "core/base/files/temporary_files.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>

#include "core/base/files/file_io.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;

/// A process that has ended: nobody has its number but a later one, which numbers reach only after a round.
pid_t dead_process() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  return child;
}

void make_old(const fs::path& file) {
  fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::seconds(stale_seconds + 60));
}

fs::path leave(const fs::path& folder, const std::string& name) {
  test::spill(folder / name, "half of it");
  make_old(folder / name);
  return folder / name;
}

TEST(TemporaryFiles, LeftoversOfDeadWritersGo) {
  const test::TemporaryFolder folder;
  const fs::path left = leave(folder.path(), ".hariko-" + std::to_string(dead_process()) + "-0.tmp");
  EXPECT_EQ(remove_stale_temporaries(folder.path()), 1U);
  EXPECT_FALSE(fs::exists(left));
  EXPECT_EQ(remove_stale_temporaries(folder.path()), 0U);
}

TEST(TemporaryFiles, NothingElseIsTouched) {
  const test::TemporaryFolder folder;
  const std::string dead = std::to_string(dead_process());
  for (const std::string& name : std::initializer_list<std::string>{
           temporary_name(3), ".hariko-" + dead + ".tmp", ".hariko-" + dead + "-1.tmp.bak",
           "hariko-" + dead + "-1.tmp", ".hariko-" + dead + "-x.tmp", ".hariko-" + dead + "-1-2.tmp",
           ".hariko--1-1.tmp", ".hariko-0-1.tmp", ".hariko-99999999999999999999-1.tmp",
           std::string(".hariko-.tmp"), std::string(".hariko-1.tmp"), std::string("model.hariko")}) {
    const fs::path file = leave(folder.path(), name);
    EXPECT_EQ(remove_stale_temporaries(folder.path()), 0U) << name;
    EXPECT_TRUE(fs::exists(file)) << name;
  }
  // Young ones: their writer may be on another machine and just about to lock them.
  const fs::path young = folder.path() / (".hariko-" + dead + "-7.tmp");
  test::spill(young, "a");
  // A folder and a link of such a name are not ours.
  fs::create_directory(folder.path() / (".hariko-" + dead + "-8.tmp"));
  fs::create_symlink(folder.path() / "model.hariko", folder.path() / (".hariko-" + dead + "-9.tmp"));
  EXPECT_EQ(remove_stale_temporaries(folder.path()), 0U);
  EXPECT_TRUE(fs::exists(young));
  EXPECT_TRUE(fs::exists(folder.path() / "model.hariko"));
  EXPECT_EQ(remove_stale_temporaries(folder.path() / "missing"), 0U);
}

TEST(TemporaryFiles, WhatAWriterHoldsStays) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / (".hariko-" + std::to_string(dead_process()) + "-0.tmp");
  // As a writer on another machine makes it: the number of its process says nothing here.
  SystemFileLayer layer;
  const int descriptor = layer.create(file.native(), 0600);
  ASSERT_GE(descriptor, 0);
  make_old(file);
  EXPECT_EQ(remove_stale_temporaries(folder.path()), 0U);
  EXPECT_TRUE(fs::exists(file));
  layer.close(descriptor);
  EXPECT_EQ(remove_stale_temporaries(folder.path()), 1U);
}

TEST(TemporaryFiles, AKilledWriteLeavesOneThatGoes) {
  const test::TemporaryFolder folder;
  // A child that dies in the middle of writing.
  class Dying final : public FileLayer {
   public:
    int create(const std::string& path, unsigned mode) override { return system_.create(path, mode); }
    int set_mode(int descriptor, unsigned mode) override { return system_.set_mode(descriptor, mode); }
    std::int64_t write(int descriptor, const char* data, std::size_t) override {
      (void)system_.write(descriptor, data, 1);
      ::_exit(0);
    }
    int sync(int descriptor) override { return system_.sync(descriptor); }
    int close(int descriptor) override { return system_.close(descriptor); }
    int rename(const std::string& from, const std::string& to) override { return system_.rename(from, to); }
    int remove(const std::string& path) override { return system_.remove(path); }
    int open_directory(const std::string& path) override { return system_.open_directory(path); }

   private:
    SystemFileLayer system_;
  };
  const pid_t child = ::fork();
  if (child == 0) {
    Dying layer;
    (void)write_file_atomic(folder.path() / "model.hariko", "whole", layer);
    ::_exit(1);
  }
  ::waitpid(child, nullptr, 0);
  std::size_t left = 0;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    make_old(entry.path());
    ++left;
  }
  ASSERT_EQ(left, 1U);
  EXPECT_EQ(remove_stale_temporaries(folder.path()), 1U);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace hariko
