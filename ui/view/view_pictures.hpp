#pragma once

// ViewPictures: draws the scene for each view that shows, when its picture would be another one.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "render/renderer.hpp"
#include "ui/editor/scene_builder.hpp"
#include "ui/editor/view_layout.hpp"
#include "ui/view/motion_samples.hpp"

namespace hariko {

/// Number of the renderer's picture for thumbnails; the views have the first ones, by their numbers.
inline constexpr int thumbnail_picture = ViewLayout::count;
static_assert(thumbnail_picture < Renderer::most_pictures);

class ViewPictures {
 public:
  /// `quick_samples`: the most samples a pixel while something moves (1 on software renderers, 4 otherwise).
  ViewPictures(Renderer& renderer, int quick_samples) : renderer_(renderer), motion_(quick_samples) {}

  struct Shown {
    int view = 0;
    PixelSize size;
  };
  /// Draws what changed: on slow renderers, while things move, the active view and one of the others a frame.
  /// `busy`: a tool runs. `jumps`: rises when the next pictures are to be faded to. Errors become notices.
  void update(Editor& editor, const SceneBuilder& scene, std::span<const Shown> shown, bool busy,
              std::uint64_t jumps);

  unsigned texture(int view) const { return renderer_.texture(view); }
  /// Share of a view's picture over what was there before a jump: 1 where nothing fades.
  double shown_share(int view, double now) const;
  unsigned faded_texture(int view) const { return renderer_.kept_texture(view); }
  static constexpr double fade_seconds = 0.15;
  /// Seconds until a picture wants another frame without any event; negative when none does.
  double next_frame_in(const Editor& editor, bool busy) const;
  std::uint64_t drawn() const { return drawn_; }
  /// Time that the last update took until OpenGL was finished; measured while the frame times show.
  double milliseconds() const { return milliseconds_; }
  /// Statistics of the views drawn in the last update.
  const FrameStatistics& statistics() const { return statistics_; }

 private:
  struct State {
    bool exists = false, stale = false;
    std::uint64_t version = 0;
    Camera camera;
    PixelSize size;
    int samples = 0;
    double changed_at = 0;
    bool unfinished = false;  ///< reference pictures become sharper with the next frames
    std::uint64_t jumps = 0;
    double fades_from = -1;  ///< time when a fade began
  };
  bool wants_rest(const State& state) const { return state.exists && state.samples < full_samples; }
  /// Returns how long an earlier drawing of the view took, where that is known by now.
  std::optional<PictureTime> draw(Editor& editor, const SceneBuilder& scene, const Shown& shown, int samples);

  Renderer& renderer_;
  MotionSamples motion_;
  std::array<State, ViewLayout::count> states_;
  std::uint64_t drawn_ = 0;
  double milliseconds_ = 0;
  FrameStatistics statistics_;
  int next_other_ = 0;  ///< number of the view, not the active one, that is next on slow renderers

  static constexpr int full_samples = 4;
  static constexpr std::size_t upload_bytes = std::size_t(8) << 20;  ///< bytes of reference pictures, a frame
  static constexpr double rest_seconds = 0.15;  ///< after which a still picture is drawn with all samples
};

}  // namespace hariko
