// The axes in time: their positions a hundred times a second, in the least time that the machine's limits allow.
//   plan PROGRAM >samples.csv

#include "open.h"

int main(int argc, char** argv) {
  const auto session = open_session(argc > 1 ? argv[1] : "part.nc", "nct");
  if (!session) return 2;
  const kadr::Control& control = session->control();
  kadr::TimeEstimate clock(kadr::AxisRoles::of(control.axes(), control.rotary()),
                           kadr::rates_of(session->machine(), session->setup(), control.axes()));
  session->outlets().clock = &clock;  // what the programmed feeds come to: the planner never goes faster
  kadr::Planned& planned = session->plan(session->own());
  planned.write_samples(stdout, {.rate = 100, .changes = {}});
  (void)session->run();
  if (!planned.finish()) return std::perror("samples"), 2;
  if (planned.time() != nullptr) std::fprintf(stderr, "%.3f s\n", planned.time()->total());
  return tell_end(*session);
}
