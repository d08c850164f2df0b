// A program block by block: before each one its line, and where the tool stands.

#include "open.h"

int main(int argc, char** argv) {
  const auto session = open_session(argc > 1 ? argv[1] : "part.nc", "nct");
  if (!session) return 2;
  kadr::Stepping stepping(*session);
  while (stepping.go(kadr::Stepping::How::block) == kadr::Session::State::held) {
    const kadr::Axes at = session->control().tool_position().work;
    std::printf("before line %u: X%g Y%g Z%g\n", stepping.next()->line, at[0], at[1], at[2]);
  }
  return tell_end(*session);
}
