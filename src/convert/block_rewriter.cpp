// BlockRewriter: rewrites blocks word by word. Used by convert/rewriting; tested by tests/convert.

#include "convert/block_rewriter.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace kadr {
namespace {

std::uint8_t group_of_motions(const ControlDef& def) {
  for (const CodeRow& row : def.codes)
    if (row.function == Function::linear) return row.group;
  return 0;
}

bool is_axis(const AddressRow& row) { return row.function == Function::axis || row.function == Function::machine_axis; }

/// True if the word states a length, whose number has a decimal point, written or implied.
bool is_length(const AddressRow& row) { return row.unit == WordUnit::length; }

constexpr std::int32_t tenths_of_code = 10;

/// Returns the number of a code word as a whole number.
std::uint32_t number_of(const Word& word) { return static_cast<std::uint32_t>(word.code / tenths_of_code); }

// Decimals of a length in addition to three. The source program may have more than three: inches, or the output of a fine CAM program.
constexpr int more_decimals = 3;

/// Returns the address letter of the length offset: H; D if H is a number of repetitions (spec/s2c42 4).
char letter_of_lengths(const ControlDef& def) {
  return def.grammar.word('H').known && def.address('H').function != Function::repeat_word ? 'H' : 'D';
}

/// Returns the address letter for the number of repetitions of a canned cycle.
char repeats_of(const ControlDef& def) { return def.behaviour.repeats_by_k ? 'K' : 'L'; }

}  // namespace

/// The codes of a block, sorted by their effect on the rewriting.
struct BlockRewriter::Kinds {
  const CodeRow* motion = nullptr;  // code that belongs to the modal group of motions
  const CodeRow* dwell = nullptr;
  const CodeRow* call = nullptr;
  const CodeRow* macro = nullptr;       // row of G65, if the block has it
  const CodeRow* exact_stop = nullptr;  // code of an exact stop at the end of this block only
  // Letters (one bit each) of words that belong to a corner mode, and that the target control's code for this mode does not accept.
  std::uint64_t left_out = 0;
  bool returns = false;  // the block has M99
  bool has_axes = false, has_feed = false;
  bool takes_axes = false;  // a code that is not a motion uses the axis words
  bool drills = false;      // a canned cycle is in force, or begins in the block
  bool is_arc = false;
};

BlockRewriter::BlockRewriter(const ControlDef& from, const ControlDef& to)
    : from_(from), to_(to), match_(from, to), codes_(from, to), flow_(from, to), o_lines_(flow_), motion_group_(group_of_motions(from)) {
  const bool has_mode = row_that_does(to, {{Function::exact_stop_mode, any_argument}}) != nullptr,
             has_block = row_that_does(to, {{Function::exact_stop_block, any_argument}}) != nullptr;
  is_metric_ = row_that_does(to, {{Function::millimetre, any_argument}, {Function::inch, any_argument}}) == nullptr;
  stops_.by_block = has_block && !has_mode, stops_.by_mode = has_mode && !has_block;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if (letter == 'F' || letter == 'H' || letter == 'K' || letter == 'L' || letter == 'P' || letter == 'Q' || letter == 'S' ||
        letter == 'T')
      continue;
    if (from.grammar.word(letter).code || !is_axis(from.address(letter)) || !is_axis(to.address(letter)) || !to.grammar.word(letter).known)
      continue;
    plain_[static_cast<std::size_t>(letter - 'A')].emplace(
        PlainWord{Words(to, letter, is_length(to.address(letter)) ? more_decimals : 0), from.address(letter).scale});
    plain_letters_ |= std::uint64_t{1} << (letter - 'A');
  }
}

Status BlockRewriter::cannot(std::string_view what) { return fail(alarm(AlarmId::function_has_no_code, {}, what)); }

/// Writes a block that has axis words only, as most blocks of a long program. Does the same as calling word() for each word, but faster.
Status BlockRewriter::write_plain(const Block& block, BlockMaker& out) {
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& one = block.words[i];
    const PlainWord& plain = *plain_[static_cast<std::size_t>(one.address - 'A')];
    KADR_TRY(out.word(plain.form, one.value * plain.scale));
  }
  return {};
}

const CodeRow* BlockRewriter::row_of(const Word& word) const {
  if (word.code < 0) return nullptr;
  const std::int32_t row = from_.row_of(word.address, word.code);
  return row < 0 ? nullptr : &from_.codes[static_cast<std::size_t>(row)];
}

void BlockRewriter::look(const Block& block, Kinds& kinds) const {
  kinds.drills = motion_is_cycle_;
  kinds.is_arc = motion_ != nullptr && (motion_->function == Function::arc_cw || motion_->function == Function::arc_ccw);
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& word = block.words[i];
    if (const CodeRow* const row = row_of(word)) {
      if (is_canned_cycle(*row)) kinds.motion = row, kinds.drills = true, kinds.is_arc = false;
      else if (ends_cycles(*row)) kinds.drills = false;
      else if (row->group == motion_group_ && row->group != 0)
        kinds.motion = row, kinds.drills = false, kinds.is_arc = row->function == Function::arc_cw || row->function == Function::arc_ccw;
      else if (traits_of(row->function).takes_axes()) kinds.takes_axes = true;
      if (row->function == Function::dwell || row->function == Function::dwell_or_turns) kinds.dwell = row;
      if (row->function == Function::call_subprogram || row->function == Function::call_program || row->function == Function::call_numbered)
        kinds.call = row;
      if (row->function == Function::macro_call) kinds.macro = row;
      if (row->function == Function::exact_stop_block) kinds.exact_stop = row;
      if (traits_of(row->function).phase == Phase::path_mode)
        kinds.left_out |= row->takes & ~(match_.of(*row) != nullptr ? match_.of(*row)->takes : std::uint64_t{0});
      kinds.returns = kinds.returns || row->function == Function::return_program;
      continue;
    }
    const AddressRow& row = from_.address(word.address);
    kinds.has_axes = kinds.has_axes || is_axis(row);
    kinds.has_feed = kinds.has_feed || word.address == 'F';
  }
}

void BlockRewriter::pass(const Block& block) {
  Kinds kinds;
  look(block, kinds);
  if (kinds.motion != nullptr) motion_ = kinds.motion;
  motion_is_cycle_ = kinds.drills;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& word = block.words[i];
    if (const CodeRow* const row = row_of(word)) {
      if (row->function == Function::inch) is_inch_ = true;
      if (row->function == Function::millimetre) is_inch_ = false;
      if (row->function == Function::exact_stop_mode) stops_.is_mode = true;
      else if (row->function == Function::constant_velocity || row->function == Function::feed_control) stops_.is_mode = false;
    }
    if (word.address == 'F' && !word.expression) feed_ = value_of(word);
    if (word.address == 'T' && !word.expression) tool_ = value_of(word);
  }
}

double BlockRewriter::value_of(const Word& word) const { return word.value * from_.address(word.address).scale; }

Status BlockRewriter::write_label(std::uint32_t label, BlockMaker& out) {
  if (is_to_o_lines() && o_lines_.begins(label)) return o_lines_.begin(label, out);
  if (flow_.has_sections()) return flow_.begin_section(std::to_string(label), out);
  if (to_.grammar.label_address == 0 && !to_.grammar.programs_by_label && !to_.grammar.o_words) return cannot("O");
  out.text(out.program_label(label));
  return {};
}

/// Rewrites the word L0205 of the 2С42, which calls subprogram 2 five times (spec/s2c42 6).
Status BlockRewriter::section_call(const Word& word, BlockMaker& out) const {
  constexpr std::uint32_t hundred = 100;
  const auto value = static_cast<std::uint32_t>(word.value);
  const std::uint32_t label = value >= hundred ? value / hundred : value, times = value >= hundred ? value % hundred : 1;
  const auto call = code_of(
      to_, {{Function::call_subprogram, any_argument}, {Function::call_program, any_argument}, {Function::call_numbered, any_argument}});
  const bool is_own_cycle =
      std::any_of(from_.cycles.begin(), from_.cycles.end(), [&](const CycleRow& cycle) { return cycle.call_number == label; });
  if (!call || word.expression || is_own_cycle) return cannot("L" + std::to_string(value));
  KADR_TRY(out.end());  // writes the block's other words first, so that they take effect before the call
  out.text(*call + fmt::format(" P{}", label));
  if (times != 1) out.text(fmt::format("L{}", times));
  return {};
}

Status BlockRewriter::code(const CodeRow& row, BlockMaker& out) const {
  const CodeRow* const match = match_.of(row);
  if (match == nullptr) return cannot(row.code);
  return out.code_text(with_digits(to_, *match));
}

/// True if the same code number has another function on the target control.
bool BlockRewriter::is_other_code(const Word& word, const CodeRow& row) const {
  const std::uint32_t number = number_of(word);
  return row.function == Function::machine_function && !codes_.there(number) && codes_.here(number);
}

/// Writes an M code by its number. The tables of both controls map the number; the number of a machine function without a table row stays
/// unchanged.
///   returns  false if the caller must match the code by its function
bool BlockRewriter::machine_code(const Word& word, const CodeRow& row, BlockMaker& out) const {
  const std::uint32_t number = number_of(word);
  const auto mapped = codes_.there(number);
  if (!mapped && row.function != Function::machine_function) return false;
  const CodeRow* const there = machine_row(to_, mapped.value_or(number));
  if (there == nullptr || (!mapped && there->function != Function::machine_function)) return false;
  out.text(machine_code_text(to_, mapped.value_or(number)));
  return true;
}

double BlockRewriter::seconds(const Word& word) const {
  constexpr double ms = 0.001;
  const DwellUnit unit = from_.behaviour.dwell_unit;
  const bool in_ms =
      word.address == 'P' && (unit == DwellUnit::milliseconds || (unit == DwellUnit::milliseconds_without_point && !word.has_point));
  return in_ms ? word.value * ms : value_of(word);
}

Status BlockRewriter::dwell_word(const Word& word, const CodeRow& dwell, BlockMaker& out) const {
  const CodeRow* const match = match_.of(dwell);
  return match == nullptr ? cannot(dwell.code) : out.dwell_word(*match, seconds(word));
}

Status BlockRewriter::number(const Word& word, char letter, BlockMaker& out) const {
  const AddressRow& row = to_.address(letter);
  if (!out.has_word(letter)) return cannot(std::string(1, letter));
  return out.word(letter, value_of(word), is_length(row) ? more_decimals : 0);
}

/// Returns the address letter of this word on the target control; nullopt if the letter has another meaning there.
std::optional<char> BlockRewriter::letter_of(const Word& word, const Kinds& kinds) const {
  constexpr Function own[] = {Function::repeat_word, Function::call_word, Function::corrector_word, Function::dwell_word,
                              Function::formal_parameter};
  const auto is_own = [&](Function function) { return std::find(std::begin(own), std::end(own), function) != std::end(own); };
  char letter = word.address;
  const Function here = from_.address(letter).function;
  if (kinds.call != nullptr && letter != 'P' && (letter == 'L' || letter == 'Q')) letter = 'L';
  else if (kinds.drills && letter == repeats_of(from_)) letter = repeats_of(to_);
  // On a control that selects length and radius offsets by D alike, H becomes D (spec/s2c42 4).
  else if (letter == 'H' && !is_own(here) && is_own(to_.address('H').function)) letter = 'D';
  const Function there = to_.address(letter).function;
  return (is_own(here) || is_own(there)) && here != there ? std::nullopt : std::optional(letter);
}

Status BlockRewriter::word(const Block& block, const Word& word, const Kinds& kinds, BlockMaker& out) {
  const AddressRow& row = from_.address(word.address);
  if (word.address > 'Z' || word.axis || word.bare || word.incremental || word.second == word.second) {
    const bool comma = word.address == comma_chamfer || word.address == comma_rounding || word.address == comma_angle;
    if (!comma || !to_.grammar.comma_words || word.expression) return cannot(block.text_of(word.where));
    return slice(block.text_of(word.where), out);
  }
  if (row.function == Function::call_word) return section_call(word, out);
  const auto wanted = letter_of(word, kinds);
  if (!wanted) return cannot(block.text_of(word.where));
  const char letter = *wanted;
  if (word.expression) {
    if (!to_.grammar.expressions || to_.address(letter).scale != row.scale || !out.has_word(letter))
      return cannot(block.text_of(word.where));
    if (letter == 'T' && to_.behaviour.tool_and_corrector != from_.behaviour.tool_and_corrector) return cannot("T");
    std::string text(block.text_of(word.where));
    text.front() = letter;
    return slice(text, out);
  }
  if (kinds.dwell != nullptr && (kinds.dwell->takes >> (letter - 'A') & 1U) != 0) return dwell_word(word, *kinds.dwell, out);
  if (letter == 'P' && kinds.drills && kinds.call == nullptr) return out.seconds_word('P', seconds(word));
  if (letter == 'T' && to_.behaviour.tool_and_corrector != from_.behaviour.tool_and_corrector) return cannot("T");
  if (is_axis(row) && !is_axis(to_.address(letter))) return cannot(std::string(1, letter));
  if (letter == 'R' && kinds.is_arc && !to_.behaviour.reads_arc_radius()) return cannot("R");
  if (row.function == Function::center && kinds.is_arc) {
    const auto is_absolute = [](const ControlDef& def) { return def.behaviour.arc_centers == ArcCenters::as_distance; };
    if (is_absolute(from_) != is_absolute(to_)) return cannot("I J K");
  }
  return number(word, letter, out);
}

/// Writes the tool number as H or D if the block does not state this word. RS274/NGC uses the tool number in this case (spec/linuxcnc 7.6);
/// the other controls need the word.
Status BlockRewriter::implied_number(const Block& block, const CodeRow& row, BlockMaker& out) const {
  if (!from_.has_parameter_file() || to_.has_parameter_file() || tool_ == 0) return {};
  if (row.function == Function::tool_length && row.arg == 0 && !block.has('H')) return out.word(letter_of_lengths(to_), tool_);
  const bool is_side =
      row.function == Function::radius_comp_left || row.function == Function::radius_comp_right || row.function == Function::tool_side;
  return is_side && !block.has('D') ? out.word('D', tool_) : Status();
}

/// Repeats the motion code in force if other blocks were inserted before this block and the block itself has no motion code.
Status BlockRewriter::write_again(const Kinds& kinds, BlockMaker& out) {
  if (!repeats_modes_ || !kinds.has_axes || kinds.takes_axes) return {};
  if (kinds.motion == nullptr && motion_ != nullptr) {
    if (motion_is_cycle_) return cannot(motion_->code);
    KADR_TRY(code(*motion_, out));
  }
  repeats_modes_ = false;
  if (std::exchange(repeats_feed_, false) && !kinds.has_feed && feed_ > 0) return out.word('F', feed_, 0);
  return {};
}

Status BlockRewriter::write(const Block& block, BlockMaker& out) {
  if (block.broken || block.codes_vary || block.file_name.end != 0) return cannot(block.text_of(block.where));
  if (block.marker == Marker::program_start || block.marker == Marker::section) return {};
  if (block.marker != Marker::none)
    return block.marker == Marker::label ? write_label(block.label, out) : cannot(block.text_of(block.where));
  out.set_skip(block.skip);
  if (is_to_o_lines() && block.has_number) KADR_TRY(o_lines_.number(block.number, out));
  if (block.has_number) out.set_number(block.number);
  if (is_plain(block)) return write_plain(block, out);
  if (block.statement.kind != StatementKind::none) {
    const bool only_assigns = block.statement.kind == StatementKind::assign && !block.statement.with_if;
    return is_to_o_lines() && !only_assigns ? o_line(block, out) : statement(block, out);
  }
  Kinds kinds;
  look(block, kinds);
  KADR_TRY(write_again(kinds, out));
  pass(block);
  if (is_to_o_lines() && kinds.macro != nullptr) return macro_call(block, out);
  if (is_to_o_lines() && kinds.returns && o_lines_.is_in_macro()) {
    if (block.word_count != 1) return cannot("M99");
    return o_lines_.end(block.position.line, out);
  }
  return words_of(block, kinds, out);
}

/// Converts an exact stop between a mode and a code for a single block, if one control has only the mode and the other only the code.
Status BlockRewriter::exact_stop(const Kinds& kinds, BlockMaker& out) {
  const bool cuts = motion_ != nullptr && kinds.has_axes && !kinds.takes_axes && !kinds.drills && motion_->function != Function::rapid;
  if (!cuts) return {};
  if (stops_.is_mode && stops_.by_block && kinds.exact_stop == nullptr) return out.code({{Function::exact_stop_block, any_argument}});
  if (kinds.exact_stop == nullptr || stops_.is_mode || !stops_.by_mode) return {};
  stops_.goes_on = true;
  return out.code({{Function::exact_stop_mode, any_argument}});
}

Status BlockRewriter::end(BlockMaker& out) {
  if (!std::exchange(stops_.goes_on, false)) return {};
  KADR_TRY(out.code({{Function::constant_velocity, any_argument}, {Function::feed_control, continuous_cutting}}));
  return out.end();
}

/// Writes an O line. If a statement follows its condition, the statement becomes a block of its own on the target control.
Status BlockRewriter::o_line(const Block& block, BlockMaker& out) {
  return o_lines_.write(
      block,
      [&]() -> Status {
        if (block.statement.kind == StatementKind::assign) {
          const std::string_view text = block.text_of(block.where);
          const std::size_t then = text.find("THEN");
          if (then == std::string_view::npos) return cannot("THEN");
          constexpr std::size_t after_then = 4;
          return slice(assignment(text.substr(then + after_then, text.find('(') - then - after_then)), out);
        }
        Kinds kinds;
        look(block, kinds);
        pass(block);
        return words_of(block, kinds, out);
      },
      out);
}

Status BlockRewriter::macro_call(const Block& block, BlockMaker& out) {
  return o_lines_.call(
      block,
      [&](const Word& word, std::string& value) -> Status {
        if (!word.expression) {
          value = fmt::format("{}", value_of(word));
          return {};
        }
        auto text = flow_.expression(block.text_of(word.where).substr(1));
        if (!text) return fail(text.error());
        value = std::move(*text);
        return {};
      },
      out);
}

Status BlockRewriter::words_of(const Block& block, const Kinds& kinds, BlockMaker& out) {
  std::size_t next = 0;  // index, among the assignments of the block, of the next assignment that is to be written
  const auto assignments_before = [&](std::uint32_t at) -> Status {
    for (; next < block.assignments.size() && block.assignments[next].where.begin < at; ++next) {
      if (!to_.grammar.expressions || from_.grammar.parameter_address != to_.grammar.parameter_address)
        return cannot(block.text_of(block.assignments[next].where));
      KADR_TRY(slice(assignment(block.text_of(block.assignments[next].where)), out));
    }
    return {};
  };
  if (kinds.call != nullptr && flow_.has_sections()) return flow_.call_in_section(block, out);
  KADR_TRY(exact_stop(kinds, out));
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& one = block.words[i];
    if (one.address == 'N') continue;
    KADR_TRY(assignments_before(one.where.begin));
    if (one.code >= 0) {
      const CodeRow* const row = row_of(one);
      if (row == nullptr) return cannot(block.text_of(one.where));
      // The target control has no corresponding path mode, so the code is omitted; conversion_text reports the omission.
      if (traits_of(row->function).phase == Phase::path_mode && match_.of(*row) == nullptr) continue;
      if (row->function == Function::millimetre && is_metric_) continue;
      if (in_section_ && (row->function == Function::program_end || row->function == Function::tape_end)) continue;
      if (one.address == 'M' && is_other_code(one, *row)) return cannot(row->code);
      if (one.address != 'M' || !machine_code(one, *row, out)) KADR_TRY(code(*row, out));
      KADR_TRY(implied_number(block, *row, out));
    } else if (one.address > 'Z' || (kinds.left_out >> (one.address - 'A') & 1U) == 0) {
      KADR_TRY(word(block, one, kinds, out));
    }
  }
  return assignments_before(~std::uint32_t{0});
}

}  // namespace kadr
