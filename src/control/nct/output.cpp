#include "control/nct/output.h"

#include "control/machinery.h"

namespace kadr::nct {

Status output(Machinery&, const Statement& s) { return fail(alarm(AlarmId::not_available, s.where, "FOPEN")); }
Result<std::string> embedded_values(Machinery&, const std::string& text, Span) { return text; }

}  // namespace kadr::nct
