// A job that lasts for hours of the double's clock: every line is executed once and in order, and nothing in the link grows with the job.

#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdlib>

#include "drive/link_rig.h"

namespace kadr::drive::grbl_stream_test {

using test::LinkRig;

/// A job without an end, line by line: short and long motions, dwells, codes and stops.
class LongJob {
 public:
  JobLine next() {
    JobLine line;
    line.number = ++number_;
    const GrblPoint from = at_;
    at_ = {std::round(std::sin(number_ * 0.01) * 40'000) / 1000, std::round(std::cos(number_ * 0.013) * 30'000) / 1000,
           -0.001 * (number_ % 100)};
    line.text = fmt::format("G90G1X{:.3f}Y{:.3f}Z{:.3f}F3000", at_[0], at_[1], at_[2]);
    if (number_ % 997 == 0) line = {"M0", number_, LineKind::stop, 0, {}};
    else if (number_ % 101 == 0) line = {"G4P0.05", number_, LineKind::plain, 0.05, {}};
    else if (number_ % 103 == 0) line = {fmt::format("M3S{}", number_ % 1000 + 1), number_, LineKind::plain, 0, {}};
    else {
      double length = 0;
      for (std::size_t i = 0; i < grbl_axes; ++i) length = std::hypot(length, at_[i] - from[i]);
      line.seconds = length / 50;
      line.path = {from, at_};
      return line;
    }
    at_ = from;
    return line;
  }

 private:
  std::uint32_t number_ = 0;
  GrblPoint at_{};
};

/// KADR_DRIVE_HOURS sets the hours of the double's clock.
TEST(GrblStream, RunsForHoursAndNothingGrows) {
  const char* const wanted = std::getenv("KADR_DRIVE_HOURS");
  const double hours = wanted != nullptr ? std::atof(wanted) : 0.1;
  LinkOptions options;
  options.line_rate = 11520;
  LinkRig rig(options);
  ASSERT_TRUE(rig.connect());
  ASSERT_TRUE(rig.link.begin_job());
  LongJob job;
  std::uint64_t offered = 0, executed = 0;
  std::size_t most_kept = 0, used_after_a_minute = 0;
  const double begin = rig.machine.now;
  for (int minute = 0; minute < hours * 60; ++minute) {
    while (rig.machine.now < begin + 60 * (minute + 1)) {
      for (; rig.link.wants_line(); ++offered) rig.link.offer(job.next());
      rig.tick();
      most_kept = std::max(most_kept, rig.link.lines_kept());
      for (const LinkEvent& event : rig.events) {
        ASSERT_NE(event.kind, LinkEventKind::fault) << name_of(event.fault) << ' ' << event.text << " after " << rig.machine.now << " s";
        if (event.kind == LinkEventKind::stop_reached) rig.link.resume();
      }
      rig.forget_events();
    }
    executed += rig.machine.executed.size();
    rig.machine.executed = {};
    rig.machine.states = {};
    rig.sent_lines = {};
    if (minute == 0) used_after_a_minute = ::mallinfo2().uordblks;
  }
  EXPECT_LE(most_kept, 400U) << "64 that wait, and what 419 lines/s bring between two reports, while the tracker is late";
  const std::size_t used = ::mallinfo2().uordblks;  // 0 under a sanitizer
  EXPECT_LE(used, used_after_a_minute + 100'000) << offered << " lines";
  EXPECT_GE(rig.link.view().accepted, executed) << "a line was executed twice";
  EXPECT_EQ(rig.machine.dropped, 0U);
  EXPECT_GT(executed, static_cast<std::uint64_t>(hours * 3600));
  RecordProperty("lines", std::to_string(executed));
  RecordProperty("bytes_in_use", std::to_string(used));
}

}  // namespace kadr::drive::grbl_stream_test
