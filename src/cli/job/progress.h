#pragma once
// Progress: shows a progress bar on the terminal while a command works for a long time. Nothing is shown if the output is not a terminal.

#include <chrono>
#include <string>

#include "session/channel_run.h"

namespace kadr::cli {

class Progress : public ProgressDisplay {
 public:
  explicit Progress(bool quiet);
  /// Removes the progress bar.
  ~Progress() override;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// True if the progress bar is due for an update. Always false without a terminal.
  bool is_due() const override;
  void show(const Control& control) override;
  /// Shows the completed fraction (0 to 1) of the work, and a description of the work.
  void show(double part, const std::string& what);

 private:
  using Clock = std::chrono::steady_clock;
  bool on_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace kadr::cli
