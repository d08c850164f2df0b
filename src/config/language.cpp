// The language in which Kadr reports faults of files. Used by cli, config, machine, out.

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

std::string in_thread_language(std::string en, std::string ru) { return thread_language() == Lang::ru ? std::move(ru) : std::move(en); }

}  // namespace kadr
