// ProgramShape: finds the loops, subprograms and calls in the text of a program. Used by convert/word_by_word; tested by tests/convert.

#include "convert/program_shape.h"

#include <algorithm>
#include <iterator>

#include "config/control/tool_numbers.h"

namespace kadr {
namespace {

bool opens(const Statement& s) {
  return s.kind == StatementKind::loop || (s.kind == StatementKind::o_word && (s.o_word == OWord::while_ || s.o_word == OWord::do_ ||
                                                                               s.o_word == OWord::repeat || s.o_word == OWord::if_));
}

bool closes(const Statement& s) {
  return s.kind == StatementKind::loop_end ||
         (s.kind == StatementKind::o_word && (s.o_word == OWord::endwhile || s.o_word == OWord::endrepeat || s.o_word == OWord::endif));
}

bool calls(Function function) {
  return function == Function::call_subprogram || function == Function::call_program || function == Function::call_numbered ||
         function == Function::macro_call || function == Function::call_local;
}

bool returns(Function function) {
  return function == Function::subprogram_return || function == Function::subprogram_end || function == Function::return_program ||
         function == Function::return_numbered;
}

/// True for functions that are motions or modes. A block with only these functions neither jumps nor calls, so the next block in the text
/// is executed after it.
bool is_straight(Function function) {
  constexpr Phase phases[] = {Phase::unit,    Phase::feed_mode,   Phase::speed_mode, Phase::spindle,  Phase::spindle_stop,
                              Phase::coolant, Phase::coolant_off, Phase::dwell,      Phase::plane,    Phase::compensation,
                              Phase::length,  Phase::zero,        Phase::path_mode,  Phase::distance, Phase::retract};
  const FunctionTraits& traits = traits_of(function);
  return traits.is(function_fact::plain_motion) || function == Function::program_end || function == Function::tape_end ||
         std::find(std::begin(phases), std::end(phases), traits.phase) != std::end(phases);
}

constexpr std::uint32_t first_name_label = 1'000'000'000, max_variable = 10'000'000;
constexpr double most_tool = 100'000;
constexpr std::uint32_t hundred = 100;

/// True for functions whose motions are straight lines, including canned drilling cycles.
bool jumps_along_lines(Function function) {
  constexpr Function lines[] = {
      Function::rapid,           Function::linear,           Function::cycle,         Function::canned_cycle,
      Function::no_motion,       Function::drilling_off,     Function::machine_point, Function::approach_reference,
      Function::reference_leave, Function::single_direction, Function::probe,         Function::measure,
      Function::measure_length,  Function::probe_move};
  return std::find(std::begin(lines), std::end(lines), function) != std::end(lines);
}

}  // namespace

ProgramShape::ProgramShape(std::shared_ptr<ByteSource> source, const ControlDef& def, const StopToken& stop) {
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    if ((def.address(letter).function == Function::axis || def.address(letter).function == Function::machine_axis) && letter != 'S' &&
        letter != 'T' && letter != 'P' && !def.grammar.word(letter).code)
      plain_letters_ |= std::uint64_t{1} << (letter - 'A');
  has_jumps_ = def.grammar.has_statements();
  BlockReader reader(std::move(source), def.grammar, Encoding::utf8);
  Block block;
  while (!stop.requested()) {
    const auto got = reader.next(block);
    if (got && *got == BlockReader::Got::end) break;
    lines_ = block.position.line;
    if (got && !take_plain(block)) take(block, def);
    note_block(block.position.line);
    last_block_ = block.position.line;
  }
  close_subprogram();
  const std::vector<TextLines> own = loops_;
  for (const auto& [line, number] : jumps_) {  // lines that a jump skips or repeats are expanded together with the jump
    const auto at = numbers_.find(number);
    if (at == numbers_.end()) continue;
    TextLines passed{std::min(line, at->second), std::max(line, at->second)};
    if (passed.first == line) passed.last = block_before(passed.last);
    if (const auto around = loop_around({line, line}); around && around->last == passed.last) leaves_.insert(line);
    // Grows the range to contain each loop that overlaps the range, unless the loop contains the whole range
    for (const TextLines& loop : own)
      if (loop.first <= passed.last && passed.first <= loop.last && !(loop.first <= passed.first && passed.last <= loop.last))
        passed = {std::min(passed.first, loop.first), std::max(passed.last, loop.last)};
    if (passed.first < passed.last) loops_.push_back(passed);
  }
}

MacroShape ProgramShape::macros() const {
  MacroShape made;
  made.leaves = leaves_;
  for (const auto& [line, number] : jumps_)
    if (const auto at = numbers_.find(number); at != numbers_.end() && at->second < line) made.jumped_back.insert(number);
  for (const std::uint32_t label : macro_labels_)
    if (const auto found = subprograms_.find(label); found != subprograms_.end()) made.macros[label] = last_return(found->second);
  return made;
}

std::uint32_t ProgramShape::last_return(TextLines lines) const {
  const auto after = std::upper_bound(edges_.begin(), edges_.end(), lines.last);
  return after == edges_.begin() || *std::prev(after) < lines.first ? lines.last : *std::prev(after);
}

void ProgramShape::take_number(const Block& block) {
  constexpr std::size_t max_numbers = 100'000;
  if (has_jumps_ && block.has_number && numbers_.size() < max_numbers) numbers_.emplace(block.number, block.position.line);
}

void ProgramShape::take_jump(const Block& block, const ControlDef& def) {
  take_number(block);
  if (!def.grammar.has_statements()) return;
  if (block.statement.kind != StatementKind::go_to) return;
  const std::string_view text = block.text_of(block.where);
  const std::size_t digits = text.find_last_not_of("0123456789 ");
  std::uint32_t number = 0;
  for (const char c : text.substr(digits + 1))
    if (c != ' ' && number < max_variable) number = 10 * number + static_cast<std::uint32_t>(c - '0');
  if (number != 0) jumps_.emplace_back(block.position.line, number);
}

/// Reads a block that has axis words only, as most blocks of a long program; faster than the general function. Returns false if the caller
/// must use the general function.
bool ProgramShape::take_plain(const Block& block) {
  if (!block.shape || (block.letters & ~plain_letters_) != 0 || in_section_) return false;
  names_of_words_.letters |= block.letters;
  take_number(block);
  return true;
}

void ProgramShape::note_flow(Function function, std::uint32_t line) {
  const FunctionTraits& traits = traits_of(function);
  const bool is_end = function == Function::program_end || function == Function::tape_end;
  if (!is_end && (traits.phase == Phase::flow || traits.is(function_fact::calls) || traits.is(function_fact::passes_control)))
    has_flow_ = true;
  if (!is_straight(function)) last_turn_ = line;
}

void ProgramShape::take(const Block& block, const ControlDef& def) {
  const std::uint32_t line = block.position.line;
  if (block.marker == Marker::label && (main_over_ || last_block_ != 0)) {
    close_subprogram();
    label_ = block.label, labelled_ = line;
    edges_.push_back(line);
  }
  if (block.statement.kind != StatementKind::none || block.marker == Marker::section || block.codes_vary || block.file_name.end != 0 ||
      block.broken)
    has_flow_ = true;
  take_section(block);
  take_o_line(block);
  take_jump(block, def);
  take_variables(block.text_of(block.where));
  const std::string label(block.statement.kind == StatementKind::o_word ? block.text_of(block.statement.label_where) : std::string_view());
  const bool ends_do =
      block.statement.o_word == OWord::while_ && !open_loops_.empty() && !label.empty() && open_loops_.back().second == label;
  if ((closes(block.statement) || ends_do) && !open_loops_.empty()) {
    loops_.push_back({open_loops_.back().first, line});
    open_loops_.pop_back();
  } else if (opens(block.statement)) {
    open_loops_.emplace_back(line, label);
  }
  take_calls(block, def);
}

/// Finds subprograms of the 2С42: N02001 begins subprogram 2 (spec/s2c42 6).
void ProgramShape::take_section(const Block& block) {
  constexpr std::uint32_t blocks_a_subprogram = 1000;
  if (block.marker == Marker::section || block.marker == Marker::program_start) {
    close_subprogram();
    in_section_ = block.marker == Marker::section;
    return;
  }
  if (!in_section_ || !block.has_number) return;
  const std::uint32_t label = block.number / blocks_a_subprogram;
  if (labelled_ != 0 && label == label_) return;
  close_subprogram();
  label_ = label, labelled_ = block.position.line;
}

/// Finds subprograms of RS274/NGC and their calls (spec/linuxcnc 6). Named subprograms get labels that are not yet used as numbers in the
/// program.
void ProgramShape::take_o_line(const Block& block) {
  const Statement& s = block.statement;
  if (s.kind != StatementKind::o_word) return;
  const std::uint32_t line = block.position.line;
  const auto label = [&] {
    return names_.emplace(block.text_of(s.label_where), first_name_label + static_cast<std::uint32_t>(names_.size())).first->second;
  };
  if (s.o_word == OWord::sub) {
    label_ = label(), labelled_ = line;
    edges_.push_back(line);
  } else if (s.o_word == OWord::endsub) {
    edges_.push_back(line);
    if (labelled_ != 0) subprograms_[label_] = {labelled_, line};
    labelled_ = 0;
  } else if (s.o_word == OWord::return_) {
    edges_.push_back(line);
  } else if (s.o_word == OWord::call) {
    callers_.emplace(label(), line);
  }
}

void ProgramShape::take_variables(std::string_view text) {
  for (std::size_t at = text.find('#'); at != std::string_view::npos; at = text.find('#', at + 1)) {
    std::uint32_t number = 0;
    for (std::size_t i = at + 1; i < text.size() && text[i] >= '0' && text[i] <= '9' && number < max_variable; ++i)
      number = 10 * number + static_cast<std::uint32_t>(text[i] - '0');
    if (number != 0) variables_.insert(number);
  }
}

void ProgramShape::close_subprogram() {
  if (labelled_ != 0) subprograms_[label_] = {labelled_, last_block_};
  labelled_ = 0;
}

void ProgramShape::take_calls(const Block& block, const ControlDef& def) {
  bool is_call = false;
  names_of_words_.letters |= block.letters;
  // A computed code (G#1) may be an arc. The address ,R rounds a corner by an arc.
  has_arcs_ = has_arcs_ || block.codes_vary || (block.letters >> ('Z' - 'A' + 1)) != 0;
  if (const Word* const speed = block.find('S'); speed != nullptr && !speed->expression)
    names_of_words_.most_speed = std::max(names_of_words_.most_speed, speed->value);
  if (const Word* const t = block.find('T'); t != nullptr && !t->expression && t->value >= 0 && t->value < most_tool)
    names_of_words_.tools.insert(tool_numbers(def, t->value).tool);
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& word = block.words[i];
    if (def.address(word.address).function == Function::call_word && !word.expression) {
      const auto value = static_cast<std::uint32_t>(word.value);  // the word L0205 calls subprogram 2 five times
      callers_.emplace(value >= hundred ? value / hundred : value, block.position.line);
    }
    if (word.code < 0) {
      if (word.address <= 'Z' && traits_of(def.address(word.address).function).phase == Phase::flow) has_flow_ = true;
      continue;
    }
    const std::int32_t row = def.row_of(word.address, word.code);
    if (row < 0) {
      has_flow_ = true;
      continue;
    }
    const Function function = def.codes[static_cast<std::size_t>(row)].function;
    if (traits_of(function).phase == Phase::path_mode) path_modes_.insert(static_cast<std::size_t>(row));
    rounds_corners_ = rounds_corners_ || (function == Function::constant_velocity && block.has('P'));
    has_arcs_ = has_arcs_ || (traits_of(function).phase == Phase::motion && !jumps_along_lines(function));
    note_flow(function, block.position.line);
    is_call = is_call || calls(function);
    if (function == Function::macro_call && block.has('P') && !block.find('P')->expression)
      macro_labels_.insert(static_cast<std::uint32_t>(block.find('P')->value));
    take_side(def.codes[static_cast<std::size_t>(row)], block.position.line);
    if (returns(function)) edges_.push_back(block.position.line);
    if (traits_of(function).phase == Phase::transform) transforms_.push_back(block.position.line);
    if (traits_of(function).is(function_fact::ends) && labelled_ == 0) main_over_ = true;
  }
  if (const Word* const p = block.find('P'); is_call && p != nullptr && !p->expression)
    callers_.emplace(static_cast<std::uint32_t>(p->value), block.position.line);
}

void ProgramShape::take_side(const CodeRow& row, std::uint32_t line) {
  const Function function = row.function;
  if (function == Function::radius_comp_left || function == Function::radius_comp_right || function == Function::tool_side ||
      (function == Function::radius_side && row.arg != 0)) {
    if (contour_ == 0) contour_ = line;
  } else if (contour_ != 0 &&
             (function == Function::radius_comp_off || function == Function::compensation_off || function == Function::radius_side)) {
    contours_.push_back({contour_, line});
    contour_ = 0;
  }
}

std::vector<std::uint32_t> ProgramShape::calls_outside() const {
  std::vector<std::uint32_t> lines;
  for (const auto& [label, line] : callers_)
    if (subprograms_.count(label) == 0) lines.push_back(line);
  return lines;
}

void ProgramShape::note_block(std::uint32_t line) {
  if (blocks_.empty() || blocks_.back().last + 1 < line) blocks_.push_back({line, line});
  else blocks_.back().last = line;
}

std::uint32_t ProgramShape::block_before(std::uint32_t line) const {
  const auto at = std::partition_point(blocks_.begin(), blocks_.end(), [line](const TextLines& run) { return run.first < line; });
  return at == blocks_.begin() ? 0 : std::min(std::prev(at)->last, line - 1);
}

std::optional<TextLines> ProgramShape::loop_around(TextLines lines) const {
  std::optional<TextLines> best;
  for (const TextLines& loop : loops_)
    if (loop.first <= lines.first && lines.last <= loop.last && !(loop == lines) &&
        (!best || loop.last - loop.first < best->last - best->first))
      best = loop;
  return best;
}

std::optional<TextLines> ProgramShape::subprogram_of(std::uint32_t line) const {
  for (const auto& [label, range] : subprograms_)
    if (range.holds(line)) return range;
  return std::nullopt;
}

std::vector<std::uint32_t> ProgramShape::callers_of(TextLines subprogram) const {
  std::vector<std::uint32_t> lines;
  for (const auto& [label, range] : subprograms_)
    if (range == subprogram)
      for (auto [at, end] = callers_.equal_range(label); at != end; ++at) lines.push_back(at->second);
  return lines;
}

}  // namespace kadr
