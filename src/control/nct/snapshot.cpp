// The dialect's part of a snapshot: its memory as a value, and what stands beside it.

#include "control/block_context.h"
#include "control/nct/nct.h"

namespace kadr::nct {
namespace {

struct NctState : DialectState {
  NctState(const Memory& plain, const ParameterStore& parameters_now, const MacroVariables& variables_now, const OutputFile& output_now)
      : memory(plain), parameters(parameters_now.memory()), variables(variables_now.memory()), output(output_now.memory()) {}

  Memory memory;
  ParameterStore::Memory parameters;
  MacroVariables::Memory variables;
  OutputFile::Memory output;
};

}  // namespace

std::shared_ptr<const DialectState> Nct::snapshot() const { return std::make_shared<NctState>(*this, parameters, variables, output); }

Status Nct::restore(BlockContext&, const DialectState& from) {
  const auto& then = static_cast<const NctState&>(from);
  KADR_TRY(output.remember(then.output));
  static_cast<Memory&>(*this) = then.memory;
  parameters.remember(then.parameters);
  variables.remember(then.variables);
  changes = Changes();  // of the state file: all rows once more
  before_ = {};
  return {};
}

}  // namespace kadr::nct
