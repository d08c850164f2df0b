// Draws a cut part as pixels. This file is used by out/picture/part_page and tested by tests/run_cut.py.

#include "out/picture/part_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/matrix.h"

namespace kadr {
namespace {

// Weights of the three components of a triangle's brightness: light from everywhere, light from the viewer, and light from above left.
constexpr double ambient = 0.35, facing = 0.5, from_above_left = 0.15;

/// A corner of a triangle in the image, pixels. `near` increases towards the viewer.
struct Corner {
  double x, y, near;
};

class Painter {
 public:
  Painter(const ViewDirection& direction, const ViewFrame& frame) : direction_(direction), frame_(frame) {
    picture_.width = frame.width, picture_.height = frame.height;
    picture_.argb.resize(std::size_t(frame.width) * std::size_t(frame.height));
    nearest_.resize(picture_.argb.size(), -1e30f);
  }

  Corner corner(const float* point) const {
    const Vec3 from = Vec3{double(point[0]), double(point[1]), double(point[2])} - frame_.centre;
    return {frame_.width / 2.0 + frame_.scale * dot(from, direction_.right), frame_.height / 2.0 - frame_.scale * dot(from, direction_.up),
            dot(from, direction_.towards)};
  }

  /// Draws a triangle that faces the viewer, which is the case if its corners run counter-clockwise in the image. Any other triangle is
  /// hidden and is not drawn.
  void paint(const std::array<Corner, 3>& c, std::uint32_t rgb) {
    const double area = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x);
    if (!(area < 0)) return;
    const int left = std::max(0, int(std::floor(std::min({c[0].x, c[1].x, c[2].x})))),
              top = std::max(0, int(std::floor(std::min({c[0].y, c[1].y, c[2].y}))));
    const int right = std::min(frame_.width - 1, int(std::ceil(std::max({c[0].x, c[1].x, c[2].x}))));
    const int bottom = std::min(frame_.height - 1, int(std::ceil(std::max({c[0].y, c[1].y, c[2].y}))));
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) {
        const double px = x + 0.5, py = y + 0.5;
        const auto share = [&](int a, int b) {
          return ((c[std::size_t(b)].x - c[std::size_t(a)].x) * (py - c[std::size_t(a)].y) -
                  (c[std::size_t(b)].y - c[std::size_t(a)].y) * (px - c[std::size_t(a)].x)) /
                 area;
        };
        const double w2 = share(0, 1), w0 = share(1, 2), w1 = 1 - w0 - w2;
        if (w0 < 0 || w1 < 0 || w2 < 0) continue;
        const float near = float(w0 * c[0].near + w1 * c[1].near + w2 * c[2].near);
        const std::size_t at = std::size_t(y) * std::size_t(frame_.width) + std::size_t(x);
        if (near <= nearest_[at]) continue;
        nearest_[at] = near;
        picture_.argb[at] = 0xFF000000U | rgb;
      }
  }

  Pixels take() { return std::move(picture_); }

 private:
  const ViewDirection& direction_;
  const ViewFrame& frame_;
  Pixels picture_;
  std::vector<float> nearest_;
};

std::uint32_t lit(std::uint32_t rgb, double light) {
  const auto part = [&](int shift) { return std::uint32_t(std::lround(std::min(255.0, double(rgb >> shift & 0xFF) * light))) << shift; };
  return part(16) | part(8) | part(0);
}

}  // namespace

Pixels part_view(const Surface& surface, const ViewDirection& direction, const ViewFrame& frame, const TriangleColour& colour_of) {
  Painter painter(direction, frame);
  const Vec3 lamp = unit(direction.towards + direction.up - direction.right);
  for (std::size_t t = 0; t * 3 + 2 < surface.triangles.size(); ++t) {
    std::array<Corner, 3> corners;
    Vec3 at[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const float* const point = &surface.points[std::size_t(surface.triangles[t * 3 + k]) * 3];
      corners[k] = painter.corner(point);
      at[k] = {double(point[0]), double(point[1]), double(point[2])};
    }
    const Vec3 normal = unit(cross(at[1] - at[0], at[2] - at[0]));
    const double light =
        ambient + facing * std::max(0.0, dot(normal, direction.towards)) + from_above_left * std::max(0.0, dot(normal, lamp));
    painter.paint(corners, lit(colour_of(t), light));
  }
  return painter.take();
}

}  // namespace kadr
