#pragma once
// KlartextCycles: reads CYCL DEF, GLOBAL DEF and TCH PROBE (spec/heidenhain 12). Base of the parser.

#include "lang/klartext/klartext_functions.h"

namespace kadr {

class KlartextCycles : public KlartextFunctions {
 public:
  using KlartextFunctions::KlartextFunctions;

 protected:
  Status cycle();
  Status global_definition();
  Status probe();

 private:
  bool is_assignment() const;
  Status cycle_line();
  Status axis_words();
  Status cycle_parameters();
};

}  // namespace kadr
