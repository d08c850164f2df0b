// Kadr as a library: reads a program as a 2С42-65 would and prints where each feed motion ends.

#include <cstdio>

#include "kadr/kadr.h"

int main(int argc, char** argv) {
  const auto def = kadr::load_control("s2c42");
  auto source = kadr::open_file(argc > 1 ? argv[1] : "-");
  if (!def || !source) return 2;
  kadr::Control control(*def, kadr::Setup(), {"part.nc", std::move(source), {}}, kadr::RunLimits());
  kadr::ActionBatch batch;
  for (;;) {
    const auto state = control.run(batch);
    for (const kadr::Action& action : batch)
      if (const auto* m = std::get_if<kadr::Motion>(&action.what); m != nullptr && m->kind == kadr::MotionKind::feed)
        std::printf("N%u X%g Y%g Z%g F%g\n", action.origin.block, m->to[0], m->to[1], m->to[2], m->feed);
    if (state == kadr::Control::State::ended) return 0;
    if (state == kadr::Control::State::stopped) {
      std::printf("line %u: %s\n", control.report().origin.line, kadr::name_of(control.report().alarm.id).data());
      return 1;
    }
  }
}
