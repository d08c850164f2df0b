// Control::snapshot() and restore(), for stepping back and for continuing in the middle of a program. Tested by
// tests/control/snapshot_test.cpp.

#include "control/state/snapshot.h"

#include "control/interpreter.h"
#include "control/snapshot_content.h"

namespace kadr {
namespace {

/// Returns `last`, the copy in the previous snapshot, if it still equals the value `now`. If not, makes a new copy of the value and returns
/// it.
template <class Value>
std::shared_ptr<const Value> shared_with(std::shared_ptr<const Value>& last, const Value& now) {
  if (!last || !(*last == now)) last = std::make_shared<const Value>(now);
  return last;
}

}  // namespace

Flow::Memory Flow::memory() const {
  Memory now{now_, position(), {}, {}};
  now.files.resize(files_.size());
  for (std::size_t i = 0; i < files_.size(); ++i)
    if (files_[i]) now.files[i].memory = files_[i]->memory();
  for (const auto& [path, reader] : opened_) now.files[reader].name = path;
  for (const auto& [name, reader] : built_in_) now.files[reader].name = name, now.files[reader].built_in = true;
  for (const auto& [number, label] : labels_)
    if (label.called) now.called.push_back(number);
  return now;
}

Status Flow::resume_from(const Memory& memory) {
  constexpr std::size_t own_files = 2;  // the program and the cycle bodies always have the same numbers
  std::vector<std::uint16_t> readers;
  for (std::size_t i = own_files; i < memory.files.size(); ++i) {
    const File& file = memory.files[i];
    if (i == memory.now.entered.reader) {
      readers.push_back(static_cast<std::uint16_t>(files_.size()));
      files_.push_back(std::make_unique<ProgramFile>("MDI", text_source(memory.now.entered.line), body_grammar_, Encoding::utf8));
      continue;
    }
    const auto reader = file.built_in ? open_built_in(file.name) : open_program(file.name);
    if (!reader) return fail(alarm(AlarmId::file_missing, {}, std::string_view(file.name)));
    readers.push_back(*reader);
  }
  // Each file gets the number that it had at the snapshot, because calls and origins refer to files by number. Files that were opened after
  // the snapshot are closed.
  std::vector<std::unique_ptr<ProgramFile>> files(memory.files.size());
  files[0] = std::move(files_[0]);
  for (std::size_t i = 0; i < readers.size(); ++i) files[own_files + i] = std::move(files_[readers[i]]);
  files_ = std::move(files);
  opened_.clear();
  built_in_.clear();
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (!files_[i]) continue;
    files_[i]->resume_from(memory.files[i].memory);
    if (i >= own_files && i != memory.now.entered.reader)
      (memory.files[i].built_in ? built_in_ : opened_)[memory.files[i].name] = static_cast<std::uint16_t>(i);
  }
  if (!memory.called.empty() && !indexed_) make_index();
  for (auto& [number, label] : labels_) label.called = false;
  for (const std::uint32_t number : memory.called)
    if (const auto label = labels_.find(number); label != labels_.end()) label->second.called = true;
  now_ = memory.now;
  go_to(now_.reader, memory.position);
  return {};
}

std::optional<Snapshot> Interpreter::snapshot(double cutting_seen_ms) const {
  if (needs_probe) return std::nullopt;
  auto content = std::make_shared<Snapshot::Content>();
  content->state = *this;
  content->run = *this;
  content->flow = flow.memory();
  content->tables = shared_with(last_tables_, tables);
  content->variables = shared_with(last_variables_, variables.all());
  content->cutting_seen_ms = cutting_seen_ms;
  content->dialect = dialect->snapshot();
  content->each_block = each_block;
  content->block = block_memory();
  return Snapshot(std::move(content));
}

std::shared_ptr<const BlockMemory> Interpreter::block_memory() const {
  auto now = std::make_shared<BlockMemory>();
  now->block = *block;
  now->text = block->text;
  now->plan = *plan_now_;
  now->waiting.assign(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(waiting_count_));
  now->canned_cycle_run = canned_cycle_run;
  if (canned_cycle_run.active()) now->cycle = static_cast<std::size_t>(canned_cycle_run.cycle() - def.cycles.data());
  now->ellipse_run = ellipse_run;
  if (running) now->running = running->clone();
  now->phase = phase_;
  if (is_stopped()) now->report = report;
  now->exact = block_exact;
  now->machine_coordinates = block_machine_coordinates;
  now->axes_taken = block_axes_taken;
  return now;
}

void Interpreter::continue_in_block(const BlockMemory& then) {
  first_block = then.block;
  first_block.repeated = false;  // the block is a copy from the snapshot, not a block that is kept in memory for a loop
  first_text_ = then.text;
  first_block.text = first_text_;
  plan_ = then.plan;
  plan_now_ = &plan_;
  std::copy(then.waiting.begin(), then.waiting.end(), waiting_.begin());
  waiting_count_ = then.waiting.size();
  canned_cycle_run = then.canned_cycle_run;
  if (canned_cycle_run.active()) canned_cycle_run.relink(&def.cycles[then.cycle]);
  ellipse_run = then.ellipse_run;
  if (then.running) running = then.running->clone();
  phase_ = then.phase;
  if (is_stopped()) report = then.report;
  block_exact = then.exact;
  block_machine_coordinates = then.machine_coordinates;
  block_axes_taken = then.axes_taken;
}

Status Interpreter::restore(const Snapshot& from) {
  const Snapshot::Content& then = from.content();
  KADR_TRY(flow.resume_from(then.flow));
  stop_cycles();
  waiting_count_ = 0;
  phase_ = RunPhase::next_block;
  needs_probe = state_saved_ = false;
  flow_before_.reset();
  journal.begin();
  first_block = Block();
  block = &first_block;  // the block that was the current one may belong to a file that is now closed
  shape_ = nullptr;
  static_cast<ControlState&>(*this) = then.state;
  static_cast<RunMemory&>(*this) = then.run;
  each_block = each_block || then.each_block;
  // Recorded states are discarded, because the block numbers continue from an earlier number.
  if (std::exchange(block_states_, nullptr)) watch_states();
  tables = *then.tables;
  variables.put(*then.variables);
  // With a parameter file the variables store lengths in the machine's unit, also in inch mode (spec/linuxcnc 1.1).
  variables.inch = modal.inch && !def.has_parameter_file();
  continue_in_block(*then.block);
  return then.dialect ? dialect->restore(*this, *then.dialect) : Status();
}

}  // namespace kadr
