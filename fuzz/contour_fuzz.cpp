// Fuzz target for the contour readers. The input is a drawing file of any bytes. Coordinates that are read must be finite and bounded;
// closed contours must be accepted as an area.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "config/drawing/drawing.h"
#include "path/pocketing/closed_loops.h"
#include "require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using kadr::fuzz::require;
  constexpr std::size_t few = 300;  // greatest number of edges for which the area is built: more only cost time
  const auto edges = kadr::read_drawing({reinterpret_cast<const char*>(data), size});
  if (!edges) return 0;
  require(!edges->empty() && edges->size() <= kadr::limits::drawing_edges, "a contour has edges, and not too many");
  for (const kadr::Edge& e : *edges) {
    require(std::abs(e.from.x) <= kadr::limits::contour_reach && std::abs(e.from.y) <= kadr::limits::contour_reach,
            "edges are within reach");
    require(std::abs(e.bulge) < 1.001, "an arc is at most half a circle");
  }
  if (edges->size() > few) return 0;
  if (const auto chains = kadr::area::chained(*edges)) (void)kadr::area::zones_of(*chains);
  return 0;
}
