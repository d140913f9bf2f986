#pragma once

// Pictures: thumbnails of files for the start page, made once and kept in the cache.

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "app/jobs/background_work.hpp"
#include "render/renderer.hpp"

namespace hariko {

/// Thumbnails as textures, which live as long as the GL context. For the main thread, with the renderer's
/// context.
class Pictures {
 public:
  Pictures(Renderer& renderer, BackgroundWork& background, std::filesystem::path cache)
      : renderer_(renderer), background_(background), cache_(std::move(cache)) {}

  static constexpr PixelSize size{256, 192};

  /// Passes the picture of a document or mesh file to `done`, now or later; never where there is none.
  void request(const std::filesystem::path& file, std::function<void(unsigned texture)> done);

 private:
  void draw(const std::string& key, const Scene& scene, const std::function<void(unsigned texture)>& done);
  void keep(const std::string& key, const Image& image);

  Renderer& renderer_;
  BackgroundWork& background_;
  std::filesystem::path cache_;
  std::map<std::string, unsigned> textures_;
};

}  // namespace hariko
