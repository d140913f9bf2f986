#include "app/commands/export_report.hpp"

#include <numbers>

#include "core/exchange/number_text.hpp"

namespace hariko {

std::string text_of(const CadExportReport& report, Unit unit) {
  const auto number = [](double value) { return rounded_text(value, 3); };
  const std::string length = " " + std::string(to_string(unit));
  std::string out;
  for (const CadObjectReport& object : report.objects) {
    out += object.name + ": " + std::to_string(object.faces) + " faces, " + std::to_string(object.exact) +
           " of them exact, " + std::to_string(object.control_points) + " control points, " +
           std::to_string(object.edges) + " edges, " + (object.closed ? "closed" : "open");
    if (!object.not_exact.empty())
      out += "\n  not exact: " + std::to_string(object.faces - object.exact) + " faces of " +
             std::string(object.not_exact);
    out += "\n  distance: largest " + number(object.distance) + length + ", tolerance " +
           number(object.tolerance) + length;
    if (object.unreached > 0) out += ", not kept by " + std::to_string(object.unreached) + " faces";
    out += "\n  normal jump across smooth edges: " + number(object.normal_jump * 180 / std::numbers::pi) +
           " degrees, asked for " + number(object.angle * 180 / std::numbers::pi) + " degrees\n";
    if (object.curvature)
      out += "  curvature jump across smooth edges: " + number(100 * object.curvature_jump) +
             " % of the curvature there\n";
  }
  out += "file: " + std::to_string(report.file.solids) + " solids, " +
         (report.file.voids > 0 ? std::to_string(report.file.voids) + " voids, " : std::string()) +
         std::to_string(report.file.open_shells) + " open shells, " +
         (report.file.valid ? "valid" : "NOT VALID") + " by OpenCASCADE, largest edge tolerance " +
         number(report.file.edge_tolerance) + " mm, " + std::to_string(report.bytes) + " bytes\n";
  return out;
}

std::string moved_text(const Vector3& moved) {
  if (moved.isZero(0)) return {};
  std::string out = "moved to zero by";
  for (int axis = 0; axis < 3; ++axis) {
    out += ' ';
    append_real(out, 0 - moved[axis]);
  }
  return out + '\n';
}

}  // namespace hariko
