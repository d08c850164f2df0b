// CutRun: runs a program that cuts a blank. It is used by cli/cut and view/part_run.

#include "session/cutting/cut_run.h"

#include "out/text/cut_text.h"

namespace kadr {
namespace {

AxisRoles roles_of(const Control& control) { return AxisRoles::of(control.axes(), control.rotary()); }

TimeEstimate clock_of(const Session& session) {
  const Channel& own = session.channels()[session.own()];
  return TimeEstimate(roles_of(*own.control), rates_of(session.machine(), own.setup, own.control->axes()));
}

}  // namespace

CutRun::CutRun(Session& session, const CutJob& cut, MachineWatch* watch)
    : session_(session), cutting_(cut, roles_of(session.control())), watch_(watch), clock_(clock_of(session)) {
  cutting_.on_finding = [this](const CutFinding& f) {
    if (!on_finding) return;
    AlarmReport report = session_.settled_control().report_for(alarm_of(f), f.origin);
    report.own_text = names_of_bodies(f);
    on_finding(f, report);
  };
}

void CutRun::on_block(std::function<void(const BlockLoad&)> take) {
  cutting_.on_block = [this, take = std::move(take)](const BlockLoad& load) {
    BlockLoad reported = load;
    name_program(reported);
    take(reported);
  };
}

template <class Take>
void CutRun::watch(const Take& take) {
  std::vector<CutFinding> found;
  std::vector<std::string> notes;
  take(found, notes);
  for (const CutFinding& finding : found) cutting_.also(finding);
  for (const std::string& note : notes)
    if (on_note) on_note(note);
}

void CutRun::attach(const StopToken& stop, ProgressDisplay* progress_display) {
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

void CutRun::finish() {
  if (watch_ != nullptr) watch([&](auto& found, auto& notes) { watch_->finish(found, notes); });
  cutting_.finish();
}

CutResult CutRun::named(CutResult result) const {
  for (auto* const findings : {&result.collisions, &result.warnings})
    for (CutFinding& f : *findings) name_program(f), f.calls = session_.settled_control().calls_of(f.origin);
  for (BlockLoad& load : result.heaviest) name_program(load);
  for (AirCut& air : result.emptiest) name_program(air);
  for (ThreadCut& thread : result.threads) name_program(thread);
  return result;
}

PartResult CutRun::part_result(const PartComparison& c) const {
  const auto difference = [&](const PartOffence& o) {
    const SweepLines::Line line = cutting_.line_of(o.sweep);
    return PartDifference{o.volume, o.deepest, o.at, line.line, program_of(line.file)};
  };
  return {difference(c.left_on), difference(c.gouged)};
}

void CutRun::consume(const Step& step, double longer) {
  const MachineTime time{step.begins + later_, step.time.seconds + longer};
  later_ += longer;
  if (watch_ != nullptr) watch([&](auto& found, auto& notes) { watch_->take(step, time, found, notes); });
  if (without_shape_) return;
  if (const Status taken = cutting_.consume(step, time); !taken) {
    without_shape_ = session_.settled_control().report_for(taken.error(), step.action.origin);
    take(*without_shape_);
  }
}

void CutRun::take(const AlarmReport& report) {
  if (report.alarm.severity != Severity::note) ++(report.alarm.severity == Severity::alarm ? alarms_ : warnings_);
  if (on_report) on_report(report);
}

}  // namespace kadr
