// What a faulty block has changed is taken back (design.md 4); Interpreter::take_moment does the same for what all controls have.

#include "control/interpreter.h"
#include "control/nct/nct.h"

namespace kadr::nct {

void Nct::begin_block(Interpreter&) {
  before_.words = state.words;
  before_.in_thread = in_thread;
  before_.thread_lead = thread_lead;
  before_.smoothed = smoothed;
  before_.surface_angle = surface_angle;
  before_.side_step = state.side_step;
  before_.compensates = state.compensates;
  before_.commons.clear();
  before_.all = false;
}

void Nct::keep_all(const Interpreter& m) {
  if (before_.all) return;
  lengths_before_ = m.modal.lengths;
  before_.all = true;
  before_.state = state;
  before_.state.words = before_.words;
  before_.state.side_step = before_.side_step;
  before_.state.compensates = before_.compensates;
  before_.modal_calls = modal_calls;
  before_.active_modal_calls = active_modal_calls;
  before_.levels = variables.depth();
  before_.repeated_arguments = repeated_arguments.size();
  before_.data_mode = data_mode;
  before_.interrupt_program = interrupt_program;
  before_.parts_done = parts_done;
  before_.cells.clear();
  tools.begin_block();
  parameters.begin_block();
}

void Nct::take_back(Interpreter& m) {
  state.words = before_.words;
  in_thread = before_.in_thread;
  thread_lead = before_.thread_lead;
  smoothed = before_.smoothed;
  surface_angle = before_.surface_angle;
  state.side_step = before_.side_step;
  state.compensates = before_.compensates;
  for (auto common = before_.commons.rbegin(); common != before_.commons.rend(); ++common)
    variables.set_common(common->first, common->second);
  before_.commons.clear();
  if (!before_.all) return;
  state = before_.state;
  modal_calls = before_.modal_calls;
  active_modal_calls = before_.active_modal_calls;
  while (variables.depth() > before_.levels) variables.close_level();
  if (repeated_arguments.size() > before_.repeated_arguments) repeated_arguments.resize(before_.repeated_arguments);
  data_mode = before_.data_mode;
  interrupt_program = before_.interrupt_program;
  parts_done = before_.parts_done;
  for (auto cell = before_.cells.rbegin(); cell != before_.cells.rend(); ++cell) *cell->first = cell->second;
  tools.undo_block();
  parameters.undo_block();
  refresh_settings(m);
}

}  // namespace kadr::nct
