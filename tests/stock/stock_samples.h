#pragma once
// Blanks, tools and programs that are shared by the tests of the stock.

#include <memory>
#include <vector>

#include "stock/stock.h"

namespace kadr::test {

inline ToolShape tool_of(ToolKind kind, double diameter, double flutes = 50) {
  ToolGeometry g;
  g.kind = kind;
  g.diameter = diameter;
  g.flutes = g.length = flutes;
  g.corner = kind == ToolKind::bull ? diameter / 6 : 0;
  g.angle = kind == ToolKind::taper ? 12 : 90;
  return shape_of(g);
}

/// Returns a T-slot cutter: a disc of thickness `thick` below a thinner shank.
inline ToolShape t_slot_cutter(double diameter, double thick, double shank) {
  ToolGeometry g;
  g.kind = ToolKind::tslot;
  g.diameter = diameter;
  g.flutes = thick;
  g.length = 60;
  g.shank = {{shank, thick}, {shank, 60}};
  return shape_of(g);
}

inline const Box3 block{{0, 0, -20}, {100, 100, 0}};

/// Returns the stock after the tool has cut along the corners of the path.
inline std::unique_ptr<Stock> cut_along(std::shared_ptr<const Blank> blank, double cell, const ToolShape& tool,
                                        const std::vector<Vec3>& path, int threads = 2) {
  auto stock = std::make_unique<Stock>(std::move(blank), cell, threads);
  const std::uint16_t number = stock->add_tool(tool);
  for (std::size_t i = 1; i < path.size(); ++i) stock->add({path[i - 1], path[i], number, false});
  stock->cut();
  return stock;
}

}  // namespace kadr::test
