#pragma once
// GrblDriver: a GrblLink connected to a port, a clock and a black box. The owner calls step() in a loop, and hold() or stop() between two
// calls; a step lasts at most as long as the owner says, so that a press acts soon.

#include <chrono>
#include <functional>
#include <memory>

#include "drive/grbl/grbl_job.h"
#include "drive/grbl/grbl_link.h"
#include "drive/port/black_box.h"
#include "drive/port/byte_port.h"

namespace kadr::drive {

class GrblDriver {
 public:
  ///   log  nullptr: nothing is recorded
  GrblDriver(std::unique_ptr<BytePort> port, BlackBox* log, const LinkOptions& options);

  /// Waits at most `seconds` for bytes, passes them to the link, and sends what the link wants to send.
  ///   returns  the events since the last step
  std::vector<LinkEvent> step(double seconds);
  /// Sends now what the link wants to send, without waiting for the next step.
  void flush();
  GrblLink& link() { return link_; }
  /// Seconds since the driver was created.
  double now() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }
  /// Time since the last report of the controller, s.
  double age() const { return now() - link_.view().reported_at; }

 private:
  std::unique_ptr<BytePort> port_;
  BlackBox* log_;
  GrblLink link_;
  std::string received_;  // received bytes of a line that is not complete, for the log
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// Offers the lines of a job to the link as it asks for them, and ends the job after the last one.
void feed(GrblLink& link, GrblJob& job);

}  // namespace kadr::drive
