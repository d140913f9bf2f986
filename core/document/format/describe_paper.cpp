// Paper models in files.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/document/format/archive.hpp"
#include "core/document/format/described.hpp"
#include "core/document/words.hpp"

namespace hariko::detail {

static constexpr std::uint32_t max_pages = 100'000;
static constexpr Range above_none{above_zero, largest_number, "a number above 0 was expected"};

static constexpr Range paper_range(double low, double high) {
  return {low, high, "the number is out of its range"};
}

static void read_value(JsonReader& reader, const JsonCursor& at, std::uint64_t& steps) {
  double number = 0;
  read_value(reader, at, number, paper_range(0, 1e12));
  if (number != std::floor(number)) reader.fail(at, "a whole number was expected");
  if (!reader.failed()) steps = static_cast<std::uint64_t>(number);
}
static void write_value(DocumentText& text, const std::uint64_t& steps) {
  text.number(static_cast<double>(steps));
}

/// Rows [object, vertex] for a reference mesh; [object, kind, id, side, u, v] for a surface, with two ids for
/// an edge.
static void read_value(JsonReader& reader, const JsonCursor& row, PaperVertex& vertex) {
  const std::size_t size = reader.array_size(row, 2, 7);
  if (reader.failed()) return;
  std::size_t next = 0;
  const auto whole = [&] { return reader.integer(JsonCursor(row, next++), 0, no_index); };
  vertex.object.value = whole();
  if (size > 2) {
    read_value(reader, JsonCursor(row, next++), vertex.element.kind);
    const bool edge = vertex.element.kind == Element::Kind::edge;
    if (vertex.element.kind == Element::Kind::none || size != (edge ? 7U : 6U))
      return reader.fail(row, "[object, vertex] or [object, kind, id, side, u, v] was expected");
    vertex.element.id = whole();
    if (edge) vertex.element.id = vertex.element.id << 32 | whole();
  }
  vertex.side = whole();
  if (size > 2) {
    vertex.u = reader.number(JsonCursor(row, next++));
    vertex.v = reader.number(JsonCursor(row, next));
  }
}
static void write_value(DocumentText& text, const PaperVertex& vertex) {
  const bool on_surface = vertex.element.kind != Element::Kind::none;
  WriteArchive row(text);
  row.row(0);
  row.entry(vertex.object);
  if (on_surface) row.entry(vertex.element.kind);
  if (vertex.element.kind == Element::Kind::edge)
    row.entry(static_cast<std::uint32_t>(vertex.element.id >> 32));
  if (on_surface) row.entry(static_cast<std::uint32_t>(vertex.element.id));
  row.entry(vertex.side);
  if (on_surface) row.entry(vertex.u);
  if (on_surface) row.entry(vertex.v);
  row.close();
}

/// Rule for numbers of vertices, of which there are so many.
struct Corners {
  std::uint32_t count = 0;
  bool low_first = false;
};

/// Entries that are numbers of different vertices.
template <class Archive, std::size_t N>
void describe_corners(Archive& archive, Described<Archive, std::array<std::uint32_t, N>>& corners,
                      const Corners& rule) {
  archive.require([&] { return rule.count > 0; }, "there are no vertices");
  for (std::size_t i = 0; i < N; ++i) {
    archive.entry(corners[i], Whole{0, rule.count - 1});
    const auto here = corners.begin() + std::ptrdiff_t(i);
    archive.require([&] { return std::find(corners.begin(), here, *here) == here; },
                    "different vertices were expected");
  }
}

static void read_value(JsonReader& reader, const JsonCursor& at, PaperEdge& edge, const Corners& rule) {
  ReadArchive row(reader, at);
  row.row(2);
  describe_corners<ReadArchive, 2>(row, edge, rule);
  row.require([&] { return !rule.low_first || edge[0] < edge[1]; }, "the lower number comes first");
}

template <class Archive>
void describe_place(Archive& archive, Described<Archive, PaperPlace>& place) {
  archive.entry(place.page, Whole{0, max_pages});
  archive.entry(place.angle, paper_range(-1e6, 1e6));
  archive.entry(place.x, paper_range(-1e9, 1e9));
  archive.entry(place.y, paper_range(-1e9, 1e9));
}
template <class Archive>
void describe(Archive& archive, Described<Archive, PaperModel::FacetPlace>& row, const Corners& rule = {}) {
  archive.row(7);
  describe_corners<Archive, 3>(archive, row.facet, rule);
  describe_place(archive, row.place);
}
template <class Archive>
void describe(Archive& archive, Described<Archive, PaperModel::StripPlace>& row, const Corners& rule = {}) {
  archive.row(6);
  describe_corners<Archive, 2>(archive, row.edge, rule);
  describe_place(archive, row.place);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, PaperSize>& page) {
  archive.row(2);
  archive.entry(page.width, paper_range(0, 10'000), above_none);
  archive.entry(page.height, paper_range(0, 10'000), above_none);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, PaperSettings>& settings) {
  constexpr Range length = paper_range(0, 10'000), angle = paper_range(0, std::numbers::pi);
  archive.line();
  archive.required("scale", settings.scale, paper_range(0, 1e300), above_none);
  archive.member("page", settings.page);
  archive.member("margin", settings.margin, length);
  archive.member("gap", settings.gap, length);
  archive.member("tab_height", settings.tab_height, length);
  if (archive.before(2)) archive.assume(settings.least_tab, 0);
  archive.member("least_tab", settings.least_tab, length);
  archive.member("strip_width", settings.strip_width, length);
  archive.member("inside", settings.inside);
  archive.member("flat_fold", settings.flat_fold, angle);
  archive.member("merge_angle", settings.merge_angle, angle);
  archive.member("fold_angles", settings.fold_angles);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, PaperModel>& paper) {
  archive.lines();
  archive.required("objects", paper.objects, Ascending{"ids must be in ascending order, each once"});
  archive.member("of_polyhedra", paper.of_polyhedra);
  archive.required("distance", paper.distance, paper_range(0, 1e300), above_none);
  archive.member("normal_angle", paper.normal_angle, paper_range(0, std::numbers::pi / 2));
  archive.required("settings", paper.settings);
  archive.member("goal", paper.goal);
  archive.member("steps", paper.steps);
  archive.list("vertices", paper.vertices, Ascending{});
  const auto count = static_cast<std::uint32_t>(paper.vertices.size());
  const Corners low_first{count, true}, directed{count, false};
  archive.list("folds", paper.folds, Ascending{}, low_first);
  archive.list("cuts", paper.cuts, Ascending{}, low_first);
  archive.list("own_folds", paper.own_folds, Ascending{}, low_first);
  archive.list("own_cuts", paper.own_cuts, Ascending{}, low_first);
  archive.list("tabs", paper.tabs, Ascending{}, directed);
  archive.list("strips", paper.strips, Ascending{}, low_first);
  archive.list("places", paper.places, directed);
  archive.list("strip_places", paper.strip_places, directed);
  archive.kept(paper.kept);
}

void read_value(JsonReader& reader, const JsonCursor& at, PaperModel& paper) {
  read_described(reader, at, paper);
}
void write_value(DocumentText& text, const PaperModel& paper) {
  write_described(text, paper);
}

}  // namespace hariko::detail
