// Saved views in the document: edits, what is refused, units, files and undo.

#include <limits>

#include "core/document/convert_unit.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/format/format.hpp"
#include "core/document/history/history.hpp"
#include "tests/document/random_documents.hpp"

namespace hariko {
namespace {

SavedView view_called(const std::string& name) {
  SavedView view;
  view.name = name;
  view.target = Vector3(1, 2, 3);
  view.orientation = Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5);
  view.distance = 40;
  view.projection = Projection::two_point;
  view.focal_length = 35;
  return view;
}

Document with_two_views() {
  const Document one = add_view(test::cube_document(), view_called("Front left")).value();
  return add_view(one, view_called("Detail")).value();
}

TEST(SavedViews, AreAddedFoundUpdatedRenamedAndRemoved) {
  const Document document = with_two_views();
  ASSERT_EQ(document.saved_views->size(), 2U);
  EXPECT_EQ(*find_view(document, "Detail"), view_called("Detail"));
  EXPECT_EQ(find_view(document, "detail"), nullptr);
  SavedView closer = view_called("Front left");
  closer.distance = 10;
  const Document updated = update_view(document, closer).value();
  EXPECT_EQ((*updated.saved_views)[0], closer) << "it keeps its place";
  EXPECT_EQ(update_view(document, view_called("Detail"))->saved_views.get(), document.saved_views.get())
      << "an edit without effect shares everything";
  const Document renamed = rename_view(document, "Front left", "View 1").value();
  EXPECT_EQ((*renamed.saved_views)[0].name, "View 1");
  EXPECT_EQ(rename_view(document, "Detail", "Detail")->saved_views.get(), document.saved_views.get());
  const Document left = remove_view(document, "Front left").value();
  ASSERT_EQ(left.saved_views->size(), 1U);
  EXPECT_EQ((*left.saved_views)[0].name, "Detail");
  EXPECT_EQ(left.objects, document.objects) << "nothing else changes";
}

TEST(SavedViews, WhatMakesNoneIsRefused) {
  const Document document = with_two_views();
  const auto code_of = [&](auto&& change) {
    SavedView view = view_called("New");
    change(view);
    const auto added = add_view(document, view);
    return added ? Code{"fine"} : added.error().code;
  };
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(code_of([](SavedView&) {}), Code{"fine"});
  EXPECT_EQ(code_of([](SavedView& v) { v.name = " "; }), e_name_empty);
  EXPECT_EQ(code_of([](SavedView& v) { v.name = "a\nb"; }), e_name_invalid);
  EXPECT_EQ(code_of([](SavedView& v) { v.name = "Detail"; }), e_view_name_taken);
  EXPECT_EQ(code_of([&](SavedView& v) { v.target.y() = infinity; }), e_view_invalid);
  EXPECT_EQ(code_of([](SavedView& v) { v.distance = 0; }), e_view_invalid);
  EXPECT_EQ(code_of([](SavedView& v) { v.distance = std::nan(""); }), e_view_invalid);
  EXPECT_EQ(code_of([](SavedView& v) { v.orientation.w() = 0.6; }), e_view_invalid);
  EXPECT_EQ(code_of([](SavedView& v) { v.focal_length = 14; }), e_view_invalid);
  EXPECT_EQ(code_of([](SavedView& v) { v.focal_length = 301; }), e_view_invalid);
  EXPECT_EQ(update_view(document, view_called("Other")).error().code, e_unknown_view);
  EXPECT_EQ(rename_view(document, "Other", "New").error().code, e_unknown_view);
  EXPECT_EQ(rename_view(document, "Detail", "Front left").error().code, e_view_name_taken);
  EXPECT_EQ(rename_view(document, "Detail", "").error().code, e_name_empty);
  EXPECT_EQ(remove_view(document, "Other").error().code, e_unknown_view);
  Document full = document;
  SavedViews many(Document::max_views, view_called(""));
  for (std::size_t i = 0; i < many.size(); ++i) many[i].name = std::to_string(i);
  full.saved_views = many;
  EXPECT_EQ(add_view(full, view_called("New")).error().code, e_too_many_views);
  EXPECT_EQ(append_document(document, full).error().code, e_too_many_views);
}

TEST(SavedViews, FollowTheUnitInTheirRealSize) {
  const Document document = with_two_views();
  const Document metres = convert_unit(document, Unit::metre).value();
  const SavedView& view = (*metres.saved_views)[0];
  EXPECT_LT((view.target - Vector3(0.001, 0.002, 0.003)).norm(), 1e-15);
  EXPECT_NEAR(view.distance, 0.04, 1e-15);
  EXPECT_EQ(view.focal_length, 35) << "a lens stays as it is";
  Document far = document;
  SavedViews views = *document.saved_views;
  views[0].distance = SavedView::max_distance;
  far.unit = Unit::metre;
  far.saved_views = views;
  EXPECT_EQ(convert_unit(far, Unit::millimetre).error().code, e_view_invalid);
}

TEST(SavedViews, ComeAlongWithAnotherDocument) {
  const Document both = append_document(with_two_views(), with_two_views()).value();
  ASSERT_EQ(both.saved_views->size(), 4U);
  EXPECT_EQ((*both.saved_views)[2].name, "Front left 2");
  EXPECT_EQ((*both.saved_views)[3].name, "Detail 2");
  Document longest = test::cube_document();
  std::string name;
  while (name.size() + 3 <= Object::max_name_length) name += "\u3042";  // three bytes each
  longest = add_view(longest, view_called(name)).value();
  const Document twice = append_document(longest, longest).value();
  EXPECT_TRUE(check_name((*twice.saved_views)[1].name));
  EXPECT_NE((*twice.saved_views)[1].name, name);
  EXPECT_TRUE(read_document(write_document(twice)));
}

TEST(SavedViews, AreInFilesAndEqualityNoticesEveryField) {
  const Document document = with_two_views();
  EXPECT_EQ(*read_document(write_document(document)), document);
  const auto changed = [&](auto&& change) {
    SavedViews views = *document.saved_views;
    change(views[1]);
    Document other = document;
    other.saved_views = views;
    EXPECT_FALSE(other == document);
    const Result<Document> again = test::must(read_document(write_document(other)));
    EXPECT_TRUE(*again == other) << write_document(*again);
  };
  changed([](SavedView& v) { v.name = "Other"; });
  changed([](SavedView& v) { v.target.x() = 4; });
  changed([](SavedView& v) { v.orientation = Eigen::Quaterniond(0, 1, 0, 0); });
  changed([](SavedView& v) { v.distance = 0.1; });
  changed([](SavedView& v) { v.projection = Projection::perspective; });
  changed([](SavedView& v) { v.projection = Projection::parallel; });
  changed([](SavedView& v) { v.focal_length = 300; });
}

TEST(SavedViews, FaultsInFilesAreNamed) {
  const std::string text = write_document(with_two_views());
  const std::pair<const char*, const char*> faults[] = {
      {"\"Front left\"", "\"Detail\""},
      {"\"Front left\"", "7"},
      {"\"target\": [1, 2, 3]", "\"target\": [1, 2]"},
      {"[0.5, 0.5, -0.5, 0.5]", "[0.5, 0.5, -0.5, 0.6]"},
      {"[0.5, 0.5, -0.5, 0.5]", "[0.5, 0.5, -0.5]"},
      {"\"projection\": \"two_point\"", "\"projection\": \"three_point\""},
      {"\"focal_length\": 35", "\"later\": 1, \"focal_length\": 35"},
      {"\"focal_length\": 35", "\"later\": 1"}};
  for (const auto& [from, to] : faults) {
    std::string faulty = text;
    ASSERT_NE(faulty.find(from), std::string::npos) << from << "\n" << text;
    faulty.replace(faulty.find(from), std::string(from).size(), to);
    const Result<Document> read = read_document(faulty);
    ASSERT_FALSE(read) << to;
    EXPECT_EQ(read.error().code, e_schema) << to;
    EXPECT_NE(read.error().text.find("views"), std::string::npos) << read.error().text;
  }
  for (const auto& [from, to] : {std::pair("\"distance\": 40", "\"distance\": -40"),
                                 std::pair("\"focal_length\": 35", "\"focal_length\": 10")}) {
    std::string faulty = text;
    ASSERT_NE(faulty.find(from), std::string::npos) << from;
    faulty.replace(faulty.find(from), std::string(from).size(), to);
    const Result<Document> read = read_document(faulty);
    ASSERT_FALSE(read) << to;
    EXPECT_NE(read.error().text.find("views[0]"), std::string::npos) << read.error().text;
  }
}

TEST(SavedViews, UndoBringsThemBack) {
  History history(with_two_views());
  const std::size_t bytes = history.bytes();
  history.push(remove_view(history.current(), "Detail").value(), "Delete view");
  EXPECT_EQ(history.current().saved_views->size(), 1U);
  EXPECT_GT(history.bytes(), bytes) << "what undo keeps is counted";
  history.undo();
  EXPECT_EQ(*find_view(history.current(), "Detail"), view_called("Detail"));
}

}  // namespace
}  // namespace hariko
