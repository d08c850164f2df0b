#pragma once
// Checklist: finds problems in a program at which no control would stop (docs/checklist.md). It observes the run of one channel, and
// reads the program's text after the run. Used by kadr check, the page and the report.

#include <vector>

#include "motion/time/steps.h"
#include "session/checklist/feed_watch.h"
#include "session/checklist/hole_watch.h"
#include "session/checklist/level_watch.h"
#include "session/checklist/path_watch.h"
#include "session/checklist/table_check.h"
#include "session/checklist/text_watch.h"
#include "session/checklist/tool_watch.h"
#include "session/session.h"

namespace kadr {

class Checklist {
 public:
  ///   pre  the session has not started
  Checklist(Session& session, std::size_t channel, ChecklistBasis basis = {});
  Checklist(const Checklist&) = delete;  // the session calls back this object
  Checklist& operator=(const Checklist&) = delete;

  /// Subscribes to Outlets::programmed of the channel. A caller that needs this outlet itself forwards the actions to take() instead.
  void attach();
  void take(const Action& action);
  /// Call after the run. Reads the whole text. Returns the findings in the order of the lines, each location once, without the findings
  /// that the set-up disables.
  std::vector<AlarmReport> reports(const StopToken& stop);

 private:
  std::vector<AlarmReport> reports_of(const Advices& advices) const;

  Session& session_;
  const std::size_t channel_;
  ChecklistBasis basis_;
  AxisRoles roles_;
  Steps steps_;
  Advices advices_;
  ToolWatch tools_;
  FeedWatch feeds_;
  HoleWatch holes_;
  LevelWatch levels_;
  PathWatch path_;
};

}  // namespace kadr
