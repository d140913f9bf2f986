#include "core/exchange/obj/obj_parts.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/base/text/decoded_text.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/exchange/obj/read_obj.hpp"
#include "core/exchange/repair/point_welder.hpp"

namespace hariko {

namespace {

constexpr std::size_t name_length = 200;

/// Joins groups that share a position; each set is represented by its least number.
void join_touching(const PolygonMesh& mesh, std::vector<std::size_t>& part_of_face, std::size_t count) {
  DisjointSets sets(count);
  PointWelder places(mesh.positions.size());
  std::vector<Index> owner;  // first group at each position
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    for (const Index v : mesh.face(f)) {
      const Index place = places.add(mesh.positions[v]);
      if (place == owner.size())
        owner.push_back(static_cast<Index>(part_of_face[f]));
      else
        sets.join(owner[place], static_cast<Index>(part_of_face[f]));
    }
  for (std::size_t& part : part_of_face) part = sets.find(static_cast<Index>(part));
}

/// Extracts the faces of one part with the vertices that they use, both in their order.
class PartMaker {
 public:
  explicit PartMaker(const PolygonMesh& mesh) : mesh_(mesh), number_(mesh.positions.size(), no_index) {}

  ImportedPart make(const std::vector<std::size_t>& faces) {
    ImportedPart out;
    std::vector<Index> used;
    for (const std::size_t f : faces) used.insert(used.end(), mesh_.face(f).begin(), mesh_.face(f).end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const Index v : used) {
      number_[v] = static_cast<Index>(out.mesh.positions.size());
      out.mesh.positions.push_back(mesh_.positions[v]);
    }
    std::vector<Index> corners;
    for (const std::size_t f : faces) {
      corners.clear();
      for (const Index v : mesh_.face(f)) corners.push_back(number_[v]);
      out.mesh.add_face(corners);
    }
    used_ = std::move(used);
    return out;
  }
  /// Adds the creases and corners (both ascending, low vertex first) that lie on these faces.
  void mark(const std::vector<std::size_t>& faces, const std::vector<std::array<Index, 2>>& creases,
            const std::vector<Index>& corners, ImportedPart& part) const {
    for (const std::size_t f : faces) {
      const auto face = mesh_.face(f);
      for (std::size_t k = 0; !creases.empty() && k < face.size(); ++k) {
        const auto [low, high] = std::minmax(face[k], face[(k + 1) % face.size()]);
        if (std::binary_search(creases.begin(), creases.end(), std::array<Index, 2>{low, high}))
          part.creases.push_back({number_[low], number_[high]});
      }
    }
    std::sort(part.creases.begin(), part.creases.end());
    part.creases.erase(std::unique(part.creases.begin(), part.creases.end()), part.creases.end());
    for (const Index v : used_)
      if (std::binary_search(corners.begin(), corners.end(), v)) part.corners.push_back(number_[v]);
  }

 private:
  const PolygonMesh& mesh_;
  std::vector<Index> number_, used_;
};

}  // namespace

/// Printable name; bytes that are not UTF-8 are letters of an old encoding.
std::string ObjParts::shown_name(std::string_view name) {
  const DecodedText text = decoded(std::string(name.substr(0, 4 * name_length)), StrayBytes::letters);
  old_letters_ += text.guessed;
  japanese_ = japanese_ || text.japanese;
  return sanitized_utf8(text.text, name_length);
}

void ObjParts::warn(std::vector<Message>& warnings) const {
  if (old_letters_ > 0)
    warnings.push_back(
        make_warning(w_name_letters,
                     std::to_string(old_letters_) +
                         " letters of the OBJ file are in an old encoding that it does not name" +
                         (japanese_ ? " (taken for Shift-JIS)" : "") + ": names may have wrong letters.",
                     "Check the names, or export the model in UTF-8."));
}

void ObjParts::begin_object(std::string_view name, std::size_t face) {
  objects_.push_back({face, shown_name(name)});
  if (object_name_.empty()) object_name_ = objects_.back().name;
}

void ObjParts::begin_group(std::string_view name, std::size_t face) {
  groups_.push_back({face, shown_name(name)});
  if (group_name_.empty()) group_name_ = groups_.back().name;
}

/// Number of the part of each face, in the order of their first faces; and the names of the parts.
std::vector<std::size_t> ObjParts::part_of_faces(const PolygonMesh& mesh,
                                                 std::vector<std::string>& names) const {
  const bool by_group = objects_.empty();
  const std::vector<Run>& runs = by_group ? groups_ : objects_;
  std::vector<std::size_t> out(mesh.face_count());
  names.assign(1, std::string());                    // faces before the first statement
  std::map<std::string, std::size_t> group_numbers;  // a group may be continued later
  std::size_t run = 0, part = 0;
  for (std::size_t f = 0; f < out.size(); ++f) {
    for (; run < runs.size() && runs[run].face <= f; ++run) {
      const auto known = by_group ? group_numbers.find(runs[run].name) : group_numbers.end();
      part = known == group_numbers.end() ? names.size() : known->second;
      if (known != group_numbers.end()) continue;
      names.push_back(runs[run].name);
      if (by_group) group_numbers.emplace(runs[run].name, part);
    }
    out[f] = part;
  }
  if (by_group && names.size() > 1) join_touching(mesh, out, names.size());
  return out;
}

std::vector<ImportedPart> ObjParts::split(PolygonMesh mesh, std::vector<std::array<Index, 2>> creases,
                                          std::vector<Index> corners, bool only_used,
                                          std::size_t& joined) const {
  joined = 0;
  for (auto& [a, b] : creases)
    if (a > b) std::swap(a, b);
  std::sort(creases.begin(), creases.end());
  std::sort(corners.begin(), corners.end());
  std::vector<std::string> names;
  const std::vector<std::size_t> part_of_face = part_of_faces(mesh, names);
  std::map<std::size_t, std::vector<std::size_t>> faces;
  for (std::size_t f = 0; f < part_of_face.size(); ++f) faces[part_of_face[f]].push_back(f);
  std::vector<ImportedPart> out;
  if (faces.size() > ImportedScene::max_parts) joined = faces.size();
  // Objects before the only one with faces may be cameras, lights or points.
  if (faces.size() == 1 && names[faces.begin()->first].empty()) names[faces.begin()->first] = first_name();
  if ((faces.size() == 1 && !only_used) || joined > 0) {
    out.push_back({std::move(mesh), joined > 0 ? first_name() : names[faces.begin()->first],
                   std::move(creases), std::move(corners)});
    return out;
  }
  PartMaker maker(mesh);
  for (const auto& [part, of_part] : faces) {
    out.push_back(maker.make(of_part));
    out.back().name = names[part];
    maker.mark(of_part, creases, corners, out.back());
  }
  return out;
}

}  // namespace hariko
