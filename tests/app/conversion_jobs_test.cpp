// Solids become polyhedra by a worker, in one step, and the window says how far their surfaces are apart.

#include "app/jobs/conversion_jobs.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/document/edits/edits.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {
namespace {

struct ConversionRig {
  Editor editor;
  BackgroundWork work{editor, {}};
  int converted = 0;
  ConversionJobs jobs{
      editor, work, [this](const char* what, const auto&) { converted += std::string(what) == "converted"; }};

  ConversionRig() {
    EnvelopeInput input;
    Solid ball{.kind = SolidKind::sphere};
    input.solids.push_back(ball);
    editor.open(add_object({}, "Ball", SolidsSource{input, {}}).value().document, {});
    editor.selection.active = objects()[0]->id;
  }
  const std::vector<std::shared_ptr<const Object>>& objects() const {
    return editor.history.current().objects;
  }
  void finish() {
    work.wait();
    work.publish();
  }
};

TEST(ConversionJobs, SolidsStayHiddenBesideTheirPolyhedron) {
  ConversionRig rig;
  rig.jobs.convert(rig.objects()[0]->id);
  rig.finish();
  ASSERT_EQ(rig.objects().size(), 2U);
  EXPECT_FALSE(rig.objects()[0]->visible);
  EXPECT_TRUE(rig.objects()[0]->solids());
  ASSERT_TRUE(rig.objects()[1]->polyhedron());
  EXPECT_TRUE(rig.objects()[1]->display.polyhedron);
  EXPECT_FALSE(rig.objects()[1]->display.points) << "they would cover the form";
  EXPECT_EQ(rig.editor.selection.active, rig.objects()[1]->id);
  EXPECT_EQ(rig.converted, 1);
  ASSERT_EQ(rig.editor.notices().size(), 1U);
  EXPECT_NE(rig.editor.notices()[0].text.find("at most"), std::string::npos) << rig.editor.notices()[0].text;
  ASSERT_TRUE(rig.editor.history.can_undo());
  rig.editor.undo();
  ASSERT_EQ(rig.objects().size(), 1U) << "one step";
  EXPECT_TRUE(rig.objects()[0]->visible);
}

TEST(ConversionJobs, SolidsThatWereChangedMeanwhileStay) {
  ConversionRig rig;
  rig.jobs.convert(rig.objects()[0]->id);
  EnvelopeInput input = *rig.objects()[0]->solids()->input;
  input.solids[0].scale *= 2;
  Document document = rig.editor.history.current();
  Object changed = *document.objects[0];
  changed.source = SolidsSource{input, {}};
  document.objects[0] = std::make_shared<const Object>(changed);
  ASSERT_TRUE(rig.editor.commit(Result<Document>(document), "Scale"));
  rig.finish();
  EXPECT_EQ(rig.objects().size(), 1U);
  EXPECT_TRUE(rig.objects()[0]->visible);
  EXPECT_EQ(rig.converted, 0);
  ASSERT_EQ(rig.editor.notices().size(), 1U);
  EXPECT_EQ(rig.editor.notices()[0].kind, Notice::Kind::warning);
}

TEST(ConversionJobs, NothingLandsInADocumentThatWasOpenedMeanwhile) {
  ConversionRig rig;
  rig.jobs.convert(rig.objects()[0]->id);
  const Document same = rig.editor.history.current();
  rig.editor.open(same, {});
  rig.finish();
  EXPECT_EQ(rig.objects().size(), 1U);
  EXPECT_EQ(rig.converted, 0);
  EXPECT_TRUE(rig.editor.notices().empty());
}

}  // namespace
}  // namespace hariko
