// LineUses: runs a program and notes what each line is used for. Used by edit/program_editor; tested by tests/edit.py.

#include "edit/line_uses.h"

#include <algorithm>

#include "action/by_kind.h"

namespace kadr {

LineUse& LineUses::at(std::uint32_t line) {
  if (line >= lines_.size()) lines_.resize(line + 1);
  return lines_[line];
}

LineUses LineUses::of(std::unique_ptr<Session> session, const StopToken& stop) {
  LineUses use;
  use.first_tool_ = static_cast<std::uint32_t>(std::max(session->setup().tool, 0));
  std::uint32_t tool = use.first_tool_, line = 0;
  const auto end_block = [&] {
    if (line == 0) return;
    LineUse& of = use.at(line);
    of.executed = true;
    if (std::find(of.tools.begin(), of.tools.end(), tool) == of.tools.end()) of.tools.push_back(tool);
    line = 0;
  };
  Control& control = session->control();
  control.return_each_block();
  control.holds_before = [&](const Origin& origin) {
    end_block();
    line = origin.file == 0 ? origin.line : 0;
    return false;
  };
  Outlets& outlets = session->outlets();
  outlets.stop = stop;
  outlets.step = [&](const Step& step) {
    by_kind(
        step.action, [&](const ToolChange& change) { tool = change.tool; },
        ignores<Motion, Dwell, Spindle, Speed, CoolantSwitch, ToolSelect, MachineFunction, AuxiliaryFunction, Stop, Message, FrameChange,
                SurfaceSpeed, Sync, ZoneChange, Couple, Uncouple, CompensationBreak, CompensationCorner, CompensationCheck>);
    const Motion* const motion = step.motion();
    if (motion != nullptr) use.diameters_ |= motion->diameters;
    if (motion == nullptr || step.action.origin.file != 0) return;
    LineUse& of = use.at(step.action.origin.line);
    of.threads = of.threads || motion->kind == MotionKind::thread;
    of.taps = of.taps || motion->in_hole == HoleWork::taps;
    of.drills = of.drills || motion->of_cycle;
  };
  while (session->go_on() == Session::State::running) {
  }
  control.holds_before = nullptr;
  end_block();
  return use;
}

}  // namespace kadr
