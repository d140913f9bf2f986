// Pictures of maps of making, drawn by the program itself.

#include "core/document/edits/edits.hpp"
#include "core/document/file.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko::test {
namespace {

class MakingPictures : public ProgramTest {
 protected:
  /// The picture's bytes; empty where the program failed, with what it said in `error`.
  std::string picture(const std::string& file, const std::string& options) {
    const std::string out = path("picture.png");
    std::filesystem::remove(out);
    const Outcome result = run("render " + file + " " + out + " --size 240x180 " + options);
    error = result.error;
    exit_code = result.exit_code;
    return exit_code == 0 ? read_text(out) : std::string();
  }
  std::string error;
  int exit_code = 0;
};

TEST_F(MakingPictures, EachMapDrawsAndItsLimitMatters) {
  const std::string file = golden("cube.obj"), plain = picture(file, "");
  for (const char* map : {"draft", "radius", "thickness"}) {
    const std::string option = std::string("--map ") + map;
    const std::string usual = picture(file, option), other = picture(file, option + " --limit 0.5");
    ASSERT_FALSE(usual.empty() || other.empty()) << map << " " << error;
    EXPECT_NE(usual, plain) << map;
    EXPECT_NE(usual, other) << map;
    EXPECT_EQ(picture(file, option), usual) << "the same input, the same bytes";
  }
  EXPECT_NE(picture(file, "--map draft --pull x"), picture(file, "--map draft --pull -z"));
  EXPECT_EQ(picture(file, "--map draft --pull 0,0,5"), picture(file, "--map draft"));
  EXPECT_EQ(picture(file, "--map draft --pull view --view top"), picture(file, "--map draft --view top"));
}

TEST_F(MakingPictures, WrongOptionsAreUsage) {
  for (const char* options :
       {"--map draft --pull q", "--map draft --pull 0,0,0", "--map draft --pull 1,2",
        "--map draft --limit 90", "--map radius --limit 0", "--map mean --limit 1", "--limit 1"}) {
    picture(golden("cube.obj"), options);
    EXPECT_EQ(exit_code, 2) << options;
  }
  EXPECT_EQ(run("render " + golden("cube.obj") + " " + path("a.svg") + " --pull x").exit_code, 2);
}

TEST_F(MakingPictures, OpenSurfacesHaveNoThickness) {
  EXPECT_EQ(picture(golden("grid3.obj"), "--map thickness"), "");
  EXPECT_EQ(exit_code, 1);
  EXPECT_NE(error.find("E_MAP_OPEN"), std::string::npos) << error;
}

TEST_F(MakingPictures, DeviationsNeedAReference) {
  Document document = document_from_mesh(cube(), "Part").value();
  Similarity place{.translation = {0.25, 0, 0}};
  document = add_object(document, "Model", document.objects[0]->source, place)->document;
  const std::string file = path("two.hariko");
  ASSERT_TRUE(save_document(document, file));
  EXPECT_EQ(picture(file, "--map deviation"), "");
  EXPECT_NE(error.find("E_MAP_REFERENCE"), std::string::npos) << error;
  EXPECT_EQ(picture(file, "--map deviation --deviation-from Nobody"), "");
  EXPECT_NE(error.find("E_NO_SUCH_OBJECT"), std::string::npos) << error;
  const std::string drawn = picture(file, "--map deviation --deviation-from Model");
  EXPECT_FALSE(drawn.empty()) << error;
  // The document's own reference, and what it was named.
  MakingSettings making;
  making.reference = document.objects[1]->id;
  ASSERT_TRUE(save_document(set_making(document, making).value(), file));
  EXPECT_EQ(picture(file, "--map deviation"), drawn);
}

}  // namespace
}  // namespace hariko::test
