#pragma once
// Selects the English or the Russian text.

#include <array>
#include <string>
#include <string_view>

#include "config/alarm_texts.h"
#include "config/control/control_def.h"

namespace kadr {

/// English text, Russian text.
using BothLanguages = std::array<std::string_view, 2>;

inline std::string_view in_language(const BothLanguages& text, Lang lang) { return text[lang == Lang::ru ? 1 : 0]; }

/// Returns the text in this language; the English text if there is no Russian one.
inline const std::string& in_language(const Text& text, Lang lang) { return lang == Lang::ru && !text.ru.empty() ? text.ru : text.en; }

}  // namespace kadr
