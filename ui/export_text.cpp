#include "ui/export_text.hpp"

#include "ui/panels/quantity.hpp"

namespace hariko {

std::string file_size_text(std::uintmax_t bytes) {
  if (bytes < 10'000) return std::to_string(bytes) + " B";
  if (bytes < 10'000'000) return std::to_string(bytes / 1000) + " kB";
  return std::to_string(bytes / 1'000'000) + " MB";
}

std::string export_text(const Language& tr, const std::filesystem::path& path, const ExportReport& report,
                        Unit document_unit, const FileChoices& choices) {
  const Unit unit = choices.unit.value_or(document_unit);
  const Vector3 size = report.size * (millimetres_per(document_unit) / millimetres_per(unit));
  const Quantity length = length_quantity(unit, size.maxCoeff());
  std::string sizes;
  for (int axis = 0; axis < 3; ++axis)
    sizes += (axis > 0 ? " \u00d7 " : "") + format_quantity(length, size[axis]);
  return fill(
      tr("Exported {0}: {1} triangles, {2}, {3}."),
      {path.filename().string(), std::to_string(report.triangles), sizes, file_size_text(report.bytes)});
}

}  // namespace hariko
