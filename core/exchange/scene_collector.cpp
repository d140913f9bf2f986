#include "core/exchange/scene_collector.hpp"
#include "core/base/solvers/small_solver.hpp"
#include "core/exchange/repair/remedies.hpp"

#include <algorithm>

#include "core/base/text/sanitized_utf8.hpp"

namespace hariko {
void turn_over(PolygonMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    std::reverse(mesh.face_vertices.begin() + mesh.face_offsets[f],
                 mesh.face_vertices.begin() + mesh.face_offsets[f + 1]);
}

namespace {

constexpr std::uint64_t always_accepted = 20'000'000;

void place(PolygonMesh& mesh, const AffineMap& placement) {
  if (placement.is_same()) return;
  for (Vector3& position : mesh.positions) position = placement(position);
  if (placement.mirrors()) turn_over(mesh);
}

/// Appends the vertices and faces of a mesh to another one.
void append_mesh(const PolygonMesh& part, PolygonMesh& whole) {
  const auto before = static_cast<Index>(whole.positions.size());
  const auto corners_before = static_cast<Index>(whole.face_vertices.size());
  whole.positions.insert(whole.positions.end(), part.positions.begin(), part.positions.end());
  for (const Index v : part.face_vertices) whole.face_vertices.push_back(before + v);
  for (std::size_t f = 1; f < part.face_offsets.size(); ++f)
    whole.face_offsets.push_back(corners_before + part.face_offsets[f]);
}

}  // namespace

Message objects_joined_message(std::size_t count) {
  return make_warning(
      w_objects_joined,
      std::to_string(count) + " objects of the file became one, as they are too many to be told apart.",
      "Export parts of the model as files of their own.");
}

Message not_finite_message(std::size_t count) {
  return make_warning(w_left_out,
                      counted(count, " face with a coordinate that is not finite was left out.",
                              " faces with coordinates that are not finite were left out."),
                      "Compare the object with that in the program that wrote the file.");
}

bool AffineMap::flattens() const {
  if (!(largest() > 0)) return true;
  const Vector3 stretches = singular_axes(linear / largest()).values;
  return !(stretches[2] > 1e-12 * stretches[0]);
}

std::optional<Message> SceneCollector::reserve(std::uint64_t vertices, std::uint64_t corners) {
  if (limits_.cancel.cancelled()) return make_error(e_cancelled, "The import was cancelled.");
  vertices_ += std::min<std::uint64_t>(vertices, limits_.vertices + 1);
  corners_ += std::min<std::uint64_t>(corners, limits_.corners + 1);
  if (vertices_ > limits_.vertices || corners_ > limits_.corners)
    return make_error(e_limit,
                      "The file has more than " + std::to_string(limits_.vertices) + " vertices or " +
                          std::to_string(limits_.corners) + " corners.",
                      remedy_reduce);
  if (vertices_ + corners_ > always_accepted + 4 * bytes_)
    return make_error(e_limit, "The file places its objects so often that the whole becomes too large.",
                      "Place fewer copies before importing it.");
  return {};
}

std::optional<Message> SceneCollector::add(PolygonMesh mesh, const AffineMap& placement,
                                           std::string_view name) {
  if (mesh.face_count() == 0) return {};
  if (placement.is_finite() && placement.flattens()) {
    ++flat_;
    return {};
  }
  place(mesh, placement);
  if (std::any_of(mesh.positions.begin(), mesh.positions.end(),
                  [](const Vector3& position) { return !position.allFinite(); }))
    return make_error(e_parse,
                      name.empty() ? std::string("The transform of an object is too large.")
                                   : "The transform of \"" + shortened(name, 200) + "\" is too large.",
                      "Correct the file, or export it again.");
  if (scene_.parts.size() == ImportedScene::max_parts) join_all();
  if (joined_ == 0) {
    scene_.parts.push_back({std::move(mesh), sanitized_utf8(name, 200)});
  } else {
    append_mesh(mesh, scene_.parts.front().mesh);
    ++joined_;
  }
  return {};
}

void SceneCollector::join_all() {
  joined_ = scene_.parts.size();
  for (std::size_t k = 1; k < joined_; ++k) append_mesh(scene_.parts[k].mesh, scene_.parts.front().mesh);
  scene_.parts.erase(scene_.parts.begin() + 1, scene_.parts.end());
  scene_.parts.front().name.clear();
}

Result<ImportedScene> SceneCollector::finish() {
  if (scene_.parts.empty())
    return make_error(e_empty,
                      flat_ > 0         ? "The transforms of all objects of the file make them flat."
                      : degenerate_ > 0 ? "All triangles of the file have two corners at the same place."
                                        : "The file places no triangles.",
                      "Export surfaces, not points or lines.");
  if (joined_ > 0) scene_.warnings.push_back(objects_joined_message(joined_));
  if (degenerate_ > 0)
    scene_.warnings.push_back(
        make_warning(w_degenerate_triangles,
                     counted(degenerate_, " triangle with two corners at the same place was left out.",
                             " triangles with two corners at the same place were left out.")));
  if (flat_ > 0)
    scene_.warnings.push_back(
        make_warning(w_flat_part, counted(flat_, " object that its transform makes flat was left out.",
                                          " objects that their transforms make flat were left out.")));
  return std::move(scene_);
}

ImportedMesh merged(ImportedScene scene) {
  ImportedMesh out;
  out.warnings = std::move(scene.warnings);
  out.name = scene.parts.front().name;
  out.mesh = std::move(scene.parts.front().mesh);
  for (std::size_t k = 1; k < scene.parts.size(); ++k) append_mesh(scene.parts[k].mesh, out.mesh);
  return out;
}

}  // namespace hariko
