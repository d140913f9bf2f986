#include "app/files/file_digits.hpp"

#include "core/document/object_box.hpp"
#include "core/document/object_shape.hpp"

namespace hariko {

namespace {

/// Enlarged box, as surfaces may extend beyond their sources.
Eigen::AlignedBox3d enlarged(const Eigen::AlignedBox3d& box) {
  const Vector3 more = Vector3::Constant(box.diagonal().norm());
  return {box.min() - more, box.max() + more};
}

}  // namespace

FileDigits file_digits(const Document& document, const std::filesystem::path& path,
                       const WriteOptions& options) {
  const FileNumbers numbers = file_numbers(path, options);
  if (numbers.kind == FileNumbers::Kind::exact) return {};
  Eigen::AlignedBox3d whole;
  for (const auto& object : document.objects)
    if (object->visible && has_shape(*object)) whole.extend(world_box(*object));
  const Vector3 zero =
      options.to_zero && !whole.isEmpty() ? Vector3(whole.center()) : Vector3(Vector3::Zero());
  return [numbers, zero](const Eigen::AlignedBox3d& box) {
    return box.isEmpty() ? 0 : largest_rounding(enlarged(box).translated(-zero), numbers);
  };
}

}  // namespace hariko
