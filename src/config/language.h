#pragma once
// The language in which Kadr reports faults of files. Functions deep in a call chain create the error sentences, and their callers only
// pass these sentences on, in tl::expected<…, std::string>. So the language belongs to the process, like a locale: the command line sets it
// once, before any file is read.

#include <string>

#include "config/alarm_texts.h"

namespace kadr {

/// Sets the language of the process; the default is English.
void set_process_language(Lang lang);
/// Sets the language of the current thread only, because each web page has a language of its own.
void set_thread_language(Lang lang);

/// Returns the language of the current thread.
Lang thread_language();

/// Returns the sentence `en` or `ru`, which mean the same, in the language of the thread. For sentences of a control file, which has both
/// languages; texts of Kadr itself are in texts/*.toml (config/texts.h).
std::string in_thread_language(std::string en, std::string ru);

}  // namespace kadr
