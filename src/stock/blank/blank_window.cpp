// The part of a blank inside a box: clips the blank's intervals to the box. Used by stock/stock.

#include "stock/blank/blank_window.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

// Limit in mm: positions that differ by less than this count as equal, because positions are rounded to single precision.
constexpr double same_place = 1e-3;

class BlankWindow : public Blank {
 public:
  BlankWindow(std::shared_ptr<const Blank> blank, const Box3& box) : blank_(std::move(blank)), box_(box) {}

  Box3 box() const override { return box_; }
  double volume() const override { return blank_->volume_within(box_); }
  void cross(int family, double u, double v, std::vector<LineRange>& ranges) const override;
  Vec3 normal(Vec3 at, int family, bool out) const override;
  std::vector<bool> bricks_at_surface(const Lattice& lattice) const override;

 private:
  bool inside(int axis, double place) const { return place > along(box_.least, axis) && place < along(box_.most, axis); }
  bool blank_ends(Vec3 at, int family, bool out) const;

  std::shared_ptr<const Blank> blank_;
  Box3 box_;
};

void BlankWindow::cross(int family, double u, double v, std::vector<LineRange>& ranges) const {
  if (!inside((family + 1) % 3, u) || !inside((family + 2) % 3, v)) return;
  const std::size_t first = ranges.size();
  blank_->cross(family, u, v, ranges);
  std::size_t kept = first;
  for (std::size_t i = first; i < ranges.size(); ++i) {
    const LineRange within{std::max(ranges[i].from, along(box_.least, family)), std::min(ranges[i].to, along(box_.most, family))};
    if (within.from < within.to) ranges[kept++] = within;
  }
  ranges.resize(kept);
}

bool BlankWindow::blank_ends(Vec3 at, int family, bool out) const {
  std::vector<LineRange> ranges;
  blank_->cross(family, along(at, (family + 1) % 3), along(at, (family + 2) % 3), ranges);
  return std::any_of(ranges.begin(), ranges.end(),
                     [&](const LineRange& r) { return std::fabs((out ? r.to : r.from) - along(at, family)) < same_place; });
}

Vec3 BlankWindow::normal(Vec3 at, int family, bool out) const {
  const double face = along(out ? box_.most : box_.least, family);
  if (std::fabs(along(at, family) - face) >= same_place || blank_ends(at, family, out)) return blank_->normal(at, family, out);
  Vec3 square;
  along(square, family) = out ? 1 : -1;
  return square;
}

/// Marks the bricks that the blank's surface or a face of the window crosses. A small margin covers the rounding of positions on lines.
std::vector<bool> BlankWindow::bricks_at_surface(const Lattice& lattice) const {
  std::vector<bool> at = blank_->bricks_at_surface(lattice);
  if (at.empty()) return at;
  const double hair = 1e-3 * lattice.cell();
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    const Vec3 corner = lattice.corner(i);
    for (int d = 0; d < 3; ++d)
      for (const Vec3& face : {box_.least, box_.most}) {
        const double place = along(face, d) - along(corner, d);
        if (place > -hair && place < lattice.edge() + hair) at[i] = true;
      }
  }
  return at;
}

}  // namespace

std::shared_ptr<const Blank> blank_within(std::shared_ptr<const Blank> blank, const Box3& window) {
  Box3 box = blank->box();
  for (int d = 0; d < 3; ++d) {
    along(box.least, d) = std::max(along(box.least, d), along(window.least, d));
    along(box.most, d) = std::min(along(box.most, d), along(window.most, d));
    if (!(along(box.least, d) < along(box.most, d))) return nullptr;
  }
  return std::make_shared<BlankWindow>(std::move(blank), box);
}

WindowFaces::WindowFaces(const Box3& window, const Box3& blank) : faces_(window) {
  constexpr double nowhere = 1e9;
  for (int d = 0; d < 3; ++d) {
    if (along(window.least, d) < along(blank.least, d) + same_place) along(faces_.least, d) = -nowhere;
    if (along(window.most, d) > along(blank.most, d) - same_place) along(faces_.most, d) = nowhere;
  }
}

bool WindowFaces::hold(const Vec3& at) const {
  for (int d = 0; d < 3; ++d)
    if (along(at, d) < along(faces_.least, d) + same_place || along(at, d) > along(faces_.most, d) - same_place) return true;
  return false;
}

}  // namespace kadr
