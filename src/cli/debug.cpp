// kadr debug: executes a program step by step. The commands come from standard input, one per line. The command is tested by
// tests/debug.py.

#include "texts/debug.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <deque>
#include <iostream>
#include <map>

#include "cli/debug_restart.h"
#include "cli/job/drive.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "lang/expression/expression.h"
#include "out/text/alarm_print.h"
#include "out/text/in_force_text.h"

namespace kadr::cli {
namespace {

/// A command of the debugger: the first word of the line, and the rest of the line.
struct DebugCommand {
  std::string word, rest;
};

DebugCommand split(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin == std::string::npos) return {};
  const std::size_t end = std::min(line.find_first_of(" \t\r", begin), line.size());
  const std::size_t rest = line.find_first_not_of(" \t\r", end);
  std::string after = rest == std::string::npos ? "" : line.substr(rest);
  after.erase(after.find_last_not_of(" \t\r") + 1);
  return {line.substr(begin, end - begin), after};
}

/// Returns the text as a whole number. Returns `otherwise` if the text is empty, and nullopt if the text is no whole number.
std::optional<std::uint32_t> count_of(const std::string& text, std::uint32_t otherwise) {
  if (text.empty()) return otherwise;
  if (text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
  return static_cast<std::uint32_t>(std::stoul(text));
}

std::string commands_text() { return translated(texts::debug::commands); }

class Debugger : public PartOfProgram {
 public:
  explicit Debugger(Part part) : PartOfProgram(part.from, part.to), begins_inside_(part.from.line != 0) {}

  std::optional<Exit> begin(Session& session, const Job& job) override {
    session_ = &session;
    job_ = &job;
    begins_.in_force = session.control().in_force();
    begins_.stand = session.control().tool_position();
    return PartOfProgram::begin(session, job);
  }

  void execute(Session&) override {
    if (!begins_inside_) state_ = stepping().go(Stepping::How::block);
    first_ = stepping().snapshot();
    show();
    const bool asks = ::isatty(STDIN_FILENO) != 0;
    for (std::string line; !quit_ && !interrupted();) {
      if (asks) type_out("(kadr) ");
      // the debugger ends if its output is closed, or if the input contains no more commands
      if (std::fflush(stdout) != 0 || !std::getline(std::cin, line)) break;
      obey(split(line));
    }
    if (state_ == Session::State::held) (void)session_->stop_here();
    else finished_ = true;
  }
  bool wants_summary() const override { return finished_; }

 private:
  void obey(const DebugCommand& command) {
    using How = Stepping::How;
    const auto& [word, rest] = command;
    if (word.empty() || word[0] == '#') return;  // empty lines and comments (#) in a script of commands have no effect
    if (word == "step" || word == "s") return move(How::block, rest);
    if (word == "next" || word == "n") return move(How::over, rest);
    if (word == "finish" || word == "f") return move(How::out, "");
    // `run` is also accepted, since gdb starts a program with this word
    if (word == "continue" || word == "c" || word == "run" || word == "r") return go_on();
    if (word == "until" || word == "u") return until(rest);
    if (word == "back") return back(rest);
    if (word == "break" || word == "b") return add_break(rest);
    if (word == "breaks" || (word == "info" && rest.starts_with('b'))) return list_breaks();
    if (word == "delete" || word == "d") return remove(rest);
    if (word == "print" || word == "p") return print(rest);
    if (word == "watch" || word == "w") return watch(rest);
    if (word == "unwatch") return unwatch(rest);
    if (word == "where" || word == "bt") return where();
    if (word == "list" || word == "l") return list(rest);
    if (word == "state") return type_out("{}", in_force_text(session_->control().in_force(), job_->lang));
    if (word == "mdi" || word == "m") return mdi(rest);
    if (word == "restart") return restart(rest);
    if (word == "search") return search(rest);
    if (word == "quit" || word == "q") return void(quit_ = true);
    if (word == "help" || word == "h" || word == "?") return type_out("{}", commands_text());
    type_out("{}\n", translated(texts::debug::no_such_command, word));
  }

  bool is_held() const {
    if (state_ == Session::State::held) return true;
    type_out("{}\n", state_ == Session::State::ended ? translated(texts::debug::program_over) : translated(texts::debug::stopped_by_alarm));
    return false;
  }

  /// Stores the state of the session before a command. back() can then restore that state.
  void keep() {
    constexpr std::size_t most = 200;
    if (auto now = stepping().snapshot()) snapshots_.push_back(std::move(*now));
    if (snapshots_.size() > most) snapshots_.pop_front();
  }

  void move(Stepping::How how, const std::string& times) {
    const auto count = count_of(times, 1);
    if (!count) return wrong(times);
    if (!is_held()) return;
    keep();
    for (std::uint32_t i = 0; i < *count && state_ == Session::State::held && (i == 0 || stepping().hit() == 0); ++i)
      state_ = stepping().go(how);
    show();
  }

  void go_on() {
    if (!is_held()) return;
    keep();
    state_ = to() != 0 ? stepping().go_past(to()) : stepping().go(Stepping::How::free);
    show();
  }

  /// Reads a text of the form LINE or LINE:PASS. Prints an error and returns nullopt if the text has another form.
  std::optional<StopPoint> target_of(const std::string& rest) const {
    const std::size_t colon = rest.find(':');
    const auto line = count_of(rest.substr(0, colon), 0);
    const auto pass = colon == std::string::npos ? std::optional(0U) : count_of(rest.substr(colon + 1), 0);
    if (!line || *line == 0 || !pass) {
      wrong(rest);
      return std::nullopt;
    }
    StopPoint target;
    target.line = *line;
    target.pass = *pass;
    return target;
  }

  void until(const std::string& rest) {
    const auto target = target_of(rest);
    if (!target || !is_held()) return;
    keep();
    state_ = stepping().go_to(*target);
    show();
  }

  void search(const std::string& rest) {
    const auto target = target_of(rest);
    if (!target || !is_held()) return;
    if (!session_->control().search_rules()) return type_out("{}\n", translated(texts::debug::no_block_search));
    keep();
    if (first_)  // the control's block search starts at the beginning of the program, so the state at the beginning is restored first
      if (const Status restored = stepping().restore(*first_); !restored) return print_alarm(restored.error(), "");
    print_search(*session_, stepping(), *target, job_->lang);
    // if the search has ended at the end of the program, go_on() returns how the program ended
    state_ = stepping().next() ? Session::State::held : session_->go_on();
    show();
  }

  void restart(const std::string& clearance) {
    constexpr std::uint32_t usual = 100;
    const auto over = count_of(clearance, usual);
    if (!over) return wrong(clearance);
    if (is_held()) print_restart(*session_, stepping(), begins_, *over, job_->lang);
  }

  void back(const std::string& times) {
    const auto count = count_of(times, 1);
    if (!count || *count == 0) return wrong(times);
    if (snapshots_.empty()) return type_out("{}\n", translated(texts::debug::nothing_to_go_back_to));
    for (std::uint32_t i = 1; i < *count && snapshots_.size() > 1; ++i) snapshots_.pop_back();
    const Status restored = stepping().restore(snapshots_.back());
    snapshots_.pop_back();
    if (!restored) return print_alarm(restored.error(), "");
    state_ = Session::State::held;
    show();
  }

  void add_break(const std::string& text) {
    StopPoint point;
    std::string place = text;
    if (const std::size_t at = text.starts_with("if ") ? 0 : text.find(" if "); at != std::string::npos) {
      point.condition = text.substr(text.find("if ", at) + 3);
      place = text.substr(0, at);
    }
    if (place.starts_with("call ")) {
      point.call = place.substr(place.find_first_not_of(' ', 5));
    } else if (!place.empty()) {
      const std::size_t colon = place.rfind(':');
      const auto line = count_of(colon == std::string::npos ? place : place.substr(colon + 1), 0);
      if (!line || *line == 0) return wrong(text);
      point.line = *line;
      if (colon != std::string::npos) point.file = place.substr(0, colon);
    } else if (point.condition.empty()) {
      return wrong(text);
    }
    if (!point.condition.empty())
      if (const auto holds = stepping().holds(point.condition); !holds) return print_alarm(holds.error(), point.condition);
    type_out("{}\n", translated(texts::debug::breakpoint, stepping().add(point)));
  }

  void list_breaks() const {
    for (const auto& [number, point] : const_cast<Debugger*>(this)->stepping().points()) {
      std::string text;
      if (!point.call.empty()) text = "call " + point.call;
      else if (point.line != 0) text = point.file.empty() ? std::to_string(point.line) : fmt::format("{}:{}", point.file, point.line);
      if (!point.condition.empty()) text += (text.empty() ? "if " : " if ") + point.condition;
      type_out("{}  {}\n", number, text);
    }
  }

  void remove(const std::string& text) {
    const auto number = count_of(text, 0);
    if (!number || !stepping().remove(*number)) wrong(text);
  }

  void print(const std::string& expression) {
    const auto value = stepping().value(expression);
    if (!value) return print_alarm(value.error(), expression);
    type_out("{} = {}\n", expression, is_vacant(*value) ? translated(texts::debug::vacant) : fmt::format("{:.12g}", *value));
  }

  void watch(const std::string& expression) {
    if (const auto value = stepping().value(expression); !value) return print_alarm(value.error(), expression);
    watches_[watches_.empty() ? 1 : watches_.rbegin()->first + 1] = expression;
    print(expression);
  }

  void unwatch(const std::string& text) {
    const auto number = count_of(text, 0);
    if (!number || watches_.erase(*number) == 0) wrong(text);
  }

  void where() {
    if (stepping().next()) type_out("{}\n", place_text(stepping().line()));
    const auto calls = session_->control().calls();
    for (auto call = calls.rbegin(); call != calls.rend(); ++call)
      type_out("  {}\n", translated(texts::debug::called_in_line, call->what, call->line));
  }

  void list(const std::string& text) {
    const auto count = count_of(text, 11);
    if (!count || *count == 0) return wrong(text);
    const auto& next = stepping().next();
    if (!next) return;
    const std::uint32_t first = next->line > *count / 2 ? next->line - *count / 2 : 1;
    std::set<std::uint32_t> lines;
    for (std::uint32_t i = 0; i < std::min(*count, 1000U); ++i) lines.insert(first + i);
    for (const auto& [line, shown] : session_->control().texts_of(lines, next->file))
      type_out("{} {:>5}  {}\n", line == next->line ? "▸" : " ", line, shown.substr(0, shown.find_last_not_of(" \t\r\n") + 1));
  }

  void mdi(const std::string& line) {
    if (line.empty()) return wrong(line);
    keep();
    const Session::State done = stepping().enter(line);
    if (state_ == Session::State::stopped) state_ = done;
    if (stepping().next()) state_ = Session::State::held;
    show();
  }

  /// Prints the present position and the values of the watched expressions.
  void show() {
    if (interrupted()) return;
    if (stepping().hit() != 0) type_out("{}\n", translated(texts::debug::breakpoint, stepping().hit()));
    if (stepping().next()) type_out("{}\n", place_text(stepping().line()));
    else if (state_ == Session::State::ended) type_out("{}\n", translated(texts::debug::program_over));
    for (const auto& [number, expression] : watches_) print(expression);
  }

  void wrong(const std::string& text) const { type_out("{}\n", translated(texts::debug::not_understood, text)); }

  /// Prints an alarm about the text that the user has typed.
  void print_alarm(const Alarm& alarm, const std::string& typed) const {
    AlarmReport report{alarm, translated(texts::debug::command), typed, {}, {}, {}};
    report.origin.line = 1;
    report.origin.column = alarm.where.begin + 1;
    write_message(alarm_text(report, job_->texts(), job_->lang, colours()));
  }

  Session* session_ = nullptr;
  const Job* job_ = nullptr;
  Restart begins_;  // position and modes before the first block of the program
  const bool begins_inside_;
  Session::State state_ = Session::State::held;
  std::optional<Stepping::Memory> first_;  // snapshot of the run before the first block of the program
  std::deque<Stepping::Memory> snapshots_;
  std::map<std::size_t, std::string> watches_;
  bool quit_ = false, finished_ = false;
};

}  // namespace

int debug(const Options& options) {
  if (options.programs.front() == "-") {
    complain(translated(texts::debug::program_from_standard_input));
    return wrong_usage;
  }
  auto part = part_of(options);
  if (!part) return wrong_usage;
  Debugger debugger(std::move(*part));
  return run_by(options, debugger);
}

}  // namespace kadr::cli
