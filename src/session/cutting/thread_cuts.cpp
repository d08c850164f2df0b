// Joins the passes of threading tools into threads. Consecutive passes along the same path that differ only in depth are one thread, even
// if different lines program them. This file is used by session/cutting and tested by tests/run_cut.py.

#include "session/cutting/thread_cuts.h"

#include <algorithm>
#include <cmath>

#include "stock/material_around.h"

namespace kadr {
namespace {

/// True if the insert extends from its tip away from the axis of rotation. Then the tool cuts an outside thread. `x`: signed radius of the
/// tip, mm.
bool cuts_outside(const ToolShape& tool, double x) {
  double beyond = 0;
  for (const InsertBody& body : tool.insert)
    for (const InsertCorner& corner : body.corners) beyond += corner.centre.x;
  return beyond * x >= 0;
}

constexpr double same_place = 0.1;  // greatest distance between passes of one thread if its lead is unknown, mm

/// True if the pass belongs to the thread. When the tool is fed in along the flank, the ends of a pass are less than one thread lead away
/// from those of the previous pass.
bool goes_with(const ThreadCut& pass, const ThreadCut& thread) {
  const double apart = std::max(std::fabs(pass.from_z - thread.from_z), std::fabs(pass.to_z - thread.to_z));
  return pass.tool == thread.tool && pass.lead == thread.lead && pass.is_outer == thread.is_outer &&
         apart < std::max(std::fabs(pass.lead), same_place);
}

}  // namespace

void ThreadCuts::add(const ThreadPass& pass, const ToolShape& tool) {
  ThreadCut one;
  one.origin = pass.origin, one.tool = tool.geometry.number, one.lead = pass.lead;
  one.is_outer = cuts_outside(tool, 0.5 * (pass.from.x + pass.to.x));
  one.from_radius = std::fabs(pass.from.x), one.to_radius = std::fabs(pass.to.x), one.from_z = pass.from.z, one.to_z = pass.to.z;
  one.passes = 1;
  if (threads_.empty() || !goes_with(one, threads_.back())) {
    threads_.push_back(one);
    return;
  }
  ThreadCut& thread = threads_.back();
  const bool deeper = one.is_outer ? one.middle_radius() < thread.middle_radius() : one.middle_radius() > thread.middle_radius();
  one.passes = thread.passes + 1;
  if (deeper) thread = one;
  else thread.passes = one.passes;
}

std::vector<ThreadCut> ThreadCuts::found_in(const Stock& stock) const {
  std::vector<ThreadCut> threads = threads_;
  for (ThreadCut& t : threads)
    if (const auto material = material_around(stock, t.middle_radius(), 0.5 * (t.from_z + t.to_z)))
      t.crest_radius = t.is_outer ? material->outer : material->inner;
  return threads;
}

std::vector<ThreadCut> ThreadCuts::found(const std::function<std::optional<Vec2>(double z)>& radii_at) const {
  std::vector<ThreadCut> threads = threads_;
  for (ThreadCut& t : threads)
    if (const auto radii = radii_at(0.5 * (t.from_z + t.to_z))) t.crest_radius = t.is_outer ? radii->y : radii->x;
  return threads;
}

}  // namespace kadr
