// Passes the commands of the machine's logic (machine/plc) to the controls of its channels. This file is used by session/channel_run.

#include "session/plc_commands.h"

#include "action/by_kind.h"

namespace kadr {

void apply(const std::vector<PlcCommand>& commands, Control& from, std::span<Control* const> channels) {
  for (const PlcCommand& command : commands) {
    const auto each = [&](const auto& act) {
      for (Control* const control : channels) act(*control);
    };
    std::visit(EachKind{[&](const AnswerBox& answer) { from.set_answer(answer.value); },
                        [&](const SetSignal& signal) { each([&](Control& c) { c.set_signal(signal.name, signal.value); }); },
                        [&](const SetSkip& skip) { each([&](Control& c) { c.set_skip(skip.number, skip.on); }); },
                        [&](const Synchronise& coupled) { each([&](Control& c) { c.synchronise(coupled.slave, coupled.master); }); },
                        [&](const CoupleAxes& axes) { each([&](Control& c) { c.couple_axes(axes.axes, axes.link, axes.on); }); },
                        [&](const ConvertSpindle& one) { each([&](Control& c) { c.convert_spindle(one.number, one.to_axis); }); },
                        // The command Start is ignored, since the virtual operator presses START at once in any case.
                        [&](const PowerCycle&) { each([](Control& c) { c.power_cycle(); }); }, ignores<Start>},
               command);
  }
}

}  // namespace kadr
