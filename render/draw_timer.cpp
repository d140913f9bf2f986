#include "render/draw_timer.hpp"

namespace hariko::gl {

DrawTimer::Measurement DrawTimer::start(bool wanted, int samples, std::optional<PictureTime>& known) {
  constexpr double milliseconds = 1e-6;  // in a nanosecond
  if (samples_ > 0) {
    GLuint ready = 0;
    glGetQueryObjectuiv(query_.name(), GL_QUERY_RESULT_AVAILABLE, &ready);
    if (!ready) return Measurement(false);
    GLuint64 time = 0;
    glGetQueryObjectui64v(query_.name(), GL_QUERY_RESULT, &time);
    known = PictureTime{milliseconds * static_cast<double>(time), samples_};
    samples_ = 0;
  }
  if (!wanted) return Measurement(false);
  if (!query_) query_ = Query::make();
  samples_ = samples;
  glBeginQuery(GL_TIME_ELAPSED, query_.name());
  return Measurement(true);
}

}  // namespace hariko::gl
