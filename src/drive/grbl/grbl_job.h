#pragma once
// GrblJob: a program for Grbl as the lines of a job. Each line is executed by Kadr's interpreter before it is sent, so its path, its time
// and its effect are known. The program is read as it is needed: memory does not grow with its length.
//
//   text ──filter of protocol.c──▶ line as it is sent ─┐
//   Session ──steps of the line──▶ path, time, kind ───┴─▶ JobLine

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "drive/grbl/grbl_restart.h"
#include "drive/grbl/grbl_settings.h"
#include "drive/grbl/job_line.h"
#include "drive/grbl/job_needs.h"
#include "session/session.h"

namespace kadr::drive {

class GrblJob {
 public:
  /// `session` has the program and has not begun; `text` is the text of the same program.
  ///   tools  the lines whose stop is a tool change (with_tool_stops())
  GrblJob(std::unique_ptr<Session> session, GrblText text, std::set<std::uint32_t> tools = {});

  /// Returns the next line, nullopt at the end. A line without words is left out.
  ///
  /// After a probe motion there is an end too, because only the machine knows where it ended: continues_at() then is the line from which a
  /// new job must be made.
  std::optional<JobLine> next();
  std::optional<std::uint32_t> continues_at() const { return continues_at_; }
  /// Lets next() go on after a probe motion as if it had touched at its end. For looking at the whole program.
  void pass_probes() { passes_probes_ = true; }
  /// What the lines returned so far need. After the last one, the program as a whole.
  const JobNeeds& needs() const { return needs_; }

 private:
  struct OfLine {
    double seconds = 0;
    std::vector<GrblPoint> path;
    bool stops = false, probes = false;
  };
  void take(const Step& step, double longer);
  void add_path(const Step& step, const Motion& motion, OfLine& line);
  void run_past(std::uint32_t line);
  void push(JobLine line);

  GrblText text_;
  std::set<std::uint32_t> tools_;
  LineReader reader_;
  std::unique_ptr<Session> session_;
  std::map<std::uint32_t, OfLine> steps_;  // what the lines do that were executed and not returned yet
  std::uint32_t alarm_line_ = 0;           // line of the text with the alarm
  std::uint32_t first_at_ = 0;             // line of the text with the first motion
  std::uint32_t executed_ = 0;             // last line of which a step has come
  bool ended_ = false, passes_probes_ = false;
  std::optional<std::uint32_t> continues_at_;
  std::deque<JobLine> ready_;
  JobNeeds needs_;
};

/// Executes the whole job.
JobNeeds needs_of(GrblJob& job, const StopToken& stop);

/// Returns the set-up with which Kadr executes a program exactly as this controller will: its settings, offsets and position replace
/// those of `setup`. Settings that the control's table of parameters does not have are left out.
///   position  machine coordinates, mm
Setup setup_of_controller(Setup setup, const GrblSettings& settings, const std::optional<GrblPoint>& position, const ControlDef& control);

}  // namespace kadr::drive
