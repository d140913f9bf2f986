#include "app/files/reading.hpp"

namespace hariko {

void add_counts(RepairReport& sum, const RepairReport& report) {
  sum.merged_vertices += report.merged_vertices;
  sum.dropped_faces += report.dropped_faces;
  sum.turned_faces += report.turned_faces;
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
  part("vertices added where it was cut apart: {0}", report.split_vertices);
  part("unused vertices removed: {0}", report.removed_vertices);
  return out;
}

Message repaired_message(const RepairReport& report) {
  return make_warning(w_repaired,
                      "The mesh made no polyhedron and was repaired: " + repair_text(report) + ".");
}

}  // namespace hariko
