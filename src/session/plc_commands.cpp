// What the machine's logic (machine/plc) commands, carried to the controls of its channels. For session/channel_run.

#include "session/plc_commands.h"

namespace kadr {

void apply(const std::vector<PlcCommand>& commands, Control& from, std::span<Control* const> channels) {
  for (const PlcCommand& command : commands) {
    if (const auto* const answer = std::get_if<AnswerBox>(&command)) from.set_answer(answer->value);
    for (Control* const control : channels) {
      if (const auto* const signal = std::get_if<SetSignal>(&command)) control->set_signal(signal->name, signal->value);
      else if (const auto* const skip = std::get_if<SetSkip>(&command)) control->set_skip(skip->number, skip->on);
      else if (const auto* const coupled = std::get_if<Synchronise>(&command)) control->synchronise(coupled->slave, coupled->master);
      else if (const auto* const axes = std::get_if<CoupleAxes>(&command)) control->couple_axes(axes->axes, axes->link, axes->on);
      else if (const auto* const converted = std::get_if<ConvertSpindle>(&command))
        control->convert_spindle(converted->number, converted->to_axis);
      else if (std::holds_alternative<PowerCycle>(command)) control->power_cycle();
    }
  }
}

}  // namespace kadr
