// Chooses the cell size of a stock. Used by cli/cut.

#include "stock/size.h"

#include <algorithm>
#include <cmath>

#include "stock/brick/brick.h"

namespace kadr {
namespace {

constexpr double cells_along = 400, max_cells_along = 1600;
constexpr double cells_in_tool = 4;
constexpr double least_cell = 1e-3;  // least edge length of a cell, mm

/// Returns the number rounded up to the next 1, 2.5 or 5 times a power of ten.
double round_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.5, 5.0})
    if (step * power >= value * (1 - 1e-9)) return step * power;
  return 10 * power;
}

}  // namespace

double bytes_of_bricks(const Box3& box, double cell) {
  double count = 1;
  for (int d = 0; d < 3; ++d) count *= std::ceil(((along(box.most, d) - along(box.least, d)) / cell + 4) / brick_edge);
  return count * double(sizeof(Brick) + 64);  // 64 is the memory in bytes of the entries of one brick in the tables of the stock.
}

double bytes_of_bricks(const Lattice& lattice) { return double(lattice.size()) * double(sizeof(Brick) + 64); }

double cell_for(const Box3& box, double max_bytes, double finest) {
  const Vec3 size = box.most - box.least;
  const double longest = std::max({size.x, size.y, size.z});
  double wanted = longest / cells_along;
  if (finest > 0) wanted = std::min(wanted, std::max(finest / cells_in_tool, longest / max_cells_along));
  double cell = round_up(std::max(wanted, least_cell));
  while (bytes_of_bricks(box, cell) > max_bytes && cell < 1e6) cell = round_up(cell * 1.01);
  return cell;
}

}  // namespace kadr
