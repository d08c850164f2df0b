// Replaces macros by their texts. Used by control/sinumerik; tested by tests/lang/named_macros_test.cpp.

#include "lang/named/named_macros.h"

#include "base/ascii.h"
#include "lang/named/named_parser.h"

namespace kadr {
namespace {

constexpr int most_passes = 4;  // depth to which a macro may stand in the text of another one
constexpr std::size_t longest_text = 100'000;

/// Replaces the macros of the text once. Returns false if there is none.
bool replaced_once(const std::string& text, const NamedMacros& macros, std::string& to) {
  bool quoted = false, any = false;
  to.clear();
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '"') quoted = !quoted;
    if (quoted || !begins_name(text[i])) {
      to += text[i++];
      continue;
    }
    std::size_t end = i;
    std::string name;
    for (; end < text.size() && continues_name(text[end]); ++end) name += to_upper(text[end]);
    const bool system = i > 0 && text[i - 1] == '$';
    const auto found = system ? macros.end() : macros.find(name);
    if (found == macros.end()) to.append(text, i, end - i);
    else to += found->second;
    any = any || found != macros.end();
    i = end;
  }
  return any;
}

}  // namespace

std::optional<std::string> with_macros(std::string_view text, const NamedMacros& macros) {
  if (macros.empty()) return std::nullopt;
  std::string now(text), next;
  bool any = false;
  for (int pass = 0; pass < most_passes && now.size() < longest_text && replaced_once(now, macros, next); ++pass) {
    any = true;
    now.swap(next);
  }
  if (!any) return std::nullopt;
  return now;
}

}  // namespace kadr
