// Fuzz target for tools files. Any text must give either tools with a shape, or an error sentence.

#include <cmath>
#include <string_view>

#include "config/tools/tool_formats.h"
#include "require.h"
#include "stock/tool/round_solid.h"

namespace {

using namespace kadr;

/// Checks that the outline of an insert is closed, counter-clockwise and has finite coordinates.
void look_at_insert(const InsertBody& body) {
  fuzz::require(body.corners.size() >= 3 && body.outward.size() == body.corners.size(), "an edge behind each corner");
  for (const InsertCorner& c : body.corners)
    fuzz::require(std::isfinite(c.centre.x) && std::isfinite(c.centre.z) && c.radius >= 0, "corners have places");
  for (std::size_t i = 0; i < body.outward.size(); ++i) {
    const InsertPoint &a = body.outward[i], &b = body.outward[(i + 1) % body.outward.size()];
    fuzz::require(std::fabs(std::hypot(a.x, a.z) - 1) < 1e-9, "normals are unit vectors");
    fuzz::require(a.x * b.z - a.z * b.x > -1e-9, "the outline turns one way");
  }
}

void look_at(const tl::expected<ToolLibrary, std::string>& library) {
  if (!library) return fuzz::require(!library.error().empty(), "a refusal says why");
  fuzz::require(!library->tools.empty(), "a library has tools");
  for (const ToolGeometry& tool : library->tools) {
    fuzz::require(tool_fault_message(tool).empty(), "what was read has a shape");
    const ToolShape shape = shape_of(tool);
    fuzz::require(shape.turns() == (tool.kind == ToolKind::turning), "inserts are of turning tools");
    for (const InsertBody& body : shape.insert) look_at_insert(body);
    if (shape.turns()) continue;
    fuzz::require(!shape.bodies.empty(), "the shape has a body");
    for (const ConvexBody& body : shape.bodies) {
      fuzz::require(!body.solids.empty() && body.top() > body.bottom(), "a body has a height");
      fuzz::require(body.widest() > 0 && std::isfinite(body.widest()), "a body has a width");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  look_at(tools_of_toml(text, "tools"));
  look_at(tools_of_linuxcnc(text, "tools"));
  look_at(tools_of_camotics(text, "tools"));
  look_at(tools_of_freecad(text, "tools"));
  look_at(tools_of_fusion(text, "tools"));
  return 0;
}
