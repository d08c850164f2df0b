// A control of your own: a file that extends a built-in one (own.toml), and what its codes do.

#include "open.h"

int main(int argc, char** argv) {
  const auto session = open_session(argc > 1 ? argv[1] : "own.nc", argc > 2 ? argv[2] : "own.toml");
  if (!session) return 2;
  std::printf("%s: %s\n", session->def().id.c_str(), session->def().name.en.c_str());
  session->outlets().step = [](const kadr::Step& step) {
    if (const auto* dwell = std::get_if<kadr::Dwell>(&step.action.what))
      std::printf("N%u dwell %g s\n", step.action.origin.block, dwell->seconds);
    if (const auto* m = std::get_if<kadr::MachineFunction>(&step.action.what)) std::printf("N%u M%u\n", step.action.origin.block, m->code);
  };
  (void)session->run();
  return tell_end(*session);
}
