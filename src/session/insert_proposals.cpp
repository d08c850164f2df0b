// InsertProposals: finds turning tools in the comments of a program, and makes tools of them. Used by view/proposals; tested by
// tests/session/insert_proposals_test.cpp.

#include "session/insert_proposals.h"

#include <algorithm>

#include "config/tools/insert_keys.h"
#include "path/compensation/nose_tip.h"

namespace kadr {
namespace {

constexpr double assumed_angle = 80, assumed_nose = 0.4, assumed_edge = 10;  // degrees, mm
constexpr double thread_edge = 4, groove_depth = 10;                         // mm
constexpr double groove_nose = 0.2;                                          // mm
constexpr double cutting_share = 0.75;                                       // share of an insert's edge that cuts
constexpr double least_edge_by_nose = 4;                                     // an insert has edges at least this many nose radii long
constexpr std::uint32_t offsets_of_turret = 100;                             // T0101 is tool 1 with offset 1

/// How much a comment tells: a designation or a width tells more than words.
int worth(const InsertProposal& p) { return (p.insert.has_code || p.insert.width ? 2 : 0) + (p.insert.corner ? 1 : 0); }

/// Returns the entering angle of the usual holder for an insert of this nose angle.
double usual_lead(double angle) { return angle >= 90 ? 75 : angle >= 75 ? 95 : angle >= 60 ? 91 : 93; }

/// Sets the direction of the tip, by the row of the offset table if it states one.
void take_tip(const InsertComment& comment, const ToolOffset* row, InsertGeometry& insert) {
  const double number = row == nullptr ? 0 : row->tip_position;
  if (number >= 1 && number <= 8) {
    const Vec2 tip = nose_vector(std::uint8_t(number), 1);  // Z, X
    insert.tip_z = tip.x > 0.5 ? 1 : tip.x < -0.5 ? -1 : 0;
    insert.tip_x = tip.y > 0.5 ? 1 : tip.y < -0.5 ? -1 : 0;
    return;
  }
  insert.tip_x = comment.inside ? 1 : -1;
  insert.tip_z = comment.work == InsertWork::threading ? 0 : -1;
}

}  // namespace

InsertProposals::InsertProposals(const ProgramLines& lines, bool inch) {
  for (const auto& [number, text] : lines)
    for (const std::string& comment : comments_of(text)) {
      InsertComment insert = read_insert_comment(comment, inch);
      if (insert.work == InsertWork::none) continue;
      auto tool = read_tool_comment(comment, inch).tool;
      if (tool && *tool >= offsets_of_turret) *tool /= offsets_of_turret;
      read_.push_back({insert, tool, number, comment});
    }
}

std::optional<InsertProposal> InsertProposals::of(std::uint32_t tool, std::uint32_t called_at) const {
  const InsertProposal* best = nullptr;
  const auto take = [&](const auto& fits) {
    for (const InsertProposal& p : read_)
      if (fits(p) && (best == nullptr || worth(p) > worth(*best))) best = &p;
  };
  take([&](const InsertProposal& p) { return p.tool == tool; });
  if (best == nullptr && called_at != 0)
    take([&](const InsertProposal& p) { return !p.tool && p.line + 1 >= called_at && p.line <= called_at + 1; });
  return best == nullptr ? std::nullopt : std::optional(*best);
}

std::optional<ToolGeometry> insert_of_comment(const InsertComment& comment, std::uint32_t tool, const ToolOffset* row) {
  ToolGeometry g;
  g.number = tool;
  g.kind = ToolKind::turning;
  const double stated = row == nullptr ? 0 : row->whole_radius();
  take_tip(comment, row, g.insert);
  if (comment.work == InsertWork::grooving) {
    if (!comment.width) return std::nullopt;
    g.insert.width = *comment.width;
    g.corner = std::min(stated > 0 ? stated : comment.corner.value_or(groove_nose), *comment.width / 2);
    g.flutes = groove_depth;
    if (comment.face) g.insert.lead = 0;
    else if (g.insert.tip_x != 0 && g.insert.tip_z != 0) g.insert.lead = 90;
  } else {
    g.corner = stated > 0 ? stated : comment.corner.value_or(comment.work == InsertWork::threading ? 0 : assumed_nose);
    g.angle = comment.angle.value_or(assumed_angle);
    const double edge = comment.work == InsertWork::threading ? thread_edge : comment.edge.value_or(assumed_edge);
    g.flutes = std::max(comment.edge ? edge * cutting_share : edge, least_edge_by_nose * g.corner);
    if (g.angle == 0) g.flutes = 0, g.insert.tip_x = g.insert.tip_z = 0;
    else if (g.insert.tip_x != 0 && g.insert.tip_z != 0) g.insert.lead = usual_lead(g.angle);
    if (comment.edge) g.length = std::max(edge, g.flutes);
  }
  complete_insert(g);
  if (g.length < g.flutes) g.length = g.flutes;
  return g;
}

}  // namespace kadr
