#include "app/pictures/sample_pictures.hpp"

#include <algorithm>
#include <bit>
#include <system_error>

#include "app/pictures/file_pictures.hpp"
#include "app/pictures/samples.hpp"
#include "core/base/files/file_io.hpp"
#include "render/picture.hpp"
#include "ui/view/view_pictures.hpp"

namespace hariko {

namespace fs = std::filesystem;

namespace {

/// Size of a sample's picture: one and a half times a card of the start page.
constexpr PixelSize picture_size{360, 240};

fs::path picture_file(const fs::path& folder, const fs::path& sample, ThemeId theme) {
  const char* const ending = theme == ThemeId::light ? "-light.png" : "-dark.png";
  return folder / (sample.stem().string() + ending);
}

Result<Done> draw_sample(PictureDrawer& drawer, const Sample& sample, const fs::path& out) {
  Scene scene = file_scene(sample.path, {});
  if (scene.objects.empty())
    return make_error(e_sample_picture, sample.path.string() + " shows nothing.", "Mend the sample.");
  for (const ThemeId theme : {ThemeId::dark, ThemeId::light}) {
    scene.background = background_of(theme);
    const Result<Image> image = drawer.draw(scene, file_camera(scene, picture_size), picture_size);
    if (!image) return image.error();
    if (const auto written = write_png(picture_file(out, sample.path, theme), *image); !written)
      return written;
  }
  return Done{};
}

/// Uploads into a texture with sides that are powers of two, like the font atlas: a software renderer
/// compiles a program for any other size, which takes a tenth of the start.
Picture upload_padded(const Image& image) {
  const auto power = [](int side) { return static_cast<int>(std::bit_ceil(static_cast<unsigned>(side))); };
  Image padded(power(image.width), power(image.height));
  const std::size_t row = 4 * static_cast<std::size_t>(image.width);
  // The last column and row are repeated, as filtering uses adjacent pixels.
  for (int y = 0; y < padded.height; ++y) {
    const std::uint8_t* from = image.pixel(0, std::min(y, image.height - 1));
    std::uint8_t* to = std::copy_n(from, row, padded.pixel(0, y));
    if (padded.width > image.width) std::copy_n(from + row - 4, 4, to);
  }
  const auto share = [](int used, int all) { return static_cast<float>(used) / static_cast<float>(all); };
  return {upload_picture(padded),
          {share(image.width, padded.width), share(image.height, padded.height)},
          share(image.width, image.height)};
}

}  // namespace

fs::path sample_pictures_folder(const fs::path& assets) {
  return assets / "pictures";
}

Result<std::size_t> make_sample_pictures(const fs::path& assets, const fs::path& out) {
  auto created = PictureDrawer::create();
  if (!created) return created.error();
  PictureDrawer drawer = std::move(created).value();
  std::error_code error;
  fs::create_directories(out, error);
  const std::vector<Sample> samples = find_samples(assets);
  for (const Sample& sample : samples)
    if (const auto drawn = draw_sample(drawer, sample, out); !drawn) return drawn.error();
  if (const auto written = write_file_atomic(out / "complete", ""); !written) return written.error();
  return samples.size();
}

void SamplePictures::give(Sample& sample, ThemeId theme) {
  sample.wanted = true;
  if (const auto image = read_png(picture_file(folder_, sample.path, theme)); image.ok()) {
    sample.picture = upload_padded(*image);
    own_.push_back(sample.picture.texture);
    return;
  }
  drawn_.request(sample.path, [this, path = sample.path](unsigned picture) {
    for (Sample& shown : samples_)
      if (shown.path == path) shown.picture = {picture, {1, 1}, static_cast<float>(Pictures::size.aspect())};
  });
}

void SamplePictures::forget() {
  for (Sample& sample : samples_) sample.wanted = false, sample.picture = {};
  for (const unsigned texture : own_) release_picture(texture);
  own_.clear();
}

}  // namespace hariko
