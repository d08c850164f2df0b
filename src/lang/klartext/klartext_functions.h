#pragma once
// KlartextFunctions: reads assignments to Q parameters, and the functions FN 0 to FN 38 (spec/heidenhain 10). Base of the parser.

#include <string_view>

#include "lang/klartext/klartext_words.h"

namespace kadr {

class KlartextFunctions : public KlartextWords {
 public:
  using KlartextWords::KlartextWords;

 protected:
  Status name_of(KlartextKind kind, std::string_view name);
  /// Passes several words with any number of blanks between them.
  bool take_spaced(std::string_view what);
  /// Reads a label: a number, a name in quotation marks, or a parameter.
  Status label(KlartextKind kind);
  Status assignment();
  Status text_assignment();
  Status function();

 private:
  Status text_value();
  Status text_piece();
  Status computed(unsigned n);
  Status second_operand(unsigned n);
  Status condition();
  Status system_value();
  Status circle_data();
  Status exported();
};

}  // namespace kadr
