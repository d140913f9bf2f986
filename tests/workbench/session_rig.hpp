#pragma once

// An open document and its file, driven as the window drives them, with folders of their own.

#include "app/document_session.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/document/file.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/workbench/bench_hands.hpp"

namespace hariko::test {

/// A window without a window, with folders of its own.
class Session : private NoServices {
 public:
  explicit Session(const std::filesystem::path& folder)
      : bench_(box(), {800, 560}, this),
        session_(bench_.editor(), bench_.workbench(), {folder / "config", folder / "state", folder / "cache"},
                 folder / "samples",
                 {[] {}, [] {}, [this](const char* what, const auto&) { happened_.emplace_back(what); }}) {}

  DocumentSession& operator*() { return session_; }
  DocumentSession* operator->() { return &session_; }
  Editor& editor() { return bench_.editor(); }
  HeadlessWorkbench& bench() { return bench_; }
  bool happened(const std::string& what) const {
    return std::find(happened_.begin(), happened_.end(), what) != happened_.end();
  }
  bool shows(const std::string& mark) { return bench_.workbench().marks().all().contains(mark); }

  /// Until all work on files is done and shown.
  void settle() {
    while (!session_.idle()) {
      session_.publish();
      std::this_thread::yield();
    }
    session_.update();
    bench_.frame();
    bench_.frame();
  }
  void click(const std::string& mark) {
    bench_.click(mark);
    settle();
  }
  void rename_object(const std::string& name) {
    Editor& editor = bench_.editor();
    const Document& document = editor.history.current();
    ASSERT_TRUE(editor.commit(hariko::rename_object(document, document.objects[0]->id, name), "Rename"));
    session_.update();
  }

 private:
  void open(const std::filesystem::path& path) override { session_.open(path); }
  void save(const std::filesystem::path& path, std::function<void()> then) override {
    session_.save(path, std::move(then));
  }

  std::vector<std::string> happened_;
  HeadlessWorkbench bench_;
  DocumentSession session_;
};

/// A document in a file, as most sessions begin.
class OpenFile : public ::testing::Test {
 protected:
  OpenFile() { EXPECT_TRUE(save_document(box("Saved"), file_).ok()); }
  void SetUp() override {
    session_.emplace(folder_.path());
    (*session_)->open(file_);
    session_->settle();
    ASSERT_EQ(session_->editor().path, file_);
  }
  /// The name of the object that a file holds.
  static std::string name_in(const std::filesystem::path& file) {
    const auto document = load_document(file);
    return document.ok() ? document->objects[0]->name : to_string(document.error());
  }
  std::string last_notice() {
    const auto& notices = session_->editor().notices();
    return notices.empty() ? std::string() : notices.back().text;
  }
  void save() {
    session_->bench().key("Ctrl+S");
    session_->settle();
  }

  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "model.hariko";
  std::optional<Session> session_;
};

}  // namespace hariko::test
