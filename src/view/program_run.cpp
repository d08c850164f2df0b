// Runs a program for the page, and records its path, marks, findings and checkpoints (ProgramRun). Used by view/page/page_session; tested
// by tests/serve.py.

#include "view/program_run.h"

#include <algorithm>
#include <chrono>

#include "action/by_kind.h"
#include "config/language.h"
#include "config/machine/rapid_path.h"
#include "out/text/alarm_print.h"
#include "session/unstated.h"

namespace kadr {
namespace {

constexpr std::size_t max_marks = 10'000;
// Greatest number of checkpoints. Each checkpoint needs some 600 KB, because it includes the batches that the control has executed ahead.
constexpr std::size_t max_checkpoints = 48;
constexpr double short_dwell = 0.05;  // time in s; a shorter dwell gets no mark on the time line

}  // namespace

std::shared_ptr<const MachineTree> tree_of(const OpenedProgram& opened, const Control& control) {
  return std::make_shared<MachineTree>(opened.machine, control.axes());
}

std::optional<Axes> apart_of(const OpenedProgram& opened, const Control& control) {
  if (!rapids_apart(*opened.def, opened.setup, control.axes())) return std::nullopt;
  return rates_of(opened.machine, opened.setup, control.axes()).rapid;
}

tl::expected<std::unique_ptr<ProgramRun>, std::string> ProgramRun::make(const OpenedProgram& opened, const StopToken& stop) {
  std::unique_ptr<ProgramRun> run(new ProgramRun(opened, stop));
  auto program = opened.program();
  if (!program) return tl::unexpected(program.error());
  auto session = Session::open(opened.spec(std::move(*program), stop));
  if (!session) return tl::unexpected(in_thread_language(session.error().fault.en, session.error().fault.ru));
  run->session_ = std::move(*session);
  run->attach();
  return run;
}

void ProgramRun::attach() {
  const Channel& own = session_->channels()[session_->own()];
  const Control& control = *own.control;
  roles_ = AxisRoles::of(control.axes(), control.rotary());
  const auto tool = std::uint32_t(std::max(own.setup.tool, 0));
  record_ = std::make_unique<PathRecord>(roles_, tree_of(opened_, control), apart_of(opened_, control), tool);
  contour_ = std::make_unique<PathRecord>(roles_, tree_of(opened_, control), apart_of(opened_, control), tool);
  programmed_ = std::make_unique<Steps>(roles_, session_->stand());
  record_->on_piece = [this](const ViewPiece& piece) {
    if (on_piece) on_piece(piece, 0);
  };
  statistics_ = std::make_unique<Statistics>(control.axes(), control.rotary(), rates_of(opened_.machine, own.setup, control.axes()));
  statistics_->start_with(own.setup);
  const auto rules = session_->look_ahead();
  if (rules) statistics_->count_by(rules->accelerates() ? TimeBasis::accelerated : TimeBasis::limited);
  Outlets& outlets = session_->outlets();
  outlets.warning = [this](const AlarmReport& report) { publish_report(report, 0); };
  outlets.alarm = [this](const AlarmReport& report) {
    publish_report(report, 0);
    return false;
  };
  checklist_ =
      std::make_unique<Checklist>(*session_, session_->own(), ChecklistBasis{opened_.tools, opened_.number == 0, opened_.number == 0});
  outlets.programmed = [this](const Action& action) {
    follow_programmed(action);
    checklist_->take(action);
  };
  outlets.clock = &statistics_->clock();
  outlets.stop = stop_;
  outlets.works_long = true;
  const bool planned = rules.has_value();
  outlets.step = [this, planned](const Step& step) {
    statistics_->consume(step);
    if (!planned) take(step, 0);
  };
  if (planned)
    outlets.timed = [this](const Step& step, double longer) {
      if (const Motion* const motion = step.motion(); motion != nullptr && longer != 0) statistics_->lengthen(*motion, longer);
      take(step, longer);
    };
}

/// Records the paths and the alarms of the other channels. The page displays nothing else about these channels.
void ProgramRun::attach_others() {
  std::vector<Channel>& channels = session_->channels();
  others_.reserve(channels.size());
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (i == session_->own()) continue;
    const Channel& channel = channels[i];
    const Control& control = *channel.control;
    Other& other = others_.emplace_back();
    other.roles = AxisRoles::of(control.axes(), control.rotary());
    other.clock = std::make_unique<TimeEstimate>(other.roles, rates_of(opened_.machine, channel.setup, control.axes()));
    const auto tool = std::uint32_t(std::max(channel.setup.tool, 0));
    other.record = std::make_unique<PathRecord>(other.roles, tree_of(opened_, control), apart_of(opened_, control), tool);
    other.record->on_piece = [this, number = std::uint32_t(others_.size())](const ViewPiece& piece) {
      if (on_piece) on_piece(piece, number);
    };
    Outlets& outlets = session_->outlets(i);
    outlets.step = [&other](const Step& step) { other.record->consume(step, 0, 0); };
    outlets.clock = other.clock.get();
    outlets.warning = [this, number = channel.number](const AlarmReport& report) { publish_report(report, number); };
    outlets.alarm = [this, number = channel.number](const AlarmReport& report) {
      publish_report(report, number);
      return false;
    };
    outlets.stop = stop_;
  }
}

void ProgramRun::publish_report(const AlarmReport& report, int channel) {
  statistics_->count(report.alarm.severity);
  const bool stands = report.alarm.severity == Severity::alarm;
  add_mark({seconds_, stands ? TimeMark::Kind::alarm : TimeMark::Kind::warning, channel == 0 ? report.origin.line : 0,
            sentence_of(report, *opened_.texts, thread_language()), report.origin.file});
  if (on_alarm) on_alarm(report, seconds_, channel);
}

void ProgramRun::take(const Step& step, double longer) {
  if (on_step) on_step(step);
  mark(step, step.begins + later_);
  record_->consume(step, later_, longer);
  later_ += longer;
  seconds_ = step.begins + step.time.seconds + step.pause + later_;
}

/// Adds a step of the contour without compensation. A motion for which no compensation is in force only updates the position.
void ProgramRun::follow_programmed(const Action& action) {
  programmed_->give(action, [this](const Step& step) {
    const Motion* const motion = step.motion();
    if (motion == nullptr || motion->side != 0) contour_->consume(step, 0, 0);
  });
}

void ProgramRun::emit_contour() {
  contour_->flush();
  contour_->take_times_of(*record_);
  if (on_contour)
    for (const ViewPiece& piece : contour_->pieces()) on_contour(piece);
  contour_.reset();
}

/// Reports the findings of the checks that are made after the run. These findings get the time of the end of the run.
void ProgramRun::report_final_findings() {
  if (end_ == End::cancelled || !on_alarm) return;
  if (end_ == End::ended)
    for (const AlarmReport& report : checklist_->reports(stop_)) on_alarm(report, seconds_, 0);
  if (const auto note = unstated(control(), *opened_.def, opened_.setup, opened_.stated)) on_alarm(*note, seconds_, 0);
}

void ProgramRun::add_mark(TimeMark mark) {
  if (marks_.size() < max_marks) marks_.push_back(std::move(mark));
}

void ProgramRun::mark(const Step& step, double at) {
  const Origin& origin = step.action.origin;
  using Kind = TimeMark::Kind;
  const auto add = [&](Kind kind, std::string text = {}) { add_mark({at, kind, origin.line, std::move(text), origin.file}); };
  by_kind(
      step.action, [&](const ToolChange& change) { add(Kind::tool, "T" + std::to_string(change.tool)); },
      [&](const Stop& stop) { add(stop.optional ? Kind::optional_stop : Kind::stop); },
      [&](const Message& message) { add(Kind::message, message.text); },
      [&](const Dwell& dwell) {
        if (dwell.seconds > short_dwell) add(Kind::dwell);
      },
      ignores<Motion, Spindle, Speed, CoolantSwitch, ToolSelect, MachineFunction, AuxiliaryFunction, FrameChange, SurfaceSpeed, Sync,
              ZoneChange, Couple, Uncouple, CompensationBreak, CompensationCorner, CompensationCheck>);
}

/// Adds a checkpoint. If the greatest number of checkpoints is reached, every second checkpoint is deleted first, and further checkpoints
/// are twice as far apart.
void ProgramRun::keep_checkpoint() {
  auto now = session_->snapshot();
  if (!now) return;
  if (checkpoints_.size() >= max_checkpoints) {
    std::vector<RunCheckpoint> half;
    for (std::size_t i = 0; i < checkpoints_.size(); i += 2) half.push_back(std::move(checkpoints_[i]));
    checkpoints_ = std::move(half);
    apart_ *= 2;
  }
  checkpoints_.push_back({session_->control().blocks(), std::move(*now)});
}

void ProgramRun::report_progress() {
  if (!on_progress || !progress_clock_.is_due()) return;
  const Control& control = session_->settled_control();
  const double bytes = double(control.bytes());
  on_progress(bytes > 0 ? std::min(double(control.bytes_read()) / bytes, 1.0) : 0, session_->blocks(), seconds_);
}

void ProgramRun::execute() {
  attach_others();
  std::uint64_t saved_at = 0;
  keep_checkpoint();
  Session::State state = Session::State::running;
  while (state == Session::State::running && !stop_.requested()) {
    state = session_->go_on();
    if (session_->blocks() - saved_at >= apart_ && state == Session::State::running) saved_at = session_->blocks(), keep_checkpoint();
    report_progress();
  }
  end_ = stop_.requested() ? End::cancelled : state == Session::State::stopped ? End::stopped : End::ended;
  record_->flush();
  for (const Other& other : others_) other.record->flush();
  emit_contour();
  report_final_findings();
  add_mark({seconds_, TimeMark::Kind::end, 0, {}, 0});
}

}  // namespace kadr
