// Files of sheets: layout, layers, words; and that other programs draw the page as we describe it.

#include "core/unfolding/pages/write_sheets.hpp"
#include "core/unfolding/cuts/convex_overlap.hpp"
#include "core/unfolding/pages/label_places.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "core/base/files/file_io.hpp"
#include "tests/unfolding/paper.hpp"

namespace hariko::test {
namespace {

Unfolding torus_model(bool inside = false) {
  const PolygonMesh mesh = torus_facets(16, 8);
  PaperSettings settings;
  settings.scale = scale_for(mesh, 0, 180);
  settings.inside = inside;
  settings.fold_angles = true;
  return unfold(shared_graph(mesh), settings, {.steps = 2000}).value();
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(WriteSheets, LayoutReadsBackExactly) {
  const PolygonMesh mesh = torus_facets(16, 8);
  const Unfolding model = torus_model();
  const auto json = nlohmann::json::parse(write_layout_json(draw_sheets(model)));
  EXPECT_EQ(json["format"].get<std::string>(), "unfolding-1");
  EXPECT_EQ(json["unit"].get<std::string>(), "mm");
  EXPECT_EQ(json["page_size"].get<std::vector<double>>(), (std::vector<double>{210, 297}));
  ASSERT_EQ(json["faces"].size(), mesh.face_count());
  CheckedLayout layout;
  layout.scale = json["scale"].get<double>();
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto& face = json["faces"][f];
    ASSERT_EQ(face["id"].get<std::size_t>(), f);
    layout.piece.push_back(face["piece"].get<Index>());
    layout.sheet.push_back(face["page"].get<Index>());
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = Vector2(face["xy"][k][0].get<double>(), face["xy"][k][1].get<double>());
    EXPECT_EQ(corners, model.corners[f]);
    layout.corners.push_back(corners);
  }
  for (const auto& fold : json["folds"])
    layout.folds.emplace_back(fold[0].get<Index>(), fold[1].get<Index>());
  check_layout(mesh, layout);
}

TEST(WriteSheets, InsidePrintIsTheMirrorImage) {
  const SheetDrawing outside = draw_sheets(torus_model()), inside = draw_sheets(torus_model(true));
  ASSERT_EQ(outside.lines.size(), inside.lines.size());
  for (std::size_t k = 0; k < outside.facets.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(inside.facets[k].corners[c].x(), 210 - outside.facets[k].corners[c].x());
      EXPECT_EQ(inside.facets[k].corners[c].y(), outside.facets[k].corners[c].y());
    }
  for (std::size_t k = 0; k < outside.folds.size(); ++k)
    EXPECT_TRUE(outside.folds[k].kind != FoldKind::mountain || inside.folds[k].kind == FoldKind::valley);
}

TEST(WriteSheets, EveryJointIsNumberedOnBothSidesAndOnTheTab) {
  const Unfolding model = torus_model();
  const SheetDrawing drawing = draw_sheets(model);
  std::map<std::string, int> words;
  for (const DrawnText& text : drawing.texts) ++words[text.text];
  for (Index j = 0; j < model.joints.size(); ++j) {
    const double length = model.settings.scale * model.graph->edge(model.joints[j].edge).length;
    const double height = std::clamp(0.12 * length, 1.5, 3.0);
    if (length < 2 * height) continue;
    // Fold angles may be the same words.
    EXPECT_GE(words[std::to_string(j + 1)], model.joints[j].tab ? 3 : 4) << j;
  }
  for (Index p = 0; p < model.pieces.size(); ++p) EXPECT_EQ(words[piece_name(p)], 1);
  EXPECT_EQ(words["50 mm"], int(model.page_count));
  // A number beside a cut lies in its facet: within some facet of the page.
  for (const DrawnText& text : drawing.texts) {
    if (text.text != "1") continue;
    EXPECT_TRUE(text.centre.x() > 0 && text.centre.x() < 210 && text.centre.y() > 0 && text.centre.y() < 297);
  }
}

/// No number covers another one, however narrow the facets are.
TEST(WriteSheets, NumbersNeverCollide) {
  for (const double size : {60.0, 120.0, 250.0}) {
    PaperSettings settings;
    const PolygonMesh mesh = torus_facets(16, 8);
    settings.scale = scale_for(mesh, 0, size);
    settings.fold_angles = true;
    const SheetDrawing drawing = draw_sheets(unfold(shared_graph(mesh), settings, {.steps = 2000}).value());
    std::size_t collisions = 0;
    for (std::size_t i = 0; i < drawing.texts.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const DrawnText &a = drawing.texts[i], &b = drawing.texts[k];
        if (a.page == b.page && overlaps(box_of(a), box_of(b), 0)) ++collisions;
      }
    EXPECT_EQ(collisions, 0U) << size << ", of " << drawing.texts.size();
  }
}

TEST(WriteSheets, FoldsAreMountainsAndValleysByTheirSign) {
  const SheetDrawing drawing = draw_sheets(torus_model());
  std::size_t mountains = 0, valleys = 0, flats = 0;
  for (const DrawnFold& fold : drawing.folds) {
    const bool flat = std::abs(fold.angle) < 0.5 * std::numbers::pi / 180;
    EXPECT_EQ(fold.kind, flat ? FoldKind::flat : fold.angle > 0 ? FoldKind::mountain : FoldKind::valley);
    ++(flat ? flats : fold.angle > 0 ? mountains : valleys);
  }
  EXPECT_GT(mountains, 20U);
  EXPECT_GT(valleys, 5U);
  EXPECT_GT(flats, 20U) << "the diagonals of plane quads";
  std::size_t lines = 0;
  for (const DrawnLine& line : drawing.lines) lines += line.inner_fold ? 1 : 0;
  EXPECT_EQ(lines, mountains + valleys);
}

TEST(WriteSheets, SvgHasLayersAndEveryFacet) {
  const Unfolding model = torus_model();
  const SheetDrawing drawing = draw_sheets(model);
  ASSERT_GT(drawing.page_count, 1U);
  std::size_t facets = 0, folds = 0;
  for (Index page = 0; page < drawing.page_count; ++page) {
    const std::string svg = write_sheet_svg(drawing, page);
    facets += count_of(svg, "<polygon class=\"face\" data-face=");
    folds += count_of(svg, "data-faces=");
    EXPECT_EQ(count_of(svg, " data-page=\"" + std::to_string(page) + "\""),
              1 + count_of(svg, "<polygon class=\"face\""));
    EXPECT_EQ(count_of(svg, "<rect class=\"page\""), 1U);
    for (const char* layer : {"cut", "fold-mountain", "fold-valley", "tab", "label", "strip"})
      EXPECT_EQ(count_of(svg, std::string("inkscape:label=\"") + layer + "\""), 1U) << layer;
  }
  EXPECT_EQ(facets, model.graph->facet_count());
  EXPECT_EQ(folds, model.graph->facet_count() - model.pieces.size());
}

TEST(WriteSheets, DxfSaysThatItsUnitIsTheMillimetre) {
  const std::string dxf = write_sheet_dxf(draw_sheets(torus_model()));
  EXPECT_EQ(count_of(dxf, "\n9\n$INSUNITS\n70\n4\n"), 1U);
}

TEST(WriteSheets, PdfKnowsWhereItsObjectsAre) {
  const std::string pdf = write_sheet_pdf(draw_sheets(torus_model()));
  const std::size_t table = pdf.rfind("startxref\n");
  ASSERT_NE(table, std::string::npos);
  const std::size_t at = std::stoul(pdf.substr(table + 10));
  ASSERT_EQ(pdf.compare(at, 5, "xref\n"), 0);
  std::istringstream rows(pdf.substr(at + 5));
  std::size_t first = 0, count = 0, place = 0, generation = 0;
  std::string kind;
  rows >> first >> count >> place >> generation >> kind;
  for (std::size_t k = 1; k < count; ++k) {
    rows >> place >> generation >> kind;
    EXPECT_EQ(pdf.compare(place, std::to_string(k).size() + 6, std::to_string(k) + " 0 obj"), 0) << k;
  }
}

// The readers of others. They are Debian packages of the full tests; where one is missing its test says so.

class OtherReaders : public ::testing::Test {
 protected:
  OtherReaders() {
    std::string pattern = (std::filesystem::temp_directory_path() / "hariko-sheets-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~OtherReaders() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  static bool has(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Grey values of a binary PGM.
  struct Picture {
    int width = 0, height = 0;
    std::string grey;
    int darkest_near(double x, double y) const {
      int out = 255;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const int i = static_cast<int>(x) + dx, k = static_cast<int>(y) + dy;
          if (i < 0 || k < 0 || i >= width || k >= height) continue;
          out = std::min(out, int(static_cast<unsigned char>(
                                  grey[static_cast<std::size_t>(k) * static_cast<std::size_t>(width) +
                                       static_cast<std::size_t>(i)])));
        }
      return out;
    }
  };
  static Picture read_pgm(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string magic;
    int depth = 0;
    Picture out;
    stream >> magic >> out.width >> out.height >> depth;
    stream.get();
    EXPECT_EQ(magic, "P5");
    EXPECT_EQ(depth, 255);
    out.grey.assign(std::istreambuf_iterator<char>(stream), {});
    return out;
  }

  static constexpr double dots = 150;  ///< an inch

  /// Along every line of the page there is ink, and where nothing is drawn there is none.
  static void expect_same_page(const SheetDrawing& drawing, Index page, const Picture& picture) {
    const double scale = dots / 25.4;
    ASSERT_NEAR(picture.height, scale * drawing.page.height, 2);
    ASSERT_NEAR(picture.width, scale * drawing.page.width, 2);
    const auto pixel = [&](const Vector2& p) {
      return Vector2(scale * p.x(), scale * (drawing.page.height - p.y()));
    };
    std::size_t asked = 0, missing = 0;
    std::vector<char> near_ink(picture.grey.size(), 0);
    const auto mark = [&](const Vector2& p, int reach) {
      for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
          const int x = static_cast<int>(p.x()) + dx, y = static_cast<int>(p.y()) + dy;
          if (x >= 0 && y >= 0 && x < picture.width && y < picture.height)
            near_ink[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                     static_cast<std::size_t>(x)] = 1;
        }
    };
    for (const DrawnLine& line : drawing.lines) {
      if (line.page != page) continue;
      const Vector2 from = pixel(line.from), to = pixel(line.to);
      const int steps = std::max(2, static_cast<int>((to - from).norm()));
      for (int k = 0; k <= steps; ++k) {
        const Vector2 p = from + (to - from) * k / steps;
        mark(p, 3);
        if (line.layer == SheetLayer::fold_valley) continue;  // dashed
        ++asked;
        if (picture.darkest_near(p.x(), p.y()) > 245) ++missing;
      }
    }
    for (const DrawnText& text : drawing.texts)
      if (text.page == page)
        mark(pixel(text.centre), static_cast<int>(scale * text.height * (1 + double(text.text.size()))));
    EXPECT_LT(double(missing), 0.002 * double(asked)) << asked;
    std::size_t stray = 0;
    for (std::size_t k = 0; k < picture.grey.size(); ++k)
      stray += !near_ink[k] && static_cast<unsigned char>(picture.grey[k]) < 200 ? 1 : 0;
    EXPECT_EQ(stray, 0U) << "ink where nothing is drawn";
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(OtherReaders, PopplerDrawsTheSamePages) {
  if (!has("pdftoppm")) GTEST_SKIP() << "pdftoppm (poppler-utils) is not installed";
  const SheetDrawing drawing = draw_sheets(torus_model());
  ASSERT_TRUE(write_file_atomic(path("sheets.pdf"), write_sheet_pdf(drawing)).ok());
  ASSERT_EQ(std::system(("pdftoppm -gray -r 150 " + path("sheets.pdf") + " " + path("page")).c_str()), 0);
  for (Index page = 0; page < drawing.page_count; ++page) {
    std::string file = path("page-" + std::to_string(page + 1) + ".pgm");
    ASSERT_TRUE(std::filesystem::exists(file)) << file;
    expect_same_page(drawing, page, read_pgm(file));
  }
}

TEST_F(OtherReaders, LibrsvgDrawsTheSamePages) {
  if (!has("rsvg-convert") || !has("convert"))
    GTEST_SKIP() << "rsvg-convert (librsvg2-bin) or convert (imagemagick) is not installed";
  const SheetDrawing drawing = draw_sheets(torus_model());
  for (Index page = 0; page < drawing.page_count; ++page) {
    ASSERT_TRUE(write_file_atomic(path("sheet.svg"), write_sheet_svg(drawing, page)).ok());
    ASSERT_EQ(
        std::system(("rsvg-convert -d 150 -p 150 -b white -o " + path("one.png") + " " + path("sheet.svg") +
                     " && convert " + path("one.png") + " -colorspace Gray -depth 8 pgm:" + path("one.pgm"))
                        .c_str()),
        0);
    expect_same_page(drawing, page, read_pgm(path("one.pgm")));
  }
}

TEST_F(OtherReaders, EzdxfFindsTheSameLines) {
  if (std::system("/usr/bin/python3 -c 'import ezdxf' >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "python3-ezdxf is not installed";
  const SheetDrawing drawing = draw_sheets(torus_model());
  ASSERT_TRUE(write_file_atomic(path("sheets.dxf"), write_sheet_dxf(drawing)).ok());
  std::ofstream(path("read.py")) << "import ezdxf, json, sys\n"
                                    "doc = ezdxf.readfile(sys.argv[1])\n"
                                    "out = {'version': doc.dxfversion, 'units': doc.header.get('$INSUNITS'), "
                                    "'errors': len(doc.audit().errors), 'lines': [], "
                                    "'texts': 0}\n"
                                    "for e in doc.modelspace():\n"
                                    "    if e.dxftype() == 'LINE':\n"
                                    "        out['lines'].append([e.dxf.layer, *e.dxf.start, *e.dxf.end])\n"
                                    "    else:\n"
                                    "        out['texts'] += e.dxftype() == 'TEXT'\n"
                                    "json.dump(out, open(sys.argv[2], 'w'))\n";
  ASSERT_EQ(
      std::system(("/usr/bin/python3 " + path("read.py") + " " + path("sheets.dxf") + " " + path("read.json"))
                      .c_str()),
      0);
  std::ifstream stream(path("read.json"));
  const auto read = nlohmann::json::parse(stream);
  EXPECT_EQ(read["version"].get<std::string>(), "AC1009");
  EXPECT_EQ(read["errors"].get<int>(), 0);
  EXPECT_EQ(read["units"].get<int>(), 4) << "millimetres";
  EXPECT_EQ(read["texts"].get<std::size_t>(), drawing.texts.size());
  ASSERT_EQ(read["lines"].size(), drawing.lines.size());
  for (std::size_t k = 0; k < drawing.lines.size(); ++k) {
    const DrawnLine& line = drawing.lines[k];
    const double x = line.page * (drawing.page.width + page_spacing);
    EXPECT_EQ(read["lines"][k][0].get<std::string>(), to_string(line.layer));
    EXPECT_NEAR(read["lines"][k][1].get<double>(), x + line.from.x(), 1e-8);
    EXPECT_NEAR(read["lines"][k][2].get<double>(), line.from.y(), 1e-8);
    EXPECT_NEAR(read["lines"][k][4].get<double>(), x + line.to.x(), 1e-8);
    EXPECT_NEAR(read["lines"][k][5].get<double>(), line.to.y(), 1e-8);
  }
}

}  // namespace
}  // namespace hariko::test
