#include "core/document/picture_source.hpp"

#include <cmath>

#include "core/base/text/utf8.hpp"

namespace hariko {

namespace {

/// Whether both JSON and the file system can represent the path.
bool storable_path(const std::string& path) {
  if (path.empty() || path.size() > PictureSource::longest_path || path.find('\0') != std::string::npos)
    return false;
  for (std::string_view rest = path; !rest.empty();) {
    const std::size_t length = utf8_length(rest);
    if (length == 0) return false;
    rest.remove_prefix(length);
  }
  return true;
}

}  // namespace

Eigen::Quaterniond facing(PictureSide side) {
  Matrix3 axes;  // right, up, towards the eye
  switch (side) {
    case PictureSide::front:
      axes << 1, 0, 0, 0, 0, -1, 0, 1, 0;
      break;
    case PictureSide::back:
      axes << -1, 0, 0, 0, 0, 1, 0, 1, 0;
      break;
    case PictureSide::left:
      axes << 0, 0, -1, -1, 0, 0, 0, 1, 0;
      break;
    case PictureSide::right:
      axes << 0, 0, 1, 1, 0, 0, 0, 1, 0;
      break;
    case PictureSide::top:
      axes << 1, 0, 0, 0, 1, 0, 0, 0, 1;
      break;
    case PictureSide::bottom:
      axes << 1, 0, 0, 0, -1, 0, 0, 0, -1;
      break;
  }
  return Eigen::Quaterniond(axes).normalized();
}

std::optional<PictureSide> faced_side(const Eigen::Quaterniond& rotation) {
  const Vector3 normal = rotation * Vector3::UnitZ();
  for (const PictureSide side : {PictureSide::front, PictureSide::back, PictureSide::left, PictureSide::right,
                                 PictureSide::top, PictureSide::bottom})
    if ((facing(side) * Vector3::UnitZ() - normal).norm() < 1e-6) return side;
  return std::nullopt;
}

Result<Done> check_picture(const PictureSource& picture) {
  const auto wrong = [](const char* what, const char* remedy) {
    return make_error(e_picture_invalid, what, remedy);
  };
  if (!storable_path(picture.path))
    return wrong("The name of the picture's file cannot be stored.", "Rename the file or its folders.");
  if (picture.columns < 1 || picture.rows < 1 || picture.columns > PictureSource::most_pixels ||
      picture.rows > PictureSource::most_pixels)
    return wrong("The picture has no pixels, or too many.", "Use another picture.");
  if (!(picture.width > 0) || !std::isfinite(picture.width) || !std::isfinite(picture.height()))
    return wrong("The picture cannot have this size.", "Give it a width above zero.");
  if (!(picture.look.opacity >= 0 && picture.look.opacity <= 1))
    return wrong("The opacity of a picture is from 0 to 1.", "Use a number from 0 to 1.");
  if (picture.bytes->size() > max_packed_pictures)
    return make_error(e_pictures_too_large, "The picture is too large to be packed into the document.",
                      "Keep it linked.");
  return Done{};
}

}  // namespace hariko
