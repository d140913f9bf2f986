// Forecast of STEP and IGES files: what is told before they are written is what is written.

#include "app/files/export_cad.hpp"

#include <filesystem>

#include "app/files/export_surfaces.hpp"
#include "app/files/left_out.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "core/document/edits/edits.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"
#include "ui/files/export_text.hpp"

namespace hariko {
namespace {

constexpr double tolerance = 1e-3;

/// Faces that are no splines.
Document torus() {
  return document_from_mesh(test::torus(4, 3), "Torus").value();
}

/// One biquadratic patch.
Document saddle() {
  BezierPatch out;
  out.degree_s = out.degree_t = 2;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) out.points.emplace_back(i, j, (i - 1) * (j - 1));
  return add_object({}, "Saddle", BezierSource::from_patches({out}).value())->document;
}

CadTotals count(const Document& document, const CadChoices& choices) {
  return *test::must(count_cad(document, choices));
}

TEST(ExportCad, WhatWasCountedIsWritten) {
  const CadTotals before = count(torus(), {tolerance});
  EXPECT_GT(before.faces, before.exact);
  EXPECT_EQ(before.unreached, 0U);
  EXPECT_GT(before.distance, 0);
  EXPECT_LE(before.distance, tolerance);
  if (why_no_cad_files()) return;
  const test::TemporaryFolder folder;
  const auto written = export_cad(torus(), folder.path() / "a.step", {tolerance}, "2026-11-22T12:00:00");
  ASSERT_TRUE(written.ok()) << to_string(written.error());
  const CadTotals after = totals(written->objects);
  EXPECT_EQ(after.faces, before.faces);
  EXPECT_EQ(after.exact, before.exact);
  EXPECT_EQ(after.distance, before.distance);
  EXPECT_EQ(after.normal_jump, before.normal_jump);
}

TEST(ExportCad, FarFromZeroIsWrittenRoundZeroOrRefused) {
  if (why_no_cad_files()) return;
  const test::TemporaryFolder folder;
  Similarity far{.translation = {1e9, -1e9, 1e9}};
  const Document document = set_transform(torus(), ObjectId{1}, far).value();
  CadChoices choices{tolerance};
  const std::string time = "2026-11-22T12:00:00";
  const auto there = export_cad(document, folder.path() / "there.step", choices, time);
  if (there.ok()) {
    EXPECT_TRUE(there->file.valid) << "a broken shape is no file with a warning";
  } else {
    EXPECT_EQ(std::string(there.error().code.name), "E_FILE_DIGITS");
    EXPECT_NE(there.error().remedy.find("--origin zero"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "there.step"));
  }
  choices.to_zero = true;
  const auto zero = test::must(export_cad(document, folder.path() / "zero.step", choices, time));
  EXPECT_TRUE(zero->file.valid);
  EXPECT_TRUE(zero->objects[0].closed);
  EXPECT_EQ(zero->objects[0].unreached, 0U);
  EXPECT_LT((zero->moved - far.translation).norm(), 10);
  const auto near = test::must(export_cad(torus(), folder.path() / "near.step", choices, time));
  EXPECT_EQ(near->objects[0].faces, zero->objects[0].faces);
  choices.unit = Unit::metre;
  const auto metres = test::must(export_cad(document, folder.path() / "metres.step", choices, time));
  EXPECT_NEAR(metres->moved.x(), 1e6, 0.01);
}

TEST(ExportCad, AnObjectTooFarFromTheOthersIsNamed) {
  if (why_no_cad_files()) return;
  const test::TemporaryFolder folder;
  Similarity far{.translation = {1e12, 0, 0}};
  const Document near = torus();
  const Object& object = *near.objects.front();
  const Document document = add_object(near, "Distant", object.source, far)->document;
  CadChoices choices{tolerance};
  for (const bool to_zero : {false, true}) {
    choices.to_zero = to_zero;
    const auto there = export_cad(document, folder.path() / "there.step", choices, "2026-11-22T12:00:00");
    ASSERT_FALSE(there.ok());
    EXPECT_EQ(there.error().code, e_file_digits) << to_string(there.error());
    if (!to_zero) {
      EXPECT_EQ(there.error().text.find("Distant: "), 0U) << there.error().text;
    }
    EXPECT_NE(there.error().remedy.find("nearer to the others"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "there.step"));
  }
}

TEST(ExportCad, AWallOfAClosedSurfaceIsOneHollowSolid) {
  if (why_no_cad_files()) return;
  const test::TemporaryFolder folder;
  const Document cube = document_from_mesh(test::cube(), "Cube").value();
  const Wall wall{0, 0.02, WallSide::both};
  for (const char* name : {"wall.step", "wall.igs"})
    for (const double place : {0.0, 1e4}) {
      Similarity moved;
      moved.translation = {place, 0, 0};
      const auto written = export_cad(set_transform(cube, ObjectId{1}, moved).value(), folder.path() / name,
                                      {tolerance}, "2026-11-22T12:00:00", {}, {}, wall);
      ASSERT_TRUE(written.ok()) << to_string(written.error());
      EXPECT_EQ(written->file.solids, 1U) << name;
      EXPECT_EQ(written->file.voids, 1U) << name;
      EXPECT_EQ(written->file.open_shells, 0U) << name;
      EXPECT_TRUE(written->file.valid) << name;
    }
}

TEST(ExportCad, LengthsAreThoseOfTheFile) {
  const CadTotals plain = count(torus(), {tolerance});
  CadChoices scaled{8 * tolerance};
  scaled.scale = 8;
  const CadTotals large = count(torus(), scaled);
  EXPECT_EQ(large.faces, plain.faces);
  EXPECT_NEAR(large.distance, 8 * plain.distance, 1e-9 * plain.distance);
}

TEST(ExportCad, ExactFormsAreCalledExact) {
  const Language english;
  const CadTotals exact = count(saddle(), {tolerance});
  EXPECT_TRUE(exact.all_exact());
  EXPECT_EQ(cad_count_text(english, exact, Unit::millimetre),
            "faces: 1, all of them exact   \u00b7   control points: 9\nnormals jump by 0\u00b0 at the most");
  EXPECT_EQ(cad_export_text(english, "a.step", exact, 61'000, Unit::millimetre),
            "Exported a.step: 1 faces, all of them exact; turned by 0\u00b0 at the most; 61 kB.");
  const CadTotals fitted{.faces = 12,
                         .exact = 4,
                         .unreached = 1,
                         .distance = 0.00031,
                         .normal_jump = 0.001,
                         .control_points = 250};
  const std::string told = cad_count_text(english, fitted, Unit::millimetre);
  for (const char* part : {"12, 4 of them exact", "control points: 250", "off by 0.00031 mm", "0.057\u00b0",
                           "not reached everywhere"})
    EXPECT_NE(told.find(part), std::string::npos) << told;
}

TEST(ExportCad, ReferenceFacetsAreLeftOutWithACount) {
  PolygonMesh triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.add_face({0, 1, 2});
  const auto with_facets = [&](const Document& document) {
    return add_object(document, "Scan", MeshSource::from_mesh(triangle).value())->document;
  };
  const CadTotals counted = count(with_facets(saddle()), {tolerance});
  EXPECT_EQ(counted.left_out, 1U);
  EXPECT_NE(cad_count_text(Language(), counted, Unit::millimetre).find("left out: 1"), std::string::npos);
  const auto told = left_out_of_cad(with_facets(saddle()));
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].code, w_not_written);
  EXPECT_NE(told[0].text.find("1 (\"Scan\")"), std::string::npos) << told[0].text;
  EXPECT_TRUE(left_out_of_cad(saddle()).empty());
  const auto alone = count_cad(with_facets({}), {tolerance});
  test::must_fail(alone, e_no_surface);
  EXPECT_NE(alone.error().text.find("reference facets"), std::string::npos) << alone.error().text;
}

TEST(ExportCad, IgesIsRefusedWhereItsDigitsBreakTheTolerance) {
  if (why_no_cad_files()) GTEST_SKIP() << "built without OpenCASCADE";
  const test::TemporaryFolder folder;
  for (const double place : {0.0, 1e4, 1e8}) {
    Similarity far;
    far.translation = {place, 0, 0};
    const auto document = test::must(set_transform(saddle(), ObjectId{1}, far));
    const auto iges = export_cad(*document, folder.path() / "a.igs", {tolerance}, "2026-11-22T12:00:00");
    // 1e8 has nine of the eleven digits before the point.
    EXPECT_EQ(iges.ok(), place < 1e8);
    if (!iges.ok()) {
      EXPECT_EQ(iges.error().code, e_file_digits);
      EXPECT_NE(iges.error().text.find("Saddle"), std::string::npos);
    }
    const auto step = export_cad(*document, folder.path() / "a.step", {tolerance}, "2026-11-22T12:00:00");
    EXPECT_TRUE(step.ok()) << to_string(step.error());
  }
}

TEST(ExportCad, CountsCanBeCancelledAndSayWhatIsMissing) {
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  EXPECT_EQ(count_cad(torus(), {tolerance}, cancel).error().code, e_cancelled);
  EXPECT_EQ(count_cad({}, {tolerance}).error().code, e_no_surface);
}

}  // namespace
}  // namespace hariko
