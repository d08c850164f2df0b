#pragma once
// Selects the English or the Russian text of a control's table row.

#include <string>

#include "config/alarm_texts.h"
#include "config/control/control_def.h"

namespace kadr {

/// Returns the text in this language. If there is no Russian text, the English text is returned.
inline const std::string& in_language(const Text& text, Lang lang) { return lang == Lang::ru && !text.ru.empty() ? text.ru : text.en; }

}  // namespace kadr
