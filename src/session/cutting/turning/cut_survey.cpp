// Surveys the motions of a run before the cut. Used by cli/cut_guess; tested by tests/run_cut.py.

#include "session/cutting/turning/cut_survey.h"

#include <algorithm>
#include <cmath>

#include "session/cutting/tool_path.h"

namespace kadr {
namespace {

constexpr double coarse_chord = 1;    // mm; only the place of a motion counts here, not its form
constexpr double near_axis = 1e-6;    // mm; a tool this near to the axis is on it
constexpr double no_rotation = 1e-9;  // degrees

}  // namespace

CutSurvey::CutSurvey(const AxisRoles& roles, const ToolLibrary& tools, TellsInsert tells_insert, std::uint32_t tool)
    : path_(roles, coarse_chord, {}), roles_(roles), tools_(tools), tells_insert_(std::move(tells_insert)), tool_(tool) {}

CutSurvey::Kind CutSurvey::kind_of(std::uint32_t row) {
  const ToolGeometry* geometry = tools_.find(tool_);
  if (geometry == nullptr && tool_ == 0 && tools_.tools.size() == 1) geometry = &tools_.tools.front();
  if (geometry != nullptr)
    return geometry->kind == ToolKind::turning ? Kind::turning : geometry->kind == ToolKind::drill ? Kind::drill : Kind::mill;
  if (!tells_insert_(row, tool_)) return Kind::unknown;
  rows_.try_emplace(tool_, row);
  return Kind::turning;
}

void CutSurvey::take(const Step& step) {
  if (const auto* const change = std::get_if<ToolChange>(&step.action.what)) tool_ = change->tool;
  const auto path = path_.take(step);
  const Motion* const motion = step.motion();
  if (!path || motion == nullptr) return;
  bool rotates = false;
  for (std::size_t i = 0; i < roles_.count; ++i)
    rotates = rotates || (roles_.is_rotary(i) && std::fabs(motion->machine[i] - step.from.machine[i]) > no_rotation);
  has_rotated_ = has_rotated_ || rotates;
  if (!is_cutting(motion->kind) || (path->corners.empty() && !path->off_plane)) return;
  const auto count = [&](Motions& of) {
    if (of.count++ == 0) of.first = step.action.origin, of.tool = tool_;
  };
  const Kind kind = kind_of(motion->length_offset != 0 ? motion->length_offset : tool_);
  if (rotates) return count(rotating_);
  if (kind == Kind::unknown) return;
  if (kind == Kind::turning) return count(path->off_plane ? beside_ : turning_);
  const bool is_beside = std::any_of(path->corners.begin(), path->corners.end(), [](Vec2 c) { return std::fabs(c.x) > near_axis; });
  if (path->off_plane || is_beside) count(kind == Kind::drill ? drilling_ : milling_);
}

}  // namespace kadr
