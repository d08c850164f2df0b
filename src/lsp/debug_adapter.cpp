// DebugAdapter: the table of the requests, and the run. Its breakpoints are in lsp/debug_points, the values of a run in lsp/debug_values.
// Used by lsp/serve_editor; tested by tests/dap.py.

#include "lsp/debug_adapter.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "config/json_text.h"
#include "config/texts.h"
#include "lang/expression/expression.h"
#include "out/text/alarm_print.h"
#include "texts/dap.h"
#include "texts/lsp.h"

namespace kadr {
namespace {

constexpr int only_thread = 1;

bool flag_or(const LspJson& object, const char* name, bool otherwise) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return object.is_object() && found != object.end() && found->is_boolean() ? found->get<bool>() : otherwise;
}

}  // namespace

const std::map<std::string_view, DebugAdapter::Request>& DebugAdapter::requests() {
  using A = DebugAdapter;
  static const std::map<std::string_view, Request> all = {
      {"initialize", &A::initialize},
      {"launch", &A::launch},
      {"configurationDone", &A::configuration_done},
      {"setBreakpoints", &A::set_breakpoints},
      {"setFunctionBreakpoints", &A::set_call_breakpoints},
      {"dataBreakpointInfo", &A::watch_info},
      {"setDataBreakpoints", &A::set_watches},
      {"setExceptionBreakpoints", &A::nothing},  // an alarm always stops the run
      {"threads", &A::threads},
      {"stackTrace", &A::stack},
      {"scopes", &A::scopes},
      {"variables", &A::variables},
      {"setVariable", &A::set_variable},
      {"evaluate", &A::evaluate},
      {"continue", &A::proceed},
      {"next", &A::step_over},
      {"stepIn", &A::step_in},
      {"stepOut", &A::step_out},
      {"stepBack", &A::step_back},
      {"reverseContinue", &A::reverse},
      {"pause", &A::pause},
      {"restart", &A::restart},
      {"terminate", &A::terminate},
      {"disconnect", &A::leave},
  };
  return all;
}

void DebugAdapter::send(LspJson message) {
  message["seq"] = ++sequence_;
  send_(dumped_message(message));
}

void DebugAdapter::event(const char* name, LspJson body) { send({{"type", "event"}, {"event", name}, {"body", std::move(body)}}); }

void DebugAdapter::output(const std::string& text, const char* category) {
  event("output", {{"category", category}, {"output", text + '\n'}});
}

void DebugAdapter::take(std::string_view text) {
  set_thread_language(lang_);
  const LspJson message = json_of(text);
  if (!message.is_object() || text_or(message, "type", "") != "request" || !message.contains("seq") || !message["seq"].is_number_integer())
    return output(translated(texts::dap::no_request), "stderr");
  const std::string command = text_or(message, "command", "");
  LspJson response = {{"type", "response"}, {"request_seq", message["seq"]}, {"command", command}, {"success", true}};
  const auto arguments = message.find("arguments");
  try {
    const auto found = requests().find(command);
    if (found == requests().end()) throw LspFault{LspFault::method_not_found, translated(texts::dap::no_such_request, command)};
    LspJson body = (this->*found->second)(arguments == message.end() ? LspJson::object() : *arguments);
    if (!body.is_null()) response["body"] = std::move(body);
  } catch (const LspFault& fault) {
    response["success"] = false;
    response["message"] = fault.text;
  }
  send(std::move(response));
  if (const auto then = std::exchange(afterwards_, nullptr)) then();
}

Stepping& DebugAdapter::stepping() {
  if (!stepping_) throw LspFault{LspFault::request_failed, translated(texts::dap::no_program)};
  return *stepping_;
}

/// Returns the stepping of a run that has begun.
Stepping& DebugAdapter::begun() {
  if (!history_) throw LspFault{LspFault::request_failed, translated(texts::dap::no_program)};
  return *stepping_;
}

/// Returns the line of a program, from 1, in an object of the editor.
std::uint32_t DebugAdapter::line_in(const LspJson& object) const {
  const LspJson& line = member(object, "line");
  constexpr std::int64_t most = 1'000'000'000;
  if (!line.is_number_integer() || line.get<std::int64_t>() < first_line_ || line.get<std::int64_t>() > most)
    throw LspFault{LspFault::invalid_params, translated(texts::lsp::wrong_member, "line")};
  return line.get<std::uint32_t>() + 1 - first_line_;
}

// ---- the beginning

LspJson DebugAdapter::initialize(const LspJson& arguments) {
  first_line_ = flag_or(arguments, "linesStartAt1", true) ? 1 : 0;
  lang_ = language_named(text_or(arguments, "locale", "")).value_or(lang_);
  return {{"supportsConfigurationDoneRequest", true},
          {"supportsFunctionBreakpoints", true},
          {"supportsConditionalBreakpoints", true},
          {"supportsHitConditionalBreakpoints", true},
          {"supportsLogPoints", true},
          {"supportsDataBreakpoints", true},
          {"supportsEvaluateForHovers", true},
          {"supportsStepBack", true},
          {"supportsSetVariable", true},
          {"supportsRestartRequest", true},
          {"supportsTerminateRequest", true}};
}

void DebugAdapter::open(const LspJson& arguments) {
  OpeningRequest request;
  request.path = text_in(arguments, "program");
  request.control = text_or(arguments, "control", "");
  request.machine = text_or(arguments, "machine", "");
  request.setup = text_or(arguments, "setup", "");
  request.lang = lang_;
  auto opened = open_for_page(request);
  if (!opened) throw LspFault{LspFault::request_failed, opened.error()};
  opened_ = std::move(*opened);
  auto program = opened_->program();
  if (!program) throw LspFault{LspFault::request_failed, program.error()};
  SessionSpec spec = opened_->spec(std::move(*program), StopToken(gives_up_));
  spec.setup.channels.clear();
  auto session = Session::open(std::move(spec));
  if (!session) throw LspFault{LspFault::request_failed, in_thread_language(session.error().fault.en, session.error().fault.ru)};
  session_ = std::move(*session);
  session_->control().return_each_block();
  const auto told = [this](const AlarmReport& report) {
    if (!quiet_) output(alarm_text(report, *opened_->texts, lang_));
  };
  session_->outlets().warning = told;
  session_->outlets().alarm = [told](const AlarmReport& report) {
    told(report);
    return false;
  };
  stepping_ = std::make_unique<Stepping>(*session_);
  stepping_->on_block = [this](const Origin& block) { before_block(block); };
}

LspJson DebugAdapter::launch(const LspJson& arguments) {
  if (session_) throw LspFault{LspFault::invalid_request, translated(texts::dap::launched_already)};
  open(arguments);
  stops_on_entry_ = flag_or(arguments, "stopOnEntry", true);
  afterwards_ = [this] { event("initialized", LspJson::object()); };
  return nullptr;
}

LspJson DebugAdapter::configuration_done(const LspJson&) {
  stepping();
  if (configured_) throw LspFault{LspFault::invalid_request, translated(texts::dap::launched_already)};
  configured_ = true;
  afterwards_ = [this] {
    const Session::State state = stepping_->go(Stepping::How::block);
    history_ = std::make_unique<RunHistory>(*session_, *stepping_);
    reason_ = "entry";
    if (stops_on_entry_ || state != Session::State::held || stepping_->hit() != 0) return stop_at(state);
    go(Stepping::How::free, "pause");
  };
  return nullptr;
}

LspJson DebugAdapter::nothing(const LspJson&) { return nullptr; }

// ---- running

void DebugAdapter::go(Stepping::How how, const char* reason) {
  reason_ = reason;
  how_ = how;
  interrupted_ = false;
  search_.reset();
  depth_ = stepping_->next() ? stepping_->next()->depth : 0;
  stepping_->begin(Stepping::How::free);
  running_ = true;
}

/// Executes a line of the operator, which may call programs.
///   throws  LspFault if the control refuses the line, or if it takes too long
void DebugAdapter::enter(const std::string& line) {
  if (is_running()) throw LspFault{LspFault::request_failed, translated(texts::dap::runs)};
  constexpr std::chrono::seconds most(5);
  const auto until = std::chrono::steady_clock::now() + most;
  stepping_->begin_entering(line);
  Session::State state = Session::State::running;
  while ((state = session_->go_on()) == Session::State::running) gives_up_ = std::chrono::steady_clock::now() > until;
  const bool gave_up = gives_up_.exchange(false);
  stepping_->end_entering(state);
  if (gave_up) throw LspFault{LspFault::request_failed, translated(texts::dap::line_takes_long)};
  if (state == Session::State::stopped) throw LspFault{LspFault::request_failed, translated(texts::dap::line_refused)};
}

/// Returns true if the present step ends before this block.
bool DebugAdapter::asks_for(const Origin& block) const {
  switch (how_) {
    case Stepping::How::block: return true;
    case Stepping::How::over: return block.depth <= depth_;
    case Stepping::How::out: return block.depth < depth_;
    default: return false;
  }
}

/// Holds the program where the step ends, or where a message waits. A loop without motions can be held only here.
void DebugAdapter::before_block(const Origin& block) {
  if (search_ && search_->inside && stop_.requested()) stepping_->hold_next();
  if (!running_) return;
  const bool ends = asks_for(block);
  interrupted_ = !ends && stop_.requested();
  if (ends || interrupted_) stepping_->hold_next();
}

void DebugAdapter::work(const StopToken& stop) {
  set_thread_language(lang_);
  stop_ = stop;
  while (search_ && !stop.requested()) search_back();
  if (std::exchange(interrupted_, false)) stepping_->begin(Stepping::How::free);
  while (running_ && !stop.requested()) {
    const Session::State state = session_->go_on();
    if (state == Session::State::held && interrupted_ && stepping_->hit() == 0) break;
    interrupted_ = false;
    if (state != Session::State::running) {
      stop_at(state);
      break;
    }
    history_->note();
  }
  stop_ = {};
}

/// Reports where the program is held, or how it ended.
void DebugAdapter::stop_at(Session::State state) {
  running_ = false;
  if (state == Session::State::held) {
    const std::size_t hit = stepping_->hit();
    if (hit != 0 && passes_on(hit) && !(stepping_->next() && asks_for(*stepping_->next()))) {
      running_ = true;
      return stepping_->begin(Stepping::How::free);
    }
    const auto special = special_.find(hit);
    const bool watched = special != special_.end() && !special->second.watched.empty();
    return report_stop(hit == 0 ? reason_ : watched ? "data breakpoint" : "breakpoint");
  }
  if (state == Session::State::stopped) return report_stop("exception");
  event("exited", {{"exitCode", 0}});
  event("terminated", LspJson::object());
}

void DebugAdapter::report_stop(const char* reason) {
  LspJson body = {{"reason", reason}, {"threadId", only_thread}, {"allThreadsStopped", true}};
  if (stepping_->hit() != 0) body["hitBreakpointIds"] = {stepping_->hit()};
  if (std::string_view(reason) == "exception" && session_->stopped().report)
    body["text"] = sentence_of(*session_->stopped().report, *opened_->texts, lang_);
  if (const auto special = special_.find(stepping_->hit()); special != special_.end() && !special->second.watched.empty()) renew_watches();
  event("stopped", std::move(body));
}

void DebugAdapter::go_to_block(std::uint32_t number, const char* reason) {
  begun();
  afterwards_ = [this, number, reason] {
    running_ = interrupted_ = false;
    search_.reset();
    quiet_ = true;
    const auto state = history_->go_back(number);
    quiet_ = false;
    if (!state) return output(opened_->texts->sentence(state.error(), lang_), "stderr");
    reason_ = reason;
    if (*state == Session::State::held) report_stop(reason);
    else stop_at(*state);
  };
}

LspJson DebugAdapter::proceed(const LspJson&) {
  begun();
  afterwards_ = [this] { go(Stepping::How::free, "pause"); };
  return {{"allThreadsContinued", true}};
}
LspJson DebugAdapter::step_over(const LspJson&) {
  begun();
  afterwards_ = [this] { go(Stepping::How::over, "step"); };
  return nullptr;
}
LspJson DebugAdapter::step_in(const LspJson&) {
  begun();
  afterwards_ = [this] { go(Stepping::How::block, "step"); };
  return nullptr;
}
LspJson DebugAdapter::step_out(const LspJson&) {
  begun();
  afterwards_ = [this] { go(Stepping::How::out, "step"); };
  return nullptr;
}

LspJson DebugAdapter::step_back(const LspJson&) {
  const auto& next = begun().next();
  const std::uint32_t number = next ? next->number : session_->control().origin().number + 1;
  go_to_block(number == 0 ? 0 : number - 1, "step");
  return nullptr;
}

/// Goes back to the last block at which a breakpoint holds the program, or to the beginning.
LspJson DebugAdapter::reverse(const LspJson&) {
  begun();
  if (search_) return nullptr;  // it runs back already
  afterwards_ = [this] {
    running_ = interrupted_ = false;
    search_ = history_->begin_search();
  };
  return nullptr;
}

/// Searches one part of the run for a breakpoint that holds the program; breakpoints that write a message do not.
void DebugAdapter::search_back() {
  const auto holds = [this](std::size_t point) {
    const auto special = special_.find(point);
    return special == special_.end() || special->second.message.empty();
  };
  quiet_ = true;
  const auto state = history_->search(*search_, holds, stop_);
  quiet_ = false;
  if (state && !*state) return;
  search_.reset();
  if (!state) return output(opened_->texts->sentence(state.error(), lang_), "stderr");
  reason_ = "entry";
  stop_at(**state);
}

LspJson DebugAdapter::restart(const LspJson&) {
  go_to_block(0, "entry");
  return nullptr;
}

LspJson DebugAdapter::pause(const LspJson&) {
  begun();
  if (!is_running()) return nullptr;  // it is held already
  reason_ = "pause";
  if (search_) {
    search_.reset();
    afterwards_ = [this] { event("stopped", {{"reason", "pause"}, {"threadId", only_thread}, {"allThreadsStopped", true}}); };
    return nullptr;
  }
  how_ = Stepping::How::block;
  if (std::exchange(interrupted_, false)) afterwards_ = [this] { stop_at(Session::State::held); };
  return nullptr;
}

/// Ends the run. The editor then disconnects.
LspJson DebugAdapter::terminate(const LspJson&) {
  begun();
  running_ = interrupted_ = false;
  search_.reset();
  history_.reset();  // the run cannot be continued
  afterwards_ = [this] { event("terminated", LspJson::object()); };
  return nullptr;
}

LspJson DebugAdapter::leave(const LspJson&) {
  running_ = false;
  over_ = true;
  return nullptr;
}

}  // namespace kadr
