#include "app/files/reading.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/base/assert.hpp"
#include "core/modeling/operations/flip.hpp"
#include "core/polyhedron/mesh_warnings.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {

namespace {

/// Faces of the closed parts that are inside out, and of their cavities, which turn with them.
std::vector<FaceId> faces_inside_out(const Polyhedron& polyhedron) {
  const std::vector<char> wrong = inside_out_components(polyhedron.topology(), polyhedron.positions());
  std::vector<FaceId> out;
  if (std::find(wrong.begin(), wrong.end(), 1) == wrong.end()) return out;
  const PolygonMesh given = polyhedron.to_mesh(), turned = orient_where_possible(given);
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    if (!std::ranges::equal(given.face(f), turned.face(f))) out.push_back(polyhedron.face_id(f));
  return out;
}

}  // namespace

JoinChoice join_choice(const Reading& reading) {
  JoinChoice out = reading.join;
  out.split_edges = reading.repair;
  return out;
}

std::size_t parts_inside_out(const Document& document) {
  std::size_t count = 0;
  for (const auto& object : document.objects) {
    const PolyhedronSource* source = object->polyhedron();
    if (!source) continue;
    const Polyhedron& polyhedron = source->polyhedron;
    const std::vector<char> wrong = inside_out_components(polyhedron.topology(), polyhedron.positions());
    count += static_cast<std::size_t>(std::count(wrong.begin(), wrong.end(), 1));
  }
  return count;
}

std::optional<Message> inside_out_message(const OpenedFile& opened) {
  const std::size_t count = opened.document && opened.meshes ? parts_inside_out(*opened.document) : 0;
  if (count == 0) return {};
  return make_warning(w_inside_out,
                      counted(count, " closed part is inside out.", " closed parts are inside out."),
                      "Turn what is inside out while opening the file (--repair).");
}

std::size_t turn_closed_parts_outwards(Document& document) {
  std::size_t turned = 0;
  for (auto& object : document.objects) {
    const PolyhedronSource* source = object->polyhedron();
    const std::vector<FaceId> faces = source ? faces_inside_out(source->polyhedron) : std::vector<FaceId>();
    if (faces.empty()) continue;
    auto flipped = flip_faces(*source, faces);
    HARIKO_ASSERT(flipped.ok(), "whole parts can be turned");
    auto changed = std::make_shared<Object>(*object);
    changed->source = std::move(flipped).value().source;
    object = std::move(changed);
    turned += faces.size();
  }
  return turned;
}

void turn_outwards(OpenedFile& opened) {
  if (!opened.document || !opened.meshes) return;
  const std::size_t turned = turn_closed_parts_outwards(*opened.document);
  if (turned > 0) opened.messages.push_back(turned_outwards_message(turned));
}

Message turned_outwards_message(std::size_t faces) {
  return make_warning(
      w_turned_outwards,
      std::to_string(faces) + (faces == 1 ? " face of closed parts that were inside out was turned."
                                          : " faces of closed parts that were inside out were turned."));
}

void add_counts(RepairReport& sum, const RepairReport& report) {
  sum.merged_vertices += report.merged_vertices;
  sum.dropped_faces += report.dropped_faces;
  sum.turned_faces += report.turned_faces;
  sum.cut_faces += report.cut_faces;
  sum.split_vertices += report.split_vertices;
  sum.removed_vertices += report.removed_vertices;
}

std::string repair_text(const RepairReport& report) {
  std::string out;
  const auto part = [&](std::string text, std::size_t count) {
    if (count == 0) return;
    text.replace(text.find("{0}"), 3, std::to_string(count));
    out += (out.empty() ? "" : ", ") + text;
  };
  part("vertices merged: {0}", report.merged_vertices);
  part("faces turned: {0}", report.turned_faces);
  part("faces dropped: {0}", report.dropped_faces);
  part("faces cut into several: {0}", report.cut_faces);
  part("vertices added where it was cut apart: {0}", report.split_vertices);
  part("unused vertices removed: {0}", report.removed_vertices);
  return out;
}

Message repaired_message(const RepairReport& report) {
  const std::string changes = repair_text(report);
  if (changes.empty()) return make_warning(w_repaired, "The mesh made no polyhedron and was repaired.");
  return make_warning(w_repaired, "The mesh made no polyhedron and was repaired: " + changes + ".");
}

}  // namespace hariko
