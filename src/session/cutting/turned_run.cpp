// Runs a program that turns a blank. Used by cli/cut_turned and view/turned_part; tested by tests/run_cut.py.

#include "session/cutting/turned_run.h"

#include "out/text/cut_text.h"
#include "session/cutting/named_body.h"

namespace kadr {
namespace {

AxisRoles lathe_roles(const Control& control) { return AxisRoles::of(control.axes(), control.rotary()); }

TimeEstimate lathe_clock(const Session& session) {
  const Channel& own = session.channels()[session.own()];
  return TimeEstimate(lathe_roles(*own.control), rates_of(session.machine(), own.setup, own.control->axes()));
}

TurnedJob with_table(TurnedJob job, const Session& session, std::function<ToolOffset(std::uint32_t)> offset_now) {
  job.offset_now = std::move(offset_now);
  job.tips = tip_numbers(session.def());
  return job;
}

}  // namespace

std::optional<TurnedJob> turned_job_of(const MachineProfile& machine, const Setup& setup, const std::string& stock,
                                       const std::vector<std::string>& fixtures) {
  const auto blank = turned_region_of(stock);
  if (!blank) return std::nullopt;
  TurnedJob job;
  job.blank = *blank;
  for (const std::string& text : fixtures) {
    auto fixture = turned_region_of(text);
    if (!fixture) return std::nullopt;
    job.fixtures.push_back(std::move(*fixture));
  }
  job.holding = work_holding(machine, setup, job.blank);
  return job;
}

TurnedRun::TurnedRun(Session& session, const CutJob& cut, TurnedJob turned, MachineWatch* watch)
    : session_(session),
      cutting_(cut, with_table(std::move(turned), session, [this](std::uint32_t row) { return offset_now(row); }),
               lathe_roles(session.control())),
      watch_(watch),
      clock_(lathe_clock(session)) {
  cutting_.on_finding = [this](const CutFinding& f) {
    if (!on_finding) return;
    AlarmReport report = session_.settled_control().report_for(alarm_of(f), f.origin);
    report.own_text = names_of_bodies(f);
    on_finding(f, report);
  };
}

/// Returns the row as the program and the set-up have left it: the control may be some blocks ahead of the step.
ToolOffset TurnedRun::offset_now(std::uint32_t row) const {
  const Setup tables = session_.settled_control().tables_now();
  const auto found = tables.offsets.find(int(row));
  return found == tables.offsets.end() || !states_insert(session_.def(), found->second) ? ToolOffset() : found->second;
}

void TurnedRun::finish() {
  if (watch_ != nullptr) watch([&](auto& found, auto& notes) { watch_->finish(found, notes); });
  cutting_.finish();
}

template <class Take>
void TurnedRun::watch(const Take& take) {
  std::vector<CutFinding> found;
  std::vector<std::string> notes;
  take(found, notes);
  for (const CutFinding& finding : found) cutting_.also(finding);
  for (const std::string& note : notes)
    if (on_note) on_note(note);
}

void TurnedRun::on_block(std::function<void(const BlockLoad&)> take) {
  cutting_.on_block = [this, take = std::move(take)](const BlockLoad& load) {
    BlockLoad reported = load;
    name_program(reported);
    take(reported);
  };
}

void TurnedRun::on_past(std::function<void(const TurnedRemoval&, const TurnedStock&)> removal,
                        std::function<void(const TurnedThread&)> thread) {
  cutting_.on_removal = [this, removal = std::move(removal)](const TurnedRemoval& what) { removal(what, cutting_.stock()); };
  cutting_.on_thread = std::move(thread);
}

void TurnedRun::attach(const StopToken& stop, ProgressDisplay* progress_display) {
  const bool planned = session_.look_ahead().has_value();
  Outlets& outlets = session_.outlets();
  outlets.warning = [this](const AlarmReport& report) { take(report); };
  outlets.alarm = [this](const AlarmReport& report) {
    take(report);
    return false;
  };
  outlets.progress_display = progress_display;
  outlets.clock = &clock_;
  outlets.stop = stop;
  outlets.works_long = true;
  if (planned) outlets.timed = [this](const Step& step, double longer) { consume(step, longer); };
  outlets.step = [this, planned](const Step& step) {
    if (!planned) consume(step, 0);
  };
  session_.change_outlets();
}

PartResult TurnedRun::part_result(const TurnedComparison& compared) const {
  const auto difference = [&](const TurnedDifference& d) {
    const auto last = d.volume > 0 ? cutting_.last_at(d.at) : std::nullopt;
    const Origin origin = last.value_or(Origin());
    return PartDifference{d.volume, d.deepest, {d.at.x, 0, d.at.y}, origin.line, program_of(origin.file)};
  };
  PartResult result;
  result.left_on = difference(compared.left_on), result.gouged = difference(compared.gouged);
  return result;
}

CutResult TurnedRun::result() const {
  CutResult result = cutting_.result();
  for (auto* const findings : {&result.collisions, &result.warnings})
    for (CutFinding& f : *findings) name_program(f), f.calls = session_.settled_control().calls_of(f.origin);
  for (BlockLoad& load : result.heaviest) name_program(load);
  for (AirCut& air : result.emptiest) name_program(air);
  for (ThreadCut& thread : result.threads) name_program(thread);
  for (TurnedResult::LeftOut& left : result.turned->left_out) name_program(left);
  return result;
}

void TurnedRun::consume(const Step& step, double longer) {
  const MachineTime time{step.begins + later_, step.time.seconds + longer};
  later_ += longer;
  if (watch_ != nullptr) watch([&](auto& found, auto& notes) { watch_->take(step, time, found, notes); });
  if (without_shape_) return;
  if (const Status taken = cutting_.consume(step, time); !taken) {
    without_shape_ = session_.settled_control().report_for(taken.error(), step.action.origin);
    take(*without_shape_);
  }
}

void TurnedRun::take(const AlarmReport& report) {
  if (report.alarm.severity != Severity::note) ++(report.alarm.severity == Severity::alarm ? alarms_ : warnings_);
  if (on_report) on_report(report);
}

}  // namespace kadr
