#include "core/document/format/read_paper.hpp"

#include <algorithm>
#include <numbers>

#include "core/document/format/format_names.hpp"
#include "core/document/format/read_source.hpp"

namespace hariko::detail {

namespace {

constexpr std::uint32_t max_pages = 100'000;

class PaperReader {
 public:
  PaperReader(JsonReader& reader, std::string_view text) : reader_(reader), text_(text) {}

  PaperModel read(const JsonCursor& at) {
    if (!reader_.is_object(at)) return std::move(paper_);
    read_choices(at);
    reader_.if_member(at, "vertices", [&](const JsonCursor& list) {
      reader_.for_each(list, [&](const JsonCursor& row) { read_vertex(row); });
    });
    edges(at, "folds", paper_.folds, true);
    edges(at, "cuts", paper_.cuts, true);
    edges(at, "own_folds", paper_.own_folds, true);
    edges(at, "own_cuts", paper_.own_cuts, true);
    edges(at, "tabs", paper_.tabs, false);
    edges(at, "strips", paper_.strips, true);
    reader_.if_member(at, "places", [&](const JsonCursor& list) {
      reader_.for_each(list, [&](const JsonCursor& row) {
        PaperModel::FacetPlace& next = paper_.places.emplace_back();
        read_placed(row, next.facet, next.place);
      });
    });
    reader_.if_member(at, "strip_places", [&](const JsonCursor& list) {
      reader_.for_each(list, [&](const JsonCursor& row) {
        PaperModel::StripPlace& next = paper_.strip_places.emplace_back();
        read_placed(row, next.edge, next.place);
      });
    });
    if (!reader_.failed()) paper_.kept = kept_members(at, paper_members, text_);
    return std::move(paper_);
  }

 private:
  void read_choices(const JsonCursor& at) {
    reader_.member(at, "objects", [&](const JsonCursor& list) {
      reader_.for_each(list, [&](const JsonCursor& id) {
        const ObjectId next{reader_.integer(id, 0, max_id)};
        if (!paper_.objects.empty() && !(paper_.objects.back() < next))
          reader_.fail(id, "ids must be in ascending order, each once");
        paper_.objects.push_back(next);
      });
    });
    reader_.if_member(at, "of_polyhedra",
                      [&](const JsonCursor& m) { paper_.of_polyhedra = reader_.boolean(m); });
    reader_.member(at, "distance", [&](const JsonCursor& m) { paper_.distance = positive(m, 1e300); });
    reader_.if_member(at, "normal_angle", [&](const JsonCursor& m) {
      paper_.normal_angle = in_range(m, 0, std::numbers::pi / 2);
    });
    reader_.member(at, "settings", [&](const JsonCursor& m) { read_settings(m); });
    reader_.if_member(at, "goal", [&](const JsonCursor& m) {
      paper_.goal = static_cast<CutGoal>(reader_.choice(m, goal_names));
    });
    reader_.if_member(at, "steps", [&](const JsonCursor& m) {
      paper_.steps = static_cast<std::uint64_t>(in_range(m, 0, 1e12));
      if (static_cast<double>(paper_.steps) != reader_.number(m))
        reader_.fail(m, "a whole number was expected");
    });
  }

  double in_range(const JsonCursor& at, double low, double high) {
    const double value = reader_.number(at);
    if (!(value >= low && value <= high)) reader_.fail(at, "the number is out of its range");
    return reader_.failed() ? low : value;
  }
  double positive(const JsonCursor& at, double high) {
    const double value = in_range(at, 0, high);
    if (value == 0) reader_.fail(at, "a number above 0 was expected");
    return value;
  }

  void read_settings(const JsonCursor& at) {
    if (!reader_.is_object(at)) return;
    refuse_unknown_members(reader_, at, paper_setting_members);
    PaperSettings& s = paper_.settings;
    reader_.member(at, "scale", [&](const JsonCursor& m) { s.scale = positive(m, 1e300); });
    reader_.if_member(at, "page", [&](const JsonCursor& list) {
      if (reader_.array_size(list, 2, 2) != 2) return;
      s.page = {positive(JsonCursor(list, 0), 10'000), positive(JsonCursor(list, 1), 10'000)};
    });
    const auto number = [&](std::string_view name, double& value, double high) {
      reader_.if_member(at, name, [&](const JsonCursor& m) { value = in_range(m, 0, high); });
    };
    number("margin", s.margin, 10'000);
    number("gap", s.gap, 10'000);
    number("tab_height", s.tab_height, 10'000);
    if (reader_.version() < 2) s.least_tab = 0;
    number("least_tab", s.least_tab, 10'000);
    number("strip_width", s.strip_width, 10'000);
    number("flat_fold", s.flat_fold, std::numbers::pi);
    reader_.if_member(at, "inside", [&](const JsonCursor& m) { s.inside = reader_.boolean(m); });
    reader_.if_member(at, "merge_angle",
                      [&](const JsonCursor& m) { s.merge_angle = in_range(m, 0, std::numbers::pi); });
    reader_.if_member(at, "fold_angles", [&](const JsonCursor& m) { s.fold_angles = reader_.boolean(m); });
  }

  void read_vertex(const JsonCursor& row) {
    const std::size_t size = reader_.array_size(row, 2, 7);
    if (reader_.failed()) return;
    PaperVertex vertex;
    std::size_t next = 0;
    const auto whole = [&] { return reader_.integer(JsonCursor(row, next++), 0, no_index); };
    vertex.object.value = whole();
    if (size > 2) {
      vertex.element.kind =
          static_cast<Element::Kind>(reader_.choice(JsonCursor(row, next++), element_names));
      const bool edge = vertex.element.kind == Element::Kind::edge;
      if (vertex.element.kind == Element::Kind::none || size != (edge ? 7U : 6U))
        return reader_.fail(row, "[object, vertex] or [object, kind, id, side, u, v] was expected");
      vertex.element.id = whole();
      if (edge) vertex.element.id = vertex.element.id << 32 | whole();
    }
    vertex.side = whole();
    if (size > 2) {
      vertex.u = reader_.number(JsonCursor(row, next++));
      vertex.v = reader_.number(JsonCursor(row, next));
    }
    if (!paper_.vertices.empty() && !(paper_.vertices.back() < vertex))
      reader_.fail(row, "entries must be in ascending order, each once");
    paper_.vertices.push_back(vertex);
  }

  /// Reads N different vertex indices, checked.
  template <std::size_t N>
  std::array<std::uint32_t, N> corners(const JsonCursor& row) {
    std::array<std::uint32_t, N> out{};
    const auto count = static_cast<std::uint32_t>(paper_.vertices.size());
    for (std::size_t i = 0; i < N && !reader_.failed(); ++i) {
      if (count == 0) {
        reader_.fail(row, "there are no vertices");
        break;
      }
      out[i] = reader_.integer(JsonCursor(row, i), 0, count - 1);
      if (std::find(out.begin(), out.begin() + std::ptrdiff_t(i), out[i]) != out.begin() + std::ptrdiff_t(i))
        reader_.fail(row, "different vertices were expected");
    }
    return out;
  }

  void edges(const JsonCursor& at, std::string_view name, std::vector<PaperEdge>& out, bool low_first) {
    reader_.if_member(at, name, [&](const JsonCursor& list) {
      reader_.for_each(list, [&](const JsonCursor& row) {
        if (reader_.array_size(row, 2, 2) != 2) return;
        const PaperEdge edge = corners<2>(row);
        if (low_first && edge[0] > edge[1]) reader_.fail(row, "the lower number comes first");
        if (!out.empty() && !(out.back() < edge))
          reader_.fail(row, "entries must be in ascending order, each once");
        out.push_back(edge);
      });
    });
  }

  template <std::size_t N>
  void read_placed(const JsonCursor& row, std::array<std::uint32_t, N>& named, PaperPlace& place) {
    if (reader_.array_size(row, N + 4, N + 4) != N + 4) return;
    named = corners<N>(row);
    place.page = reader_.integer(JsonCursor(row, N), 0, max_pages);
    place.angle = in_range(JsonCursor(row, N + 1), -1e6, 1e6);
    place.x = in_range(JsonCursor(row, N + 2), -1e9, 1e9);
    place.y = in_range(JsonCursor(row, N + 3), -1e9, 1e9);
  }

  JsonReader& reader_;
  std::string_view text_;
  PaperModel paper_;
};

}  // namespace

PaperModel read_paper(JsonReader& reader, const JsonCursor& at, std::string_view text) {
  return PaperReader(reader, text).read(at);
}

}  // namespace hariko::detail
