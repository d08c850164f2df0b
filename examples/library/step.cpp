// A program block by block: stops before each one and tells its line and where the tool stands.

#include <utility>

#include "open.h"

int main(int argc, char** argv) {
  const auto session = open_session(argc > 1 ? argv[1] : "part.nc", "nct");
  if (!session) return 2;
  kadr::Control& control = session->control();
  kadr::Origin next;
  bool may_pass = false;
  control.holds_before = [&](const kadr::Origin& block) {
    next = block;
    return !std::exchange(may_pass, false);
  };
  for (;;) {
    const auto state = session->go_on();
    if (state == kadr::Session::State::running) continue;
    if (state != kadr::Session::State::held) return tell_end(*session);
    const kadr::Axes at = control.tool_position().work;
    std::printf("before line %u: X%g Y%g Z%g\n", next.line, at[0], at[1], at[2]);
    may_pass = true;
  }
}
