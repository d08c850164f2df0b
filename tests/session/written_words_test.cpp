// out/program/words: a written feed means the same in each unit and mode that the program may be in.

#include <gtest/gtest.h>

#include "out/program/words.h"
#include "session/a_session.h"

namespace kadr::written_words_test {
namespace {

using test::ASession;

/// Returns the trace of a motion with this feed word.
std::string trace_with(const std::string& control, const std::string& modes, const std::string& feed) {
  ASession session(control, "%\nO0001\nG90 G17 " + modes + "\nS100 M3\nG0 X0. Y0.\nG1 X1. " + feed + "\nM30\n%\n");
  EXPECT_TRUE(session.opened());
  (void)session->run();
  EXPECT_TRUE(session.reported().empty()) << control << ' ' << modes << ' ' << feed << ": " << session.reported().front();
  return session.trace();
}

// Without a point the feed would be read in hundredths of an inch or of a
// millimetre per revolution (spec/fanuc 1.3), or in thousandths (spec/haas 1.2).
TEST(written_words, a_whole_feed_is_not_taken_for_increments) {
  for (const char* const control : {"fanuc", "haas", "nct", "linuxcnc"})
    for (const char* const modes : {"G21 G94", "G20 G94", "G21 G95", "G20 G95"})
      for (const int feed : {1, 10}) {
        const auto word = Words(*test::shared_control(control), 'F').word(feed);
        ASSERT_TRUE(word);
        const std::string plain = "F" + std::to_string(feed) + ".";
        EXPECT_EQ(trace_with(control, modes, *word), trace_with(control, modes, plain)) << control << ' ' << modes << ' ' << *word;
      }
}

}  // namespace
}  // namespace kadr::written_words_test
