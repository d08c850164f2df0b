// A program carried out on the part. For cli/cut.

#include "cli/cut_run.h"

#include <fmt/core.h>

#include "cli/stop.h"
#include "cli/terminal.h"
#include "out/text/alarm_print.h"
#include "out/text/cut_load_text.h"
#include "out/text/cut_text.h"

namespace kadr::cli {

CutRun::CutRun(const CutOptions& options, const Job& job, Session& session, const CutJob& cut, MachineWatch* watch)
    : job_(job),
      lang_(language(options.run)),
      session_(session),
      cutting_(cut, AxisRoles::of(session.control().axes(), session.control().rotary())),
      watch_(watch),
      progress_(options.run.quiet) {
  cutting_.on_finding = [this](const CutFinding& f) {
    AlarmReport report = session_.settled_control().report_for(alarm_of(f), f.origin);
    report.own_text = names_of_bodies(f);
    tell(report);
  };
}

void CutRun::write_blocks(std::FILE* file) {
  if (file == nullptr) return;
  fmt::print(file, "{}", blocks_heading());
  cutting_.on_block = [this, file](const BlockLoad& load) {
    BlockLoad told = load;
    name_program(told);
    fmt::print(file, "{}", blocks_row(told));
  };
}

template <class Take>
void CutRun::watch(const Take& take) {
  std::vector<CutFinding> found;
  std::vector<std::string> notes;
  take(found, notes);
  for (const CutFinding& finding : found) cutting_.also(finding);
  for (const std::string& note : notes) say(note + "\n");
}

void CutRun::carry_out(Drive& drive, const StopToken& stop) {
  const bool planned = session_.look_ahead().has_value();
  const Channel& own = session_.channels()[session_.own()];
  TimeEstimate clock(AxisRoles::of(own.control->axes(), own.control->rotary()), rates_of(job_.profile, own.setup, own.control->axes()));
  const auto say_it = [this](const AlarmReport& report) { count(report), tell(report); };
  Outlets& outlets = session_.outlets();
  outlets.warning = say_it;
  outlets.alarm = [say_it](const AlarmReport& report) { return say_it(report), false; };
  outlets.onlooker = &progress_;
  outlets.clock = &clock;
  outlets.stop = stop;
  outlets.works_long = true;
  if (planned) outlets.timed = [this](const Step& step, double longer) { consume(step, longer); };
  outlets.step = [this, planned](const Step& step) {
    if (!planned) consume(step, 0);
  };
  session_.change_outlets();
  drive.carry_out(session_);
  if (interrupted()) return;
  if (watch_ != nullptr) watch([&](auto& found, auto& notes) { watch_->finish(found, notes); });
  cutting_.finish();
}

CutResult CutRun::named(CutResult result) const {
  for (auto* const findings : {&result.collisions, &result.warnings})
    for (CutFinding& f : *findings) name_program(f), f.calls = session_.settled_control().calls_of(f.origin);
  for (BlockLoad& load : result.heaviest) name_program(load);
  for (AirCut& air : result.emptiest) name_program(air);
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
  if (watch_ != nullptr) watch([&](auto& found, auto& notes) { watch_->take(step, longer, found, notes); });
  if (failed_) return;
  const Status taken = cutting_.consume(step, longer);
  if (taken) return;
  failed_ = true;
  const AlarmReport report = session_.settled_control().report_for(taken.error(), step.action.origin);
  count(report);
  tell(report);
}

void CutRun::count(const AlarmReport& report) {
  if (report.alarm.severity != Severity::note) ++(report.alarm.severity == Severity::alarm ? alarms_ : warnings_);
}

void CutRun::tell(const AlarmReport& report) const { say(alarm_text(report, job_.texts(), lang_, colours())); }

}  // namespace kadr::cli
