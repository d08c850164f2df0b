// Describes punched tape in words. Used by cli/tape_command and view/page/page_tape; tested by tests/run_tapes.py and
// tests/serve_making.py.

#include "out/text/tape_text.h"

#include <fmt/core.h>

#include "lang/text/eia.h"

namespace kadr {

std::string orientation_in_words(TapeOrientation lie, Lang lang) {
  const bool ru = lang == Lang::ru;
  switch (lie) {
    case TapeOrientation::wrong_end: return ru ? "считана с конца: образ перевёрнут" : "read from its wrong end: turned";
    case TapeOrientation::wrong_side: return ru ? "считана не той стороной: дорожки переставлены" : "read from its wrong side: turned over";
    default: return ru ? "считана с конца и не той стороной: образ перевёрнут" : "read from its wrong end and side: turned";
  }
}

std::string fault_in_words(const TapeFault& fault, TapeCode code, Lang lang) {
  const bool ru = lang == Lang::ru, odd = code == TapeCode::eia;
  const bool parity = odd != has_odd_parity(fault.byte);
  const char* const what = !parity ? (ru ? "нет такого кода EIA" : "no code of EIA")
                           : !ru   ? "parity error"
                           : odd   ? "чётное число отверстий"
                                   : "нечётное число отверстий";
  return fmt::format(fmt::runtime(ru ? "строка {}: {} (байт {:03o})" : "row {}: {} (byte {:03o})"), fault.row, what, fault.byte);
}

std::string_view name_for_people(TapeCode code) { return code == TapeCode::eia ? "EIA" : "ISO-7"; }

}  // namespace kadr
