// A sink of your own: how far each tool has cut, and how long.

#include <map>

#include "open.h"

/// Takes Steps: actions with the tool's place before them, their path and their time.
class CutByTool {
 public:
  void consume(const kadr::Step& step) {
    if (const auto* change = std::get_if<kadr::ToolChange>(&step.action.what)) tool_ = change->tool;
    const kadr::Motion* const motion = step.motion();
    if (motion == nullptr || motion->kind == kadr::MotionKind::rapid || motion->kind == kadr::MotionKind::home) return;
    Cut& cut = cuts_[tool_];
    cut.length += step.curve().length(motion->along);
    cut.seconds += step.time.seconds;
  }

  void print() const {
    for (const auto& [tool, cut] : cuts_) std::printf("T%u: %.3f mm, %.3f s\n", tool, cut.length, cut.seconds);
  }

 private:
  struct Cut {
    double length = 0, seconds = 0;
  };
  std::map<std::uint32_t, Cut> cuts_;
  std::uint32_t tool_ = 0;
};

int main(int argc, char** argv) {
  const auto session = open_session(argc > 1 ? argv[1] : "part.nc", "nct");
  if (!session) return 2;
  const kadr::Control& control = session->control();
  kadr::TimeEstimate clock(kadr::AxisRoles::of(control.axes(), control.rotary()),
                           kadr::rates_of(session->machine(), session->setup(), control.axes()));
  session->outlets().clock = &clock;  // who wants times says by what they are counted
  CutByTool cuts;
  session->outlets().step = [&](const kadr::Step& step) { cuts.consume(step); };
  (void)session->run();
  cuts.print();
  return tell_end(*session);
}
