#pragma once
// Checklist: finds problems in a program at which no control would stop (docs/checklist.md). It observes the run of one channel, and reads
// the program's text after the run. It is used by kadr check, the page and the report.

#include <memory>
#include <optional>
#include <vector>

#include "motion/time/steps.h"
#include "session/checklist/feed_watch.h"
#include "session/checklist/hole_watch.h"
#include "session/checklist/lathe_watch.h"
#include "session/checklist/level_watch.h"
#include "session/checklist/path_watch.h"
#include "session/checklist/stored_places.h"
#include "session/checklist/table_check.h"
#include "session/checklist/text_watch.h"
#include "session/checklist/tool_watch.h"
#include "session/session.h"

namespace kadr {

/// A reading of the text that can continue at a place.
struct TextReading {
  TextWatch watch;
  TextWatch::Place place;
};
using TextPlaces = StoredPlaces<TextReading>;

class Checklist {
 public:
  ///   pre  the session has not started
  Checklist(Session& session, std::size_t channel, ChecklistBasis basis = {});
  Checklist(const Checklist&) = delete;  // not copyable: the session has a pointer to this object
  Checklist& operator=(const Checklist&) = delete;

  /// Stores take() as the observer of the programmed contour in the channel's outlets (Outlets::programmed). A caller that needs this
  /// observer itself calls take() for each action instead.
  void attach();
  void take(const Action& action);
  /// Reads the whole text of the program and returns the findings, in the order of the lines. A finding of one type is listed once per
  /// line. Findings that the set-up disables are omitted. Call this function after the run.
  ///   places  the places that an earlier reading has stored; those of this reading are added. May be nullptr
  std::vector<AlarmReport> reports(const StopToken& stop, TextPlaces* places = nullptr);

  /// What the checklist has observed so far.
  struct Memory {
    ToolPosition stands;
    Advices advices;
    ToolWatch tools;
    FeedWatch feeds;
    HoleWatch holes;
    LevelWatch levels;
    PathWatch path;
    LatheWatch lathe;
  };
  Memory memory() const { return {steps_->position(), advices_, tools_, feeds_, holes_, levels_, path_, lathe_}; }
  void resume_from(const Memory& memory);

 private:
  TextWatch read_text(std::shared_ptr<const ControlDef> def, const StopToken& stop, TextPlaces* places) const;
  std::vector<AlarmReport> reports_of(const Advices& advices) const;

  Session& session_;
  const std::size_t channel_;
  ChecklistBasis basis_;
  AxisRoles roles_;
  std::optional<Steps> steps_;  // never empty; it is optional, because Steps cannot be assigned
  Advices advices_;
  ToolWatch tools_;
  FeedWatch feeds_;
  HoleWatch holes_;
  LevelWatch levels_;
  PathWatch path_;
  LatheWatch lathe_;
};

}  // namespace kadr
