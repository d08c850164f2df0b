#pragma once
// CutRun: runs a program that cuts a blank. It passes the steps of a session to the stock and to the collision check of the machine's
// bodies, and passes the findings to the caller. It is used by cli/cut and view/part_run.
//
//   CutRun run(session, job, watch);
//   run.attach(stop);         // connects the run to the session's outlets
//   …                         // the caller runs the session
//   run.finish();
//   run.cutting().stock()     // the remaining stock

#include <functional>

#include "session/cutting/cutting.h"
#include "session/cutting/machine_watch.h"
#include "session/session.h"
#include "stock/part/part_compare.h"

namespace kadr {

class CutRun {
 public:
  /// The arguments must outlive the CutRun object. `watch`: the collision check; nullptr: the machine has no bodies.
  CutRun(Session& session, const CutJob& cut, MachineWatch* watch);
  CutRun(const CutRun&) = delete;  // not copyable: the session has a pointer to this object

  /// A function of the caller that receives the alarms, warnings and notes of the program, and the alarm about a tool whose shape is
  /// unknown.
  std::function<void(const AlarmReport&)> on_report;
  /// A function of the caller that receives each collision, together with the alarm or warning that describes the collision and its
  /// location.
  std::function<void(const CutFinding&, const AlarmReport&)> on_finding;
  /// Sets the function of the caller that receives what each block has removed, and the name of the file with that block. To be called
  /// before the first step.
  void on_block(std::function<void(const BlockLoad&)> take);
  /// A function of the caller that receives a sentence about each input value that is questionable but used unchanged.
  std::function<void(const std::string&)> on_note;

  /// Makes this object the observer of the session: replaces the functions in the session's outlets by functions of this object.
  void attach(const StopToken& stop, ProgressDisplay* progress_display = nullptr);
  /// Declares that no step follows. All motions that have not been cut yet are cut now.
  void finish();

  const Cutting& cutting() const { return cutting_; }
  /// Returns the result with the names of the program files, and with the calls that led to the block of each finding.
  CutResult named(CutResult result) const;
  PartResult part_result(const PartComparison& c) const;
  std::size_t alarms() const { return alarms_; }
  std::size_t warnings() const { return warnings_; }
  /// Returns the alarm at which cutting stopped because the shape of a tool is unknown; nullopt if all shapes were known.
  const std::optional<AlarmReport>& without_shape() const { return without_shape_; }

 private:
  /// Returns the name of the file with the number Origin::file; empty for the main program.
  std::string program_of(std::uint16_t file) const { return file == 0 ? std::string() : session_.settled_control().file_name(file); }
  void name_program(auto& of) const { of.program = program_of(of.origin.file); }

  /// Cuts a step. After the first tool without a shape the function only runs the collision check. `longer`: additional time that the
  /// machine needs for the step, s.
  void consume(const Step& step, double longer);

  /// Calls the function `take`, which passes a step to the collision check of the machine's bodies (watch_) and returns the collisions
  /// found. Reports these collisions together with the findings of the stock.
  template <class Take>
  void watch(const Take& take);

  void take(const AlarmReport& report);

  Session& session_;
  Cutting cutting_;
  MachineWatch* const watch_;  // the collision check; nullptr: the machine has no bodies
  TimeEstimate clock_;
  double later_ = 0;  // delay of the machine's real time compared with the programmed time, s
  std::size_t alarms_ = 0, warnings_ = 0;
  std::optional<AlarmReport> without_shape_;
};

}  // namespace kadr
