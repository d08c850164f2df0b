#pragma once
// Progress: shows a progress bar on the terminal during long work; shows nothing if the output is not a terminal.

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
  /// Returns true if it is time to update the progress bar; always false without a terminal.
  bool is_due() const override;
  void show(const Control& control) override;
  /// Shows the fraction done, 0 … 1, and a description of the work.
  void show(double part, const std::string& what);

 private:
  using Clock = std::chrono::steady_clock;
  bool on_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace kadr::cli
