#pragma once
// kadr cut --portion, which cuts a portion of the blank's bricks, and kadr cut --join, which joins what several processes have cut so
// (stock/portion/portion.h). This file is used by cli/cut.

#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include "cli/job/outputs.h"
#include "cli/options/options.h"
#include "session/cutting/cut_run.h"
#include "stock/portion/joined_surface.h"

namespace kadr::cli {

/// Checks --portion and --join, and that no other option contradicts them. If an error occurs, it is printed and the function returns
/// false.
bool portion_options_fit(const CutOptions& options);

/// Determines the bricks that this process cuts, if it cuts a portion or joins portions. If an error occurs, it is printed and the function
/// returns false.
///   pre  job.blank and job.cell are known
bool find_bricks(const CutOptions& options, CutJob& job);

/// Writes the file of a portion, batch by batch.
class PortionOutput {
 public:
  /// Writes the beginning, and makes the cut pass each batch to this object, which must outlive the cut.
  PortionOutput(const CutOptions& options, const Outputs& outputs, CutJob& job);
  PortionOutput(const PortionOutput&) = delete;
  /// Writes the end, after the program. Returns the exit status.
  int finish(const CutJob& job, const Cutting& cutting, const std::optional<Mesh>& part, Outputs& outputs);

 private:
  std::string name_;
  PortionWriter writer_;
};

/// What portions have together, apart from what the cut itself has joined.
struct Joined {
  JoinedSurface surface;
  PartComparison held;
};

/// Reads the files of portions, batch by batch.
class PortionInputs {
 public:
  /// Opens the files. If an error occurs, it is printed and the function returns nullptr.
  ///   job  passes the portions' batches to the cut; the object must outlive the cut
  static std::unique_ptr<PortionInputs> open(const CutOptions& options, CutJob& job);
  /// Joins the rest, after the program, and writes the surface to --out. If an error occurs, it is printed and the function returns
  /// nullopt.
  std::optional<Joined> join(const CutOptions& options, const Outputs& outputs, const Cutting& cutting);

 private:
  using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
  bool fits(const std::vector<PortionHead>& heads, const CutJob& job) const;
  std::optional<std::vector<PortionEnd>> ends(const CutOptions& options, const Cutting& cutting);

  std::vector<File> files_;
  std::vector<PortionReader> readers_;
};

}  // namespace kadr::cli
