// What a debugger shows of a held program: calls, positions, modes, variables, expressions. Tested by tests/dap.py.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/ascii.h"
#include "config/texts.h"
#include "lang/expression/expression.h"
#include "lsp/debug_adapter.h"
#include "texts/dap.h"
#include "texts/lsp.h"

namespace kadr {
namespace {

using Kind = InForce::Kind;

/// The groups of values. Their numbers are the references by which the editor asks for them.
enum Scope : int { positions = 1, modes, variables_of_program, locals_of_frame = 100 };  // and the number of the frame

constexpr std::uint32_t last_local = 33, last_local_of_calls = 30;  // #1 to #33 (nct 23.1); #1 to #30 (spec/linuxcnc 6.2)

bool is_of_name(char c) { return is_digit(c) || is_letter(c) || c == '_'; }

/// Returns the length of the variable at the beginning of a text: #101, #<depth>, WIDTH; 0 if there is none.
std::size_t variable_at(std::string_view text) {
  if (text.empty()) return 0;
  if (text.starts_with("#<")) return text.find('>') == std::string_view::npos ? 0 : text.find('>') + 1;
  const std::size_t begin = text.front() == '#' ? 1 : 0;
  if (begin == 0 && !is_letter(text.front()) && text.front() != '_') return 0;
  std::size_t end = begin;
  while (end < text.size() && is_of_name(text[end])) ++end;
  return end == begin ? 0 : end;
}

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

/// Returns the frames of the call stack, innermost first: all, or the part that the editor asks for.
LspJson DebugAdapter::stack(const LspJson& arguments) {
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
  const auto number = [&](const char* name) -> std::size_t {
    const auto found = arguments.is_object() ? arguments.find(name) : arguments.end();
    return arguments.is_object() && found != arguments.end() && found->is_number_unsigned() ? found->get<std::size_t>() : 0;
  };
  const std::size_t first = std::min(number("startFrame"), count), levels = number("levels");
  const std::size_t last = levels == 0 ? count : first + std::min(levels, count - first);
  frames = LspJson(LspJson::array_t(frames.begin() + std::ptrdiff_t(first), frames.begin() + std::ptrdiff_t(last)));
  return {{"stackFrames", std::move(frames)}, {"totalFrames", count}};
}

/// Returns how many calls were open in the frame that the editor names: the innermost if it names none.
std::size_t DebugAdapter::depth_of_frame(const LspJson& arguments) const {
  const std::size_t open = session_->control().calls().size();
  const auto frame = arguments.is_object() ? arguments.find("frameId") : arguments.end();
  if (!arguments.is_object() || frame == arguments.end()) return open;
  if (!frame->is_number_unsigned() || frame->get<std::uint64_t>() > open)
    throw LspFault{LspFault::invalid_params, translated(texts::dap::no_frame, frame->dump())};
  return open - frame->get<std::size_t>();
}

/// Returns the local variables of the program and of its calls, outermost first.
std::vector<LocalVariables> DebugAdapter::locals() const {
  const auto snapshot = session_->control().snapshot();
  return snapshot ? local_variables(*snapshot, session_->def()) : std::vector<LocalVariables>();
}

namespace {

/// Returns the variables of the innermost level that a frame with this number of open calls has; nullptr if there is none.
const LocalVariables* level_at(const std::vector<LocalVariables>& levels, std::size_t depth) {
  const auto found = std::find_if(levels.rbegin(), levels.rend(), [&](const LocalVariables& level) { return level.depth <= depth; });
  return found == levels.rend() ? nullptr : &*found;
}

const double* value_named(const LocalVariables& level, std::string_view name) {
  const auto found = std::find_if(level.values.begin(), level.values.end(), [&](const auto& one) { return one.first == name; });
  return found == level.values.end() ? nullptr : &found->second;
}

}  // namespace

LspJson DebugAdapter::scopes(const LspJson& arguments) {
  stepping();
  const std::size_t frame = session_->control().calls().size() - depth_of_frame(arguments);
  const auto scope = [](const std::string& name, int reference) {
    return LspJson{{"name", name}, {"variablesReference", reference}, {"expensive", false}};
  };
  LspJson all = {scope(translated(texts::dap::positions), positions), scope(translated(texts::dap::modes), modes),
                 scope(translated(texts::dap::variables), variables_of_program)};
  if (const auto levels = locals(); !levels.empty()) {
    LspJson own = scope(translated(texts::dap::locals), locals_of_frame + static_cast<int>(frame));
    own["presentationHint"] = "locals";
    const LocalVariables* const level = level_at(levels, depth_of_frame(arguments));
    const bool has_values = level != nullptr && !level->values.empty();
    all.insert(has_values ? all.begin() : all.end(), std::move(own));  // editors open the first scope
  }
  return {{"scopes", std::move(all)}};
}

LspJson DebugAdapter::variables_json(const std::vector<std::pair<std::string, double>>& values) const {
  LspJson all = LspJson::array();
  for (const auto& [name, value] : values)
    all.push_back({{"name", name}, {"value", text_of(value)}, {"evaluateName", name}, {"variablesReference", 0}});
  return {{"variables", std::move(all)}};
}

LspJson DebugAdapter::variables(const LspJson& arguments) {
  const LspJson& number = member(arguments, "variablesReference");
  stepping();
  const int reference = number.is_number_unsigned() ? static_cast<int>(std::min<std::uint64_t>(number.get<std::uint64_t>(), 1U << 30U)) : 0;
  const std::vector<LocalVariables> levels = locals();
  if (reference >= locals_of_frame) {
    const LocalVariables* const level = level_at(levels, depth_of_frame({{"frameId", unsigned(reference - locals_of_frame)}}));
    return variables_json(level == nullptr ? std::vector<std::pair<std::string, double>>() : level->values);
  }
  if (reference < positions || reference > variables_of_program)
    throw LspFault{LspFault::invalid_params, translated(texts::lsp::wrong_member, "variablesReference")};
  LspJson all = LspJson::array();
  for (const InForce& value : session_->control().in_force()) {
    if (reference != scope_of(value.kind)) continue;
    if (value.kind == Kind::variable && !levels.empty() && value_named(levels.back(), value.name) != nullptr) continue;  // a local one
    const std::string text = value.code.empty() ? text_of(value.value) : value.code;
    LspJson shown = {{"name", name_of(value)}, {"value", text}, {"variablesReference", 0}};
    if (value.kind == Kind::variable) shown["evaluateName"] = value.name;
    all.push_back(std::move(shown));
  }
  return {{"variables", std::move(all)}};
}

/// Evaluates an expression with the local variables of a frame. They are replaced by their values, because the control only knows those of
/// the innermost one.
Result<double> DebugAdapter::value_in_frame(const std::string& expression, std::size_t depth) const {
  const std::vector<LocalVariables> levels = locals();
  const LocalVariables* const level = level_at(levels, depth);
  if (level == nullptr || level == &levels.back()) return stepping_->value(expression);
  const bool by_calls = session_->def().has_parameter_file();
  std::string text;
  for (std::size_t at = 0; at < expression.size();) {
    const std::string_view rest = std::string_view(expression).substr(at);
    if (rest.starts_with("#[")) throw LspFault{LspFault::request_failed, translated(texts::dap::indirect)};
    const std::size_t length = std::max<std::size_t>(variable_at(rest), is_digit(rest.front()) ? 1 : 0);
    const std::string name(rest.substr(0, std::max<std::size_t>(length, 1)));
    at += name.size();
    const std::uint32_t number = name.size() > 1 && name.size() < 4 && name.front() == '#' ? std::uint32_t(std::atoi(name.c_str() + 1)) : 0;
    const bool is_numbered = number != 0 && number <= (by_calls ? last_local_of_calls : last_local);
    const double* const value = value_named(*level, name);
    if (value != nullptr) text += name.front() == '#' ? fmt::format("[{:.12f}]", *value) : fmt::format("({:.12f})", *value);
    else if (is_numbered) text += by_calls ? "0" : "#0";
    else if (value_named(levels.back(), name) != nullptr)
      throw LspFault{LspFault::request_failed, translated(texts::dap::not_in_frame, name)};
    else text += name;
  }
  return stepping_->value(text);
}

LspJson DebugAdapter::set_variable(const LspJson& arguments) {
  const std::string name = text_in(arguments, "name"), value = text_in(arguments, "value");
  const LspJson& reference = member(arguments, "variablesReference");
  if (reference != int(variables_of_program) && reference != int(locals_of_frame))
    throw LspFault{LspFault::request_failed, translated(texts::dap::only_variables)};
  begun();
  if (const auto number = stepping().value(value); !number)
    throw LspFault{LspFault::request_failed, opened_->texts->sentence(number.error(), lang_)};
  enter(name + "=" + value);
  const auto now = stepping().value(name);
  return {{"value", now ? text_of(*now) : value}};
}

/// Evaluates an expression. In the console, a text that is no expression is a line of the operator (MDI), which is executed.
LspJson DebugAdapter::evaluate(const LspJson& arguments) {
  const std::string text = text_in(arguments, "expression");
  const auto context = arguments.find("context");
  const std::size_t depth = (stepping(), depth_of_frame(arguments));
  const auto value = value_in_frame(text, depth);
  if (value) return {{"result", text_of(*value)}, {"variablesReference", 0}};
  if (context == arguments.end() || *context != "repl")
    throw LspFault{LspFault::request_failed, opened_->texts->sentence(value.error(), lang_)};
  begun();
  enter(text);
  return {{"result", translated(texts::dap::line_executed)}, {"variablesReference", 0}};
}

}  // namespace kadr
