#include "core/exchange/archive_3mf/read_3mf.hpp"

#include <Model/COM/NMR_DLLInterfaces.h>
#include <zip.h>

#include <array>

#include "core/exchange/affine_map.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/polyhedron/polyhedron.hpp"
#include "tests/exchange/fixture_files.hpp"
#include "tests/exchange/gltf_text.hpp"
#include "tests/exchange/mesh_text.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko::test {
namespace {

constexpr const char* core_space = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";

std::string code_of(const Result<ImportedScene>& result) {
  if (result.ok()) return "ok";
  EXPECT_FALSE(result.error().text.empty());
  EXPECT_FALSE(result.error().remedy.empty());
  const Element& element = result.error().element;
  return std::string(result.error().code.name) +
         (element.kind == Element::Kind::line ? " " + std::to_string(element.id) : "");
}

/// A tetrahedron with its outside outside; volume 1/6. On one line.
const std::string tetrahedron =
    R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/><triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/></triangles></mesh>)";

std::string model(const std::string& resources, const std::string& build,
                  const std::string& attributes = "") {
  return "<?xml version=\"1.0\"?>\n<model xmlns=\"" + std::string(core_space) +
         "\" xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" " + attributes +
         "><resources>\n" + resources + "\n</resources><build>\n" + build + "\n</build></model>\n";
}
const std::string one_object = "<object id=\"1\" name=\"a\">" + tetrahedron + "</object>";

/// A zip archive of parts.
std::string archive(const std::vector<std::pair<std::string, std::string>>& parts) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_t* zip = zip_open_from_source(target, ZIP_TRUNCATE, &error);
  zip_source_keep(target);
  for (const auto& [name, text] : parts)
    EXPECT_GE(zip_file_add(zip, name.c_str(), zip_source_buffer(zip, text.data(), text.size(), 0), 0), 0);
  EXPECT_EQ(zip_close(zip), 0);
  EXPECT_EQ(zip_source_open(target), 0);
  zip_stat_t status;
  zip_source_stat(target, &status);
  std::string out(status.size, '\0');
  EXPECT_EQ(zip_source_read(target, out.data(), out.size()), zip_int64_t(out.size()));
  zip_source_close(target);
  zip_source_free(target);
  return out;
}

TEST(Read3mf, OurOwnFilesComeBackExactlyWhereverTheyAreAndHoweverLarge) {
  for_random(81, 12, [](std::mt19937_64& rng) {
    const double size = std::pow(10, test::uniform(rng, -3, 6));
    std::array<PolygonMesh, 2> meshes{test::torus(test::uniform_int(rng, 3, 9), 5), test::octahedron()};
    for (PolygonMesh& mesh : meshes) {
      const Vector3 shift = test::random_vector(rng, 1e6 * size);
      for (Vector3& p : mesh.positions) p = size * p + shift;
    }
    constexpr std::array units{0.001, 0.01, 0.0254, 1.0};
    const double metres = units[std::size_t(test::uniform_int(rng, 0, 3))];
    const std::vector<NamedPolygons> named{{"張り子 <\"a\" & b>", &meshes[0]}, {"b", &meshes[1]}};
    const auto read = test::must(read_3mf(*write_3mf(named, metres)));
    EXPECT_EQ(read->metres_per_unit, metres);
    EXPECT_TRUE(read->warnings.empty());
    ASSERT_EQ(read->parts.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(read->parts[k].name, named[k].name);
      EXPECT_EQ(read->parts[k].mesh.positions, meshes[k].positions);
      EXPECT_TRUE(Polyhedron::build(read->parts[k].mesh).ok());
    }
  });
}

/// Handles of the library, released at the end.
struct Handles {
  ~Handles() {
    for (NMR::PLib3MFBase* handle : all) NMR::lib3mf_release(handle);
  }
  NMR::PLib3MFBase* keep(NMR::PLib3MFBase* handle) {
    all.push_back(handle);
    return handle;
  }
  std::vector<NMR::PLib3MFBase*> all;
};

TEST(Read3mf, FilesOfAnotherProgramWithComponentsAreTheSame) {
  for_random(82, 4, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = test::octahedron();
    std::vector<NMR::MODELMESHVERTEX> vertices;
    std::vector<NMR::MODELMESHTRIANGLE> triangles;
    for (const Vector3& p : mesh.positions) vertices.push_back({{float(p.x()), float(p.y()), float(p.z())}});
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
      triangles.push_back({{mesh.face(f)[0], mesh.face(f)[1], mesh.face(f)[2]}});
    const auto transform = [&](AffineMap& placement) {
      NMR::MODELTRANSFORM out;
      for (int axis = 0; axis < 3; ++axis) {
        for (int k = 0; k < 3; ++k)
          placement.linear(axis, k) = out.m_fFields[axis][k] = float(test::uniform(rng, -2, 2));
        placement.shift[axis] = out.m_fFields[axis][3] = float(test::uniform(rng, -50, 50));
      }
      return out;
    };
    AffineMap inner, outer;
    NMR::MODELTRANSFORM of_component = transform(inner), of_item = transform(outer);
    Handles handles;
    NMR::PLib3MFBase *file = nullptr, *object = nullptr, *group = nullptr, *component = nullptr,
                     *item = nullptr, *writer = nullptr;
    NMR::lib3mf_createmodel(&file);
    handles.keep(file);
    NMR::lib3mf_model_setunit(file, NMR::MODELUNIT_INCH);
    NMR::lib3mf_model_addmeshobject(file, &object);
    handles.keep(object);
    NMR::lib3mf_object_setnameutf8(object, "octahedron");
    ASSERT_EQ(NMR::lib3mf_meshobject_setgeometry(object, vertices.data(), DWORD(vertices.size()),
                                                 triangles.data(), DWORD(triangles.size())),
              0);
    NMR::lib3mf_model_addcomponentsobject(file, &group);
    handles.keep(group);
    ASSERT_EQ(NMR::lib3mf_componentsobject_addcomponent(group, object, &of_component, &component), 0);
    handles.keep(component);
    ASSERT_EQ(NMR::lib3mf_model_addbuilditem(file, group, &of_item, &item), 0);
    handles.keep(item);
    NMR::lib3mf_model_querywriter(file, "3mf", &writer);
    handles.keep(writer);
    const test::TemporaryFolder folder;
    ASSERT_EQ(NMR::lib3mf_writer_writetofileutf8(writer, (folder.path() / "a.3mf").c_str()), 0);

    const auto read = test::must(read_scene_file(folder.path() / "a.3mf"));
    EXPECT_EQ(read->metres_per_unit, 0.0254);
    ASSERT_EQ(read->parts.size(), 1U);
    EXPECT_EQ(read->parts[0].name, "octahedron");
    PolygonMesh found = read->parts[0].mesh;
    ASSERT_EQ(found.positions.size(), mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      EXPECT_LT((found.positions[v] - outer(inner(mesh.positions[v]))).norm(), 1e-3);
    const double volume = test::volume_of(mesh) * std::abs((outer.linear * inner.linear).determinant());
    for (Vector3& p : found.positions) p -= outer(inner(Vector3::Zero()));
    EXPECT_NEAR(test::volume_of(found), volume, 1e-3 * volume + 1e-2);
  });
}

TEST(Read3mf, ExtensionsThatAreNeededAreNamedToTheirEnd) {
  const auto read = read_scene_file(test::case_file("3mf_needs_beamlattice.3mf"));
  test::must_fail(read, e_format_unknown);
  EXPECT_NE(read.error().text.find("\"beamlattice\""), std::string::npos) << read.error().text;
  EXPECT_NE(read.error().text.find("3dmanufacturing/beamlattice/2017/02)"), std::string::npos);
}

TEST(Read3mf, ItemsAndComponentsPlaceObjects) {
  // Rows stand behind a row vector: the third row says where z goes.
  const std::string text = model(
      one_object +
          R"(<object id="2"><components><component objectid="1" transform="0 1 0 -1 0 0 0 0 2 5 0 0"/>)" +
          R"(<component objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/></components></object>)" +
          R"(<object id="3" name="unused">)" + tetrahedron + "</object>",
      R"(<item objectid="2" transform="1 0 0 0 1 0 0 0 1 0 0 10"/><item objectid="1"/>)");
  const auto read = test::must(read_3mf_model(text));
  ASSERT_EQ(read->parts.size(), 3U);
  EXPECT_EQ(read->metres_per_unit, 0.001);
  const std::array<std::vector<Vector3>, 3> expected{
      std::vector<Vector3>{{5, 0, 10}, {5, 1, 10}, {4, 0, 10}, {5, 0, 12}},
      std::vector<Vector3>{{0, 0, 10}, {-1, 0, 10}, {0, 1, 10}, {0, 0, 11}},
      std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(read->parts[k].mesh.positions, expected[k]);
    EXPECT_NEAR(test::volume_of(read->parts[k].mesh), k == 0 ? 2 / 6.0 : 1 / 6.0, 1e-12) << k;
    EXPECT_EQ(read->parts[k].name, "a");
  }
}

TEST(Read3mf, UnitsThatDocumentsHaveAreKeptAndOthersAreMillimetres) {
  struct Case {
    const char* unit;
    double metres, factor;
  };
  for (const Case& c :
       {Case{"micron", 0.001, 0.001}, Case{"millimeter", 0.001, 1}, Case{"centimeter", 0.01, 1},
        Case{"inch", 0.0254, 1}, Case{"foot", 0.001, 304.8}, Case{"meter", 1, 1}}) {
    const auto read =
        read_3mf_model(model(one_object, "<item objectid=\"1\"/>", "unit=\"" + std::string(c.unit) + "\""));
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(read->metres_per_unit, c.metres);
    EXPECT_NEAR(read->parts[0].mesh.positions[1].x(), c.factor, 1e-12 * c.factor);
  }
}

TEST(Read3mf, ObjectsThatNothingPlacesAreTakenWhereNothingIsBuilt) {
  const auto read = read_3mf_model(model(
      one_object + R"(<object id="2" name="b"><components><component objectid="1"/></components></object>)",
      ""));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->parts.size(), 1U);
  EXPECT_EQ(read->parts[0].name, "a");
}

TEST(Read3mf, ObjectsThatTheBuildLeavesOutAreCounted) {
  const auto object = [](int id) {
    return "<object id=\"" + std::to_string(id) + "\">" + tetrahedron + "</object>";
  };
  const std::string group = "<object id=\"4\"><components><component objectid=\"2\"/></components></object>";
  const std::string resources = one_object + object(2) + object(3) + group;
  auto read = test::must(read_3mf_model(model(resources, "<item objectid=\"1\"/>")));
  ASSERT_EQ(read->warnings.size(), 1U);
  EXPECT_EQ(read->warnings[0].code, w_left_out);
  EXPECT_EQ(read->warnings[0].text, "2 objects of the file that its build does not place were left out.");
  read = read_3mf_model(model(resources, "<item objectid=\"1\"/><item objectid=\"4\"/>"));
  ASSERT_EQ(read->warnings.size(), 1U);
  EXPECT_EQ(read->warnings[0].text, "1 object of the file that its build does not place was left out.");
  EXPECT_TRUE(read_3mf_model(model(resources, ""))->warnings.empty()) << "without a build all are placed";
}

/// A model with an extension's prefix x that is used and not required.
std::string with_extension(const std::string& space, const std::string& resources, const std::string& build) {
  return model(resources, build, "xmlns:x=\"http://schemas.microsoft.com/3dmanufacturing/" + space + "\"");
}

TEST(Read3mf, ShapesInExtensionsThatAreNotReadAreToldWithTheirObject) {
  const std::string lattice =
      "<x:beamlattice radius=\"1\"><x:beams><x:beam v1=\"0\" v2=\"1\"/></x:beams></x:beamlattice>";
  const std::string
      beams_beside = with(tetrahedron, "</mesh>", lattice + "</mesh>"),
      beams =
          "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices>" +
          lattice + "</mesh>";
  struct Case {
    const char* space;
    std::string object;
    const char* sentence;
  };
  const std::string missing = "The object \"b\" was left out: its shape is in the extension ",
                    partly = "The object \"b\" lacks a part of its shape: it is in the extension ";
  for (const Case& c : {
           Case{"beamlattice/2017/02", "<object id=\"2\" name=\"b\">" + beams_beside + "</object>",
                partly.c_str()},
           Case{"beamlattice/2017/02", "<object id=\"2\" name=\"b\">" + beams + "</object>", missing.c_str()},
           Case{"displacement/2022/07", "<object id=\"2\" name=\"b\"><x:displacementmesh/></object>",
                missing.c_str()},
           Case{"slice/2015/07",
                "<object id=\"2\" name=\"b\" "
                "x:slicestackid=\"9\"><mesh><vertices/><triangles/></mesh></object>",
                missing.c_str()},
           Case{"slice/2015/07",
                "<object id=\"2\" name=\"b\" x:slicestackid=\"9\" x:meshresolution=\"lowres\">" +
                    tetrahedron + "</object>",
                partly.c_str()},
           Case{"slice/2015/07",
                "<object id=\"2\" name=\"b\" x:slicestackid=\"9\">" + tetrahedron + "</object>", ""},
           Case{"trianglesets/2021/07",
                "<object id=\"2\" name=\"b\">" + with(tetrahedron, "</mesh>", "<x:trianglesets/></mesh>") +
                    "</object>",
                ""},
       }) {
    const auto read =
        read_3mf_model(with_extension(c.space, one_object + c.object,
                                      "<item objectid=\"1\"/><item objectid=\"2\"/><item objectid=\"2\"/>"));
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    ASSERT_EQ(read->warnings.size(), *c.sentence ? 1U : 0U) << c.object;
    if (!*c.sentence) continue;
    const std::string space = c.space;
    EXPECT_EQ(read->warnings[0].code, w_left_out);
    EXPECT_EQ(read->warnings[0].text, c.sentence + ("\"" + space.substr(0, space.find('/'))) +
                                          "\" (http://schemas.microsoft.com/3dmanufacturing/" + space +
                                          "), which is not read.");
  }
  // Several objects are counted; what nothing places is not.
  std::string objects = one_object, items = "<item objectid=\"1\"/>";
  for (int id = 2; id < 6; ++id) {
    objects += "<object id=\"" + std::to_string(id) + "\" name=\"b" + std::to_string(id) + "\">" + beams +
               "</object>";
    if (id < 5) items += "<item objectid=\"" + std::to_string(id) + "\"/>";
  }
  const auto read = test::must(read_3mf_model(with_extension("beamlattice/2017/02", objects, items)));
  ASSERT_EQ(read->warnings.size(), 1U);
  EXPECT_TRUE(read->warnings[0].text.starts_with("3 objects, first \"b2\", were left out: "))
      << read->warnings[0].text;
}

TEST(Read3mf, AFileOfShapesThatAreNotReadNamesTheExtension) {
  const auto read = read_3mf_model(
      with_extension("booleanoperations/2023/07",
                     one_object + "<object id=\"3\" name=\"cut\"><x:booleanshape objectid=\"1\"/></object>",
                     "<item objectid=\"3\"/>"));
  ASSERT_EQ(code_of(read), "E_EMPTY");
  EXPECT_NE(read.error().text.find("\"cut\""), std::string::npos) << read.error().text;
  EXPECT_NE(read.error().text.find("\"booleanoperations\""), std::string::npos) << read.error().text;
}

TEST(Read3mf, AnObjectIsNoComponentWhereOneOfItsNumberInAnotherPartIs) {
  const std::string root =
      one_object +
      R"(<object id="2"><components><component objectid="1" p:path="/3D/other.model" transform="1 0 0 0 1 0 0 0 1 3 0 0"/></components></object>)";
  const auto read =
      read_3mf(archive({{"3D/3dmodel.model", model(root, "")},
                        {"3D/other.model", model(with(one_object, "name=\"a\"", "name=\"inner\""), "")}}));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->parts.size(), 2U);
  EXPECT_EQ(read->parts[0].name, "a");
  EXPECT_EQ(read->parts[1].name, "inner");
  EXPECT_EQ(read->parts[1].mesh.positions[1], Vector3(4, 0, 0));
}

TEST(Read3mf, NamesOfPartsAreFoundEscapedAndWithBackslashes) {
  const auto relation = [](const char* target) {
    return R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target=")" +
           std::string(target) +
           R"(" Id="b" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)";
  };
  const std::string whole = model(one_object, "<item objectid=\"1\"/>");
  struct Case {
    const char *relations, *target, *part;
  };
  for (const Case& c : {Case{"_rels/.rels", "/3D/my%20model.model", "3D/my model.model"},
                        Case{"_rels/.rels", "/3D/my%20model.model", "3D/my%20model.model"},
                        Case{"_rels/.rels", "/3D/my model.model", "3D/my%20model.model"},
                        Case{"_rels\\.rels", "/3D/m.model", "3D\\m.model"}}) {
    const auto read = read_3mf(archive({{c.relations, relation(c.target)}, {c.part, whole}}));
    EXPECT_EQ(code_of(read), "ok") << c.part;
  }
  const std::string root =
      R"(<object id="2"><components><component objectid="1" p:path="/3D/a%20b.model"/></components></object>)";
  EXPECT_EQ(code_of(read_3mf(archive({{"3D/3dmodel.model", model(root, "<item objectid=\"2\"/>")},
                                      {"3D/a b.model", model(one_object, "")}}))),
            "ok");
}

TEST(Read3mf, PartsOfThePackageAreFound) {
  const std::string relations =
      R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/x/Thumb.png" Id="a" Type="http://schemas.openxmlformats.org/package/2006/relationships/metadata/thumbnail"/><Relationship Target="/x/Root.model" Id="b" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)";
  const std::string root = model(
      R"(<object id="7"><components><component objectid="1" p:path="/x/other.model" transform="1 0 0 0 1 0 0 0 1 3 0 0"/></components></object>)",
      R"(<item objectid="7"/><item objectid="1" p:path="/x/other.model"/>)", "requiredextensions=\"p\"");
  const auto read = read_3mf(archive(
      {{"_rels/.rels", relations}, {"x/root.model", root}, {"x/other.model", model(one_object, "")}}));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->parts.size(), 2U);
  EXPECT_EQ(read->parts[0].mesh.positions[1], Vector3(4, 0, 0));
  EXPECT_EQ(read->parts[1].mesh.positions[1], Vector3(1, 0, 0));
  // A package without relationships has its model at the usual place.
  EXPECT_EQ(code_of(read_3mf(archive({{"3D/3dmodel.model", model(one_object, "<item objectid=\"1\"/>")}}))),
            "ok");
  EXPECT_EQ(code_of(read_3mf(archive({{"_rels/.rels", relations}}))), "E_FORMAT_UNKNOWN");
  EXPECT_EQ(code_of(read_3mf(archive({{"a.txt", "no model"}}))), "E_FORMAT_UNKNOWN");
  const auto size = relations.find("Root.model");
  EXPECT_EQ(code_of(read_3mf(archive({{"_rels/.rels", relations.substr(0, size)}}))), "E_TRUNCATED 1");
}

TEST(Read3mf, EachRefusalHasItsReasonAndItsLine) {
  const std::string good = model(one_object, "<item objectid=\"1\"/>");
  ASSERT_EQ(code_of(read_3mf_model(good)), "ok");
  struct Case {
    const char *old, *now, *code;
  };
  for (const Case& c : {
           Case{"core/2015/02", "core/2010/01", "E_FORMAT_UNKNOWN 7"},
           Case{"<model ", "<model unit=\"yard\" ", "E_PARSE 2"},
           Case{"<model ", "<model requiredextensions=\"x\" ", "E_FORMAT_UNKNOWN 2"},
           Case{"<model ", "<model requiredextensions=\"b\" xmlns:b=\"http://a.example/beams\" ",
                "E_FORMAT_UNKNOWN 2"},
           Case{"<model ", "<!DOCTYPE model [<!ENTITY a \"b\">]><model ", "E_PARSE 2"},
           Case{"id=\"1\"", "id=\"-1\"", "E_PARSE 3"},
           Case{"<object id=\"1\" ", "<object ", "E_PARSE 3"},
           Case{"</object>", "</object><object id=\"1\"/>", "E_PARSE 3"},
           Case{"x=\"1\"", "x=\"1,5\"", "E_PARSE 3"},
           Case{"x=\"1\"", "x=\"nan\"", "E_PARSE 3"},
           Case{"x=\"1\"", "x=\"1e999\"", "E_PARSE 3"},
           Case{"x=\"1\"", "", "E_PARSE 3"},
           Case{"v3=\"1\"", "v3=\"4\"", "E_INDEX_RANGE 3"},
           Case{"v3=\"1\"", "v3=\"99999999999999999999\"", "E_PARSE 3"},
           Case{"v3=\"1\"", "v3=\"one\"", "E_PARSE 3"},
           Case{"objectid=\"1\"", "objectid=\"2\"", "E_PARSE 5"},
           Case{"objectid=\"1\"", "", "E_PARSE 5"},
           Case{"objectid=\"1\"", "objectid=\"1\" transform=\"1 0 0\"", "E_PARSE 5"},
           Case{"objectid=\"1\"", "objectid=\"1\" p:path=\"/none.model\"", "E_PARSE"},
           Case{"objectid=\"1\"",
                "objectid=\"1\" transform=\"1e308 1e308 1e308 1e308 0 1e308 0 1e308 1e308 1e308 0 0\"",
                "E_PARSE"},
           Case{"objectid=\"1\"", "objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 0 0 0 0\"", "E_EMPTY"},
           Case{"</resources>", "", "E_PARSE 6"},
           Case{"</model>", "", "E_TRUNCATED 7"},
           Case{"</model>", "</model>x", "E_PARSE 6"},
       })
    EXPECT_EQ(code_of(read_3mf_model(with(good, c.old, c.now))), c.code) << c.old << " -> " << c.now;
  EXPECT_EQ(code_of(read_3mf("")), "E_EMPTY");
  EXPECT_EQ(code_of(read_3mf("solid a")), "E_FORMAT_UNKNOWN");
  EXPECT_EQ(code_of(read_3mf("PK\x03\x04")), "E_TRUNCATED");
  EXPECT_EQ(code_of(read_3mf_model(model("", ""))), "E_EMPTY");
  const auto flat = read_3mf_model(
      model(with(one_object, "<triangles>", "<triangles><triangle v1=\"0\" v2=\"0\" v3=\"1\"/>"),
            "<item objectid=\"1\"/>"));
  EXPECT_EQ(flat->warnings.at(0).code, w_degenerate_triangles);
}

TEST(Read3mf, ComponentsEndAndCopiesStayInBounds) {
  const auto group = [](int id, const std::string& components) {
    return "<object id=\"" + std::to_string(id) + "\"><components>" + components + "</components></object>\n";
  };
  const auto component = [](int id) { return "<component objectid=\"" + std::to_string(id) + "\"/>"; };
  // Each group holds the one before twice: 2^40 copies.
  std::string doubled = one_object, chain = one_object;
  for (int k = 2; k <= 41; ++k) doubled += group(k, component(k - 1) + component(k - 1));
  EXPECT_EQ(code_of(read_3mf_model(model(doubled, "<item objectid=\"41\"/>"))), "E_LIMIT");
  std::string empty = group(1, "");
  for (int k = 2; k <= 41; ++k) empty += group(k, component(k - 1) + component(k - 1));
  EXPECT_EQ(code_of(read_3mf_model(model(empty, "<item objectid=\"41\"/>"))), "E_LIMIT");
  for (int k = 2; k <= 1000; ++k) chain += group(k, component(k - 1));
  EXPECT_EQ(code_of(read_3mf_model(model(chain, "<item objectid=\"60\"/>"))), "ok");
  EXPECT_EQ(code_of(read_3mf_model(model(chain, "<item objectid=\"1000\"/>"))).substr(0, 7), "E_PARSE");
  const std::string circle = group(1, component(2)) + group(2, component(1));
  EXPECT_EQ(code_of(read_3mf_model(model(circle, "<item objectid=\"1\"/>"))), "E_PARSE 4");
  EXPECT_EQ(code_of(read_3mf_model(model(group(1, component(1)), "<item objectid=\"1\"/>"))), "E_PARSE 3");
  ReadLimits limits{.vertices = 7};
  EXPECT_EQ(
      code_of(read_3mf_model(model(one_object, "<item objectid=\"1\"/><item objectid=\"1\"/>"), limits)),
      "E_LIMIT");
  limits.vertices = 3;
  EXPECT_EQ(code_of(read_3mf_model(model(one_object, "<item objectid=\"1\"/>"), limits)), "E_LIMIT 3");
}

TEST(Read3mf, TextThatGrowsOrNestsIsRefused) {
  // 100 MiB of blanks are packed to a thousandth.
  const std::string blanks(std::size_t{100} << 20, ' ');
  const std::string bomb =
      archive({{"3D/3dmodel.model", with(model(one_object, "<item objectid=\"1\"/>"), "\n", blanks)}});
  ASSERT_LT(bomb.size(), 200'000U);
  EXPECT_EQ(code_of(read_3mf(bomb)), "E_LIMIT");
  EXPECT_EQ(code_of(read_3mf_model("<a " + std::string(3'000'000, 'b') + "=\"\"/>")), "E_LIMIT 1");
  std::string deep;
  for (int k = 0; k < 100; ++k) deep += "<a>";
  EXPECT_EQ(code_of(read_3mf_model(deep)), "E_PARSE 1");
}

TEST(Read3mf, FilesThatAreCutOffOrChangedAreRefusedOrSound) {
  const PolygonMesh mesh = test::octahedron();
  const std::vector<NamedPolygons> named{{"a", &mesh}};
  const std::string whole = *write_3mf(named, 0.001);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(code_of(read_3mf(whole.substr(0, size))), "ok") << size;
  const std::string text = model(one_object, "<item objectid=\"1\"/>");
  for (std::size_t size = 0; size + 2 < text.size(); ++size)
    EXPECT_NE(code_of(read_3mf_model(text.substr(0, size))), "ok") << size;
  for_random(83, 400, [&](std::mt19937_64& rng) {
    std::string changed = test::chance(rng, 0.5) ? whole : text;
    const bool zip = changed.starts_with("PK");
    for (int k = test::uniform_int(rng, 1, 4); k > 0; --k)
      changed[std::size_t(rng() % changed.size())] = char(rng());
    const auto read = zip ? read_3mf(changed) : read_3mf_model(changed);
    if (!read.ok()) return;
    for (const auto& part : read->parts) test::expect_sound(part.mesh);
  });
}

}  // namespace
}  // namespace hariko::test
