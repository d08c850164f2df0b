#pragma once
// The language in which the readers of files tell what is wrong. Their sentences leave by tl::expected<…, std::string>, whole, from deep
// inside; so the language is that of the process, as a locale is: the command line sets it once, before anything is read.

#include <cstdint>
#include <string>

#include "config/alarm_texts.h"

namespace kadr {

/// English until somebody says otherwise.
void tell_in(Lang lang);
/// From here on in this thread, whatever the others are told: of a page with a language of its own.
void tell_here_in(Lang lang);

/// That of this thread.
Lang told_lang();

/// One of two sentences that say the same.
std::string told(std::string en, std::string ru);

/// A number of things in Russian: told_count(3, "строка", "строки", "строк") is "3 строки".
std::string told_count(std::uint64_t n, const char* one, const char* few, const char* many);

}  // namespace kadr
