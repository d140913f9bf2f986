// Section curves by hand: several planes through all objects by palette and panel, their combs, and their
// files.

#include <algorithm>

#include "app/engines/section_engine.hpp"
#include "core/document/edits/edits.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/headless_workbench.hpp"

namespace hariko {
namespace {

/// Keeps what is to be exported.
class OrderedSections : public test::NoServices {
 public:
  void export_sections(SectionOrder order) override { ordered = std::move(order); }
  std::optional<SectionOrder> ordered;
};

Document part_and_copy() {
  Document document = document_from_mesh(test::cube(), "Part").value();
  Similarity place{.translation = {4, 0, 0}};
  return add_object(document, "Copy", document.objects[0]->source, place)->document;
}

class SectionCurvesByHand : public ::testing::Test {
 protected:
  void SetUp() override {
    bench_ = std::make_unique<test::HeadlessWorkbench>(part_and_copy(), ImVec2{1440, 1000}, &services_);
    engine_ = std::make_unique<SectionEngine>(editor(), editor().sections, [] {});
    bench_->wait_for_surfaces();
  }
  void TearDown() override { engine_.reset(); }
  Editor& editor() { return bench_->editor(); }
  const std::map<std::string, Marks::Rect>& marks() { return bench_->workbench().marks().all(); }
  void frames(int count) { bench_->frames(count); }
  /// Until the curves are those of the planes and surfaces.
  void make_curves() {
    bench_->wait_for_surfaces();
    engine_->sync();
    engine_->wait();
    engine_->publish();
    frames(2);
  }
  void from_palette(const char* words, const std::string& id) {
    bench_->from_palette(words, id);
    make_curves();
  }
  /// Clicks an item of the rows, which are brought into sight first.
  void click_row(const std::string& mark) {
    bench_->workbench().show_property("section_combs");
    frames(4);
    bench_->click(mark);
    frames(3);
  }
  const Scene& scene() { return bench_->workbench().viewport().scene().scene(); }

  OrderedSections services_;
  std::unique_ptr<test::HeadlessWorkbench> bench_;
  std::unique_ptr<SectionEngine> engine_;
};

TEST_F(SectionCurvesByHand, PlanesThroughAllObjectsComeAndGo) {
  from_palette("section curves", "analyse.section_curves");
  const SectionCurves& curves = editor().sections;
  ASSERT_TRUE(curves.set) << (curves.error ? curves.error->text : "");
  EXPECT_EQ(curves.planes.count, 7);
  const auto of_object = [&](std::size_t number) {
    return std::count_if(curves.set->curves.begin(), curves.set->curves.end(),
                         [&](const SectionCurve& curve) { return curve.surface == number; });
  };
  EXPECT_GT(of_object(0), 0);
  EXPECT_GT(of_object(1), 0);
  EXPECT_EQ(scene().curves.size(), 2U) << "teeth and curves";
  EXPECT_FALSE(editor().history.dirty()) << "a way of looking, no edit";
  // A hidden object is not cut.
  const ObjectId copy = editor().document().objects[1]->id;
  EXPECT_TRUE(editor().commit(set_visible(editor().history.current(), copy, false), "Hide"));
  make_curves();
  EXPECT_EQ(of_object(1), 0);
  from_palette("section curves", "analyse.section_curves");
  EXPECT_FALSE(curves.shown);
  EXPECT_TRUE(scene().curves.empty());
}

/// A replay begins without them, so that rows of the panel would stand elsewhere in it.
TEST_F(SectionCurvesByHand, ARecordingBeginsWithoutThem) {
  from_palette("section curves", "analyse.section_curves");
  ASSERT_TRUE(editor().sections.shown);
  editor().begin_recording();
  bench_->workbench().forget_interface();
  make_curves();
  EXPECT_FALSE(editor().sections.shown);
  EXPECT_FALSE(editor().sections.placed);
  EXPECT_TRUE(scene().curves.empty());
  editor().end_recording();
}

TEST_F(SectionCurvesByHand, CombsGoOffAndOnAndGetLonger) {
  from_palette("section curves", "analyse.section_curves");
  const double length = tooth_length(*editor().sections.set, editor().sections.combs.scale);
  EXPECT_GT(length, 0);
  from_palette("longer section teeth", "analyse.section_longer");
  EXPECT_NEAR(tooth_length(*editor().sections.set, editor().sections.combs.scale), 2 * length, 1e-9 * length);
  click_row("check.section_combs");
  make_curves();
  EXPECT_FALSE(editor().sections.combs.shown);
  EXPECT_EQ(scene().curves.size(), 1U) << "curves alone";
  click_row("check.section_combs");
  make_curves();
  EXPECT_EQ(scene().curves.size(), 2U);
}

TEST_F(SectionCurvesByHand, TheDirectionIsChosenInThePanel) {
  from_palette("section curves", "analyse.section_curves");
  click_row("combo.section_across");
  bench_->click("choice.section_across.2");
  make_curves();
  EXPECT_EQ(editor().sections.planes.direction, Vector3::UnitZ());
  for (const SectionCurve& curve : editor().sections.set->curves) {
    const double height = editor().sections.planes.offset(curve.plane);
    for (const Vector3& point : curve.points) EXPECT_NEAR(point.z(), height, 1e-6);
  }
}

TEST_F(SectionCurvesByHand, PlanesThatMeetNothingAreTold) {
  from_palette("section curves", "analyse.section_curves");
  editor().sections.planes.first = 1000;
  make_curves();
  ASSERT_TRUE(editor().sections.error);
  EXPECT_TRUE(scene().curves.empty());
  click_row("button.section_spread");
  make_curves();
  EXPECT_FALSE(editor().sections.error);
  EXPECT_EQ(scene().curves.size(), 2U);
}

TEST_F(SectionCurvesByHand, TheFileIsOrderedWithPlanesAndCombs) {
  const Command* command = bench_->workbench().commands().find("analyse.section_export");
  ASSERT_NE(command, nullptr);
  EXPECT_TRUE(command->why_not()) << "nothing is shown yet";
  from_palette("section curves", "analyse.section_curves");
  from_palette("export section curves", "analyse.section_export");
  ASSERT_TRUE(marks().contains("dialog.accept"));
  bench_->click("dialog.format");
  frames(3);
  bench_->click("dialog.format.dxf");
  frames(2);
  bench_->click("dialog.accept");
  frames(2);
  ASSERT_TRUE(services_.ordered);
  EXPECT_EQ(services_.ordered->file.filename(), "Untitled sections.dxf");
  EXPECT_EQ(services_.ordered->surfaces.size(), 2U);
  EXPECT_EQ(services_.ordered->planes, editor().sections.planes);
  EXPECT_EQ(services_.ordered->millimetres, 1);
}

}  // namespace
}  // namespace hariko
