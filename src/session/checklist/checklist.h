#pragma once
// Checklist: what is wrong with a program though no control would stop at it (docs/checklist.md). It watches a run, and reads the text once
// more when that is over. Of one channel. For kadr check, the page and the report.

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
  /// Of a session that has not begun.
  Checklist(Session& session, std::size_t channel, ChecklistBasis basis = {});
  Checklist(const Checklist&) = delete;  // the session calls it back
  Checklist& operator=(const Checklist&) = delete;

  /// It takes what Outlets::programmed of the channel gives; who needs that outlet for himself calls take() from it.
  void attach();
  void take(const Action& action);
  /// After the run: in the order of the lines, each place once; what the set-up disables is left out. Reads the whole text.
  std::vector<AlarmReport> reports(const StopToken& stop);

 private:
  std::vector<AlarmReport> told(const Advices& advices) const;

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
