// machine/plc: the commands that the events of a set-up give, and their effect on a control. tests/golden/README.md, "Events".

#include "machine/plc.h"

#include <gtest/gtest.h>

#include "config/control/control_file.h"
#include "session/plc_commands.h"

namespace kadr::plc_test {
namespace {

std::vector<SetupEvent> events(const std::string& json) {
  const auto setup = parse_setup(R"({"events": [)" + json + "]}");
  EXPECT_TRUE(setup) << setup.error();
  return setup ? setup->events : std::vector<SetupEvent>();
}

/// Returns a command as a short text, so that lists of commands can be compared.
std::string name_of(const PlcCommand& command) {
  if (const auto* s = std::get_if<SetSignal>(&command)) return s->name + "=" + std::to_string(int(s->value));
  if (const auto* s = std::get_if<SetSkip>(&command)) return "skip " + std::to_string(s->number) + (s->on ? " on" : " off");
  if (const auto* a = std::get_if<AnswerBox>(&command)) return "answer " + std::to_string(int(a->value));
  if (const auto* s = std::get_if<Synchronise>(&command)) return std::to_string(s->slave) + " follows " + std::to_string(s->master);
  if (const auto* c = std::get_if<CoupleAxes>(&command))
    return c->axes.front() + (c->axes.size() > 1 ? c->axes[1] : "") + (c->on ? " on" : " off");
  if (const auto* c = std::get_if<ConvertSpindle>(&command)) return (c->to_axis ? "axis " : "spindle ") + std::to_string(c->number);
  return std::holds_alternative<PowerCycle>(command) ? "power" : "start";
}

std::string names_of(const std::vector<PlcCommand>& commands) {
  std::string all;
  for (const PlcCommand& command : commands) all += (all.empty() ? "" : ", ") + name_of(command);
  return all;
}

Origin block(std::uint32_t number, bool main_block = false) {
  Origin origin;
  origin.block = number;
  origin.has_block = true;
  origin.main_block = main_block;
  return origin;
}

template <class What>
Action action(What what) {
  return {Origin(), what};
}

const char* const start = R"("do": "start"})";

TEST(plc, blocks) {
  Plc plc(events(R"({"when": {"block": "N30"}, "do": "set", "signal": "CP_MINT", "value": 1},
                    {"when": {"block": "N30", "at": "end"}, "do": "set", "signal": "CP_MINT", "value": 0},
                    {"when": {"block": ":30"}, "do": "set", "signal": "CP_NOWT", "value": 1})"));
  EXPECT_EQ(plc.error(), "");
  EXPECT_EQ(names_of(plc.block(block(30), false)), "CP_MINT=1");
  EXPECT_EQ(names_of(plc.block(block(30), true)), "CP_MINT=0");
  EXPECT_EQ(names_of(plc.block(block(30, true), false)), "CP_NOWT=1");
  EXPECT_EQ(names_of(plc.block(block(31), false)), "");
  EXPECT_EQ(names_of(plc.block(Origin(), false)), "");  // no block number
}

TEST(plc, every_code_that_the_machine_is_told) {
  const std::pair<const char*, Action> codes[] = {{"M90", action(MachineFunction{90})},
                                                  {"M3", action(Spindle{SpindleDir::cw, 100})},
                                                  {"M04", action(Spindle{SpindleDir::ccw, 100})},
                                                  {"M5", action(Spindle{SpindleDir::stop, 0})},
                                                  {"M19", action(Spindle{SpindleDir::orient, 0})},
                                                  {"M7", action(CoolantSwitch{Coolant::mist})},
                                                  {"M8", action(CoolantSwitch{Coolant::flood})},
                                                  {"M9", action(CoolantSwitch{Coolant::off})},
                                                  {"M0", action(Stop{false})},
                                                  {"M1", action(Stop{true})},
                                                  {"M6", action(ToolChange{5})},
                                                  {"T5", action(ToolSelect{5, 0})},
                                                  {"S1200", action(Speed{1200, false})},
                                                  {"B45", action(AuxiliaryFunction{'B', 45})}};
  for (const auto& [code, seen] : codes) {
    Plc plc(events(R"({"when": {"code": ")" + std::string(code) + "\"}, " + start));
    EXPECT_EQ(plc.error(), "") << code;
    for (const auto& [other, what] : codes)
      EXPECT_EQ(plc.action(what).size(), std::string(code) == other ? 1u : 0u) << code << ' ' << other;
  }
}

TEST(plc, n_th_time_of_each_event) {
  Plc plc(events(R"({"when": {"code": "M90", "count": 3}, "do": "skip", "switch": 8, "on": false},
                    {"when": {"code": "M90"}, "do": "set", "signal": "CP_MINT", "value": 1},
                    {"when": {"code": "M90", "count": 1}, "do": "skip", "switch": 8, "on": true})"));
  const Action m90 = action(MachineFunction{90});
  EXPECT_EQ(names_of(plc.action(m90)), "CP_MINT=1, skip 8 on");
  EXPECT_EQ(names_of(plc.action(m90)), "CP_MINT=1");
  EXPECT_EQ(names_of(plc.action(m90)), "skip 8 off, CP_MINT=1");
  EXPECT_EQ(names_of(plc.action(m90)), "CP_MINT=1");
}

TEST(plc, messages_and_stops) {
  Plc plc(events(R"({"when": {"action": "message"}, "do": "answer", "answer": "no"},
                    {"when": {"action": "message"}, "do": "set", "signal": "CP_MINT", "value": 1},
                    {"when": {"action": "stop"}, "do": "start"})"));
  EXPECT_EQ(names_of(plc.action(action(Message{"", 200, true}))), "answer 3, CP_MINT=1");
  EXPECT_EQ(names_of(plc.action(action(Message{"", 5, false}))), "CP_MINT=1");  // nothing to answer
  EXPECT_EQ(names_of(plc.action(action(Stop{false, StopReason::message}))), "start");
  EXPECT_EQ(names_of(plc.program_end()), "");
}

TEST(plc, answers) {
  const std::pair<const char*, const char*> answers[] = {
      {"cancel", "answer 0"}, {"ok", "answer 1"}, {"yes", "answer 2"}, {"no", "answer 3"}};
  for (const auto& [answer, command] : answers) {
    Plc plc(events(R"({"when": {"action": "message"}, "do": "answer", "answer": ")" + std::string(answer) + "\"}"));
    EXPECT_EQ(names_of(plc.action(action(Message{"", 100, true}))), command);
  }
}

TEST(plc, program_end_and_spindles) {
  Plc plc(events(R"({"when": {"program": "end"}, "do": "power_cycle"},
                    {"when": {"program": "end"}, "do": "synchronise", "spindle": 2, "master": 1},
                    {"when": {"program": "end"}, "do": "release", "spindle": 2},
                    {"when": {"program": "end"}, "do": "spindle_to_axis", "spindle": 1},
                    {"when": {"program": "end"}, "do": "axis_to_spindle", "spindle": 1})"));
  EXPECT_EQ(names_of(plc.program_end()), "power, 2 follows 1, 2 follows 0, axis 1, spindle 1");
}

TEST(plc, what_it_cannot_serve_is_said) {
  const auto error_of = [](const char* code, bool control_reports_ends) {
    return Plc(events(R"({"when": {"code": ")" + std::string(code) + "\"}, " + start), control_reports_ends).error();
  };
  for (const char* const code : {"M2", "M30", "M98", "M99", "G4", "N1"})
    EXPECT_EQ(error_of(code, false), "events: the machine's logic does not see " + std::string(code));
  for (const char* const code : {"M2", "M30", "M98", "M99"}) EXPECT_EQ(error_of(code, true), "");  // nct 13.1
  EXPECT_TRUE(Plc({}).idle());
}

TEST(plc, axes_are_coupled_and_released) {
  Plc plc(events(R"({"when": {"code": "M41"}, "do": "synchronise", "axes": ["V", "W"]},
                    {"when": {"code": "M40"}, "do": "release", "axis": "V"})"));
  EXPECT_EQ(plc.error(), "");
  EXPECT_EQ(names_of(plc.action(action(MachineFunction{41}))), "VW on");
  EXPECT_EQ(names_of(plc.action(action(MachineFunction{40}))), "V off");
}

// ---- with controls

/// Two channels of one machine, executed block by block.
struct Machine {
  explicit Machine(const std::string& program, const Setup& setup = {}) {
    static const ControlDef def = load_control("nct").value();
    for (std::unique_ptr<Control>& c : owned) {
      c = std::make_unique<Control>(def, setup, Program{"test.nct", text_source(program), Encoding::utf8}, RunLimits{});
      c->return_each_block();
      all.push_back(c.get());
    }
  }
  void run(std::size_t i) {
    ActionBatch batch;
    while (owned[i]->run(batch) != Control::State::ended) ASSERT_FALSE(owned[i]->is_stopped());
  }
  double variable(std::size_t i, const std::string& name) const {
    for (const auto& [own, value] : owned[i]->ending().variables)
      if (own == name) return value;
    return -1;
  }
  std::array<std::unique_ptr<Control>, 2> owned;
  std::vector<Control*> all;
};

TEST(plc, switches_are_the_machines_answers_the_channels) {
  Machine machine("/2 #100=1\n#101=#3107\n");
  apply({SetSkip{2, true}, AnswerBox{3}}, *machine.owned[0], machine.all);
  machine.run(0);
  machine.run(1);
  EXPECT_EQ(machine.variable(0, "#100"), -1);
  EXPECT_EQ(machine.variable(1, "#100"), -1);
  EXPECT_EQ(machine.variable(0, "#101"), 3);
  EXPECT_EQ(machine.variable(1, "#101"), 0);
}

TEST(plc, spindles_follow_and_are_released) {
  Machine machine("#100=1\n");
  const auto master = [&](int spindle) {
    const RunState state = *machine.owned[1]->run_state();
    return state.spindles.contains(spindle) ? state.spindles.at(spindle).master : -1;
  };
  apply({Synchronise{1, 2}}, *machine.owned[0], machine.all);
  EXPECT_EQ(master(1), 2);
  apply({Synchronise{0, 0}}, *machine.owned[0], machine.all);
  EXPECT_EQ(master(1), 0);
}

TEST(plc, power_off_ends_the_program) {
  Machine machine("#100=1\n#500=2\n#501=3\n");
  ActionBatch batch;
  machine.owned[0]->on_block = [&](const Origin& origin, bool at_end) {
    if (origin.line == 2 && at_end) apply({PowerCycle{}}, *machine.owned[0], machine.all);
  };
  machine.run(0);
  EXPECT_EQ(machine.variable(0, "#100"), -1);
  EXPECT_EQ(machine.variable(0, "#500"), 2);
  EXPECT_EQ(machine.variable(0, "#501"), -1);
}

/// A block starts, is executed, and ends; it ends only when its actions have been passed on.
TEST(plc, order_of_blocks_and_actions) {
  Machine machine("N1 G1 X1 F100\nN2 #100=1\nN3 M8\n");
  std::string seen;
  Control& control = *machine.owned[0];
  control.on_block = [&](const Origin& origin, bool at_end) { seen += (at_end ? "]" : "[") + std::to_string(origin.block); };
  ActionBatch batch;
  while (control.run(batch) != Control::State::ended)
    for (const Action& a : batch)
      if (!std::holds_alternative<FrameChange>(a.what)) seen += "!";
  EXPECT_EQ(seen, "[1!]1[2]2[3!]3");
}

}  // namespace
}  // namespace kadr::plc_test
