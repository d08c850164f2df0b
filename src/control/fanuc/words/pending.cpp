// Handlers of words that need no action of their own (axis words, arguments of other codes), and the handler that raises the alarm for
// functions that Kadr does not implement.

#include "control/functions/functions.h"

namespace kadr::functions {

Status machine_axis(Emitter&, const Call&) { return {}; }
Status increment_axis(Emitter&, const Call&) { return {}; }
Status argument_only(Emitter&, const Call&) { return {}; }
Status not_available(Emitter&, const Call& call) {
  return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string()));
}

}  // namespace kadr::functions
