// What a debugger shows of a held program: calls, positions, modes, variables, expressions. Tested by tests/dap.py.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "config/texts.h"
#include "lang/expression/expression.h"
#include "lsp/debug_adapter.h"
#include "texts/dap.h"

namespace kadr {
namespace {

using Kind = InForce::Kind;

/// The groups of values. Their numbers are the references by which the editor asks for them.
enum Scope : int { positions = 1, modes, variables_of_program };

Scope scope_of(Kind kind) {
  switch (kind) {
    case Kind::position:
    case Kind::machine: return positions;
    case Kind::variable: return variables_of_program;
    default: return modes;
  }
}

std::string name_of(const InForce& value) {
  switch (value.kind) {
    case Kind::machine: return translated(texts::dap::of_machine, value.name);
    case Kind::feed: return "F";
    case Kind::speed: return "S";
    case Kind::spindle: return translated(texts::dap::spindle);
    case Kind::coolant: return translated(texts::dap::coolant);
    case Kind::tool: return translated(texts::dap::tool);
    case Kind::selected: return "T";
    case Kind::offset: return "D";
    case Kind::length_offset: return "H";
    case Kind::origin: return translated(texts::dap::origin, value.name);
    case Kind::length: return translated(texts::dap::tool_length, value.name);
    case Kind::rotation: return translated(texts::dap::rotation);
    case Kind::scale: return translated(texts::dap::scale, value.name);
    default: return value.name;
  }
}

}  // namespace

std::string DebugAdapter::text_of(double value) const {
  return is_vacant(value) ? translated(texts::dap::empty) : fmt::format("{:.10g}", value);
}

/// Replaces each {expression} of a message by its value.
std::string DebugAdapter::filled(const std::string& message) const {
  std::string text;
  for (std::size_t at = 0; at < message.size();) {
    const std::size_t open = message.find('{', at), close = message.find('}', open);
    if (close == std::string::npos) return text + message.substr(at);
    text += message.substr(at, open - at);
    const auto value = stepping_->value(message.substr(open + 1, close - open - 1));
    text += value ? text_of(*value) : opened_->texts->sentence(value.error(), lang_);
    at = close + 1;
  }
  return text;
}

LspJson DebugAdapter::threads(const LspJson&) { return {{"threads", {{{"id", 1}, {"name", translated(texts::dap::channel)}}}}}; }

LspJson DebugAdapter::frame_json(int id, const std::string& name, const std::string& file, std::uint32_t line) const {
  const std::string& path = file.empty() ? opened_->path : file;
  std::error_code none;
  const std::string whole = std::filesystem::absolute(path, none).string();
  return {{"id", id},
          {"name", name},
          {"source", {{"name", std::filesystem::path(path).filename().string()}, {"path", whole}}},
          {"line", std::max(line, 1U) - 1 + first_line_},
          {"column", first_line_}};
}

LspJson DebugAdapter::stack(const LspJson&) {
  const std::optional<Origin>& next = stepping().next();
  const Control& control = session_->control();
  const Origin here = next.value_or(control.origin());
  const std::vector<AlarmReport::Call> calls = control.calls();
  LspJson frames = LspJson::array();
  const std::string program = std::filesystem::path(opened_->path).filename().string();
  frames.push_back(
      frame_json(0, calls.empty() ? program : calls.back().what, here.file == 0 ? "" : control.file_name(here.file), here.line));
  for (std::size_t i = calls.size(); i-- > 0;)
    frames.push_back(frame_json(static_cast<int>(frames.size()), i == 0 ? program : calls[i - 1].what, calls[i].file, calls[i].line));
  const std::size_t count = frames.size();
  return {{"stackFrames", std::move(frames)}, {"totalFrames", count}};
}

LspJson DebugAdapter::scopes(const LspJson&) {
  stepping();
  const auto scope = [](const std::string& name, int reference) {
    return LspJson{{"name", name}, {"variablesReference", reference}, {"expensive", false}};
  };
  return {{"scopes",
           {scope(translated(texts::dap::positions), positions), scope(translated(texts::dap::modes), modes),
            scope(translated(texts::dap::variables), variables_of_program)}}};
}

LspJson DebugAdapter::variables(const LspJson& arguments) {
  const LspJson& reference = member(arguments, "variablesReference");
  stepping();
  LspJson all = LspJson::array();
  for (const InForce& value : session_->control().in_force()) {
    if (reference != scope_of(value.kind)) continue;
    const std::string text = value.code.empty() ? text_of(value.value) : value.code;
    LspJson shown = {{"name", name_of(value)}, {"value", text}, {"variablesReference", 0}};
    if (value.kind == Kind::variable) shown["evaluateName"] = value.name;
    all.push_back(std::move(shown));
  }
  return {{"variables", std::move(all)}};
}

LspJson DebugAdapter::set_variable(const LspJson& arguments) {
  const std::string name = text_in(arguments, "name"), value = text_in(arguments, "value");
  if (member(arguments, "variablesReference") != int(variables_of_program))
    throw LspFault{LspFault::request_failed, translated(texts::dap::only_variables)};
  if (running_) throw LspFault{LspFault::request_failed, translated(texts::dap::runs)};
  if (const auto number = stepping().value(value); !number)
    throw LspFault{LspFault::request_failed, opened_->texts->sentence(number.error(), lang_)};
  if (begun().enter(name + "=" + value) == Session::State::stopped)
    throw LspFault{LspFault::request_failed, translated(texts::dap::line_refused)};
  const auto now = stepping().value(name);
  return {{"value", now ? text_of(*now) : value}};
}

/// Evaluates an expression. In the console, a text that is no expression is a line of the operator (MDI), which is executed.
LspJson DebugAdapter::evaluate(const LspJson& arguments) {
  const std::string text = text_in(arguments, "expression");
  const auto context = arguments.find("context");
  const auto value = stepping().value(text);
  if (value) return {{"result", text_of(*value)}, {"variablesReference", 0}};
  if (context == arguments.end() || *context != "repl")
    throw LspFault{LspFault::request_failed, opened_->texts->sentence(value.error(), lang_)};
  if (running_) throw LspFault{LspFault::request_failed, translated(texts::dap::runs)};
  if (begun().enter(text) == Session::State::stopped) throw LspFault{LspFault::request_failed, translated(texts::dap::line_refused)};
  return {{"result", translated(texts::dap::line_executed)}, {"variablesReference", 0}};
}

}  // namespace kadr
