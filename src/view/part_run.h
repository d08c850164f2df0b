#pragma once
// PartRun: cuts a blank with a program, for the page. It finds collisions, the remaining stock, and the state of the part at any instant
// (docs/panel-protocol.md: cut, part).
//
//   PartRequest ─ PartRun::make() ─▶ its own session ─ CutRun ─▶ two stocks: a fine one as in `kadr cut`, for volumes and findings,
//                                                              and a coarser one that records its history, for display

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "session/cutting/cut_run.h"
#include "view/opening.h"
#include "view/progress_clock.h"

namespace kadr {

/// The blank, fixtures and tools of a cut. Solids are descriptions for body_of(), in which files are paths in the file system.
struct PartRequest {
  std::string stock;
  std::vector<std::string> fixtures;
  std::vector<std::string> fixture_names;  // names of the fixtures as the page displays them
  ToolLibrary tools;
  double resolution = 0;  // cell size of the stock in mm; 0 if Kadr is to choose it
};

/// The remaining stock at an instant.
struct PartThen {
  double seconds = 0;  // the instant in s; at most the end of the program
  double stock = 0;    // volume of the blank, mm³
  double left = 0;
  double cell = 0;  // cell size of the displayed stock, mm
  Surface surface;  // surface of the stock, in the work coordinates of the blank
};

class PartRun {
 public:
  static constexpr double max_bytes = 400e6;  // memory limit in bytes for both stocks, including the earlier states of the displayed stock

  /// Creates a run.
  ///   opened   the program; must outlive this object
  ///   returns  the run, or an error sentence
  static tl::expected<std::unique_ptr<PartRun>, std::string> make(const OpenedProgram& opened, const PartRequest& request,
                                                                  const StopToken& stop);

  /// A function of the client that receives the progress of the run, from 0 to 1. PartRun calls this function several times per second.
  std::function<void(double part)> on_progress;
  std::function<void(const CutFinding&, const AlarmReport&)> on_finding;

  /// Runs the program to its end, or to an alarm.
  ///   returns  an error sentence if the run was stopped, memory ran out, or the shape of a tool is unknown
  tl::expected<void, std::string> execute();

  // ---- functions that return the results of the run; to be called after execute()
  const CutResult& result() const { return result_; }
  /// Returns the number of alarms, and that of warnings, that the program itself has caused.
  std::size_t alarms() const { return run_->alarms(); }
  std::size_t warnings() const { return run_->warnings(); }
  /// Sentences about mesh files that were repaired, and about questionable input that was used unchanged.
  const std::vector<std::string>& notes() const { return notes_; }
  PartThen at(double instant) const;
  /// Converts a state of the stock to a binary frame of kind 3.
  std::string frame_of(const PartThen& then) const;

 private:
  PartRun(const OpenedProgram& opened, const StopToken& stop) : opened_(opened), stop_(stop) {}
  tl::expected<void, std::string> find_material(const PartRequest& request);
  tl::expected<std::shared_ptr<const Blank>, std::string> body(const std::string& text);
  tl::expected<void, std::string> open_session(const PartRequest& request);
  tl::expected<void, std::string> fault() const;
  void report_progress();

  const OpenedProgram& opened_;
  StopToken stop_;
  CutJob job_;
  std::vector<std::string> notes_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<MachineWatch> watch_;
  std::unique_ptr<CutRun> run_;
  CutResult result_;
  ProgressClock progress_clock_;
  bool too_much_ = false;  // true if the run has exceeded the memory limit
};

}  // namespace kadr
