#pragma once
// A line on the terminal during long work; nothing elsewhere.

#include <chrono>
#include <string>

#include "session/channel_run.h"

namespace kadr::cli {

class Progress : public Onlooker {
 public:
  explicit Progress(bool quiet);
  /// Leaves nothing on the terminal.
  ~Progress() override;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Something is to be shown; nothing off a terminal.
  bool is_due() const override;
  void show(const Control& control) override;
  /// A part 0..1 of what is to be done, and what that is.
  void show(double part, const std::string& what);

 private:
  using Clock = std::chrono::steady_clock;
  bool on_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace kadr::cli
