#pragma once
// Selects the English or the Russian text of a row of a control.

#include <string>

#include "config/alarm_texts.h"
#include "config/control/control_def.h"

namespace kadr {

/// Returns the text in this language; the English text if there is no Russian one.
inline const std::string& in_language(const Text& text, Lang lang) { return lang == Lang::ru && !text.ru.empty() ? text.ru : text.en; }

}  // namespace kadr
