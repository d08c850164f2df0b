// Blanks with the shape of a box or a cylinder. Used by stock/stock.

#include "stock/blank/blank.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr int lines_across = 1024;

class BoxBlank : public Blank {
 public:
  explicit BoxBlank(const Box3& box) : box_(box) {}
  Box3 box() const override { return box_; }
  void cross(int family, double u, double v, std::vector<LineRange>& ranges) const override {
    if (inside((family + 1) % 3, u) && inside((family + 2) % 3, v)) ranges.push_back({along(box_.least, family), along(box_.most, family)});
  }
  Vec3 normal(Vec3, int family, bool out) const override {
    Vec3 n;
    along(n, family) = out ? 1 : -1;
    return n;
  }
  double volume() const override {
    const Vec3 size = box_.most - box_.least;
    return size.x * size.y * size.z;
  }

 private:
  bool inside(int axis, double place) const { return place > along(box_.least, axis) && place < along(box_.most, axis); }
  Box3 box_;
};

class CylinderBlank : public Blank {
 public:
  CylinderBlank(Vec2 centre, double bottom, double top, double diameter)
      : centre_(centre), bottom_(bottom), top_(top), radius_(diameter / 2) {}
  Box3 box() const override {
    return {{centre_.x - radius_, centre_.y - radius_, bottom_}, {centre_.x + radius_, centre_.y + radius_, top_}};
  }
  void cross(int family, double u, double v, std::vector<LineRange>& ranges) const override {
    if (family == 2) {
      if (length(Vec2{u, v} - centre_) < radius_) ranges.push_back({bottom_, top_});
      return;
    }
    const double z = family == 0 ? v : u, aside = family == 0 ? u - centre_.y : v - centre_.x, middle = family == 0 ? centre_.x : centre_.y;
    const double square = radius_ * radius_ - aside * aside;
    if (z > bottom_ && z < top_ && square > 0) ranges.push_back({middle - std::sqrt(square), middle + std::sqrt(square)});
  }
  Vec3 normal(Vec3 at, int family, bool out) const override {
    if (family == 2) return {0, 0, out ? 1.0 : -1.0};
    const Vec2 from{at.x - centre_.x, at.y - centre_.y};
    const double far = length(from);
    return far > 0 ? Vec3{from.x / far, from.y / far, 0} : Vec3{1, 0, 0};
  }
  double volume() const override { return pi * radius_ * radius_ * (top_ - bottom_); }

 private:
  Vec2 centre_;
  double bottom_, top_, radius_;
};

}  // namespace

double Blank::volume_within(const Box3& box) const {
  const double step_y = (box.most.y - box.least.y) / lines_across, step_z = (box.most.z - box.least.z) / lines_across;
  std::vector<LineRange> ranges;
  double length = 0;
  for (int j = 0; j < lines_across; ++j)
    for (int k = 0; k < lines_across; ++k) {
      ranges.clear();
      cross(0, box.least.y + (j + 0.5) * step_y, box.least.z + (k + 0.5) * step_z, ranges);
      for (const LineRange& r : ranges) length += std::max(std::min(r.to, box.most.x) - std::max(r.from, box.least.x), 0.0);
    }
  return length * step_y * step_z;
}

std::shared_ptr<const Blank> box_blank(const Box3& box) { return std::make_shared<BoxBlank>(box); }

std::shared_ptr<const Blank> cylinder_blank(Vec2 centre, double bottom, double top, double diameter) {
  return std::make_shared<CylinderBlank>(centre, bottom, top, diameter);
}

}  // namespace kadr
