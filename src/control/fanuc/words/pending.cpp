// Functions that are not done yet say so.

#include "control/functions/functions.h"

namespace kadr::functions {

Status machine_axis(Interpreter&, const Call&) { return {}; }
Status increment_axis(Interpreter&, const Call&) { return {}; }
Status argument_only(Interpreter&, const Call&) { return {}; }
Status not_available(Interpreter&, const Call& call) {
  return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string()));
}

}  // namespace kadr::functions
