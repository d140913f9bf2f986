#include "core/exchange/write_mesh.hpp"

#include <Eigen/Geometry>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstring>
#include <limits>
#include <locale>
#include <map>
#include <sstream>

#include "core/exchange/mesh_file.hpp"
#include "core/exchange/obj/read_obj.hpp"
#include "core/exchange/repair/triangulate.hpp"
#include "core/exchange/triangles/read_off.hpp"
#include "core/exchange/triangles/read_ply.hpp"
#include "core/exchange/triangles/read_stl.hpp"
#include "tests/exchange/mesh_text.hpp"
#include "tests/support/places.hpp"

namespace hariko::test {
namespace {

/// Random triangles over random positions, far from zero at times, with fewer or more normals than positions.
TriangleMesh random_triangles(std::mt19937_64& rng, bool with_normals) {
  TriangleMesh mesh;
  const double scale = std::pow(10.0, test::uniform(rng, -9, 9));
  if (test::chance(rng, 0.5)) mesh.origin = test::random_vector(rng, 1e6 * scale);
  const int position_count = test::uniform_int(rng, 4, 40), normal_count = test::uniform_int(rng, 3, 60);
  for (int i = 0; i < position_count; ++i) mesh.positions.push_back(test::random_vector(rng, scale));
  for (int i = 0; with_normals && i < normal_count; ++i)
    mesh.normals.push_back((test::random_vector(rng) + Vector3(0, 0, 2)).normalized());
  for (int i = test::uniform_int(rng, 1, 80); i > 0; --i) {
    const auto pick = [&](int count) { return static_cast<Index>(test::uniform_int(rng, 0, count - 1)); };
    mesh.triangles.push_back({pick(position_count), pick(position_count), pick(position_count)});
    if (with_normals)
      mesh.normal_triangles.push_back({pick(normal_count), pick(normal_count), pick(normal_count)});
  }
  return mesh;
}

/// Corners of all faces in order, absolute.
std::vector<Vector3> corners_of(const PolygonMesh& mesh) {
  std::vector<Vector3> out;
  for (const Index v : mesh.face_vertices) out.push_back(mesh.positions[v]);
  return out;
}
std::vector<Vector3> corners_of(const TriangleMesh& mesh) {
  std::vector<Vector3> out;
  for (const auto& triangle : mesh.triangles)
    for (const Index v : triangle) out.push_back(mesh.origin + mesh.positions[v]);
  return out;
}

TEST(WriteMesh, PolygonsComeBackBitForBit) {
  for_random(100, 60, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = test::random_polygons(rng, test::chance(rng, 0.2));
    const NamedPolygons named[] = {{"Körper 1", &mesh}};
    const auto obj = test::must(read_obj(write_obj(named)));
    test::expect_same(obj->mesh, mesh);
    EXPECT_EQ(obj->name, "Körper 1");
    EXPECT_TRUE(obj->warnings.empty());
    for (const MeshEncoding encoding : {MeshEncoding::ascii, MeshEncoding::binary}) {
      const auto ply = test::must(read_ply(write_ply(named, encoding)));
      test::expect_same(ply->mesh, mesh);
      EXPECT_TRUE(ply->warnings.empty());
    }
  });
}

TEST(WriteMesh, TrianglesComeBackInEveryFormat) {
  for_random(200, 60, [](std::mt19937_64& rng) {
    const bool with_normals = test::chance(rng, 0.7);
    const TriangleMesh mesh = random_triangles(rng, with_normals);
    const NamedTriangles named[] = {{"a", &mesh}};
    const std::vector<Vector3> expected = corners_of(mesh);
    const auto obj = test::must(read_obj(write_obj(named)));
    EXPECT_EQ(corners_of(obj->mesh), expected);
    for (const MeshEncoding encoding : {MeshEncoding::ascii, MeshEncoding::binary}) {
      const auto ply = test::must(read_ply(write_ply(named, encoding)));
      EXPECT_EQ(corners_of(ply->mesh), expected);
    }
    const std::string stl = write_stl(named).value();
    ASSERT_EQ(stl.size(), 84 + 50 * mesh.triangles.size());
    for (std::size_t corner = 0; corner < expected.size(); ++corner) {
      float stored[3];
      std::memcpy(stored, stl.data() + 84 + corner / 3 * 50 + 12 + corner % 3 * 12, 12);
      EXPECT_EQ(Eigen::Map<Eigen::Vector3f>(stored), expected[corner].cast<float>());
    }
  });
}

/// A closed mesh of small tetrahedra: what STL must keep closed.
PolygonMesh tetrahedra(std::mt19937_64& rng, double scale) {
  PolygonMesh mesh;
  for (Index i = 0; i < 20; ++i) {
    const Vector3 centre = test::random_vector(rng, 100 * scale);
    for (const Vector3& p : {Vector3(1, 1, 1), Vector3(-1, -1, 1), Vector3(-1, 1, -1), Vector3(1, -1, -1)})
      mesh.positions.push_back(centre + p * scale);
    const Index a = 4 * i;
    mesh.add_face({a, a + 2, a + 1});
    mesh.add_face({a, a + 1, a + 3});
    mesh.add_face({a, a + 3, a + 2});
    mesh.add_face({a + 1, a + 2, a + 3});
  }
  return mesh;
}

TEST(WriteMesh, StlStaysClosedAndComesBackThroughTextToo) {
  for_random(300, 20, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = tetrahedra(rng, std::pow(10.0, test::uniform(rng, -9, 9)));
    const auto result = test::must(read_stl(write_stl(std::vector<NamedPolygons>{{"t", &mesh}}).value()));
    ASSERT_EQ(result->mesh.positions.size(), mesh.positions.size());
    ASSERT_EQ(result->mesh.face_count(), mesh.face_count());
    std::map<std::pair<Index, Index>, int> uses;
    for (std::size_t f = 0; f < result->mesh.face_count(); ++f)
      for (std::size_t c = 0; c < 3; ++c)
        ++uses[{result->mesh.face(f)[c], result->mesh.face(f)[(c + 1) % 3]}];
    for (const auto& [edge, count] : uses) {
      EXPECT_EQ(count, 1);
      EXPECT_TRUE(uses.contains({edge.second, edge.first}));
    }
    // The same triangles as text, written by hand.
    std::string text = "solid t\n";
    int corner = 0;
    for (const Vector3& p : corners_of(result->mesh)) {
      char line[200];
      std::snprintf(line, sizeof line, "vertex %.9g %.9g %.9g\n", p.x(), p.y(), p.z());
      if (corner % 3 == 0) text += "facet normal 0 0 0\nouter loop\n";
      text += line;
      if (++corner % 3 == 0) text += "endloop\nendfacet\n";
    }
    const auto again = test::must(read_stl(text + "endsolid t\n"));
    EXPECT_EQ(again->mesh.face_vertices, result->mesh.face_vertices);
    for (std::size_t v = 0; v < again->mesh.positions.size(); ++v)
      EXPECT_EQ(again->mesh.positions[v].cast<float>(), result->mesh.positions[v].cast<float>());
  });
}

TriangleMesh two_triangles() {
  TriangleMesh mesh;
  mesh.origin = {10, 0, 0};
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  mesh.normals = {{0, 0, 1}, {0, 1, 0}};
  mesh.normal_triangles = {{0, 0, 0}, {1, 1, 0}};  // split at position 1, shared at position 2
  return mesh;
}

TEST(WriteMesh, ExactTexts) {
  const TriangleMesh mesh = two_triangles();
  const NamedTriangles named[] = {{"one\ntwo\\", &mesh}, {"", &mesh}};
  EXPECT_EQ(write_obj(named),
            "o one?two_\nv 10 0 0\nv 11 0 0\nv 10 1 0\nv 11 1 0.5\nvn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf "
            "2//2 4//2 3//1\n"
            "o object\nv 10 0 0\nv 11 0 0\nv 10 1 0\nv 11 1 0.5\nvn 0 0 1\nvn 0 1 0\nf 5//3 6//3 7//3\nf "
            "6//4 8//4 7//3\n");
  EXPECT_EQ(write_ply(std::span(named, 1), MeshEncoding::ascii),
            "ply\nformat ascii 1.0\ncomment object one?two_\nelement vertex 5\nproperty double x\nproperty "
            "double y\nproperty double z\n"
            "property float nx\nproperty float ny\nproperty float nz\nelement face 2\nproperty list uchar "
            "int vertex_indices\nend_header\n"
            "10 0 0 0 0 1\n11 0 0 0 0 1\n10 1 0 0 0 1\n11 0 0 0 1 0\n11 1 0.5 0 1 0\n3 0 1 2\n3 3 4 2\n");
  TriangleMesh first = mesh;
  first.triangles.resize(1);
  EXPECT_EQ(write_stl(std::vector<NamedTriangles>{{"one\ntwo", &first}}, MeshEncoding::ascii).value(),
            "solid one?two\nfacet normal 0 0 1\nouter loop\nvertex 10 0 0\nvertex 11 0 0\nvertex 10 1 0\n"
            "endloop\nendfacet\nendsolid one?two\n");
}

/// Rest of each line that begins with `beginning`.
std::vector<std::string> texts_after(const std::string& text, std::string_view beginning) {
  std::vector<std::string> out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(beginning)) out.push_back(line.substr(beginning.size()));
  return out;
}

TEST(WriteMesh, SeveralMeshesKeepTheirNumbersApart) {
  for_random(400, 20, [](std::mt19937_64& rng) {
    const TriangleMesh a = random_triangles(rng, true), b = random_triangles(rng, test::chance(rng, 0.5)),
                       c = random_triangles(rng, true);
    const NamedTriangles named[] = {{"a", &a}, {"b", &b}, {"c", &c}};
    std::vector<Vector3> expected = corners_of(a);
    for (const TriangleMesh* mesh : {&b, &c})
      for (const Vector3& p : corners_of(*mesh)) expected.push_back(p);
    EXPECT_EQ(corners_of(read_obj(write_obj(named))->mesh), expected);
    EXPECT_EQ(corners_of(read_ply(write_ply(named, MeshEncoding::binary))->mesh), expected);
    EXPECT_EQ(corners_of(read_ply(write_ply(named, MeshEncoding::ascii))->mesh), expected);
    EXPECT_EQ(write_stl(named)->size(), 84 + 50 * expected.size() / 3);
    const std::string text = write_stl(named, MeshEncoding::ascii).value();
    EXPECT_EQ(texts_after(text, "solid "), (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_EQ(texts_after(text, "endsolid "), (std::vector<std::string>{"a", "b", "c"}));
  });
}

TEST(WriteMesh, NormalsOfPlyAndStlPointWhereTheyShould) {
  const TriangleMesh mesh = two_triangles();
  const NamedTriangles named[] = {{"a", &mesh}};
  const std::string stl = write_stl(named).value();
  float normal[3];
  std::memcpy(normal, stl.data() + 84, 12);
  EXPECT_EQ(Eigen::Map<Eigen::Vector3f>(normal), Eigen::Vector3f(0, 0, 1));
  EXPECT_FALSE(stl.starts_with("solid"));
  for (const double scale : {1e-200, 1e-30, 1e30}) {  // no overflow, no underflow of the normal
    TriangleMesh scaled = mesh;
    scaled.origin = Vector3::Zero();
    for (Vector3& p : scaled.positions) p *= scale;
    const std::string bytes = write_stl(std::vector<NamedTriangles>{{"a", &scaled}}).value();
    std::memcpy(normal, bytes.data() + 84, 12);
    EXPECT_EQ(Eigen::Map<Eigen::Vector3f>(normal), Eigen::Vector3f(0, 0, 1)) << scale;
  }
}

TEST(WriteMesh, StlRefusesWhatFloatsCannotHold) {
  for (const double wrong : {1e39, -1e300, std::numeric_limits<double>::infinity(), std::nan("")})
    for (const MeshEncoding encoding : {MeshEncoding::ascii, MeshEncoding::binary}) {
      TriangleMesh mesh = two_triangles();
      mesh.positions[0].x() = wrong;
      const auto written = write_stl(std::vector<NamedTriangles>{{"a", &mesh}}, encoding);
      ASSERT_FALSE(written.ok()) << wrong;
      EXPECT_EQ(written.error().code, e_limit);
    }
}

/// The numbers of every facet of binary STL, normals included.
std::vector<float> numbers_of_binary(const std::string& stl) {
  std::vector<float> out;
  for (std::size_t facet = 84; facet < stl.size(); facet += 50) {
    float numbers[12];
    std::memcpy(numbers, stl.data() + facet, sizeof numbers);
    out.insert(out.end(), numbers, numbers + 12);
  }
  return out;
}

/// The same of text, read word by word.
std::vector<float> numbers_of_text(const std::string& stl) {
  std::vector<float> out;
  std::istringstream words(stl);
  for (std::string word; words >> word;)
    if (word == "normal" || word == "vertex")
      for (int axis = 0; axis < 3; ++axis) {
        words >> word;
        float number = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
        EXPECT_TRUE(error == std::errc() && end == word.data() + word.size()) << word;
        out.push_back(number);
      }
  return out;
}

std::vector<Eigen::Vector3f> floats_of(const PolygonMesh& mesh) {
  std::vector<Eigen::Vector3f> out;
  for (const Vector3& p : mesh.positions) out.push_back(p.cast<float>());
  return out;
}

TEST(WriteMesh, StlAsTextHasTheNumbersOfBinary) {
  for_random(450, 40, [](std::mt19937_64& rng) {
    const TriangleMesh mesh = random_triangles(rng, false);
    const NamedTriangles named[] = {{"Körper 1", &mesh}};
    const std::string binary = write_stl(named).value(), text = write_stl(named, MeshEncoding::ascii).value();
    EXPECT_EQ(numbers_of_text(text), numbers_of_binary(binary));
    const auto from_binary = read_stl(binary), from_text = read_stl(text);
    ASSERT_EQ(from_text.ok(), from_binary.ok());
    if (!from_text.ok()) return;  // no triangle with three corners
    EXPECT_EQ(from_text->name, "Körper 1");
    // The reader takes text for what it says: decimal numbers, next to those floats.
    EXPECT_EQ(floats_of(from_text->mesh), floats_of(from_binary->mesh));
    EXPECT_EQ(from_text->mesh.face_vertices, from_binary->mesh.face_vertices);
  });
  for_random(460, 20, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = test::random_polygons(rng);
    const NamedPolygons named[] = {{"facet solid", &mesh}};
    EXPECT_EQ(numbers_of_text(write_stl(named, MeshEncoding::ascii).value()),
              numbers_of_binary(write_stl(named).value()));
  });
}

TEST(TriangulatePolygon, ConcavePolygonsKeepTheirArea) {
  for_random(500, 100, [](std::mt19937_64& rng) {
    // A star-shaped polygon in a random plane: simple, and concave nearly always.
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(test::uniform(rng, -1, 1), test::uniform(rng, -1, 1), 0.3, 0.2).normalized();
    const int n = test::chance(rng, 0.1) ? 3001 : test::uniform_int(rng, 3, 30);
    std::vector<Vector3> corners;
    double area = 0;
    std::vector<double> radii;
    for (int i = 0; i < n; ++i) radii.push_back(test::uniform(rng, 0.2, 1));
    const double step = 2 * M_PI / n;
    for (int i = 0; i < n; ++i) {
      corners.push_back(turn * Vector3(radii[i] * std::cos(step * i), radii[i] * std::sin(step * i), 0) +
                        Vector3(5, 6, 7));
      area += 0.5 * radii[i] * radii[(i + 1) % n] * std::sin(step);
    }
    const auto triangles = triangulate_polygon(corners);
    ASSERT_EQ(triangles.size(), static_cast<std::size_t>(n - 2));
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
      const Vector3 cross = (corners[b] - corners[a]).cross(corners[c] - corners[a]);
      EXPECT_GT(cross.dot(turn * Vector3::UnitZ()), 0);
      sum += 0.5 * cross.norm();
    }
    EXPECT_NEAR(sum, area, n > 1000 ? 1e-9 : 1e-12);
  });
}

/// Half of them are reflex, and the ears of a comb are as long as the polygon: a fan would have many times
/// the area.
TEST(TriangulatePolygon, PolygonsOfMoreThanAHundredThousandCornersKeepTheirArea) {
  constexpr std::size_t n = 120'002;
  std::vector<Vector3> star, comb;
  std::mt19937_64 rng(501);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * double(i) / n, radius = i % 2 == 0 ? test::uniform(rng, 0.5, 0.8) : 1;
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  // Teeth of length 1 on a bar, turned by an angle that no axis has.
  const double c = std::cos(0.6), s = std::sin(0.6);
  const auto add = [&](double x, double y) { comb.emplace_back(c * x - s * y, s * x + c * y, 0); };
  add(0, -0.1);
  add(1, -0.1);
  for (std::size_t i = 0; i + 2 < n; ++i)
    add(1 - double(i) / double(n - 3), i % 2 == 0 ? 1 : test::uniform(rng, 0, 0.3));
  for (const auto* corners : {&star, &comb}) {
    double area = 0, sum = 0;
    for (std::size_t i = 0; i < n; ++i) area += 0.5 * (*corners)[i].cross((*corners)[(i + 1) % n]).z();
    const auto triangles = triangulate_polygon(*corners);
    ASSERT_EQ(triangles.size(), n - 2);
    for (const auto& [i, j, k] : triangles) {
      const Vector3& at = (*corners)[i];
      sum += 0.5 * ((*corners)[j] - at).cross((*corners)[k] - at).norm();
    }
    EXPECT_GT(area, 0.5);
    EXPECT_NEAR(sum, area, 1e-8);
  }
}

TEST(TriangulatePolygon, DegenerateAndHugePolygonsEnd) {
  EXPECT_TRUE(triangulate_polygon(std::vector<Vector3>(2, Vector3::Zero())).empty());
  EXPECT_EQ(triangulate_polygon(std::vector<Vector3>(12, Vector3(1, 2, 3))).size(), 10U);
  EXPECT_EQ(triangulate_polygon(std::vector<Vector3>(200'000, Vector3(1, 2, 3))).size(), 199'998U);
}

/// Decimal comma and thousands dots for every stream and C function of the process.
class CommaLocale {
 public:
  CommaLocale()
      : before_(std::locale::global(std::locale(std::locale::classic(), new Comma))),
        c_before_(std::setlocale(LC_ALL, nullptr)) {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8"})
      if (std::setlocale(LC_ALL, name)) break;
  }
  ~CommaLocale() {
    std::locale::global(before_);
    std::setlocale(LC_ALL, c_before_.c_str());
  }

 private:
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  std::locale before_;
  std::string c_before_;
};

TEST(WriteMesh, NumbersDoNotDependOnTheLocale) {
  std::mt19937_64 rng(7);
  const PolygonMesh mesh = test::random_polygons(rng);
  const NamedPolygons named[] = {{"a", &mesh}};
  const std::string obj = write_obj(named), ply = write_ply(named, MeshEncoding::ascii),
                    stl = write_stl(named, MeshEncoding::ascii).value();
  const CommaLocale comma;
  std::ostringstream proof;
  proof << 1234567.5;
  ASSERT_NE(proof.str().find(','), std::string::npos);
  EXPECT_EQ(write_obj(named), obj);
  EXPECT_EQ(write_ply(named, MeshEncoding::ascii), ply);
  EXPECT_EQ(write_stl(named, MeshEncoding::ascii).value(), stl);
  test::expect_same(read_obj(obj)->mesh, mesh);
  test::expect_same(read_ply(ply)->mesh, mesh);
  EXPECT_EQ(read_off("OFF\n3 1 0\n0.5 0 0\n1.25 0 0\n0 1e-1 0\n3 0 1 2\n")->mesh.positions[1].x(), 1.25);
  EXPECT_EQ(read_obj("v 0,5 0 0\n").error().code, e_parse);
}

TEST(MeshFile, FormatsAreToldByExtensionOrContent) {
  std::mt19937_64 rng(3);
  const PolygonMesh mesh = tetrahedra(rng, 1);
  const std::vector<NamedPolygons> named{{"", &mesh}};
  const test::TemporaryFolder folder;
  for (const char* name : {"a.obj", "a.PLY", "a.Stl", "a.oFF", "a.Glb", "a.3mF"}) {
    ASSERT_TRUE(write_mesh_file(folder.path() / name, std::span<const NamedPolygons>(named)).ok());
    const std::string bytes = test::slurp(folder.path() / name);
    for (const std::string& copy : {std::string(name), std::string("none"), std::string("odd.xyz")}) {
      test::spill(folder.path() / copy, bytes);
      const auto result = test::must(read_mesh_file(folder.path() / copy));
      EXPECT_EQ(result->mesh.face_count(), mesh.face_count());
    }
  }
  EXPECT_EQ(read_mesh_file(folder.path() / "a.Stl")->name, "a");
  EXPECT_EQ(format_of_content("# comment\nOFF\n"), MeshFormat::off);
  EXPECT_EQ(format_of_content("# comment\nmtllib a\nv 0 0 0\n"), MeshFormat::obj);
  EXPECT_EQ(format_of_content("solid a\nfacet"), MeshFormat::stl);
  EXPECT_EQ(format_of_content("{\"v\": 1}"), std::nullopt);
  EXPECT_EQ(format_of_content(""), std::nullopt);
}

TEST(MeshFile, UnitScaleAndUpAxisAreThoseAskedFor) {
  std::mt19937_64 rng(5);
  const PolygonMesh mesh = tetrahedra(rng, 2);
  const std::vector<NamedPolygons> named{{"", &mesh}};
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.obj";
  const auto written = [&](const WriteOptions& options) {
    EXPECT_TRUE(write_mesh_file(path, std::span<const NamedPolygons>(named), options).ok());
    return read_mesh_file(path).value().mesh.positions;
  };
  EXPECT_EQ(written({}), mesh.positions);
  // Millimetres in inches, twice as large, with y up.
  const auto found = written({.metres_per_file_unit = 0.0254, .factor = 2, .up = UpAxis::y});
  for (std::size_t v = 0; v < found.size(); ++v) {
    const Vector3 p = mesh.positions[v] * 2 / 25.4;
    EXPECT_LT((found[v] - Vector3(p.x(), p.z(), -p.y())).norm(), 1e-14 * p.norm());
  }
  EXPECT_TRUE(written_format("a.OBJ")->unit);
  EXPECT_FALSE(written_format("a.glb")->unit);
  EXPECT_TRUE(written_format("a.3mf")->unit);
  EXPECT_FALSE(written_format("a.3mf")->up);
  EXPECT_FALSE(written_format("a.txt"));
}

TEST(MeshFile, ErrorsNameTheFile) {
  const test::TemporaryFolder folder;
  const auto expect_error = [&](const char* name, const std::string& bytes, Code code) {
    test::spill(folder.path() / name, bytes);
    const auto result = read_mesh_file(folder.path() / name);
    test::must_fail(result, code);
    EXPECT_TRUE(result.error().text.starts_with("\"" + (folder.path() / name).native() + "\": "))
        << result.error().text;
  };
  expect_error("a.obj", "v 1 2\n\n", e_parse);
  expect_error("a.off", "OFF\n", e_truncated);
  expect_error("a.ply", "none", e_format_unknown);
  expect_error("a.stl", "", e_empty);
  expect_error("a.glb", "", e_empty);
  expect_error("a.gltf", "{}", e_format_unknown);
  expect_error("a.3mf", "v 0 0 0", e_format_unknown);
  expect_error("a.xyz", "0 0 0\n", e_format_unknown);
  EXPECT_EQ(read_mesh_file(folder.path() / "missing.obj").error().code, e_file_open);
  EXPECT_EQ(read_mesh_file(folder.path()).error().code, e_file_open);
  EXPECT_EQ(read_mesh_file(folder.path() / "a.obj", {}, 3).error().code, e_limit);
  const std::vector<NamedTriangles> nothing;
  EXPECT_EQ(write_mesh_file(folder.path() / "a.xyz", std::span<const NamedTriangles>(nothing)).error().code,
            e_format_unknown);
  EXPECT_EQ(
      write_mesh_file(folder.path() / "no" / "a.obj", std::span<const NamedTriangles>(nothing)).error().code,
      e_file_write);
}

/// Files made to break a reader, and minimised finds of the fuzzers: each must be read or refused within
/// bounds.
TEST(MeshFile, FixturesAreReadOrRefused) {
  std::size_t count = 0;
  const auto folder = std::filesystem::path(test::source_folder()) / "tests" / "exchange" / "fixtures";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    ++count;
    const std::string bytes = test::slurp(entry.path());
    for (const MeshFormat format : {MeshFormat::obj, MeshFormat::off, MeshFormat::ply, MeshFormat::stl,
                                    MeshFormat::gltf, MeshFormat::three_mf}) {
      const auto result = read_mesh(bytes, format);
      if (result.ok())
        test::expect_sound(result->mesh);
      else
        EXPECT_FALSE(result.error().text.empty());
    }
  }
  EXPECT_GT(count, 0U);
}

}  // namespace
}  // namespace hariko::test
