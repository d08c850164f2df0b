#pragma once
// TurnedRun: runs a program that turns a blank. It passes the steps of a session to TurnedCutting and to the collision check of the
// machine's bodies, and the findings to the caller. It is used by cli/cut_turned and view/turned_part.
//
//   TurnedRun run(session, job, {blank, fixtures, {}}, watch);
//   run.attach(stop);       // connects the run to the session's outlets
//   …                       // the caller runs the session
//   run.finish();
//   run.cutting().stock()   // the remaining part

#include <functional>

#include "session/cutting/machine_watch.h"
#include "session/cutting/turned_cutting.h"
#include "session/session.h"
#include "stock/turned/turned_part.h"

namespace kadr {

/// Returns what an exact cut needs, with the chuck and the tailstock of the machine; nullopt if blank or fixtures are not cylinders about
/// X0 Y0 (turned_region_of).
std::optional<TurnedJob> turned_job_of(const MachineProfile& machine, const Setup& setup, const std::string& stock,
                                       const std::vector<std::string>& fixtures);

class TurnedRun {
 public:
  /// `session` and `watch` must outlive the TurnedRun object. The members `offset_now` and `tips` of `turned` are set here. `watch`: the
  /// collision check of the machine's bodies; nullptr: the machine has none.
  TurnedRun(Session& session, const CutJob& cut, TurnedJob turned, MachineWatch* watch = nullptr);
  TurnedRun(const TurnedRun&) = delete;  // not copyable: the session has a pointer to this object

  /// Functions of the caller, as those of CutRun: they receive the reports of the program and the findings of the cut.
  std::function<void(const AlarmReport&)> on_report;
  std::function<void(const CutFinding&, const AlarmReport&)> on_finding;
  std::function<void(const std::string&)> on_note;
  void on_block(std::function<void(const BlockLoad&)> take);
  /// Sets the functions that receive what is removed and the threads, as those of TurnedCutting. `now` is the part after the removal.
  void on_past(std::function<void(const TurnedRemoval&, const TurnedStock& now)> removal, std::function<void(const TurnedThread&)> thread);

  /// Makes this object the observer of the session.
  void attach(const StopToken& stop, ProgressDisplay* progress_display = nullptr);
  /// Declares that no step follows.
  void finish();

  const TurnedCutting& cutting() const { return cutting_; }
  /// Compares the part with the wanted part.
  PartResult part_result(const TurnedComparison& compared) const;
  /// Returns the result with the names of the program files, and with the calls that led to the block of each finding.
  CutResult result() const;
  std::size_t alarms() const { return alarms_; }
  std::size_t warnings() const { return warnings_; }
  /// Returns the alarm at which cutting stopped because the form of a tool is unknown; nullopt if all forms were known.
  const std::optional<AlarmReport>& without_shape() const { return without_shape_; }

 private:
  std::string program_of(std::uint16_t file) const { return file == 0 ? std::string() : session_.settled_control().file_name(file); }
  void name_program(auto& of) const { of.program = program_of(of.origin.file); }
  ToolOffset offset_now(std::uint32_t row) const;
  void consume(const Step& step, double longer);
  /// Calls `take`, which passes a step to the collision check of the machine's bodies, and reports what it has found.
  template <class Take>
  void watch(const Take& take);
  void take(const AlarmReport& report);

  Session& session_;
  TurnedCutting cutting_;
  MachineWatch* const watch_;
  TimeEstimate clock_;
  double later_ = 0;  // delay of the machine's real time compared with the programmed time, s
  std::size_t alarms_ = 0, warnings_ = 0;
  std::optional<AlarmReport> without_shape_;
};

}  // namespace kadr
