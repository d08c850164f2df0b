// The program flow (the order in which blocks are executed): readers, call stack, repetitions, jumps. Used by control/interpreter,
// control/snapshot_content.

#include "control/flow/flow.h"

#include <algorithm>

#include "base/code_literals.h"
#include "config/embedded.h"
#include "lang/text/utf16.h"

namespace kadr {
namespace {

constexpr std::size_t max_labels = 100'000;  // greatest number of subprograms in one file

/// Returns the grammar of the bodies of canned cycles, which have no block numbers, no sign % and no ПС (end-of-block character).
Grammar grammar_of_bodies(const Grammar& program) {
  Grammar g = program;
  g.block_number_required = false;
  g.program_start_required = false;
  g.mark_everywhere = false;
  return g;
}

std::string text_of_bodies(const ControlDef& def, std::map<std::string, Position>& starts) {
  std::string text;
  std::uint32_t line = 1;
  for (const CycleRow& cycle : def.cycles) {
    if (cycle.body.empty()) continue;
    starts[cycle.name] = {text.size(), line, 0};
    text += cycle.body;
    line += static_cast<std::uint32_t>(std::count(cycle.body.begin(), cycle.body.end(), '\n'));
  }
  return text;
}

}  // namespace

Flow::Flow(const ControlDef& def, Program program, RunLimits limits)
    : def_(def), limits_(std::move(limits)), body_grammar_(grammar_of_bodies(def.grammar)) {
  files_.push_back(
      std::make_unique<ProgramFile>(std::move(program.file), std::move(program.source), def.grammar, program.encoding, limits_.stop));
  files_.push_back(nullptr);
  std::string bodies = text_of_bodies(def, body_starts_);
  if (!bodies.empty()) bodies_ = std::make_unique<BlockReader>(text_source(std::move(bodies)), body_grammar_, Encoding::utf8);
}

Result<BlockReader::Got> Flow::next(Block*& block) {
  if (now_.ended) return BlockReader::Got::end;
  if (!now_.frames.empty() || now_.restarts != 0 || now_.jumped_back) KADR_TRY(count_repeated(*block));
  ++now_.blocks;
  if (now_.reader != 1) [[likely]]
    return files_[now_.reader]->next(block);
  block = &body_block_;
  return bodies_->next(body_block_);
}

/// Counts a block that is executed again, and fails if the number exceeds the limit. `last`: the block before the repeated one; it is still
/// the current block.
Status Flow::count_repeated(const Block& last) {
  if (++now_.repeated <= limits_.repeated_blocks) return {};
  now_.ended = true;
  return fail(alarm(AlarmId::endless_program, last.where, static_cast<double>(limits_.repeated_blocks)));
}

void Flow::go_to(std::uint16_t reader, Position position) {
  now_.reader = reader;
  if (reader == 1) bodies_->seek(position);
  else files_[reader]->seek(position);
}

void Flow::jump(Position position) {
  ProgramFile& file = *files_[now_.reader];
  if (position.offset < file.position().offset) {
    now_.jumped_back = true;
    file.keep_blocks();
  }
  file.seek(position);
}

std::optional<std::uint16_t> Flow::open_program(const std::string& path) {
  if (const auto known = opened_.find(path); known != opened_.end()) return known->second;
  auto text = open_text(path, {}, limits_.door);
  if (!text.source) return std::nullopt;
  files_.push_back(std::make_unique<ProgramFile>(path, std::move(text.source), def_.grammar, text.encoding, limits_.stop));
  const auto reader = static_cast<std::uint16_t>(files_.size() - 1);
  opened_.emplace(path, reader);
  return reader;
}

std::vector<std::uint16_t> Flow::called_files() const {
  std::vector<std::uint16_t> numbers;
  for (std::size_t i = 1; i < files_.size(); ++i)
    if (files_[i] && i != now_.entered.reader) numbers.push_back(static_cast<std::uint16_t>(i));
  return numbers;
}

std::vector<std::string> Flow::paths() const {
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < files_.size(); ++i)
    if (files_[i] && (i == 0 || i != now_.entered.reader)) paths.push_back(files_[i]->path());
  return paths;
}

std::optional<std::uint16_t> Flow::open_built_in(const std::string& name) {
  const std::string file = "macros/" + name + "." + def_.id;
  if (const auto known = built_in_.find(name); known != built_in_.end()) return known->second;
  for (const EmbeddedFile& row : embedded_files()) {
    if (row.name != file) continue;
    files_.push_back(
        std::make_unique<ProgramFile>(name + " (" + def_.id + ")", text_source(std::string(row.text)), def_.grammar, Encoding::utf8));
    const auto reader = static_cast<std::uint16_t>(files_.size() - 1);
    built_in_.emplace(name, reader);
    return reader;
  }
  return std::nullopt;
}

Status Flow::call_at(std::uint16_t reader, Position start, const CallFrame& frame, Span where) {
  const auto pushed = push(frame, where);
  if (!pushed) return fail(pushed.error());
  (*pushed)->reader = reader;
  (*pushed)->start = start;
  (*pushed)->done = 1;
  files_[reader]->keep_blocks();
  go_to(reader, start);
  return {};
}

std::optional<Position> Flow::label_of(std::uint32_t number) {
  if (def_.grammar.label_address == 0) return std::nullopt;
  if (!indexed_) make_index();
  const auto label = labels_.find(number);
  if (label == labels_.end() || label->second.twice) return std::nullopt;
  label->second.called = true;
  return label->second.position;
}

void Flow::back_to(const Place& place) {
  now_.frames = place.frames;
  now_.restarts = place.restarts;
  now_.ended = place.ended;
  if (now_.reader != place.reader || position() != place.position) go_to(place.reader, place.position);
}

Result<CallFrame*> Flow::push(const CallFrame& frame, Span where) {
  if (now_.frames.size() >= def_.behaviour.call_depth) return fail(alarm(AlarmId::call_too_deep, where, double(def_.behaviour.call_depth)));
  CallFrame& pushed = now_.frames.emplace_back(frame);
  pushed.back = position();
  pushed.back_reader = now_.reader;
  return &pushed;
}

Status Flow::call(std::uint32_t subprogram, std::uint32_t times, const Origin& caller, Span where) {
  if (!indexed_) make_index();
  const auto label = labels_.find(subprogram);
  if (label == labels_.end()) return fail(alarm(AlarmId::subprogram_missing, where, double(subprogram)));
  if (label->second.twice) return fail(alarm(AlarmId::label_twice, where, double(subprogram)));
  label->second.called = true;
  CallFrame frame;
  frame.kind = CallFrame::Kind::subprogram;
  frame.start = label->second.position;
  frame.name = subprogram;
  frame.left = times;
  frame.caller = caller;
  KADR_TRY(push(frame, where));
  go_to(0, frame.start);
  return {};
}

Status Flow::call_body(const CycleRow& cycle, std::uint32_t times, const Origin& caller, Span where) {
  CallFrame frame;
  frame.kind = CallFrame::Kind::cycle_body;
  frame.start = body_starts_.at(cycle.name);
  frame.reader = 1;
  frame.left = times;
  frame.caller = caller;
  frame.name = static_cast<std::uint32_t>(&cycle - def_.cycles.data());
  KADR_TRY(push(frame, where));
  go_to(1, frame.start);
  return {};
}

Status Flow::repeat(std::uint32_t times, const Origin& caller, Span where) {
  CallFrame frame;
  frame.kind = CallFrame::Kind::repetition;
  frame.start = position();
  frame.reader = now_.reader;
  frame.left = times;
  frame.caller = caller;
  KADR_TRY(push(frame, where));
  return {};
}

Result<const CallFrame*> Flow::end_subprogram(Span where) {
  if (now_.frames.empty()) return fail(alarm(AlarmId::return_without_call, where));
  CallFrame& top = now_.frames.back();
  if (top.kind == CallFrame::Kind::repetition) return fail(alarm(AlarmId::repeat_end_missing, where, double(top.caller.line)));
  if (--top.left > 0) {
    top.repeating = true;
    ++top.done;
    go_to(top.reader, top.start);
    return nullptr;
  }
  now_.left = top;
  now_.frames.pop_back();
  go_to(now_.left.back_reader, now_.left.back);
  return &now_.left;
}

Status Flow::end_repetition(Span where) {
  if (now_.frames.empty() || now_.frames.back().kind != CallFrame::Kind::repetition) return fail(alarm(AlarmId::repeat_end_alone, where));
  CallFrame& top = now_.frames.back();
  if (--top.left > 0) {
    top.repeating = true;
    go_to(top.reader, top.start);
  } else {
    now_.frames.pop_back();
  }
  return {};
}

void Flow::abandon(std::optional<Position> again) {
  if (now_.frames.empty()) return;
  const CallFrame left = now_.frames.back();
  now_.frames.pop_back();
  if (left.kind != CallFrame::Kind::repetition) go_to(left.back_reader, left.back);
  else if (again) go_to(now_.reader, *again);
}

bool Flow::restart(Position from) {
  if (passes() >= limits_.restarts) return false;
  ++now_.restarts;
  now_.repeated = 0;
  now_.frames.clear();
  go_to(0, from);
  return true;
}

BlockReader& Flow::elsewhere() {
  if (!elsewhere_) elsewhere_ = std::make_unique<BlockReader>(files_[0]->source(), def_.grammar, program().encoding());
  return *elsewhere_;
}

/// Reads the whole file and records where its subprograms start. Faults of blocks are reported only when the blocks are executed.
void Flow::make_index() {
  indexed_ = true;
  BlockReader& reader = elsewhere();
  reader.seek({});
  auto block = std::make_unique<Block>();
  bool in_section = false;
  std::int64_t current = -1;  // number of the subprogram that is being read; -1: no subprogram
  for (;;) {
    const Position at = reader.position();
    const auto got = reader.next(*block);
    if (got && *got == BlockReader::Got::end) break;
    std::optional<std::uint32_t> name;
    if (def_.has_sections()) {
      constexpr std::uint8_t digits_of_label = 5;  // N02001 is subprogram 02, block 001 (2С42 6.3.5)
      if (block->marker == Marker::section) in_section = true;
      if (block->marker != Marker::none) current = -1;
      if (block->marker == Marker::program_start) in_section = false;
      if (in_section && block->has_number && block->number_digits == digits_of_label) name = block->number / 1000;
      if (name && *name == current) name.reset();
      else if (name) current = *name;
      for (std::uint32_t i = 0; i < block->word_count && got; ++i)
        if (block->words[i].address == 'M' && block->words[i].code == 2_m) in_section = false;
    } else if (block->marker == Marker::label) {
      name = block->label;
    }
    if (!name || labels_.size() >= max_labels) continue;
    auto [label, added] = labels_.try_emplace(*name, Label{block->position.offset == at.offset ? at : block->position, false, false});
    if (!added) label->second.twice = true;
  }
}

void Flow::each_uncalled(const std::function<void(Result<BlockReader::Got>, const Block&)>& visit) {
  if (def_.grammar.label_address == 0 && !def_.has_sections()) return;
  if (!indexed_) make_index();
  auto block = std::make_unique<Block>();
  BlockReader& reader = elsewhere();
  visiting_ = true;
  for (const auto& [name, label] : labels_) {
    if (label.called || now_.passed.contains(name)) continue;
    reader.seek(label.position);
    bool first = true;
    for (;;) {
      const auto got = reader.next(*block);
      if (got && *got == BlockReader::Got::end) break;
      const bool other =
          block->marker != Marker::none || (def_.has_sections() && block->number_digits == 5 && block->number / 1000 != name);
      if (!first && other) break;
      visit(got, *block);
      first = false;
    }
  }
  visiting_ = false;
}

std::string Flow::name_of(const ControlDef& def, const CallFrame& frame) {
  const auto two_digits = [](std::uint32_t n) { return (n < 10 ? "0" : "") + std::to_string(n); };
  switch (frame.kind) {
    case CallFrame::Kind::repetition: return "H … M20";
    case CallFrame::Kind::cycle_body: return def.cycles[frame.name].name;
    default: return def.has_sections() ? "L" + two_digits(frame.name) : "O" + std::to_string(frame.name);
  }
}

}  // namespace kadr
