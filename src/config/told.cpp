// The language in which the readers of files report faults. Used by cli, config, machine, out.

#include "config/told.h"

#include <atomic>
#include <optional>

namespace kadr {
namespace {

std::atomic<Lang> spoken = Lang::en;
thread_local std::optional<Lang> spoken_here;

}  // namespace

void tell_in(Lang lang) { spoken = lang; }

void tell_here_in(Lang lang) { spoken_here = lang; }

Lang told_lang() { return spoken_here.value_or(spoken.load()); }

std::string told(std::string en, std::string ru) { return told_lang() == Lang::ru ? std::move(ru) : std::move(en); }

std::string told_count(std::uint64_t n, const char* one, const char* few, const char* many) {
  const std::uint64_t ten = n % 10, hundred = n % 100;
  const bool teen = hundred >= 11 && hundred <= 14;
  const char* const form = teen ? many : ten == 1 ? one : ten >= 2 && ten <= 4 ? few : many;
  return std::to_string(n) + " " + form;
}

}  // namespace kadr
