// Plc: matches blocks, actions and the end of the program against the events of a set-up. Used by session/channel_run and
// session/plc_commands; tested by tests/machine/plc_test.cpp.

#include "machine/plc.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include "texts/control_start.h"

namespace kadr {
namespace {

using When = SetupEvent::When;
using Do = SetupEvent::Do;

/// A code that the control reports to the machine, spelled as in the program: M3, T5, S1200, B90.
struct Code {
  char letter = 0;
  double number = 0;
};

struct CodeOf {
  Code operator()(const MachineFunction& m) const { return {'M', double(m.code)}; }
  Code operator()(const CoolantSwitch& c) const { return {'M', c.what == Coolant::off ? 9.0 : c.what == Coolant::mist ? 7.0 : 8.0}; }
  Code operator()(const Spindle& s) const {
    switch (s.dir) {
      case SpindleDir::cw: return {'M', 3};
      case SpindleDir::ccw: return {'M', 4};
      case SpindleDir::stop: return {'M', 5};
      case SpindleDir::orient: return {'M', 19};
      default: return {};
    }
  }
  Code operator()(const Stop& s) const {
    if (s.reason == StopReason::single_block || s.reason == StopReason::message) return {};
    return {'M', s.optional ? 1.0 : 0.0};
  }
  Code operator()(const Speed& s) const { return s.surface ? Code{} : Code{'S', s.value}; }
  Code operator()(const ToolSelect& t) const { return {'T', double(t.tool)}; }
  Code operator()(const ToolChange& t) const { return t.there ? Code{} : Code{'M', 6}; }
  Code operator()(const AuxiliaryFunction& a) const { return {a.address, a.value}; }
  template <class Other>
  Code operator()(const Other&) const {
    return {};
  }
};

double answer_value(const std::string& answer) {
  constexpr std::pair<const char*, double> answers[] = {{"cancel", 0}, {"ok", 1}, {"yes", 2}, {"no", 3}};
  for (const auto& [name, value] : answers)
    if (answer == name) return value;
  return 0;
}

/// Returns false for a code that the control executes itself, without reporting it to the machine's logic.
bool is_seen(const std::string& code, bool control_reports_ends) {
  constexpr std::string_view letters = "MSTABCUVW";
  if (letters.find(code[0]) == std::string_view::npos) return false;
  const double number = std::strtod(code.c_str() + 1, nullptr);
  return control_reports_ends || code[0] != 'M' || !(number == 2 || number == 30 || number == 98 || number == 99);
}

PlcCommand command_of(const SetupEvent& event) {
  const bool on = event.what == Do::synchronise;
  if (!event.axes.empty() && (on || event.what == Do::release)) return CoupleAxes{event.axes, AxisLink::follows, on};
  switch (event.what) {
    case Do::exchange: return CoupleAxes{event.axes, AxisLink::exchanged, event.on};
    case Do::reverse: return CoupleAxes{event.axes, AxisLink::reversed, event.on};
    case Do::park: return CoupleAxes{event.axes, AxisLink::parked, event.on};
    case Do::set: return SetSignal{event.signal, event.value};
    case Do::skip: return SetSkip{event.switch_number, event.on};
    case Do::start: return Start{};
    case Do::answer: return AnswerBox{answer_value(event.answer)};
    case Do::power_cycle: return PowerCycle{};
    case Do::spindle_to_axis: return ConvertSpindle{event.spindle, true};
    case Do::axis_to_spindle: return ConvertSpindle{event.spindle, false};
    case Do::synchronise: return Synchronise{event.spindle, event.master};
    case Do::release: return Synchronise{event.spindle, 0};
  }
  return Start{};
}

}  // namespace

Plc::Plc(const std::vector<SetupEvent>& events, bool control_reports_ends) {
  for (const SetupEvent& from : events) {
    const std::string& word = from.code.empty() ? from.block : from.code;
    const char letter = word.empty() ? '\0' : word[0];
    if (!from.code.empty() && !is_seen(from.code, control_reports_ends))
      error_ = translated(texts::control_start::event_not_seen, from.code);
    const double number = word.empty() ? 0 : std::strtod(word.c_str() + 1, nullptr);
    events_.push_back({from.when, letter == ':', letter, number, from.count, 0, command_of(from)});
  }
}

template <class Matches>
const std::vector<PlcCommand>& Plc::fire(Matches matches) {
  commands_.clear();
  for (Event& event : events_) {
    if (!matches(event)) continue;
    ++event.seen;
    if (event.count == 0 || event.seen == event.count) commands_.push_back(event.command);
  }
  return commands_;
}

const std::vector<PlcCommand>& Plc::block(const Origin& origin, bool at_end) {
  const When when = at_end ? When::block_end : When::block_start;
  return fire(
      [&](const Event& e) { return origin.has_block && e.when == when && e.number == origin.block && e.main_block == origin.main_block; });
}

const std::vector<PlcCommand>& Plc::action(const Action& action) {
  const Code code = std::visit(CodeOf{}, action.what);
  const auto* const message = std::get_if<Message>(&action.what);
  const bool stops = std::holds_alternative<Stop>(action.what);
  (void)fire([&](const Event& e) {
    return (e.when == When::code && code.letter != 0 && e.letter == code.letter && e.number == code.number) ||
           (e.when == When::message && message != nullptr) || (e.when == When::stop && stops);
  });
  if (message != nullptr && !message->asks)
    std::erase_if(commands_, [](const PlcCommand& c) { return std::holds_alternative<AnswerBox>(c); });
  return commands_;
}

const std::vector<PlcCommand>& Plc::program_end() {
  return fire([](const Event& e) { return e.when == When::program_end; });
}

}  // namespace kadr
