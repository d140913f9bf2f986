#include "ui/files/export_text.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "ui/base/quantity.hpp"

namespace hariko {

namespace {

std::string angle_text(double radians) {
  Quantity angle = angle_quantity();
  angle.decimals = 3;
  return format_quantity(angle, radians * 180 / std::numbers::pi);
}

std::string length_text(Unit unit, double length) {
  return format_quantity(length_quantity(unit, length), length);
}

}  // namespace

std::string file_size_text(std::uintmax_t bytes) {
  if (bytes < 1000) return std::to_string(bytes) + " B";
  constexpr std::array units{" kB", " MB", " GB"};
  std::size_t unit = 0;
  auto size = static_cast<double>(bytes) / 1000;
  for (; unit + 1 < units.size() && size >= 999.5; ++unit) size /= 1000;
  // Two digits at least: files of like sizes are told apart.
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), size < 9.95 ? "%.1f" : "%.0f", size);
  return text.data() + std::string(units[unit]);
}

std::string export_text(const Language& tr, const std::filesystem::path& path, const ExportReport& report,
                        Unit document_unit, const FileChoices& choices) {
  const Unit unit = choices.unit.value_or(document_unit);
  const Vector3 size = report.size * (millimetres_per(document_unit) / millimetres_per(unit));
  const Quantity length = length_quantity(unit, size.maxCoeff());
  std::string sizes;
  for (int axis = 0; axis < 3; ++axis)
    sizes += (axis > 0 ? " \u00d7 " : "") + format_quantity(length, size[axis]);
  std::string text =
      fill(tr("Exported {0}: {1} triangles, {2}, {3}."),
           {path.filename().string(), std::to_string(report.triangles), sizes, file_size_text(report.bytes)});
  if (report.moved.isZero(0)) return text;
  const Quantity place = length_quantity(unit, report.moved.cwiseAbs().maxCoeff());
  return text + " " +
         fill(tr("Its zero is the point {0}, {1}, {2} of the model."),
              {format_quantity(place, report.moved.x()), format_quantity(place, report.moved.y()),
               format_quantity(place, report.moved.z())});
}

std::string cad_count_text(const Language& tr, const CadTotals& count, Unit document_unit) {
  const std::string faces = std::to_string(count.faces), gap = "   \u00b7   ";
  const std::string points = gap + fill(tr("control points: {0}"), {std::to_string(count.control_points)});
  std::string text = count.all_exact()
                         ? fill(tr("faces: {0}, all of them exact"), {faces})
                         : fill(tr("faces: {0}, {1} of them exact"), {faces, std::to_string(count.exact)});
  text += points;
  if (count.unreached > 0) text += gap + std::string(tr("the tolerance is not reached everywhere"));
  if (count.left_out > 0)
    text += gap + fill(tr("objects of reference facets left out: {0}"), {std::to_string(count.left_out)});
  text += "\n";
  if (!count.all_exact())
    text +=
        fill(tr("off by {0} at the most, by samples"), {length_text(document_unit, count.distance)}) + gap;
  text += fill(tr("normals jump by {0} at the most"), {angle_text(count.normal_jump)});
  if (count.curvature)
    text +=
        gap + fill(tr("curvature by {0}"), {std::to_string(std::lround(100 * count.curvature_jump)) + " %"});
  return text;
}

std::string cad_export_text(const Language& tr, const std::filesystem::path& path, const CadTotals& written,
                            std::uintmax_t bytes, Unit document_unit) {
  const std::string name = path.filename().string(), faces = std::to_string(written.faces),
                    angle = angle_text(written.normal_jump), size = file_size_text(bytes);
  if (written.all_exact())
    return fill(tr("Exported {0}: {1} faces, all of them exact; turned by {2} at the most; {3}."),
                {name, faces, angle, size});
  return fill(
      tr("Exported {0}: {1} faces, {2} of them exact; off by {3} and turned by {4} at the most; {5}."),
      {name, faces, std::to_string(written.exact), length_text(document_unit, written.distance), angle,
       size});
}

}  // namespace hariko
