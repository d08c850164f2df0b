// session/planned: a dry run takes as long as the same program with the dry-run feed written in it.

#include <cmath>

#include "session/a_session.h"
#include "session/planned.h"

namespace kadr::dry_run_test {
namespace {

using test::ASession;

/// Returns the planned seconds of all feed motions. `dry` is in mm/min; 0 means as programmed.
double cutting_seconds(const std::string& control, const std::string& program, double dry) {
  ASession session(control, program);
  EXPECT_TRUE(session.opened());
  Planned& planned = session->plan(session->own());
  planned.run_dry(dry);
  (void)session->run();
  EXPECT_TRUE(planned.finish());
  EXPECT_TRUE(session.reported().empty());
  EXPECT_NE(planned.time(), nullptr);
  return planned.time() == nullptr ? 0 : planned.time()->cutting.all;
}

struct Case {
  const char* what;
  const char* control;
  std::string before, feeds, after;  // the program; for comparison G94 and the dry-run feed replace `feeds`
};

const Case cases[] = {
    {"lines", "mach3", "G21 G90 G17\nG0 X0 Y0\n", "G94 F20", "G1 X30\nG1 X40 Y40\nX0\nM30\n"},
    {"arcs", "mach3", "G21 G90 G91.1 G17\nG0 X0 Y0\n", "G94 F20", "G2 X40 I20 J0\nG3 X0 I-20 J0 Z5\nM30\n"},
    {"a feed faster than the dry one", "mach3", "G21 G90 G17\nG0 X0 Y0\n", "G94 F3000", "G1 X30\nY40\nM30\n"},
    {"a feed per revolution", "nct", "G21 G90 G17\nG0 X0 Y0\nM3 S100\n", "G95 F0.1", "G1 X30\nY40\nM30\n"},
    {"a feed per revolution at a constant surface speed", "nct", "G21 G90 G17\nG0 X50 Y0\nG96 S20 M3\n", "G95 F0.1", "G1 X30\nY40\nM30\n"},
};

TEST(dry_run, takes_as_long_as_with_the_feed_written) {
  for (const Case& one : cases) {
    const double programmed = cutting_seconds(one.control, one.before + one.feeds + "\n" + one.after, 0);
    const double dry = cutting_seconds(one.control, one.before + one.feeds + "\n" + one.after, 600);
    const double written = cutting_seconds(one.control, one.before + "G94 F600\n" + one.after, 0);
    EXPECT_NEAR(dry, written, 1e-6 * written) << one.what;
    EXPECT_GT(std::fabs(programmed - dry), 0.3 * dry) << one.what << ": the case shows nothing";
  }
}

// G33 is synchronous with the spindle, and the dry run does not change the spindle.
TEST(dry_run, leaves_threads_as_they_are) {
  const std::string thread = "G21 G90 G17\nG0 X0 Y0 Z0\nM3 S300\nG33 Z-20 F1\nM30\n";
  EXPECT_NEAR(cutting_seconds("nct", thread, 600), cutting_seconds("nct", thread, 0), 1e-9);
}

}  // namespace
}  // namespace kadr::dry_run_test
