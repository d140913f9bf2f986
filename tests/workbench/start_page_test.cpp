// The start page: what it offers, by mouse and by keys.

#include <filesystem>
#include <fstream>
#include <set>

#include "app/pictures/samples.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/workbench/headless_workbench.hpp"

namespace hariko::test {
namespace {

const std::vector<std::string> ways{"start.polyhedron", "start.solids", "start.sections", "start.outline",
                                    "start.open"};

/// The start page with all samples; `pictured` gets those whose pictures were asked for.
class StartPageBench {
 public:
  explicit StartPageBench(ImVec2 size = {1280, 800}) : bench_(Document(), size, &asked_) {
    bench_.workbench().samples() = find_samples(test::source_folder() + "/assets");
    bench_.editor().has_document = false;
    bench_.frame();
    bench_.frame();
  }
  HeadlessWorkbench* operator->() { return &bench_; }
  const std::map<std::string, Marks::Rect>& marks() { return bench_.workbench().marks().all(); }
  const std::set<std::string>& pictured() const { return asked_.pictured; }
  const std::vector<std::filesystem::path>& opened() const { return asked_.opened; }

 private:
  struct Asked final : test::NoServices {
    void give_picture(Sample& sample) override {
      sample.wanted = true;
      pictured.insert(sample.path.stem().string());
    }
    void open(const std::filesystem::path& path) override { opened.push_back(path); }
    std::set<std::string> pictured;
    std::vector<std::filesystem::path> opened;
  };
  Asked asked_;
  HeadlessWorkbench bench_;
};

TEST(StartPage, ShowsTheWaysInThenRecentFilesThenSamplesByTheWaysTheyWereMade) {
  StartPageBench bench;
  RecentFile file;
  file.path = "/somewhere/mouse.hariko";
  bench->workbench().offers().recent.push_back(file);
  bench->frame();
  const auto top = [&](const std::string& mark) { return bench.marks().at(mark).y; };
  for (std::size_t i = 1; i < ways.size(); ++i) {
    EXPECT_EQ(top(ways[i]), top(ways[0]));
    EXPECT_GT(bench.marks().at(ways[i]).x, bench.marks().at(ways[i - 1]).x);
  }
  EXPECT_GT(top("recent.mouse.hariko"), top("start.open"));
  EXPECT_GT(top("sample.car.hariko"), top("recent.mouse.hariko"));
  // The groups stand in the order of the ways.
  int before = 0;
  for (const char* one : {"car", "solids_dryer", "skin_car_smooth", "shell"}) {
    EXPECT_GT(top("sample." + std::string(one) + ".hariko"), before) << one;
    before = top("sample." + std::string(one) + ".hariko");
  }
}

TEST(StartPage, BeginsWhatItSays) {
  const auto chosen = [](const std::string& way, const auto& look) {
    SCOPED_TRACE(way);
    StartPageBench bench;
    bench->click(way);
    bench->frame();
    bench->frame();
    look(bench);
  };
  chosen("start.polyhedron", [](StartPageBench& bench) {
    ASSERT_TRUE(bench->editor().active_object());
    EXPECT_TRUE(bench->editor().active_object()->polyhedron());
  });
  chosen("start.solids", [](StartPageBench& bench) {
    ASSERT_TRUE(bench->editor().active_object());
    EXPECT_TRUE(bench->editor().active_object()->solids());
  });
  for (const char* drawn : {"start.sections", "start.outline"})
    chosen(drawn, [](StartPageBench& bench) {
      EXPECT_TRUE(bench->editor().has_document);
      EXPECT_TRUE(bench->workbench().viewport().tool_active());
    });
  chosen("start.open", [](StartPageBench& bench) {
    EXPECT_FALSE(bench->editor().has_document);
    EXPECT_TRUE(bench.marks().contains("dialog.name"));
  });
}

TEST(StartPage, IsUsedByKeysAlone) {
  StartPageBench bench;
  bench->key("Enter");
  EXPECT_FALSE(bench->editor().has_document) << "nothing is chosen yet";
  bench->key("Tab");
  bench->key("Tab");  // past the guide
  bench->key("Right");
  bench->key("Down");  // below the second way, the second sample
  bench->frame();
  bench->key("Enter");
  ASSERT_EQ(bench.opened().size(), 1U);
  EXPECT_EQ(bench.opened()[0].stem(), "fig2");
  bench->key("Up");
  bench->key("Enter");
  ASSERT_TRUE(bench->editor().active_object());
  EXPECT_TRUE(bench->editor().active_object()->solids());
}

TEST(StartPage, EveryCardIsReachedByTabAndComesIntoSight) {
  StartPageBench bench({800, 600});
  std::set<std::string> seen;
  const std::size_t cards = 6 + bench->workbench().samples().size();
  for (std::size_t i = 0; i < cards; ++i) {
    bench->key("Tab");
    for (int frame = 0; frame < 3; ++frame) bench->frame();
    for (const auto& [mark, rect] : bench.marks()) {
      const bool whole = rect.y >= 0 && rect.y + rect.height <= 600;
      if (whole && (mark.starts_with("sample.") || mark.starts_with("start."))) seen.insert(mark);
    }
  }
  EXPECT_EQ(seen.size(), cards);
}

TEST(StartPage, UnsavedWorkHasItsPlaceBeforeItIsKnown) {
  StartPageBench bench;
  RecentFile file;
  file.path = "/somewhere/mouse.hariko";
  Offers& offers = bench->workbench().offers();
  offers.recent.push_back(file);
  offers.recovery_places = 1;
  bench->frame();
  const int before = bench.marks().at("recent.mouse.hariko").y;
  ASSERT_TRUE(bench.marks().contains("recovery.place.0"));
  RecoveryOffer offer;
  offer.id = "1";
  offers.recoveries.push_back(offer);
  offers.recoveries_known = true;
  bench->frame();
  ASSERT_TRUE(bench.marks().contains("recovery.recover"));
  EXPECT_EQ(bench.marks().at("recent.mouse.hariko").y, before) << "the list goes away under the pointer";
  offers.recoveries.clear();  // it was nothing
  bench->frame();
  EXPECT_EQ(bench.marks().at("recent.mouse.hariko").y, before);
}

TEST(StartPage, FitsNarrowWindowsInBothLanguages) {
  for (const bool japanese : {false, true}) {
    SCOPED_TRACE(japanese);
    StartPageBench bench({800, 600});
    if (japanese) {
      bench->editor().language = Language::load(test::source_folder() + "/assets/languages/ja.po").value();
      FontRequest fonts;
      for (const char32_t character : bench->editor().language.characters())
        fonts.characters.insert(character);
      bench->set_fonts(fonts);
    }
    bench->frame();
    bench->frame();
    for (const std::string& way : ways) {
      const Marks::Rect rect = bench.marks().at(way);
      EXPECT_GE(rect.x, 0) << way;
      EXPECT_LE(rect.x + rect.width, 800) << way;
      EXPECT_LE(rect.y + rect.height, 600) << way;
    }
    for (const char* title : {"Polyhedron", "Solids", "Sections", "Outline", "Open or import"})
      EXPECT_LE(ImGui::CalcTextSize(bench->editor().language(title)).x,
                static_cast<float>(bench.marks().at(ways[0]).width - 24))
          << title;
  }
}

TEST(StartPage, AsksForPicturesOfWhatIsSeenAndNoMore) {
  StartPageBench bench({800, 600});
  EXPECT_TRUE(bench.pictured().contains("car"));
  EXPECT_TRUE(bench.pictured().contains("shell")) << "that of a way in";
  EXPECT_FALSE(bench.pictured().contains("catenoid")) << "the last sample";
  bench->key("End");
  for (int frame = 0; frame < 3; ++frame) bench->frame();
  EXPECT_TRUE(bench.pictured().contains("catenoid"));
}

TEST(Samples, HaveTitlesInBothLanguagesAndAPlaceAmongTheWays) {
  const auto japanese = Language::load(test::source_folder() + "/assets/languages/ja.po").value();
  std::set<std::string> titles;
  for (const Sample& sample : find_samples(test::source_folder() + "/assets")) {
    SCOPED_TRACE(sample.path.filename());
    EXPECT_NE(sample.beginning, Beginning::other);
    EXPECT_TRUE(japanese.has(sample.title)) << sample.title;
    EXPECT_TRUE(japanese.has(sample.description)) << sample.description;
    EXPECT_TRUE(titles.insert(sample.title).second) << "two samples are called " << sample.title;
  }
  EXPECT_GE(titles.size(), 40U);
}

TEST(Samples, UnknownOnesComeLastUnderTheirNames) {
  test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "samples");
  for (const char* name : {"a_lamp.hariko", "cube.hariko", "notes.txt"})
    std::ofstream(folder.path() / "samples" / name) << "{}";
  const std::vector<Sample> samples = find_samples(folder.path());
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0].title, "Cube");
  EXPECT_EQ(samples[1].title, "A lamp");
  EXPECT_EQ(samples[1].beginning, Beginning::other);
}

}  // namespace
}  // namespace hariko::test
