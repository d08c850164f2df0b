// The breakpoints of a debugger: on lines, on calls, on the change of values; and messages. Tested by tests/dap.py.

#include <fmt/format.h>

#include <filesystem>

#include "config/texts.h"
#include "lang/expression/expression.h"
#include "lsp/debug_adapter.h"
#include "texts/dap.h"
#include "texts/lsp.h"

namespace kadr {
namespace {

constexpr const char* of_calls = "call";  // the keys of points_ that are no files
constexpr const char* of_watches = "watch";

LspJson refused_point(const std::string& why) { return {{"verified", false}, {"message", why}}; }

/// Returns the list of breakpoints in a request.
///   throws  LspFault if there is none
const LspJson& points_in(const LspJson& arguments) {
  const LspJson& list = member(arguments, "breakpoints");
  if (!list.is_array()) throw LspFault{LspFault::invalid_params, translated(texts::lsp::wrong_member, "breakpoints")};
  return list;
}

}  // namespace

/// Removes the breakpoints of a file, of the calls or of the watched values.
void DebugAdapter::clear(const std::string& group) {
  stepping();
  for (const std::size_t number : std::exchange(points_[group], {})) {
    stepping_->remove(number);
    special_.erase(number);
  }
}

LspJson DebugAdapter::set_breakpoints(const LspJson& arguments) {
  const std::string path = text_in(member(arguments, "source"), "path");
  const auto wanted = arguments.find("breakpoints");
  clear(path);
  LspJson answer = LspJson::array();
  if (wanted == arguments.end() || !wanted->is_array()) return {{"breakpoints", std::move(answer)}};
  std::error_code none;
  const bool own = std::filesystem::equivalent(path, opened_->path, none) || path == opened_->path;
  for (const LspJson& one : *wanted) {
    StopPoint point;
    point.line = line_in(one);
    if (!own) point.file = path;
    point.condition = text_or(one, "condition", "");
    const std::string times = text_or(one, "hitCondition", "");
    constexpr std::size_t most_digits = 9;
    if (times.find_first_not_of("0123456789") != std::string::npos || times.size() > most_digits) {
      answer.push_back(refused_point(translated(texts::lsp::no_number, times)));
      continue;
    }
    if (!times.empty()) point.pass = static_cast<std::uint32_t>(std::stoul(times));
    if (!point.condition.empty())
      if (const auto holds = stepping().holds(point.condition); !holds) {
        answer.push_back(refused_point(opened_->texts->sentence(holds.error(), lang_)));
        continue;
      }
    const std::size_t number = stepping().add(point);
    points_[path].push_back(number);
    if (const std::string text = text_or(one, "logMessage", ""); !text.empty()) special_[number].message = text;
    answer.push_back({{"id", number}, {"verified", true}, {"line", point.line - 1 + first_line_}});
  }
  return {{"breakpoints", std::move(answer)}};
}

LspJson DebugAdapter::set_call_breakpoints(const LspJson& arguments) {
  const LspJson& wanted = points_in(arguments);
  clear(of_calls);
  LspJson answer = LspJson::array();
  for (const LspJson& one : wanted) {
    StopPoint point;
    point.call = text_in(one, "name");
    points_[of_calls].push_back(stepping().add(point));
    answer.push_back({{"id", points_[of_calls].back()}, {"verified", true}});
  }
  return {{"breakpoints", std::move(answer)}};
}

LspJson DebugAdapter::watch_info(const LspJson& arguments) {
  const std::string name = text_in(arguments, "name");
  const auto value = stepping().value(name);
  if (!value) return {{"dataId", nullptr}, {"description", opened_->texts->sentence(value.error(), lang_)}};
  return {{"dataId", name}, {"description", name}, {"accessTypes", {"write"}}, {"canPersist", true}};
}

LspJson DebugAdapter::set_watches(const LspJson& arguments) {
  const LspJson& wanted = points_in(arguments);
  clear(of_watches);
  LspJson answer = LspJson::array();
  for (const LspJson& one : wanted) {
    const std::string name = text_in(one, "dataId");
    const auto value = stepping().value(name);
    if (!value) {
      answer.push_back(refused_point(opened_->texts->sentence(value.error(), lang_)));
      continue;
    }
    StopPoint point;
    point.condition = fmt::format("{} != {}", name, is_vacant(*value) ? "#0" : fmt::format("{:.12f}", *value));
    points_[of_watches].push_back(stepping().add(point));
    special_[points_[of_watches].back()].watched = name;
    answer.push_back({{"id", points_[of_watches].back()}, {"verified", true}});
  }
  return {{"breakpoints", std::move(answer)}};
}

/// Returns true if a breakpoint that applies does not hold the program: it writes a message.
bool DebugAdapter::passes_on(std::size_t point) {
  const auto found = special_.find(point);
  if (found == special_.end() || found->second.message.empty()) return false;
  output(filled(found->second.message));
  return true;
}

/// Compares watched values from now on with what they are now.
void DebugAdapter::renew_watches() {
  LspJson watches = LspJson::array();
  for (const std::size_t number : points_[of_watches]) watches.push_back({{"dataId", special_[number].watched}});
  (void)set_watches({{"breakpoints", watches}});
}

}  // namespace kadr
