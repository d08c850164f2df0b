#pragma once
// CutRun: runs a program on the part. It passes the steps of a session to the material and to the bodies of the machine, and the findings
// to the caller. Used by cli/cut and view/part_run.
//
//   CutRun run(session, job, watch);
//   run.attach(stop);         // to the session's outlets
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
  /// The arguments must outlive this object. `watch`: nullptr if the machine has no bodies.
  CutRun(Session& session, const CutJob& cut, MachineWatch* watch);
  CutRun(const CutRun&) = delete;  // the session calls it back

  /// Receives alarms, warnings and notes of the program, and the alarm about a tool without a shape.
  std::function<void(const AlarmReport&)> on_report;
  /// Receives a collision, and the same as an alarm or warning with its location.
  std::function<void(const CutFinding&, const AlarmReport&)> on_finding;
  /// Receives what a block has removed, with the name of its file. Set before the first step.
  void on_block(std::function<void(const BlockLoad&)> take);
  /// Receives sentences about input that is used as it is.
  std::function<void(const std::string&)> on_note;

  /// Subscribes to the outlets of the session.
  void attach(const StopToken& stop, Onlooker* onlooker = nullptr);
  /// States that nothing follows: cuts everything that is still pending.
  void finish();

  const Cutting& cutting() const { return cutting_; }
  /// Completes the result with the names of files, and with the calls that led to the findings.
  CutResult named(CutResult result) const;
  PartResult part_result(const PartComparison& c) const;
  std::size_t alarms() const { return alarms_; }
  std::size_t warnings() const { return warnings_; }
  /// The alarm at which cutting stopped, because a tool has no shape.
  const std::optional<AlarmReport>& without_shape() const { return without_shape_; }

 private:
  /// File of a line by Origin::file; empty for the program itself.
  std::string program_of(std::uint16_t file) const { return file == 0 ? std::string() : session_.settled_control().file_name(file); }
  void name_program(auto& of) const { of.program = program_of(of.origin.file); }

  /// Does nothing after the first tool without a shape.
  void consume(const Step& step, double longer);

  /// Reports collisions of the machine's bodies together with the findings of the cut.
  template <class Take>
  void watch(const Take& take);

  void take(const AlarmReport& report);

  Session& session_;
  Cutting cutting_;
  MachineWatch* const watch_;  // nullptr: the machine has no bodies
  TimeEstimate clock_;
  double later_ = 0;  // s by which the machine is later than the programmed time
  std::size_t alarms_ = 0, warnings_ = 0;
  std::optional<AlarmReport> without_shape_;
};

}  // namespace kadr
