#pragma once

// DrawTimer: how long the graphics card draws a picture, without waiting for it. Internal to render/.

#include <optional>

#include "render/gl_object.hpp"
#include "render/renderer.hpp"

namespace hariko::gl {

/// Timer of one picture. A measurement is known some time after the drawing; until then no other begins.
class DrawTimer {
 public:
  /// Measurement in progress: lasts as long as this object.
  class Measurement {
   public:
    explicit Measurement(bool runs) : runs_(runs) {}
    ~Measurement() {
      if (runs_) glEndQuery(GL_TIME_ELAPSED);
    }
    Measurement(const Measurement&) = delete;
    Measurement& operator=(const Measurement&) = delete;

   private:
    bool runs_;
  };
  /// Begins a measurement of a picture with so many samples, where `wanted` and the last one is known; that
  /// is put into `known`. Measurements of several timers must not overlap.
  [[nodiscard]] Measurement start(bool wanted, int samples, std::optional<PictureTime>& known);

 private:
  Query query_;
  int samples_ = 0;  ///< samples in the measurement that is not known yet; 0: there is none
};

}  // namespace hariko::gl
