#include "core/exchange/triangles/read_ply.hpp"

#include <array>
#include <bit>
#include <cstring>

#include "tests/exchange/mesh_text.hpp"

namespace hariko::test {
namespace {

const std::string small_header =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";  // 9 lines
const std::string small_points = "0 0 0\n1 0 0\n0 1 0\n";

/// Writes numbers of any PLY type in either byte order.
struct Bytes {
  bool big = false;
  std::string out;
  void put(const std::string& type, double value) {
    if (type == "char" || type == "int8") append(static_cast<std::int8_t>(value));
    if (type == "uchar" || type == "uint8") append(static_cast<std::uint8_t>(value));
    if (type == "short" || type == "int16") append(static_cast<std::int16_t>(value));
    if (type == "ushort" || type == "uint16") append(static_cast<std::uint16_t>(value));
    if (type == "int" || type == "int32") append(static_cast<std::int32_t>(value));
    if (type == "uint" || type == "uint32") append(static_cast<std::uint32_t>(value));
    if (type == "float" || type == "float32") append(static_cast<float>(value));
    if (type == "double" || type == "float64") append(value);
  }
  template <class T>
  void append(T value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (big != (std::endian::native == std::endian::big)) std::reverse(raw, raw + sizeof value);
    out.append(raw, sizeof value);
  }
};

const std::vector<std::string> integer_types{"char",   "int8",   "uchar", "uint8", "short", "int16",
                                             "ushort", "uint16", "int",   "int32", "uint",  "uint32"};
const std::vector<std::string> real_types{"float", "float32", "double", "float64"};

TEST(ReadPly, EveryTypeInEveryFormat) {
  std::vector<std::string> scalars = integer_types;
  scalars.insert(scalars.end(), real_types.begin(), real_types.end());
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"})
    for (const std::string& scalar : scalars)
      for (const std::string& count : integer_types)
        for (const std::string& index : integer_types) {
          const std::string header = "ply\nformat " + format +
                                     " 1.0\ncomment c\nobj_info o\nelement face 1\nproperty list " + count +
                                     " " + index + " vertex_index\nelement vertex 3\nproperty " + scalar +
                                     " z\nproperty list uchar float extra\nproperty " + scalar +
                                     " x\nproperty " + scalar + " y\nend_header\n";
          Bytes data{format == "binary_big_endian", {}};
          const std::string text = "3 0 1 2\n3 2 0.5 0.25 1 2\n6 0 4 5\n9 0 7 8\n";
          data.put(count, 3);
          for (int i = 0; i < 3; ++i) data.put(index, i);
          for (int i = 0; i < 3; ++i) {
            data.put(scalar, 3 * i + 3);
            data.put("uchar", i == 0 ? 2 : 0);
            for (int k = 0; k < 2 && i == 0; ++k) data.put("float", 0.5);
            data.put(scalar, 3 * i + 1);
            data.put(scalar, 3 * i + 2);
          }
          const auto result = read_ply(header + (format == "ascii" ? text : data.out));
          ASSERT_TRUE(result.ok()) << header << to_string(result.error());
          test::expect_sound(result->mesh);
          EXPECT_EQ(result->mesh.face_vertices, (std::vector<Index>{0, 1, 2}));
          EXPECT_EQ(result->mesh.positions, (std::vector<Vector3>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
          EXPECT_TRUE(result->warnings.empty());
        }
}

TEST(ReadPly, UnknownElementsAreSkipped) {
  const auto result = read_ply(
      "ply\r\nformat ascii 1.0\r\nelement camera 2\r\nproperty float f\r\nproperty list uint8 float "
      "m\r\nelement vertex 3\r\n"
      "property double x\r\nproperty uchar red\r\nproperty double y\r\nproperty double z\r\nelement none "
      "0\r\nelement face 1\r\n"
      "property list uchar int vertex_indices\r\nproperty list uchar float texcoord\r\nend_header\r\n"
      "1 2 nan 4\r\n1 0\r\n0 255 0 0\r\n1 255 0 0\r\n0 255 1 0\r\n3 0 1 2 6 0 0 1 0 0 1\r\n");
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_EQ(result->mesh.positions[2], Vector3(0, 1, 0));
  EXPECT_TRUE(result->warnings.empty()) << "a camera has no shape";
}

TEST(ReadPly, ElementsThatMayHaveAShapeAreCounted) {
  std::string header = small_header;
  header.replace(header.find("element face"), 0,
                 "element edge 2\nproperty int vertex1\nproperty int vertex2\n");
  const auto result = test::must(read_ply(header + small_points + "0 1\n1 2\n3 0 1 2\n"));
  ASSERT_EQ(result->warnings.size(), 1U);
  EXPECT_EQ(result->warnings[0].code.name, std::string("W_LEFT_OUT"));
  EXPECT_EQ(result->warnings[0].text, "The element \"edge\" with 2 entries is not read and was left out.");
}

TEST(ReadPly, StripsAreTrianglesInTurnAndBeginAgainAfterMinusOne) {
  const std::string head =
      "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
  const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}};
  const std::vector<int> strip{0, 1, 2, 3, 4, -1, 0, 1, 1, 3};
  std::string text = "ply\nformat ascii 1.0\n" + head;
  for (const auto& p : points)
    text += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
  text += std::to_string(strip.size());
  for (const int v : strip) text += " " + std::to_string(v);
  text += "\n";
  for (const bool big : {false, true}) {
    Bytes bytes{big, {}};
    for (const auto& p : points)
      for (const double x : p) bytes.put("float", x);
    bytes.put("int", double(strip.size()));
    for (const int v : strip) bytes.put("int", v);
    const auto read = test::must(read_ply(std::string("ply\nformat binary_") + (big ? "big" : "little") +
                                          "_endian 1.0\n" + head + bytes.out));
    const auto same = test::must(read_ply(text));
    test::expect_same(read->mesh, same->mesh);
    // All three look up; what has no area only turns the strip.
    const std::vector<Index> expected{0, 1, 2, 2, 1, 3, 2, 3, 4};
    EXPECT_EQ(read->mesh.face_vertices, expected);
  }
  EXPECT_EQ(outcome(read_ply(test::with(text, " -1 ", " -2 "))), "E_INDEX_RANGE 15");
  EXPECT_EQ(outcome(read_ply(text, {.vertices = 9, .corners = 8})), "E_LIMIT 15");
}

TEST(ReadPly, BinaryDataMayStartWithALineFeed) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string header = "ply" + end + "format binary_little_endian 1.0" + end + "element vertex 3" +
                               end + "property uchar x" + end + "property uchar y" + end +
                               "property uchar z" + end + "element face 1" + end +
                               "property list uchar uchar vertex_indices" + end + "end_header" + end;
    const auto result = read_ply(header + "\n\r\n" + "\r\n\n" + "\n\n\n" + std::string("\3\0\1\2", 4));
    ASSERT_TRUE(result.ok()) << to_string(result.error());
    EXPECT_EQ(result->mesh.positions[0], Vector3(10, 13, 10));
    EXPECT_EQ(result->mesh.positions[2], Vector3(10, 10, 10));
  }
}

std::string with_header(const std::string& replaced, const std::string& by) {
  std::string text = small_header;
  const std::size_t at = text.find(replaced);
  EXPECT_NE(at, std::string::npos) << replaced;
  return text.replace(at, replaced.size(), by) + small_points + "3 0 1 2\n";
}

TEST(ReadPly, EveryMalformedHeaderHasItsCodeAndLine) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "E_FORMAT_UNKNOWN 1"},
      {"plyx\n", "E_FORMAT_UNKNOWN 1"},
      {"ply\n", "E_TRUNCATED 2"},
      {"ply\nformat ascii 1.0\nelement vertex 3\n", "E_TRUNCATED 4"},
      {"ply\nend_header\n", "E_FORMAT_UNKNOWN 2"},
      {with_header("format ascii", "format text"), "E_FORMAT_UNKNOWN 2"},
      {with_header("1.0", "2.0"), "E_FORMAT_UNKNOWN 2"},
      {with_header("element vertex 3", "elements vertex 3"), "E_PARSE 3"},
      {with_header("element vertex 3", "element vertex"), "E_PARSE 3"},
      {with_header("element vertex 3", "element"), "E_PARSE 3"},
      {with_header("element vertex 3", "element vertex three"), "E_PARSE 3"},
      {with_header("element vertex 3", "element vertex -3"), "E_PARSE 3"},
      {with_header("element vertex 3", "element vertex 3 4"), "E_PARSE 3"},
      {with_header("element vertex 3", "property float x\nelement vertex 3"), "E_PARSE 3"},
      {with_header("element vertex 3", "element vertex 99999999999999999999"), "E_LIMIT 3"},
      {with_header("element vertex 3", "element vertex 4000000000"), "E_LIMIT 3"},
      {with_header("property float x", "property real x"), "E_PARSE 4"},
      {with_header("property float x", "property float"), "E_PARSE 4"},
      {with_header("property float x", "property float y"), "E_PARSE 5"},
      {with_header("property float x", "property float a"), "E_PARSE 3"},
      {with_header("property float x", "property list uchar float x"), "E_PARSE 3"},
      {with_header("element face 1", "element vertex 1"), "E_PARSE 7"},
      {with_header("element face 1", "element empty 5\nelement face 1"), "E_PARSE 7"},
      {with_header("list uchar int", "list float int"), "E_PARSE 8"},
      {with_header("list uchar int", "list uchar"), "E_PARSE 8"},
      {with_header("list uchar int", "list uchar float"), "E_PARSE 7"},
      {with_header("list uchar int", "int"), "E_PARSE 7"},
      {with_header("vertex_indices", "corners"), "E_PARSE 7"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(outcome(read_ply(text)), expected) << text;
}

TEST(ReadPly, EveryMalformedTextRowHasItsCodeAndLine) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "E_TRUNCATED 10"},
      {"0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "E_PARSE 11"},
      {"0 0 0\n1 0 0 5\n0 1 0\n3 0 1 2\n", "E_PARSE 11"},
      {"0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n", "E_PARSE 11"},
      {"0 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n", "E_EMPTY 0"},
      {"0 0 0\n1 0 0\n", "E_TRUNCATED 12"},
      {"0 0 0\n1 0 0\n0 1", "E_TRUNCATED 12"},
      {small_points, "E_TRUNCATED 13"},
      {small_points + "3 0 1\n", "E_PARSE 13"},
      {small_points + "3 0 1", "E_TRUNCATED 13"},
      {small_points + "-3 0 1 2\n", "E_PARSE 13"},
      {small_points + "3 0 1 2 2\n", "E_PARSE 13"},
      {small_points + "3 0 1 1.5\n", "E_PARSE 13"},
      {small_points + "3 0 1 3\n", "E_INDEX_RANGE 13"},
      {small_points + "3 0 1 -1\n", "E_INDEX_RANGE 13"},
  };
  for (const auto& [rows, expected] : cases)
    EXPECT_EQ(outcome(read_ply(small_header + rows)), expected) << rows;
  EXPECT_EQ(outcome(read_ply(small_header + small_points + "3 0 1 2\n", {.vertices = 2, .corners = 9})),
            "E_LIMIT 3");
  EXPECT_EQ(outcome(read_ply(small_header + small_points + "3 0 1 2\n", {.vertices = 9, .corners = 2})),
            "E_LIMIT 13");
  std::string cloud = small_header;
  cloud.replace(cloud.find("face 1"), 6, "face 0");
  EXPECT_EQ(outcome(read_ply(cloud + small_points)), "E_EMPTY 0");
}

std::string binary_header(const std::string& vertices, const std::string& faces) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list int int vertex_indices\nend_header\n";
}

std::string binary_points() {
  Bytes data;
  for (const double value : {0, 0, 0, 1, 0, 0, 0, 1, 0}) data.put("float", value);
  return data.out;
}

std::string integers(std::initializer_list<double> values) {
  Bytes data;
  for (const double value : values) data.put("int", value);
  return data.out;
}

TEST(ReadPly, EveryMalformedBinaryFileHasItsCode) {
  const std::string good = binary_header("3", "1") + binary_points();
  EXPECT_EQ(outcome(read_ply(good + integers({3, 0, 1, 2}))), "ok");
  EXPECT_EQ(outcome(read_ply(good)), "E_TRUNCATED 0");
  EXPECT_EQ(outcome(read_ply(good + integers({3, 0, 1}))), "E_TRUNCATED 0");
  EXPECT_EQ(outcome(read_ply(good + integers({2000000000, 0, 1, 2}))), "E_TRUNCATED 0");
  EXPECT_EQ(outcome(read_ply(good + integers({-3, 0, 1, 2}))), "E_PARSE 0");
  EXPECT_EQ(outcome(read_ply(good + integers({3, 0, 1, 3}))), "E_INDEX_RANGE 0");
  EXPECT_EQ(outcome(read_ply(good + integers({3, 0, 1, -1}))), "E_INDEX_RANGE 0");
  EXPECT_EQ(outcome(read_ply(good + integers({3, 0, 1, 2}), {.vertices = 9, .corners = 2})), "E_LIMIT 0");
  // Headers that lie must not allocate what they promise.
  EXPECT_EQ(outcome(read_ply(binary_header("100000000", "1") + binary_points())), "E_TRUNCATED 0");
  EXPECT_EQ(outcome(read_ply(binary_header("3", "400000000") + binary_points())), "E_TRUNCATED 0");
  EXPECT_EQ(outcome(read_ply(binary_header("3", "9223372036854775807") + binary_points())), "E_LIMIT 7");
  std::string not_finite = good + integers({3, 0, 1, 2});
  not_finite.replace(not_finite.find("end_header\n") + 11 + 4, 4, std::string("\0\0\xc0\x7f", 4));
  EXPECT_EQ(outcome(read_ply(not_finite)), "E_EMPTY 0");
  const auto longer = test::must(read_ply(good + integers({3, 0, 1, 2, 9})));
  EXPECT_EQ(longer->warnings.at(0).code, w_trailing_data);
}

TEST(ReadPly, PlacesThatAScanDoesNotSeeAreDroppedWithTheirFaces) {
  const std::string header =
      "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 3\nproperty list int int vertex_indices\nend_header\n";
  Bytes bytes;
  for (const double value : {0., 0., 0., std::nan(""), 0., 0., 1., 0., 0., 0., 1., 0., 0., std::nan(""), 1.})
    bytes.put("float", value);
  for (const std::string& data :
       {"ply\nformat binary_little_endian 1.0\n" + header + bytes.out +
            integers({3, 0, 2, 3, 3, 1, 2, 3, 3, 4, 0, 2}),
        "ply\nformat ascii 1.0\n" + header +
            "0 0 0\nnan 0 0\n1 0 0\n0 1 0\n0 -inf 1\n3 0 2 3\n3 1 2 3\n3 4 0 2\n"}) {
    const auto read = test::must(read_ply(data));
    test::expect_sound(read->mesh);
    EXPECT_EQ(read->mesh.positions.size(), 3U);
    EXPECT_EQ(read->mesh.face_vertices, (std::vector<Index>{0, 1, 2}));
    ASSERT_EQ(read->warnings.size(), 1U);
    EXPECT_EQ(read->warnings[0].text, "2 faces with coordinates that are not finite were left out.");
  }
  // Such places without faces are not worth a word.
  std::string unused = small_header + small_points + "3 0 1 2\n";
  unused.replace(unused.find("vertex 3"), 8, "vertex 4");
  unused.replace(unused.find("3 0 1 2"), 0, "nan nan nan\n");
  const auto read = test::must(read_ply(unused));
  EXPECT_EQ(read->mesh.positions.size(), 3U);
  EXPECT_TRUE(read->warnings.empty());
}

TEST(ReadPly, HugeCountsOfSkippedElementsTakeNoTime) {
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement junk 9223372036854775807\nproperty list uchar int "
      "a\nend_header\n";
  EXPECT_EQ(outcome(read_ply(header)), "E_TRUNCATED 0");
  EXPECT_EQ(
      outcome(read_ply(
          "ply\nformat ascii 1.0\nelement junk 9223372036854775807\nproperty int a\nend_header\n1\n2\n")),
      "E_TRUNCATED 8");
}

TEST(ReadPly, TruncationAtEveryByteIsHandled) {
  for (const std::string& text : {small_header + small_points + "3 0 1 2\n",
                                  binary_header("3", "1") + binary_points() + integers({3, 0, 1, 2})}) {
    for (std::size_t size = 0; size < text.size(); ++size) {
      const auto result = read_ply(std::string(text, 0, size));
      if (size < text.size() - 1) {
        EXPECT_FALSE(result.ok()) << size;
      }
    }
    EXPECT_TRUE(read_ply(text).ok());
  }
}

}  // namespace
}  // namespace hariko::test
