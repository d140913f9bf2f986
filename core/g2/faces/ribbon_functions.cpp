#include "core/g2/faces/ribbon_functions.hpp"

namespace hariko {

void ribbon_quintic(double t, Derivatives (&out)[7]) {
  const double a = 1 - t, t2 = t * t, t3 = t2 * t, a2 = a * a, a3 = a2 * a;
  out[0] = {a3 * (1 + 3 * t + 6 * t2), -30 * t2 * a2, -60 * t * a * (1 - 2 * t), -60 * (1 - 6 * t * a)};
  out[1] = {t * a3 * (1 + 3 * t), a2 * (1 - 3 * t) * (1 + 5 * t), t * a * (-36 + 60 * t),
            -36 + 192 * t - 180 * t2};
  out[2] = {0.5 * t2 * a3, 0.5 * t * a2 * (2 - 5 * t), 0.5 * a * (2 - 16 * t + 20 * t2),
            -9 + 36 * t - 30 * t2};
  out[3] = {t3 * (1 + 3 * a + 6 * a2), 30 * t2 * a2, 60 * t * a * (1 - 2 * t), 60 * (1 - 6 * t * a)};
  // Derivative at 1 in the direction of increasing t.
  out[4] = {-a * t3 * (1 + 3 * a), t2 * (1 - 3 * a) * (1 + 5 * a), -a * t * (-36 + 60 * a),
            -36 + 192 * a - 180 * a2};
  out[5] = {0.5 * a2 * t3, -0.5 * a * t2 * (2 - 5 * a), 0.5 * t * (2 - 16 * a + 20 * a2),
            9 - 36 * a + 30 * a2};
  out[6] = {t3 * a3, 3 * t2 * a2 * (1 - 2 * t), 6 * t * a * (1 - 5 * t * a),
            6 * (1 - 2 * t) * (1 - 10 * t * a)};
}

void ribbon_cubic(double t, Derivatives (&out)[6]) {
  const double a = 1 - t, t2 = t * t, a2 = a * a, odd = 2 * t - 1;
  out[0] = {a2 * (1 + 2 * t), -6 * t * a, -6 + 12 * t, 12};
  out[1] = {t * a2, a * (1 - 3 * t), -4 + 6 * t, 6};
  out[2] = {t2 * (1 + 2 * a), 6 * t * a, 6 - 12 * t, -12};
  out[3] = {-a * t2, t * (1 - 3 * a), 4 - 6 * a, 6};
  const double bump = t2 * a2, bump1 = 2 * t * a * (1 - 2 * t), bump2 = 2 - 12 * t * a, bump3 = 12 * odd;
  out[4] = {bump, bump1, bump2, bump3};
  out[5] = {bump * odd, bump1 * odd + 2 * bump, bump2 * odd + 4 * bump1, bump3 * odd + 6 * bump2};
}

void ribbon_linear(double t, Derivatives (&out)[4]) {
  out[0] = {1 - t, -1, 0, 0};
  out[1] = {t, 1, 0, 0};
  const double bump = t * (1 - t), bump1 = 1 - 2 * t, odd = 2 * t - 1;
  out[2] = {bump, bump1, -2, 0};
  out[3] = {bump * odd, bump1 * odd + 2 * bump, -2 * odd + 4 * bump1, -12};
}

}  // namespace hariko
