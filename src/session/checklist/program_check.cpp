// ProgramCheck: reports everything that a check of a program finds. It is used by cli/check and view/page/page_check, and tested by
// tests/run_check.py and tests/same_check.py.

#include "session/checklist/program_check.h"

#include <algorithm>
#include <deque>

#include "session/checklist/check_memory.h"
#include "session/checklist/checklist.h"
#include "session/checklist/sub_file.h"
#include "session/unstated.h"

namespace kadr {
namespace {

// greatest number of faults of one program; a text with more is probably no program for this control
constexpr std::size_t max_faults = 1000;
// Greatest number of repetitions of faults that have been reported already. After more repetitions the check ends, since the program is
// probably in an endless loop with a fault.
constexpr std::size_t most_again = 100'000;

bool holds_only_subs(const Session& session) {
  if (!session.def().grammar.o_words) return false;
  const auto source = session.control().source_of(0);
  return source != nullptr && holds_only_subprograms(LineReader(source));
}

}  // namespace

struct ProgramCheck::OfChannel {
  OfChannel(Session& session, std::size_t channel, const ChecklistBasis& basis) : checklist(session, channel, basis) {}
  Checklist checklist;
  std::size_t alarms = 0, warnings = 0, again = 0;
};

bool ProgramCheck::take(std::size_t channel, OfChannel& of, const AlarmReport& report) {
  const AlarmId id = report.alarm.id;
  if (request_.one_pass && (id == AlarmId::program_begins_again || id == AlarmId::passes_done)) return true;
  if (only_subprograms_ && id == AlarmId::rs274_program) return true;
  if (!seen_[channel].insert({report.file, report.origin.line, report.origin.column, id}).second) return ++of.again < most_again;
  if (running_ != nullptr) running_->note(report);
  of.alarms += report.alarm.severity == Severity::alarm;
  of.warnings += report.alarm.severity == Severity::warning;
  return take_(channel, report) && id != AlarmId::interrupted && of.alarms + of.warnings < max_faults;
}

/// Runs the session from the last stored place on, and stores places.
void ProgramCheck::run(Session& session, OfChannel& of, CheckMemory& memory) {
  CheckMemory::Before before = memory.continue_run(session, of.checklist);
  running_ = &memory;
  for (const AlarmReport& report : before.reports) (void)take(session.own(), of, report);
  of.again = before.again;
  while (session.go_on() == Session::State::running) memory.store_run(session, of.checklist, of.again);
  running_ = nullptr;
}

void ProgramCheck::check(Session& session, CheckMemory* memory) {
  const std::vector<Channel>& channels = session.channels();
  seen_.resize(std::max(seen_.size(), channels.size()));
  only_subprograms_ = holds_only_subs(session);
  session.together().stop_together = false;
  std::deque<OfChannel> all;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    OfChannel& of = all.emplace_back(session, i, request_.basis);
    const auto take_one = [this, i, &of](const AlarmReport& report) { return take(i, of, report); };
    session.outlets(i) = {.warning = [take_one](const AlarmReport& report) { (void)take_one(report); },
                          .alarm = take_one,
                          .progress_display = request_.progress_display,
                          .stop = request_.stop};
    of.checklist.attach();
  }
  // a single channel does not wait at waiting codes, since the programs of the other channels are not available
  if (channels.size() == 1) session.control().set_waiting(Control::Waiting::pass);
  if (memory != nullptr && channels.size() == 1) run(session, all.front(), *memory);
  else (void)session.run();
  for (std::size_t i = 0; i < channels.size() && !request_.stop.requested(); ++i) {
    OfChannel& of = all[i];
    channels[i].control->check_uncalled([&](const AlarmReport& report) { (void)take(i, of, report); });
    // After a refused block the rest of the run may differ from what the programmer intended. Therefore the checklist is omitted until the
    // errors are corrected.
    if (of.alarms == 0 && !only_subprograms_ && !request_.stop.requested())
      for (const AlarmReport& advice : of.checklist.reports(request_.stop, memory == nullptr ? nullptr : &memory->text_places()))
        (void)take(i, of, advice);
    if (i != session.own()) continue;
    if (const auto note = unstated(*channels[i].control, session.def(), session.setup(), request_.stated)) (void)take(i, of, *note);
  }
}

}  // namespace kadr
