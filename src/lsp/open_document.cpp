// OpenDocument: a program that is open in an editor. Used by lsp/language_server; tested by tests/lsp.py.

#include "lsp/open_document.h"

#include <algorithm>

#include "config/texts.h"
#include "session/checklist/program_check.h"
#include "texts/lsp.h"

namespace kadr {
namespace {

constexpr std::size_t max_findings = 1000;
constexpr std::uint64_t max_repeated = 2'000'000;  // blocks that jumps repeat: the program in an editor may be endless

/// Returns the line, from 1, of the program itself to which a report belongs: its own, or that of the outermost call.
std::uint32_t own_line(const AlarmReport& report) {
  if (report.origin.file == 0) return report.origin.line;
  const auto call = std::find_if(report.calls.begin(), report.calls.end(), [](const AlarmReport::Call& c) { return c.file.empty(); });
  return call == report.calls.end() ? 1 : call->line;
}

SessionSpec spec_of(const OpenedProgram& opened, Program program, const StopToken& stop) {
  SessionSpec spec = opened.spec(std::move(program), stop);
  spec.limits.restarts = 0;
  spec.limits.repeated_blocks = max_repeated;
  spec.setup.channels.clear();  // the programs of other channels are not open
  return spec;
}

}  // namespace

OpenDocument::OpenDocument(std::string its_uri, std::string its_path, std::string text, int its_version, ColumnUnit unit,
                           DocumentChoice choice)
    : uri(std::move(its_uri)), path(std::move(its_path)), version(its_version), text_(std::move(text), unit) {
  reopen(choice);
}

void OpenDocument::reopen(const DocumentChoice& choice) {
  const std::string before = opened_ ? opened_->def->id : std::string();
  choice_ = choice;
  checked_ = has_results_ = false;
  check_memory_ = {};
  OpeningRequest request{path, choice.control, choice.machine, choice.setup, {}, text_.text()};
  request.lang = choice.lang;
  auto opened = open_for_page(request);
  no_control_ = opened ? std::string() : opened.error();
  opened_.reset();
  if (opened) opened_ = std::move(*opened);
  if (!opened_) return names_.reset();
  opened_->text.reset();  // the text of this document is used instead
  if (names_ && opened_->def->id == before) return;
  names_.emplace(opened_->def);
  names_->read(text_);
}

void OpenDocument::change(const std::optional<TextRange>& range, const std::string& text) {
  const TextDocument::ChangedLines changed = range ? text_.change(*range, text) : text_.replace(text);
  checked_ = has_results_ = false;
  if (names_) names_->update(text_, changed);
  // The results of the lines before the change stay, and those after it move with their lines.
  if (results_.empty()) return;
  results_.resize(std::max(results_.size(), changed.first + changed.removed));
  const auto at = results_.begin() + static_cast<std::ptrdiff_t>(changed.first);
  results_.insert(results_.erase(at, at + static_cast<std::ptrdiff_t>(changed.removed)), changed.added, {});
}

const LineResult* OpenDocument::result(std::size_t line) const {
  return line < results_.size() && results_[line].runs != 0 ? &results_[line] : nullptr;
}

void OpenDocument::add(const AlarmReport& report, std::vector<DocumentFinding>& to) const {
  DocumentFinding found{finding_of(report, *opened_->texts, choice_.lang), {}, {}, {}};
  const std::size_t line = std::max(own_line(report), 1U) - 1;
  const auto range_between = [&](std::uint32_t from, std::uint32_t until) {
    const auto at = static_cast<std::uint32_t>(line);
    return TextRange{{at, text_.column_of_character(line, from)}, {at, text_.column_of_character(line, until)}};
  };
  if (report.origin.file != 0) {
    found.range = text_.range_of_line(line);
  } else {
    found.range = range_between(found.finding.column, found.finding.end_column);
    found.fix = quick_fix(report, choice_.lang);
    if (found.fix) found.fixed = range_between(found.fix->from, found.fix->to);
  }
  to.push_back(std::move(found));
}

bool OpenDocument::find_faults(const StopToken& stop) {
  std::vector<DocumentFinding> found;
  auto program = opened_->program_of(text_.text());
  if (!program) {
    no_control_ = program.error();
    return true;
  }
  program->source = check_memory_.follow(std::move(program->source));
  auto session = Session::open(spec_of(*opened_, std::move(*program), stop));
  if (!session) {
    no_control_ = choice_.lang == Lang::ru ? session.error().fault.ru : session.error().fault.en;
    return true;
  }
  ProgramCheck({.stated = opened_->stated, .basis = {opened_->tools, opened_->number == 0, opened_->number == 0}, .stop = stop},
               [&](std::size_t, const AlarmReport& report) {
                 if (report.alarm.id != AlarmId::interrupted) add(report, found);
                 return found.size() < max_findings;
               })
      .check(**session, &check_memory_);
  if (stop.requested()) return false;
  findings_ = std::move(found);
  return true;
}

void OpenDocument::find_results(const StopToken& stop) {
  has_results_ = true;
  if (!opened_) return;
  auto program = opened_->program_of(text_.text());
  if (!program) return;
  auto session = Session::open(spec_of(*opened_, std::move(*program), stop));
  if (!session) return;
  std::vector<LineResult> results(text_.lines());
  Outlets& outlets = (*session)->outlets();
  outlets.stop = stop;
  outlets.wants_times = true;
  outlets.step = [&](const Step& step) {
    const Origin& origin = step.action.origin;
    const Motion* const motion = step.motion();
    if (origin.file != 0 || origin.line == 0 || origin.line > results.size()) return;
    LineResult& of = results[origin.line - 1];
    of.seconds += motion != nullptr ? step.time.seconds : step.pause;
    if (motion == nullptr) return;
    ++of.runs;
    of.moves = true;
    of.to = motion->to;
    of.feed = step.time.feed;
  };
  while ((*session)->go_on() == Session::State::running) {
  }
  has_results_ = !stop.requested();
  if (has_results_) results_ = std::move(results);
}

bool OpenDocument::check(const StopToken& stop) {
  if (!opened_) {
    reopen(choice_);  // the text may say more now
    if (!opened_) {
      findings_.clear();
      checked_ = true;
      return true;
    }
  }
  checked_ = find_faults(stop);
  return checked_;
}

}  // namespace kadr
