// Executes a program or a part of it (--from, --to). This file is used by cli/run and cli/debug, and tested by tests/debug.py.

#include "cli/job/drive.h"

#include <fmt/core.h>

#include <charconv>

#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "out/text/alarm_print.h"
#include "out/text/in_force_text.h"
#include "texts/job.h"

namespace kadr::cli {
namespace {

/// Returns the text as a whole number that is at least 1; nullopt for any other text.
std::optional<std::uint32_t> count_in(std::string_view text) {
  std::uint32_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || end != text.data() + text.size() || count == 0) return std::nullopt;
  return count;
}

std::nullopt_t wrong(const char* option, const std::string& text, PlainText wanted) {
  complain(fmt::format("{}: {}: {}", option, text, translated(wanted)));
  return std::nullopt;
}

}  // namespace

std::optional<Exit> Drive::begin(Session&, const Job&) { return std::nullopt; }

std::optional<Part> part_of(const Options& options) {
  Part part;
  if (!options.from.empty()) {
    const std::size_t colon = options.from.find(':');
    const auto line = count_in(std::string_view(options.from).substr(0, colon));
    const auto pass = colon == std::string::npos ? std::optional(1U) : count_in(std::string_view(options.from).substr(colon + 1));
    if (!line || !pass) return wrong("--from", options.from, texts::job::line_or_pass_wanted);
    part.from.line = *line;
    part.from.pass = *pass;
  }
  if (!options.to.empty()) {
    const auto line = count_in(options.to);
    if (!line) return wrong("--to", options.to, texts::job::line_wanted);
    part.to = *line;
  }
  return part;
}

std::unique_ptr<Drive> drive_of(const Options& options) {
  auto part = part_of(options);
  if (!part) return nullptr;
  if (part->is_whole()) return std::make_unique<Drive>();
  return std::make_unique<PartOfProgram>(std::move(part->from), part->to);
}

std::string place_text(const AlarmReport::Line& line) {
  std::string text = line.text.substr(0, line.text.find_last_not_of(" \t\r\n") + 1);
  return fmt::format("{}:{}: {}", line.file, line.number, text);
}

std::optional<Exit> PartOfProgram::begin(Session& session, const Job& job) {
  if (session.channels().size() > 1 && (from_.line != 0 || to_ != 0)) {
    complain(translated(texts::job::part_of_several_channels));
    return wrong_usage;
  }
  stepping_ = std::make_unique<Stepping>(session);
  return from_.line == 0 ? std::nullopt : go_there(session, job);
}

std::optional<Exit> PartOfProgram::go_there(Session& session, const Job& job) {
  Outlets& outlets = session.outlets();
  outlets.silent = true;
  outlets.alarm = [&job](const AlarmReport& report) {
    write_message(alarm_text(report, job.texts(), job.lang, colours()));
    return false;
  };
  const Session::State state = stepping_->go_to(from_);
  if (state == Session::State::held) {
    const std::string begins = translated(texts::job::run_begins_here);
    write_message(fmt::format("{}\n{}\n{}", place_text(stepping_->line()), begins, in_force_text(session.control().in_force(), job.lang)));
    return std::nullopt;
  }
  const std::string place = fmt::format("{}:{}", job.file, from_.line);
  const std::uint32_t passes = stepping_->passes(from_.line);
  if (state == Session::State::stopped) complain(translated(texts::job::alarm_before_from, place));
  else if (passes == 0) complain(translated(texts::job::no_block_at_from, place));
  else complain(translated(texts::job::fewer_passes_of_from, place, passes, from_.pass));
  return state == Session::State::stopped ? alarms : wrong_usage;
}

void PartOfProgram::execute(Session& session) {
  if (to_ == 0) return void(stepping_->go(Stepping::How::free));
  const Session::State state = stepping_->go_past(to_);
  if (state == Session::State::held) (void)session.stop_here();
}

}  // namespace kadr::cli
