// A whole run as a fuzz target. For fuzz/run_*_fuzz, fuzz/own_control.

#include "run_program.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "config/state_json.h"
#include "machine/virtual_machine.h"
#include "motion/time/steps.h"
#include "out/picture/plot.h"
#include "out/text/summary.h"
#include "out/trace/trace.h"
#include "path/contour/contour_corners.h"
#include "path/contour/radius_compensation.h"

namespace kadr::fuzz {

Setup some_setup(unsigned switches) {
  Setup s;
  s.start = {{"X", 10}, {"Y", -20}, {"Z", 100}};
  s.offsets = {{1, {50, 5}}, {2, {-12.5, 0}}, {9, {33.3, 0}}};
  s.work_offsets = {{"G54", {{"X", 100}, {"Y", 50}}}, {"G55", {{"Z", -25}}}, {"common", {{"X", 1}}}};
  s.zeros = {{1, {{"X", 100}, {"Y", 50}, {"Z", 7}}}, {2, {{"X", -3}}}};
  s.correctors = {{1, 0.5}, {2, -0.25}, {15, 9.8}, {17, 2}};
  s.variables = {{"#100", 3.5}, {"R0", 100}, {"R1", -20000}, {"R2", 1000}, {"R3", 5000}};
  s.reference_points = {{1, {{"X", 500}, {"Y", 400}, {"Z", 300}}}, {2, {{"Z", 200}}}};
  s.probe_hole = ProbeHole{1, 0, 0, 40, 0, 10};
  s.watch = {"#100", "#2000", "#7", "R4"};
  s.spindles[1].rpm = 500;
  s.points = {0.25, 0.5};
  if ((switches & mirror_x) != 0) s.mirror.emplace_back("X");
  if ((switches & mirror_y) != 0) s.mirror.emplace_back("Y");
  if ((switches & skip_blocks) != 0) s.skip = {1, 3};
  s.optional_stop = (switches & skip_blocks) != 0;
  if ((switches & narrow_limits) != 0) s.machine["*"].limits = {-300, 300};
  return s;
}

namespace {

constexpr std::size_t most_actions = 20'000;  // of one run
constexpr std::size_t most_alarms = 200;
constexpr std::size_t most_shown = 40;     // alarms that are put into words
constexpr std::size_t most_compared = 15;  // alarms before which the state is kept, to be compared
constexpr std::size_t most_watched = 200;  // blocks around which the state is kept
constexpr double farthest_end = 1e8;       // mm: what no motion may reach
constexpr double same_place = 1e-5;        // mm: rounding of coordinates of ten kilometres

bool is_finite(const Axes& axes) {
  for (const double v : axes)
    if (!std::isfinite(v)) return false;
  return true;
}
bool near(double a, double b) { return std::fabs(a - b) <= same_place * (1 + 1e-6 * std::fabs(a)); }
bool near(const Axes& a, const Axes& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!near(a[i], b[i])) return false;
  return true;
}

class Run {
 public:
  Run(const Shop& shop, std::string text, unsigned switches)
      : shop_(shop),
        setup_(shop.setup(switches)),
        control_(shop.def, setup_,
                 {shop.file, text_source(std::move(text)), (switches & as_cp1251) != 0 ? std::optional(Encoding::cp1251) : std::nullopt},
                 shop.limits),
        stand_(control_.tool_position()),
        machine_(control_.axes(), control_.rotary(), shop.profile, setup_, stand_),
        statistics_(control_.axes(), control_.rotary(), rates_of(shop.profile, setup_, control_.axes())),
        plot_(control_.axes(), control_.rotary(), stand_),
        corners_(stand_),
        compensation_(stand_),
        trace_(shop.nowhere, control_.axes(), control_.rotary(), setup_.points),
        steps_(machine_.roles(), stand_, &statistics_.clock()) {
    require(is_finite(stand_.work) && is_finite(stand_.machine), "the run begins somewhere");
    control_.on_warning = [this](const AlarmReport& report) { show(report); };
    if (!shop.logic || (switches & machine_logic) == 0) return;
    control_.hand_over_each_block();
    control_.on_block = [this](const Origin& origin, bool at_end) {
      watch_block(at_end);
      shop_.logic(control_, origin, at_end);
    };
  }

  void carry_out() {
    ActionBatch batch;
    for (Control::State state = Control::State::running;
         state != Control::State::ended && actions_ < most_actions && alarms_ < most_alarms;) {
      const bool compared = !shop_.logic && alarms_ < most_compared;  // nct may hand over before a block: watch_block
      const Ending before = compared ? control_.ending() : Ending();
      const std::uint64_t blocks = control_.blocks();
      state = control_.run(batch);
      const bool one_block = control_.blocks() == blocks + 1;
      go_beside(batch, state != Control::State::running);
      for (Action& action : batch) take(action);
      if (state == Control::State::stopped || control_.is_stopped()) {
        stopped(compared && state == Control::State::stopped && one_block ? &before : nullptr);
        control_.go_on();
      }
    }
    control_.check_uncalled([this](const AlarmReport& report) { show(report); });
    const Ending end = control_.ending();
    if (alarms_ == 0) trace_.finish(end);
    else trace_.finish(end, last_, shop_.texts, Lang::ru);
    require(is_utf8(statistics_.text(control_.blocks(), Lang::ru)), "the summary is UTF-8");
    if (const auto state = control_.run_state(); state) {
      const std::string text = state_json(*state);
      require(nlohmann::json::accept(text), "the state is JSON");
      require(parse_setup(text).has_value(), "the state is a set-up");
    }
  }

 private:
  /// Keeps the state before a block that the machine's logic sees.
  void watch_block(bool at_end) {
    block_open_ = !at_end && ++watched_ <= most_watched;
    if (block_open_) before_block_ = control_.ending();
  }

  void take(Action& action) {
    ++actions_;
    block_open_ = false;  // a cycle that has begun
    if (auto* const motion = std::get_if<Motion>(&action.what)) {
      if (motion->kind == MotionKind::probe) {
        const ProbeAnswer answer = machine_.probe(*motion);
        end_at(*motion, answer, machine_.position().turn.get());
        control_.answer(answer);
      }
      check_motion(*motion);
    }
    if (const auto* const frame = std::get_if<FrameChange>(&action.what)) {
      require(is_finite(frame->placement.origin) && is_finite(frame->placement.length) && is_finite(frame->work),
              "the frame is of numbers");
      frame_ = *frame;
    }
    check_other(action);
    if (const Status taken = machine_.take(action); !taken) show(control_.report_for(taken.error(), action.origin));
    stand_.take(action);
    steps_.give(action, [this](const Step& step) {
      statistics_.consume(step);
      plot_.consume(step);
      trace_.write(step);
    });
  }

  /// The same actions through the stages of `path`, as the tool's centre goes; the machine takes those of the program.
  void go_beside(const ActionBatch& batch, bool last) {
    beside_ = batch;
    const auto corner = corners_.take(beside_, last ? ContourCorners::Follows::nothing : ContourCorners::Follows::more);
    const auto fault = compensation_.take(beside_, corner || last);
    for (const auto& f : {corner, fault})
      if (f) show(control_.report_for(f->alarm, f->origin));
    for (const CompensationFault& cut : compensation_.warnings()) show(control_.report_for(cut.alarm, cut.origin));
    for (const Action& action : beside_) {
      const auto* const m = std::get_if<Motion>(&action.what);
      if (m == nullptr) continue;
      require(is_finite(m->to) && is_finite(m->machine), "the tool's centre goes somewhere");
      const bool arc = is_arc(m->kind);
      require(arc ? m->turns > 0 && std::isfinite(m->turns) : m->turns == 0, "its arcs turn, its lines do not");
      require(!arc || (std::isfinite(m->center.x) && std::isfinite(m->center.y)), "its arcs have a centre");
    }
  }

  void check_motion(const Motion& motion) const {
    require(is_finite(motion.to) && is_finite(motion.machine), "a motion ends somewhere");
    require(std::isfinite(motion.center.x) && std::isfinite(motion.center.y), "an arc has a centre");
    require(std::isfinite(motion.feed) && motion.feed >= 0, "the feed is a number");
    require(std::isfinite(motion.turns) && std::isfinite(motion.tolerance) && motion.tolerance >= 0, "turns and tolerance are numbers");
    const bool calculated =
        motion.detail && motion.detail->contour && motion.detail->contour->on == SupportingCurve::circle;  // its start is found in `path`
    require(is_arc(motion.kind) ? motion.turns > 0 || calculated : motion.turns == 0, "an arc turns, a line does not");
    for (std::size_t a = 0; a < control_.axes().size(); ++a) {
      require(std::fabs(motion.to[a]) < farthest_end && std::fabs(motion.machine[a]) < farthest_end, "a motion ends on this earth");
      // An axis that does not move keeps a length that its next motion takes out (2С42).
      const double apart = motion.machine[a] - motion.to[a];
      const bool in_frame = near(apart, frame_.placement.origin[a] + frame_.placement.length[a]);
      require(!shop_.plain_frames || in_frame || near(apart, stand_.machine[a] - stand_.work[a]), "machine = work + origin + length");
    }
  }

  static void check_other(const Action& action) {
    if (const auto* const dwell = std::get_if<Dwell>(&action.what))
      require(std::isfinite(dwell->seconds) && dwell->seconds >= 0, "a dwell ends");
    if (const auto* const spindle = std::get_if<Spindle>(&action.what)) require(std::isfinite(spindle->rpm), "the speed is a number");
    if (const auto* const message = std::get_if<Message>(&action.what)) require(is_utf8(message->text), "a message is UTF-8");
  }

  /// `before`: the state before the block that failed, where the run began with it.
  void stopped(const Ending* before) {
    ++alarms_;
    last_ = control_.report();
    show(last_);
    if (alarms_ > 2 * most_compared) return;
    const Ending after = control_.ending();
    require(near(after.position, stand_.work) && near(after.machine_position, stand_.machine),
            "after an alarm the control stands where the motions led");
    if (block_open_ && last_.alarm.id != AlarmId::call_too_deep) same_state(before_block_, after);  // an interrupt macro may nest too deep
    block_open_ = false;
    if (before == nullptr) return;
    same_state(*before, after);
  }

  static void same_state(const Ending& before, const Ending& after) {
    if (before.variables != after.variables || before.modal != after.modal)
      std::fprintf(stderr, "before: %s\nafter:  %s\n", text_of(before).c_str(), text_of(after).c_str());
    require(before.variables == after.variables, "a faulty block changes no variable");
    require(before.modal == after.modal, "a faulty block changes no mode");
  }

  static std::string text_of(const Ending& e) {
    std::string text;
    for (const auto& [name, value] : e.variables) text += name + "=" + std::to_string(value) + " ";
    for (const std::string& code : e.modal) text += code + " ";
    return text;
  }

  void show(const AlarmReport& report) {
    if (++shown_ > most_shown) return;
    std::vector<Finding> findings;
    for (const Lang lang : {Lang::en, Lang::ru}) {
      require(is_utf8(alarm_text(report, shop_.texts, lang)), "an alarm is UTF-8");
      findings.push_back(finding_of(report, shop_.texts, lang));
      require(!findings.back().text.empty() && findings.back().end_column >= findings.back().column, "an alarm has a text and a place");
    }
    require(nlohmann::json::accept(findings_json(findings)), "the list of alarms is JSON");
    if (shown_ % 8 == 1) require(nlohmann::json::accept(findings_sarif(findings, {"0", 0, {}})), "the SARIF log is JSON");
  }

  const Shop& shop_;
  Setup setup_;
  Control control_;
  ToolPosition stand_;
  VirtualMachine machine_;
  Statistics statistics_;
  Plot plot_;
  ContourCorners corners_;
  RadiusCompensation compensation_;
  ActionBatch beside_;
  TraceWriter trace_;
  Steps steps_;
  FrameChange frame_{};
  AlarmReport last_;
  Ending before_block_;
  std::size_t watched_ = 0;
  bool block_open_ = false;
  std::size_t actions_ = 0;
  std::size_t alarms_ = 0;
  std::size_t shown_ = 0;
};

}  // namespace

void run_text(const Shop& shop, std::string text, unsigned switches, const std::function<void()>& then) {
  Run run(shop, std::move(text), switches);
  run.carry_out();
  if (then) then();
}

}  // namespace kadr::fuzz
