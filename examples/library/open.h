#pragma once
// What the other examples have in common: a session of a program, or why there is none.

#include <kadr/kadr.h>

#include <cstdio>
#include <iostream>

/// nullptr: told.
inline std::unique_ptr<kadr::Session> open_session(const char* file, const char* control, const char* machine = "generic") {
  auto def = kadr::load_control(control);
  if (!def) return std::cerr << def.error() << '\n', nullptr;
  auto profile = kadr::load_machine(machine);
  if (!profile) return std::cerr << profile.error() << '\n', nullptr;
  auto source = kadr::open_file(file);
  if (!source) return std::perror(file), nullptr;
  auto session = kadr::Session::open({.control = std::make_shared<const kadr::ControlDef>(std::move(*def)),
                                      .machine = std::move(*profile),
                                      .setup = {},
                                      .program = {file, std::move(source), {}}});
  if (!session) return std::cerr << session.error().fault.en << '\n', nullptr;
  return std::move(*session);
}

/// Status of the program: 0 ran to its end, 1 stopped by an alarm, which is told.
inline int tell_end(const kadr::Session& session) {
  if (!session.stopped().report) return 0;
  const auto texts = kadr::AlarmTexts::load(&session.def());
  std::cerr << kadr::alarm_text(*session.stopped().report, *texts, kadr::Lang::en);
  return 1;
}
