#pragma once
// DriveProgram: the program of kadr drive as a text for Grbl. A program of another control is converted, with proof, before.

#include <memory>
#include <optional>

#include "cli/job/job.h"
#include "drive/grbl/grbl_job.h"

namespace kadr::cli {

class DriveProgram {
 public:
  /// Loads the program that the options name. Prints errors and returns nullptr.
  static std::unique_ptr<DriveProgram> load(const DriveOptions& options);

  /// Opens the program as a job, for a controller with these settings and at this position. Prints an error and returns nullptr if the
  /// set-up does not fit.
  std::unique_ptr<drive::GrblJob> open(const drive::GrblSettings& settings, const std::optional<drive::GrblPoint>& position) const;
  /// Opens the rest of the program as a job, which begins with the lines of `restart`.
  std::unique_ptr<drive::GrblJob> open(const drive::GrblSettings& settings, const std::optional<drive::GrblPoint>& position,
                                       const drive::GrblRestart& restart) const;
  /// Returns the program from a line on. Prints an error and returns nullopt if it cannot continue there.
  std::optional<drive::GrblRestart> restart(const drive::GrblSettings& settings, const drive::GrblRestartPlan& plan) const;
  /// Prints an alarm of the program.
  void print(const AlarmReport& alarm) const;
  const Job& job() const { return job_; }
  const Setup& setup() const { return setup_; }

 private:
  DriveProgram(Job job, const RunLimits& limits) : job_(std::move(job)), limits_(limits) {}
  bool convert();
  bool stop_for_tools();
  std::unique_ptr<drive::GrblJob> open(const Setup& setup, const drive::GrblText& text) const;
  std::unique_ptr<Session> session(std::shared_ptr<ByteSource> text, const Setup& setup) const;

  Job job_;
  RunLimits limits_;
  std::shared_ptr<const ControlDef> grbl_;
  std::shared_ptr<ByteSource> text_;  // the text for Grbl
  std::set<std::uint32_t> tools_;     // lines with M6, at which Kadr stops
  Setup setup_;                       // the set-up for this text, as far as the user states it
};

}  // namespace kadr::cli
