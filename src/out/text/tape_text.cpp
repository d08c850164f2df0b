// Describes a punched tape in words. This file is used by cli/tape_command and view/page/page_tape, and tested by tests/run_tapes.py and
// tests/serve_making.py.

#include "out/text/tape_text.h"

#include <fmt/core.h>

#include "lang/text/eia.h"
#include "texts/tape_text.h"

namespace kadr {

std::string orientation_in_words(TapeOrientation orientation, Lang lang) {
  switch (orientation) {
    case TapeOrientation::wrong_end: return plain_text(texts::tape_text::from_wrong_end, lang);
    case TapeOrientation::wrong_side: return plain_text(texts::tape_text::from_wrong_side, lang);
    default: return plain_text(texts::tape_text::from_wrong_end_and_side, lang);
  }
}

std::string fault_in_words(const TapeFault& fault, TapeCode code, Lang lang) {
  const bool odd = code == TapeCode::eia;
  const bool parity = odd != has_odd_parity(fault.byte);
  const PlainText what = !parity ? texts::tape_text::no_such_code : odd ? texts::tape_text::even_holes : texts::tape_text::odd_holes;
  return translated_in(lang, texts::tape_text::row_fault, fault.row, plain_text(what, lang), fmt::format("{:03o}", fault.byte));
}

std::string_view name_for_people(TapeCode code) { return code == TapeCode::eia ? "EIA" : "ISO-7"; }

}  // namespace kadr
