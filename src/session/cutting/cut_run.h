#pragma once
// CutRun: a program carried out on the part: the steps of a session go to the material and to the bodies of the machine, what is found to
// whoever tells it. For cli/cut and view/part_run.
//
//   CutRun run(session, job, watch);
//   run.attach(stop);         // to the session's outlets
//   …                         // whoever drives the session
//   run.finish();
//   run.cutting().stock()     // what is left

#include <functional>

#include "session/cutting/cutting.h"
#include "session/cutting/machine_watch.h"
#include "session/session.h"
#include "stock/part/part_compare.h"

namespace kadr {

class CutRun {
 public:
  /// What it is given must outlive it. `watch`: nullptr: the machine has no bodies.
  CutRun(Session& session, const CutJob& cut, MachineWatch* watch);
  CutRun(const CutRun&) = delete;  // the session calls it back

  /// Of the program itself, alarms, warnings, notes; and a tool without a shape.
  std::function<void(const AlarmReport&)> on_report;
  /// What was hit, and the same as an alarm or a warning with its place.
  std::function<void(const CutFinding&, const AlarmReport&)> on_finding;
  /// What a block took away, with the name of its file. Set before the first step, if at all.
  void on_block(std::function<void(const BlockLoad&)> take);
  /// Sentences about what was taken as it is.
  std::function<void(const std::string&)> on_note;

  /// From now on it looks at the session.
  void attach(const StopToken& stop, Onlooker* onlooker = nullptr);
  /// Nothing follows: all that has come is cut.
  void finish();

  const Cutting& cutting() const { return cutting_; }
  /// With the names of files, and by which calls findings came about.
  CutResult named(CutResult result) const;
  PartResult part_result(const PartComparison& c) const;
  std::size_t alarms() const { return alarms_; }
  std::size_t warnings() const { return warnings_; }
  /// The alarm after which nothing more was cut: a tool has no shape.
  const std::optional<AlarmReport>& without_shape() const { return without_shape_; }

 private:
  /// File of a line, if it is not the program itself; by Origin::file.
  std::string program_of(std::uint16_t file) const { return file == 0 ? std::string() : session_.settled_control().file_name(file); }
  void name_program(auto& of) const { of.program = program_of(of.origin.file); }

  /// After the first tool that cannot be cut with nothing more is.
  void consume(const Step& step, double longer);

  /// What the bodies of the machine meet, told with what the cut finds.
  template <class Take>
  void watch(const Take& take);

  void take(const AlarmReport& report);

  Session& session_;
  Cutting cutting_;
  MachineWatch* const watch_;  // nullptr: the machine has no bodies
  TimeEstimate clock_;
  double later_ = 0;  // s by which the machine is behind the programmed time
  std::size_t alarms_ = 0, warnings_ = 0;
  std::optional<AlarmReport> without_shape_;
};

}  // namespace kadr
