// The interpreter alone: where each feed motion of a program ends.

#include <kadr/kadr.h>

#include <cstdio>
#include <iostream>

int main(int argc, char** argv) {
  const auto def = kadr::load_control("nct");  // or "s2c42", "mach3", "gost", "correctors", a file of your own
  if (!def) return std::cerr << def.error() << '\n', 2;
  const char* const name = argc > 1 ? argv[1] : "part.nc";
  auto source = kadr::open_file(name);
  if (!source) return std::perror(name), 2;
  kadr::Control control(*def, kadr::Setup(), {name, std::move(source), {}}, kadr::RunLimits());
  kadr::ActionBatch batch;
  kadr::Control::State state;
  do {
    state = control.run(batch);
    for (const kadr::Action& action : batch)  // a motion, a dwell, a tool change: one value each
      if (const auto* m = std::get_if<kadr::Motion>(&action.what); m != nullptr && m->kind == kadr::MotionKind::feed)
        std::printf("N%u X%g Y%g Z%g F%g\n", action.origin.block, m->to[0], m->to[1], m->to[2], m->feed);
  } while (state == kadr::Control::State::running);
  if (state == kadr::Control::State::ended) return 0;
  const auto texts = kadr::AlarmTexts::load(&*def);
  std::cerr << kadr::alarm_text(control.report(), *texts, kadr::Lang::en);
  return 1;
}
