// The report of a crash, offered at the next start: on the start page, and over a document.

#include "app/offers.hpp"
#include "core/document/edits/edits.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/workbench/headless_workbench.hpp"

namespace hariko::test {
namespace {

class OfferOfACrash : public ::testing::Test, protected test::NoServices {
 protected:
  OfferOfACrash()
      : bench_(document_from_mesh(test::prism(4), "Box").value(), {1280, 900}, this),
        offers_(bench_.editor(), bench_.workbench(), state_, log_, [this](const auto& path) {
          shown_.push_back(path);
          return can_show_;
        }) {
    std::filesystem::create_directory(state_);
    log_.line("opened", "vase.hariko");
    spill(state_ / "crash-77.txt", "hariko crashed: SEGV\nvase(f+0x1)\n");
  }
  /// As the window does at its start.
  void start() {
    offers_.find();
    bench_.workbench().offer_recovery();
    bench_.frame();
    bench_.frame();
  }
  bool shows(const std::string& mark) { return bench_.workbench().marks().all().contains(mark); }

  test::TemporaryFolder folder_;
  std::filesystem::path state_ = folder_.path() / "state";
  RunLog log_{state_};
  std::vector<std::filesystem::path> shown_;
  bool can_show_ = true;
  HeadlessWorkbench bench_;
  CrashOffers offers_;

 private:
  void dismiss_crash() override { offers_.dismiss(); }
  void show_log_folder() override { offers_.show_folder(); }
};

TEST_F(OfferOfACrash, StandsOnTheStartPage) {
  bench_.editor().has_document = false;
  start();
  EXPECT_TRUE(shows("crash.copy"));
  EXPECT_FALSE(shows("offers.close")) << "a dialog over the start page";
  bench_.click("crash.copy");
  const std::string copied = ImGui::GetClipboardText();
  EXPECT_TRUE(copied.starts_with("hariko crashed: SEGV\nvase(f+0x1)\n")) << copied;
  EXPECT_NE(copied.find(" opened vase.hariko\n"), std::string::npos) << "the log is missing: " << copied;

  bench_.click("crash.folder");
  EXPECT_EQ(shown_, std::vector{state_});

  bench_.click("crash.dismiss");
  bench_.frame();
  EXPECT_FALSE(shows("crash.copy"));
  start();
  EXPECT_FALSE(shows("crash.copy")) << "a report that was dismissed is offered again";
  EXPECT_TRUE(std::filesystem::exists(state_ / "crash.txt"));
}

TEST_F(OfferOfACrash, StandsInADialogOverADocument) {
  start();
  ASSERT_TRUE(shows("crash.dismiss"));
  bench_.click("offers.close");
  bench_.frame();
  EXPECT_FALSE(shows("crash.dismiss"));
  // Later means later.
  EXPECT_TRUE(bench_.workbench().commands().run("file.recover").ran);
  bench_.frame();
  bench_.frame();
  ASSERT_TRUE(shows("crash.dismiss"));
  bench_.click("crash.dismiss");
  bench_.frame();
  bench_.frame();
  EXPECT_FALSE(shows("crash.dismiss"));
  EXPECT_FALSE(shows("offers.close")) << "an empty dialog stays open";
}

TEST_F(OfferOfACrash, StandsAboveUnsavedWork) {
  bench_.workbench().offers().recoveries.push_back({"1", "/tmp/vase.hariko", 0, 1, false, false, 0, 1});
  start();
  ASSERT_TRUE(shows("crash.dismiss"));
  ASSERT_TRUE(shows("recovery.recover"));
  const auto& marks = bench_.workbench().marks().all();
  EXPECT_LT(marks.at("crash.dismiss").y, marks.at("recovery.recover").y);
  bench_.click("crash.dismiss");
  bench_.frame();
  EXPECT_TRUE(shows("recovery.recover")) << "dismissing the report took the work away";
}

TEST_F(OfferOfACrash, WithoutAFileManagerANoticeSaysWhere) {
  can_show_ = false;
  offers_.show_folder();
  ASSERT_FALSE(bench_.editor().notices().empty());
  EXPECT_NE(bench_.editor().notices().back().text.find(state_.string()), std::string::npos);
}

TEST_F(OfferOfACrash, NothingIsOfferedWhereNothingCrashed) {
  std::filesystem::remove(state_ / "crash-77.txt");
  start();
  EXPECT_FALSE(bench_.workbench().offers().crash);
  EXPECT_FALSE(shows("offers.close"));
}

}  // namespace
}  // namespace hariko::test
