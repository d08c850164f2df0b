// Builds the outline of a tool for drawings. Used by view/sheet; tested by tests/stock/tool_outline_test.cpp.

#include "stock/tool/tool_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "config/tools/tool_library.h"
#include "stock/tool/round_solid.h"

namespace kadr {
namespace {

// Number of straight lines that replace a quarter circle: the lines are shorter than a pixel of the drawing.
constexpr int quarter_steps = 8;

/// Appends the quarter circle at the end of a ball or bull-nose tool.
void add_round(const RoundSolid& s, std::vector<ProfilePoint>& outline) {
  const bool ball = s.form == RoundSolid::Form::ball;
  const double flat = ball ? 0 : s.bottom_radius, rise = ball ? s.top_radius : s.top - s.bottom;
  const double low = ball ? s.top - s.top_radius : s.bottom;
  for (int i = 0; i <= quarter_steps; ++i) {
    const double angle = std::numbers::pi / 2 * i / quarter_steps;
    outline.push_back({2 * (flat + (s.top_radius - flat) * std::sin(angle)), low + rise * (1 - std::cos(angle))});
  }
}

}  // namespace

std::vector<ProfilePoint> outline_of(const ToolGeometry& given) {
  ToolGeometry tool = given;
  complete(tool);
  if (tool.kind == ToolKind::turning || !tool_fault_message(tool).empty()) return {};
  std::vector<RoundSolid> solids;
  for (const ConvexBody& body : shape_of(tool).bodies) solids.insert(solids.end(), body.solids.begin(), body.solids.end());
  std::stable_sort(solids.begin(), solids.end(), [](const RoundSolid& a, const RoundSolid& b) { return a.bottom < b.bottom; });
  std::vector<ProfilePoint> outline;
  for (const RoundSolid& s : solids) {
    if (outline.empty()) outline.push_back({0, s.form == RoundSolid::Form::ball ? s.top - s.top_radius : s.bottom});
    if (s.form == RoundSolid::Form::ball || s.form == RoundSolid::Form::torus) {
      add_round(s, outline);
      continue;
    }
    outline.push_back({2 * s.bottom_radius, std::max(s.bottom, outline.back().height)});
    outline.push_back({2 * s.top_radius, std::max(s.top, outline.back().height)});
  }
  outline.erase(std::unique(outline.begin(), outline.end()), outline.end());
  return outline;
}

}  // namespace kadr
