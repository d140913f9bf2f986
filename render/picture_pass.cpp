#include "render/picture_pass.hpp"

#include <algorithm>

namespace hariko::gl {

namespace {

constexpr int bytes_a_pixel = 4;

void set_up_depth(PictureLayer layer, bool opaque) {
  glEnable(GL_DEPTH_CLAMP);
  if (layer != PictureLayer::space) {
    glDisable(GL_DEPTH_TEST);
    return;
  }
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  // Translucent pictures do not write depth, so that lines and points behind them show.
  glDepthMask(opaque ? GL_TRUE : GL_FALSE);
  // Depth offset, so that a grid or a curve in the picture's plane shows.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1, 2);
}

std::vector<const ScenePicture*> farthest_first(const Frame& frame, const Scene& scene, PictureLayer layer) {
  std::vector<const ScenePicture*> order;
  for (const ScenePicture& picture : scene.pictures)
    if (picture.image && picture.look.layer == layer && picture.look.opacity > 0 &&
        picture.seen_by(frame.camera))
      order.push_back(&picture);
  const Vector3 forward = frame.camera.forward();
  std::stable_sort(order.begin(), order.end(), [&](const ScenePicture* a, const ScenePicture* b) {
    return forward.dot(a->middle()) > forward.dot(b->middle());
  });
  return order;
}

}  // namespace

PictureTexture::PictureTexture(const ReferenceImage& image, std::size_t&) : texture_(Texture::make()) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  const int last = static_cast<int>(image.levels.size()) - 1;
  const auto fits = [&](int level) {
    const Image& pixels = image.levels[static_cast<std::size_t>(level)];
    return std::max(pixels.width, pixels.height) <= largest;
  };
  while (first_ < last && !fits(first_)) ++first_;
  next_ = last;
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  for (int level = first_; level <= last; ++level) {
    const Image& pixels = image.levels[static_cast<std::size_t>(level)];
    glTexImage2D(GL_TEXTURE_2D, level - first_, GL_RGBA8, pixels.width, pixels.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, nullptr);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, last - first_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, last - first_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

bool PictureTexture::fill(const ReferenceImage& image, std::size_t& budget, std::size_t& uploaded) {
  if (next_ < first_) return true;
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, bytes_a_pixel);
  while (next_ >= first_ && budget > 0) {
    const Image& pixels = image.levels[static_cast<std::size_t>(next_)];
    const std::size_t row_bytes = std::size_t(pixels.width) * bytes_a_pixel;
    const std::size_t left = std::size_t(pixels.height - row_);
    const int rows = static_cast<int>(std::min(left, std::max<std::size_t>(1, budget / row_bytes)));
    glTexSubImage2D(GL_TEXTURE_2D, next_ - first_, 0, row_, pixels.width, rows, GL_RGBA, GL_UNSIGNED_BYTE,
                    pixels.pixel(0, row_));
    const std::size_t bytes = std::size_t(rows) * row_bytes;
    budget -= std::min(budget, bytes);
    uploaded += bytes;
    row_ += rows;
    if (row_ < pixels.height) break;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, next_ - first_);
    row_ = 0;
    --next_;
  }
  return next_ < first_;
}

Result<Done> PicturePass::prepare() {
  if (program_) return Done{};
  Result<Program> loaded = Program::load("picture");
  if (!loaded) return loaded.error();
  program_ = std::move(loaded).value();
  if (!empty_) empty_ = VertexArray::make();
  return Done{};
}

void PicturePass::draw(const Frame& frame, const Scene& scene, PictureLayer layer, unsigned picture_bit,
                       FrameStatistics& statistics) {
  const auto order = farthest_first(frame, scene, layer);
  if (order.empty() || !program_) return;
  program_->use();
  program_->set("projection", to_float(frame.projection));
  program_->set("pixels", 0);
  glActiveTexture(GL_TEXTURE0);
  glBindVertexArray(empty_.name());
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  for (const ScenePicture* picture : order) {
    PictureTexture& texture = textures_.get(picture->image, picture_bit, statistics.uploaded_bytes);
    if (!texture.fill(*picture->image, budget_, statistics.uploaded_bytes)) statistics.unfinished = true;
    set_up_depth(layer, picture->look.opacity >= 1);
    program_->set("to_eye", to_float(Matrix4(frame.view * picture->transform)));
    program_->set("half_sides", glm::vec2(picture->half.x(), picture->half.y()));
    program_->set("opacity", picture->look.opacity);
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    ++statistics.draw_calls;
    statistics.triangles += 2;
  }
  glBindTexture(GL_TEXTURE_2D, 0);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_DEPTH_CLAMP);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

std::vector<OverlayLine> picture_frames(const Scene& scene, const Camera& camera, const Style& style) {
  constexpr float width = 2;  // design pixels
  std::vector<OverlayLine> lines;
  for (const ScenePicture& picture : scene.pictures) {
    const bool marked = picture.selected || picture.hovered;
    if ((!marked && picture.image) || !picture.seen_by(camera)) continue;
    const Color paint = picture.selected  ? style.selected_edge.paint
                        : picture.hovered ? style.hovered_edge.paint
                                          : style.polyhedron.paint;
    const auto corners = picture.corners();
    const auto add = [&](std::size_t from, std::size_t to) {
      lines.push_back({corners[from], corners[to], paint, width, true});
    };
    for (std::size_t i = 0; i < 4; ++i) add(i, (i + 1) % 4);
    if (!picture.missing) continue;
    add(0, 2);
    add(1, 3);
  }
  return lines;
}

Box3 box_of_pictures(const Scene& scene, const Camera& camera) {
  Box3 box;
  for (const ScenePicture& picture : scene.pictures)
    if (picture.look.layer == PictureLayer::space && picture.seen_by(camera))
      for (const Vector3& corner : picture.corners()) box.extend(corner);
  return box;
}

}  // namespace hariko::gl
