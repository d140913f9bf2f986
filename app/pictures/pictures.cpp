#include "app/pictures/pictures.hpp"

#include <algorithm>
#include <optional>
#include <system_error>
#include <vector>

#include "app/pictures/file_pictures.hpp"
#include "core/base/files/file_stamp.hpp"
#include "core/base/files/file_uri.hpp"

namespace hariko {

namespace fs = std::filesystem;

namespace {

/// Cache key of a file, which changes with its content. FNV-1a.
std::string key_of(const fs::path& file) {
  std::string text = file_uri(file);
  if (const auto stamp = stamp_of(file))
    text += "|" + std::to_string(stamp->size) + "|" + std::to_string(stamp->modified);
  std::uint64_t sum = 0xcbf29ce484222325U;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  std::string name;
  constexpr std::string_view digits = "0123456789abcdef";
  for (int shift = 60; shift >= 0; shift -= 4) name += digits[(sum >> static_cast<unsigned>(shift)) & 15U];
  return name;
}

/// Removes the oldest pictures: those of changed or deleted files are never requested again.
void prune(const fs::path& cache) {
  constexpr std::size_t most = 200;
  std::vector<std::pair<fs::file_time_type, fs::path>> found;
  std::error_code error;
  for (fs::directory_iterator it(cache, error), end; !error && it != end; it.increment(error))
    if (std::error_code unknown; it->path().extension() == ".png")
      found.emplace_back(fs::last_write_time(it->path(), unknown), it->path());
  if (found.size() <= most) return;
  std::sort(found.begin(), found.end());
  for (std::size_t i = 0; i + most < found.size(); ++i) fs::remove(found[i].second, error);
}

struct Found {
  std::string key;
  std::optional<Image> image;  ///< from the cache
  Scene scene;                 ///< to be drawn where the cache has none
};

}  // namespace

void Pictures::request(const fs::path& file, std::function<void(unsigned texture)> done) {
  background_.run(
      {},
      [file, cache = cache_](const CancelToken& cancel) {
        Found found;
        found.key = key_of(file);
        if (auto image = read_png(cache / (found.key + ".png")); image.ok())
          found.image = std::move(image).value();
        else
          found.scene = file_scene(file, cancel);
        return found;
      },
      [this, done = std::move(done)](const Found& found) {
        const auto known = textures_.find(found.key);
        if (known != textures_.end()) return done(known->second);
        if (!found.image) return draw(found.key, found.scene, done);
        done(textures_[found.key] = upload_picture(*found.image));
      });
}

void Pictures::draw(const std::string& key, const Scene& scene,
                    const std::function<void(unsigned texture)>& done) {
  const std::optional<Image> image = draw_picture(renderer_, scene, size);
  if (!image) return;
  done(textures_[key] = upload_picture(*image));
  keep(key, *image);
}

void Pictures::keep(const std::string& key, const Image& image) {
  background_.run(
      {},
      [cache = cache_, key, image](const CancelToken&) {
        std::error_code unknown;  // without a cache pictures are made again
        fs::create_directories(cache, unknown);
        (void)write_png(cache / (key + ".png"), image);
        prune(cache);
        return Done{};
      },
      [](Done) {});
}

}  // namespace hariko
