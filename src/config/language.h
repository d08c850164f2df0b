#pragma once
// The language in which the readers of files report faults. Functions deep in a call chain create the error sentences, which the callers
// only pass on, in tl::expected<…, std::string>. So the language belongs to the process, like a locale: the command line sets it once,
// before anything is read.

#include <string>

#include "config/alarm_texts.h"

namespace kadr {

/// Sets the language of the process; the default is English.
void set_process_language(Lang lang);
/// Sets the language of the current thread only: a web page has a language of its own.
void set_thread_language(Lang lang);

/// Returns the language of the current thread.
Lang thread_language();

/// Returns one of two sentences with the same meaning, in the language of the thread: for what a control file says in both languages. Texts
/// of Kadr itself are in texts/*.toml (config/texts.h).
std::string in_thread_language(std::string en, std::string ru);

}  // namespace kadr
