// The language in which the readers of files report faults. Used by cli, config, machine, out.

#include "config/language.h"

#include <atomic>
#include <optional>

namespace kadr {
namespace {

std::atomic<Lang> spoken = Lang::en;
thread_local std::optional<Lang> spoken_here;

}  // namespace

void set_process_language(Lang lang) { spoken = lang; }

void set_thread_language(Lang lang) { spoken_here = lang; }

Lang thread_language() { return spoken_here.value_or(spoken.load()); }

std::string told(std::string en, std::string ru) { return thread_language() == Lang::ru ? std::move(ru) : std::move(en); }

std::string count_in_russian(std::uint64_t n, const char* one, const char* few, const char* many) {
  const std::uint64_t ten = n % 10, hundred = n % 100;
  const bool teen = hundred >= 11 && hundred <= 14;
  const char* const form = teen ? many : ten == 1 ? one : ten >= 2 && ten <= 4 ? few : many;
  return std::to_string(n) + " " + form;
}

}  // namespace kadr
