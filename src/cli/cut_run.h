#pragma once
// CutRun: a program carried out on the part: steps to the material and to the bodies of the machine, findings to the terminal. For cli/cut.

#include <cstdio>

#include "cli/drive.h"
#include "cli/job.h"
#include "cli/progress.h"
#include "session/cutting/cutting.h"
#include "session/cutting/machine_watch.h"
#include "session/session.h"
#include "stock/part/part_compare.h"

namespace kadr::cli {

class CutRun {
 public:
  /// `watch`: nullptr: the machine has no bodies.
  CutRun(const CutOptions& options, const Job& job, Session& session, const CutJob& cut, MachineWatch* watch);

  /// A row a block is written there.
  void write_blocks(std::FILE* file);

  /// To the end of the program, or until it is asked to stop.
  void carry_out(Drive& drive, const StopToken& stop);

  const Cutting& cutting() const { return cutting_; }
  /// With the names of files, and by which calls findings came about.
  CutResult named(CutResult result) const;
  PartResult part_result(const PartComparison& c) const;
  std::size_t alarms() const { return alarms_; }
  std::size_t warnings() const { return warnings_; }

 private:
  /// File of a line, if it is not the program itself; by Origin::file.
  std::string program_of(std::uint16_t file) const { return file == 0 ? std::string() : session_.settled_control().file_name(file); }
  void name_program(auto& of) const { of.program = program_of(of.origin.file); }

  /// After the first tool that cannot be cut with nothing more is.
  void consume(const Step& step, double longer);

  /// What the bodies of the machine meet, told with what the cut finds.
  template <class Take>
  void watch(const Take& take);

  void count(const AlarmReport& report);
  void tell(const AlarmReport& report) const;

  const Job& job_;
  const Lang lang_;
  Session& session_;
  Cutting cutting_;
  MachineWatch* const watch_;  // nullptr: the machine has no bodies
  Progress progress_;
  std::size_t alarms_ = 0, warnings_ = 0;
  bool failed_ = false;
};

}  // namespace kadr::cli
