// RunHistory: a search back that is interrupted at every block finds the block that an uninterrupted search finds.

#include "lsp/run_history.h"

#include <atomic>

#include "session/a_session.h"

namespace kadr::run_history_test {
namespace {

/// A program in a loop of 4000 passes, run to its end, with stop points and the snapshots of the way.
struct ARun {
  test::ASession session;
  Stepping stepping;
  RunHistory history;

  explicit ARun(const std::vector<StopPoint>& points)
      : session("fanuc", "O1\nG21 G90 F100\n#1=0\nWHILE[#1LT4000]DO1\n#1=#1+1\nG1 X#1\nEND1\nM30\n"),
        stepping(*session),
        history((stepping.go(Stepping::How::block), *session), stepping) {
    stepping.begin(Stepping::How::free);
    while (session->go_on() == Session::State::running) history.note();
    for (const StopPoint& point : points) stepping.add(point);
  }

  /// Goes back to the last stop. `interrupted`: the search ends at each block and is continued.
  std::pair<std::uint32_t, std::size_t> search(bool interrupted) {
    const std::atomic<bool> requested = true;
    const StopToken stop = interrupted ? StopToken(requested) : StopToken();
    RunHistory::Search search = history.begin_search();
    if (interrupted)
      stepping.on_block = [&](const Origin&) {
        if (search.inside) stepping.hold_next();
      };
    std::size_t calls = 1;
    const auto any = [](std::size_t) { return true; };
    for (auto state = history.search(search, any, stop); state && !*state; state = history.search(search, any, stop)) ++calls;
    stepping.on_block = nullptr;
    return {stepping.next() ? stepping.next()->number : 0, calls};
  }
};

TEST(RunHistory, an_interrupted_search_finds_the_same_block) {
  for (const std::vector<StopPoint>& points : {std::vector<StopPoint>{{.line = 6, .condition = "#1 EQ 3210"}},
                                               {{.line = 6, .condition = "#1 EQ 3"}},
                                               {{.line = 5}},
                                               {{.line = 6, .condition = "#1 LT 100"}, {.line = 5, .condition = "#1 EQ 2000"}},
                                               {{.condition = "#1 EQ 1500"}}}) {
    ARun plain(points), interrupted(points);
    const auto [wanted, few] = plain.search(false);
    const auto [found, many] = interrupted.search(true);
    EXPECT_GT(wanted, 0U);
    EXPECT_EQ(found, wanted);
    EXPECT_GT(many, few) << "the search was not interrupted";
    EXPECT_EQ(interrupted.stepping.next()->line, plain.stepping.next()->line);
  }
}

}  // namespace
}  // namespace kadr::run_history_test
