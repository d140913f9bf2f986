#include "core/exchange/read_patches.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/files/file_ending.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {

namespace {

class BezierTextReader {
 public:
  explicit BezierTextReader(std::string_view text)
      : scanner_(text, {.comments = true, .continuation = false}) {}

  Result<std::vector<BezierPatch>> read(bool indexed) {
    if (!scanner_.find_content())
      return TextScanner::error_at_line(e_empty, scanner_.line(), "The file is empty.",
                                        "Export the file again.");
    std::int64_t count = 0;
    if (auto failed = scanner_.read_integer("the number of patches", count)) return *failed;
    if (count < 1 || count > std::int64_t(max_patches_of_file))
      return scanner_.error_here(e_limit, "From 1 to 100000 patches are accepted.", "Split the file.");
    if (auto failed = indexed ? read_indexed(count) : read_plain(count)) return *failed;
    for (std::size_t k = 0; k < patches_.size(); ++k)
      if (auto failed = check_patch(patches_[k], k)) return *failed;
    return std::move(patches_);
  }

 private:
  std::optional<Message> read_plain(std::int64_t count) {
    for (std::int64_t k = 0; k < count; ++k) {
      BezierPatch patch;
      for (int* degree : {&patch.degree_t, &patch.degree_s}) {
        std::int64_t value = 0;
        if (auto failed = integer("a degree", value)) return failed;
        if (value < 1 || value > max_bezier_degree)
          return scanner_.error_here(
              e_patch_degree, "A patch has degree " + std::to_string(value) + ".",
              "Degrees from 1 to " + std::to_string(max_bezier_degree) + " are accepted.");
        *degree = int(value);
      }
      const int points = (patch.degree_s + 1) * (patch.degree_t + 1);
      for (int i = 0; i < points; ++i)
        if (auto failed = point(patch.points)) return failed;
      patches_.push_back(std::move(patch));
    }
    return std::nullopt;
  }
  std::optional<Message> read_indexed(std::int64_t count) {
    std::vector<std::array<std::int64_t, 16>> indices;
    std::vector<std::size_t> lines;
    for (std::int64_t k = 0; k < count; ++k) {
      indices.emplace_back();
      for (std::int64_t& index : indices.back())
        if (auto failed = integer("the number of a point", index)) return failed;
      lines.push_back(scanner_.line());
    }
    std::int64_t total = 0;
    if (auto failed = integer("the number of points", total)) return failed;
    if (total < 1 || total > 16 * std::int64_t(max_patches_of_file))
      return scanner_.error_here(e_limit, "From 1 to 1600000 points are accepted.", "Split the file.");
    std::vector<Vector3> points;
    for (std::int64_t k = 0; k < total; ++k)
      if (auto failed = point(points)) return failed;
    for (std::size_t k = 0; k < indices.size(); ++k) {
      BezierPatch patch;
      for (const std::int64_t index : indices[k]) {
        if (index < 1 || index > total)
          return TextScanner::error_at_line(e_index_range, lines[k],
                                            "There is no point " + std::to_string(index) + ".",
                                            "Points are numbered from 1 to " + std::to_string(total) + ".");
        patch.points.push_back(points[std::size_t(index - 1)]);
      }
      patches_.push_back(std::move(patch));
    }
    return std::nullopt;
  }
  std::optional<Message> integer(const char* what, std::int64_t& value) {
    if (!scanner_.find_content()) return scanner_.file_ends(what);
    return scanner_.read_integer(what, value);
  }
  std::optional<Message> point(std::vector<Vector3>& points) {
    if (!scanner_.find_content()) return scanner_.file_ends("a control point");
    Vector3 p;
    if (auto failed = scanner_.read_point("a control point", p)) return failed;
    points.push_back(p);
    return std::nullopt;
  }

  TextScanner scanner_;
  std::vector<BezierPatch> patches_;
};

using Json = nlohmann::json;

Message malformed(const std::string& sentence) {
  return make_error(e_parse, sentence, "Each patch needs \"ctrl\": rows of points of three numbers.");
}

bool read_row(const Json& row, std::vector<Vector3>& out) {
  if (!row.is_array()) return false;
  for (const Json& point : row) {
    if (!point.is_array() || point.size() != 3) return false;
    for (const Json& x : point)
      if (!x.is_number()) return false;
    out.emplace_back(point[0].get<double>(), point[1].get<double>(), point[2].get<double>());
  }
  return true;
}

/// Transposed rows: they run along s in the file, along t in a patch.
template <class Value>
std::vector<Value> transposed(const std::vector<std::vector<Value>>& rows) {
  std::vector<Value> out;
  for (std::size_t j = 0; j < rows[0].size(); ++j)
    for (const auto& row : rows) out.push_back(row[j]);
  return out;
}

std::optional<Message> read_json_patch(const Json& json, const std::string& name, BezierPatch& patch) {
  if (!json.is_object() || !json.contains("ctrl") || !json["ctrl"].is_array() || json["ctrl"].empty())
    return malformed(name + " has no control points.");
  std::vector<std::vector<Vector3>> rows;
  for (const Json& row : json["ctrl"]) {
    rows.emplace_back();
    if (!read_row(row, rows.back()) || rows.back().size() != rows[0].size() || rows[0].empty())
      return malformed(name + " has a row of points that is malformed or shorter than the others.");
  }
  const std::size_t most = std::size_t(max_bezier_degree) + 1;
  if (rows.size() > most || rows[0].size() > most)
    return make_error(e_patch_degree, name + " has more than " + std::to_string(most) + " points a row.",
                      "Degrees from 1 to " + std::to_string(max_bezier_degree) + " are accepted.");
  patch.degree_s = int(rows.size()) - 1;
  patch.degree_t = int(rows[0].size()) - 1;
  patch.points = transposed(rows);
  if (!json.contains("weights") || json["weights"].is_null()) return std::nullopt;
  std::vector<std::vector<double>> weights;
  for (const Json& row : json["weights"]) {
    weights.emplace_back();
    if (row.is_array())
      for (const Json& w : row) weights.back().push_back(w.is_number() ? w.get<double>() : 0.0);
    if (weights.back().size() != rows[0].size()) return malformed(name + " has other weights than points.");
  }
  if (weights.size() != rows.size()) return malformed(name + " has other weights than points.");
  patch.weights = transposed(weights);
  return std::nullopt;
}

}  // namespace

Result<std::vector<BezierPatch>> read_bezier_text(std::string_view text) {
  if (text.find(',') == std::string_view::npos) return BezierTextReader(text).read(false);
  // Commas become blanks, which keeps the columns of messages.
  std::string blank(text);
  std::replace(blank.begin(), blank.end(), ',', ' ');
  return BezierTextReader(blank).read(true);
}

Result<std::vector<NamedPatches>> read_bezier_json(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object()) return malformed("The file is no JSON object.");
  std::vector<NamedPatches> out;
  std::size_t count = 0;
  for (const auto& [key, list] : json.items()) {
    if (!list.is_array()) continue;
    NamedPatches named;
    named.name = sanitized_utf8(key, 200);
    count += list.size();
    if (count > max_patches_of_file)
      return make_error(e_limit, "Up to 100000 patches are accepted.", "Split the file.");
    for (const Json& patch : list) {
      const std::size_t number = named.patches.size();
      named.patches.emplace_back();
      const std::string name = "Patch " + std::to_string(number + 1) + " of \"" + named.name + "\"";
      if (auto failed = read_json_patch(patch, name, named.patches.back())) return *failed;
      if (auto failed = check_patch(named.patches.back(), number)) return *failed;
    }
    if (!named.patches.empty()) out.push_back(std::move(named));
  }
  if (out.empty()) return make_error(e_empty, "The file has no patches.", "Export the file again.");
  return out;
}

Result<std::vector<NamedPatches>> read_patch_file(const std::filesystem::path& path) {
  const auto text = read_file(path);
  if (!text.ok()) return text.error();
  if (lower_ending(path) == ".json") return read_bezier_json(*text);
  auto patches = read_bezier_text(*text);
  if (!patches.ok()) return patches.error();
  return std::vector<NamedPatches>{{"", std::move(patches).value()}};
}

}  // namespace hariko
