// TextWatch: finds problems in the text of a program without executing it. It is used by session/checklist and tested by
// tests/checklist.py.

#include "session/checklist/text_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/code_literals.h"
#include "lang/text/tool_comment.h"
#include "session/checklist/comment_teeth.h"

namespace kadr {
namespace {

constexpr std::size_t max_found = 200;
constexpr std::size_t max_numbers = 10'000;  // greatest number of block and program numbers that are stored

/// A function that should be cancelled before the end of a program, and the function that cancels it. A program that states one of the two
/// functions before its first motion is not reported.
struct Mode {
  Function on, off;
};
constexpr std::array modes{
    Mode{Function::incremental, Function::absolute},
    Mode{Function::rotation_on, Function::rotation_off},
    Mode{Function::plane_rotation_on, Function::plane_rotation_off},
    Mode{Function::scale_on, Function::scale_off},
    Mode{Function::scaling_on, Function::scaling_off},
    Mode{Function::polar_on, Function::polar_off},
    Mode{Function::polar_data_on, Function::polar_data_off},
    Mode{Function::feed_inverse_time, Function::feed_per_minute},
};

/// Returns the number if the expression is a single number from 0 to 10⁹; nullopt for any other expression.
std::optional<std::uint32_t> constant(const Block& block, const Expression& expression) {
  if (expression.end != expression.begin + 1 || block.code[expression.begin].op != Op::number) return std::nullopt;
  const double number = block.code[expression.begin].number;
  return number >= 0 && number < 1e9 ? std::optional(static_cast<std::uint32_t>(number)) : std::nullopt;
}

bool has_code(const Block& block, char letter, std::int32_t tenth) {
  return std::any_of(block.words.begin(), block.words.begin() + block.word_count,
                     [&](const Word& w) { return w.address == letter && w.code == tenth; });
}

/// Returns true if a program may lead to the block by its name: a label or the head of a subprogram of a language with names
/// (spec/heidenhain 9, spec/sinumerik 8, 9).
bool has_name(const Block& block) {
  if (block.statement.label_where.end > block.statement.label_where.begin) return true;
  const std::string_view text = block.text_of(block.statement.text);
  if (block.statement.kind == StatementKind::klartext) return text.starts_with("LBL");
  return block.statement.kind == StatementKind::named && (text.starts_with("PROC") || text.starts_with("%"));
}

}  // namespace

Origin TextWatch::origin_of(const Block& block) {
  Origin origin;
  origin.line = block.position.line;
  origin.block = block.number;
  origin.has_block = block.has_number;
  origin.main_block = block.main_block;
  origin.block_digits = block.number_digits;
  origin.column = 1;
  return origin;
}

const CodeRow* TextWatch::row(const Word& word) const {
  if (word.code < 0 || word.expression) return nullptr;
  const std::int32_t at = def().row_of(word.address, word.code);
  return at < 0 ? nullptr : &def().codes[static_cast<std::size_t>(at)];
}

bool TextWatch::is_axis(char letter) const {
  if (letter < 'A' || letter > 'Z') return false;
  const Function function = def().address(letter).function;
  return function == Function::axis || function == Function::machine_axis;
}

bool TextWatch::moves(const Block& block) const {
  return std::any_of(block.words.begin(), block.words.begin() + block.word_count, [&](const Word& w) { return is_axis(w.address); });
}

template <class... Args>
void TextWatch::add(AlarmId id, const Origin& origin, Span where, Args... args) {
  if (found_.size() < max_found) found_.push_back({advice(id, where, AlarmArg(args)...), origin});
}

/// Records numbers without a decimal point, which count increments. They are reported if nearly all other numbers of the program have a
/// decimal point. Blocks with a dwell, a call, table values or a turning cycle are not examined, since numbers without a point may be
/// intended there.
void TextWatch::take_points(const Block& block) {
  const auto is_turning_cycle = [&](const Word& w) {
    const std::int32_t row = w.code < 0 ? -1 : def().row_of(w.address, w.code);
    return row >= 0 && def().codes[static_cast<std::size_t>(row)].function == Function::turning_cycle;
  };
  if (std::any_of(block.words.begin(), block.words.begin() + block.word_count, is_turning_cycle)) return;
  if (has_code(block, 'G', 4_g) || has_code(block, 'G', 10_g) || has_code(block, 'G', 65_g) || has_code(block, 'G', 66_g)) return;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    if (w.address < 'A' || w.address > 'Z' || w.address == 'Q' || w.expression || w.code >= 0 || w.value == 0) continue;
    if (w.has_point) {
      with_point_ += def().grammar.word(w.address).counted != 0;
    } else if (w.counted != 0) {
      ++without_point_;
      if (pointless_.size() >= max_found) continue;
      // in inch programs the increment of a length is 0.0001 in (spec/fanuc 1.3), so the value is a tenth of that in the word format
      const bool finer = inch_ && def().address(w.address).unit != WordUnit::angle;
      const std::string read = fmt::format("{:g} {}", finer ? w.value / 10 : w.value,
                                           def().address(w.address).unit == WordUnit::angle ? "°"
                                           : inch_                                          ? "in"
                                                                                            : "mm");
      pointless_.push_back({advice(AlarmId::point_forgotten, w.where, AlarmArg(block.text_of(w.where)), AlarmArg(std::string_view(read))),
                            origin_of(block)});
    }
  }
}

void TextWatch::take_numbers(const Word& word) {
  const bool tool = word.address == 'T';
  if (word.expression) (tool ? named_.tools_by_value : named_.rows_by_value) = true;
  std::set<std::uint32_t>& to = tool ? named_.tools : named_.rows;
  const double number = word.value * std::pow(10.0, word.counted);
  if (number >= 0 && number < 1e9 && to.size() < max_numbers) to.insert(static_cast<std::uint32_t>(std::llround(number)));
}

void TextWatch::take_codes(const Block& block) {
  if (const Word* const s = block.find('S'); s != nullptr && !s->expression && most_rpm_ > 0 && s->value > most_rpm_)
    add(AlarmId::speed_beyond_spindle, origin_of(block), s->where, s->value, most_rpm_);
  const bool axis_words = moves(block);
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    if (w.address == 'T' || w.address == 'H' || w.address == 'D') take_numbers(w);
    const CodeRow* const code = row(w);
    if (code == nullptr) continue;
    if (code->function == Function::inch) inch_ = true;
    if (code->function == Function::millimetre) inch_ = false;
    if (code->function == Function::incremental) absolute_ = false;
    if (code->function == Function::absolute) absolute_ = true;
    if (code->function == Function::plane_xy) in_xy_ = true;
    if (code->function == Function::plane_zx || code->function == Function::plane_yz || code->function == Function::select_plane)
      in_xy_ = w.code == 17_g;
    if (!began_) stated_.insert(code->function);
    if (main_over_) continue;
    for (const Mode& mode : modes) {
      if (mode.on == code->function) switched_on_[mode.on] = {origin_of(block), code->code};
      if (mode.off == code->function) switched_on_.erase(mode.on);
    }
  }
  began_ = began_ || axis_words;
}

/// Checks that R is above Z in the block of a drilling cycle, since an absolute cycle drills downwards. Values that another block or a
/// caller sets are not compared.
void TextWatch::take_levels(const Block& block, const Word& cycle) {
  const Word* const r = block.find('R');
  const Word* const z = block.find('Z');
  if (r != nullptr && !r->expression) level_ = r->value;
  if (z != nullptr && !z->expression) bottom_ = z->value;
  const bool back_bores = cycle.code == 87_g;
  if (!absolute_ || !in_xy_ || back_bores || r == nullptr || z == nullptr || r->expression || z->expression || r->value > z->value) return;
  add(AlarmId::levels_swapped, origin_of(block), r->where, r->value, z->value);
}

/// Finds positions after a cancelled cycle. In `G81 …`, positions, `G0 X10 Y10`, positions, `G80` the control does not drill at the
/// positions after G0. The late G80 suggests that the programmer expects the control to drill there.
void TextWatch::take_cycle(const Block& block) {
  const bool axis_words = moves(block);
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    const CodeRow* const code = row(w);
    if (code == nullptr || w.address != 'G') continue;
    const bool drills =
        w.code >= 73_g && w.code <= 89_g && w.code != 80_g && w.code % 10 == 0 &&
        (code->function == Function::cycle || code->function == Function::drilling || code->function == Function::canned_cycle);
    if (drills) {
      in_cycle_ = true, lost_ = false;
      cancelled_.reset();
      return take_levels(block, w);
    }
    if (w.code == 80_g) {
      if (cancelled_ && lost_ && found_.size() < max_found) found_.push_back(*cancelled_);
      in_cycle_ = lost_ = false;
      cancelled_.reset();
      return;
    }
    if (in_cycle_ && w.code <= 3_g && (w.code % 10) == 0) {
      in_cycle_ = false;
      const bool along_xy = block.has('X') || block.has('Y');
      if (along_xy && !block.has('Z') && w.code == 0)
        cancelled_ = Advice{advice(AlarmId::hole_lost, w.where, AlarmArg("G80")), origin_of(block), 0};
      return;
    }
    if (cancelled_ && w.code <= 3_g) cancelled_.reset();
  }
  if (cancelled_ && axis_words) {
    const bool only_positions = (block.has('X') || block.has('Y')) && !block.has('Z') && !block.has('G') && !block.has('M');
    if (only_positions) lost_ = true;
    else cancelled_.reset();
  }
}

void TextWatch::note_call(const Block& block, const Word& code) {
  const Word* const p = block.find('P');
  if (p == nullptr) return;
  if (p->expression) {
    calls_by_value_ = true;
    return;
  }
  const double number = p->value * std::pow(10.0, p->counted);
  if (!(number >= 0 && number < 1e9) || calls_.size() >= max_numbers) return;
  const auto n = static_cast<std::uint32_t>(std::llround(number));
  calls_.insert(n);
  // in M98 P30100 the first digit is the number of calls and the last four are the program number, so only the last four are stored
  if (code.address == 'M') calls_.insert(n % 10'000);
}

void TextWatch::take_flow(const Block& block) {
  if (block.statement.kind == StatementKind::o_word) has_o_words_ = true;
  const bool begins = block.marker == Marker::label;
  if (begins || sections_.empty()) {
    if (sections_.size() < max_numbers)
      sections_.push_back({begins ? block.label : 0, origin_of(block), false, false, {}, {}, {}, 0, false});
    if (begins) ended_ = false;
    if (sections_.size() > 1) absolute_ = false, in_xy_ = true;
  }
  if (block.marker == Marker::program_start || block.marker == Marker::section || has_name(block)) ended_ = false;
  Section& now = sections_.back();
  const Statement& s = block.statement;
  if (s.kind == StatementKind::go_to) {
    now.has_targets = true;
    if (const auto target = constant(block, s.value); target && now.jumps.size() < max_numbers)
      now.jumps.try_emplace(*target, block.position.line);
  }
  if (ended_ && moves(block) && block.marker == Marker::none) {
    if (!now.after_end) now.after_end = origin_of(block);
    ++now.lines_after_end;
  }
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    if (w.address == 'M' && (w.code == 98_m || w.code == 97_m)) note_call(block, w);
    if (w.address == 'G' && (w.code == 65_g || w.code == 66_g || w.code == 66.1_g)) note_call(block, w);
    if (w.address == 'M' && (w.code == 97_m || w.code == 99_m) && block.has('P')) now.has_targets = true;
    if (w.address == 'M' && w.code == 99_m)
      now.returns = true, ended_ = ended_ || (block.skip == 0 && s.condition_count == 0 && !block.has('P'));
    const CodeRow* const code = row(w);
    if (code != nullptr && code->function == Function::repeat_program) repeats_ = true;
    if (code != nullptr && (code->function == Function::program_end || code->function == Function::tape_end)) {
      now.ends_program = main_over_ = true;
      ended_ = ended_ || (block.skip == 0 && s.condition_count == 0);
    }
  }
}

void TextWatch::take_comments(const Block& block) {
  if (const Word* const t = block.find('T'); t != nullptr && !t->expression) {
    tool_ = static_cast<std::uint32_t>(std::clamp(t->value, 0.0, 1e6));
    if (loose_teeth_ > 0 && teeth_.size() < max_numbers) teeth_.try_emplace(tool_, loose_teeth_);
    loose_teeth_ = 0;
  }
  for (const Span& where : block.comments) {
    const std::string_view text = block.text_of(where);
    const int teeth = teeth_named(text);
    if (teeth == 0) continue;
    const auto named = read_tool_comment(text, false).tool;
    const bool in_call_block = !named && block.has('T') && tool_ != 0;
    if ((named || in_call_block) && teeth_.size() < max_numbers) teeth_.try_emplace(named ? *named : tool_, teeth);
    else loose_teeth_ = teeth;  // the comment belongs to the tool that the program calls next
  }
}

void TextWatch::take(const Block& block) {
  take_comments(block);
  take_flow(block);
  take_points(block);
  take_codes(block);
  take_cycle(block);
}

void TextWatch::read(BlockReader reader, const StopToken& stop, const std::optional<Place>& from,
                     const std::function<void(const Place&)>& meet) {
  constexpr unsigned now_and_then = 4096, between_places = 1024;
  const BlockReader::Memory fresh = reader.memory();
  const auto each = [&](auto&& take_block) {
    Block block;
    for (unsigned n = 0; n % now_and_then != 0 || !stop.requested(); ++n) {
      block.clear();
      const auto got = reader.next(block);
      if (!got) continue;  // the control reports a fault of the block by an alarm, so the block is skipped here
      if (*got == BlockReader::Got::end) break;
      take_block(block);
    }
  };
  if (from) {
    reader.resume_from(from->reader);
    reader.seek(from->position);
  }
  unsigned blocks = 0;
  each([&](const Block& block) {
    take(block);
    if (meet && ++blocks % between_places == 0) meet({reader.position(), reader.memory()});
  });
  const bool jumps = std::any_of(sections_.begin(), sections_.end(), [](const Section& s) { return !s.jumps.empty(); });
  if (!jumps) return;
  reader.resume_from(fresh);
  reader.seek({});
  std::size_t at = 0;
  bool first = true;
  each([&](const Block& block) {
    if (block.marker == Marker::label && !first && at + 1 < sections_.size()) ++at;
    first = false;
    Section& section = sections_[at];
    if (block.has_number && section.jumps.contains(block.number)) ++section.twice[block.number];
  });
}

bool TextWatch::has_end() const {
  return repeats_ || std::any_of(sections_.begin(), sections_.end(), [](const Section& s) { return s.ends_program || s.returns; });
}

void TextWatch::finish(Advices& to) {
  if (with_point_ >= 4 && without_point_ * 4 <= with_point_)
    for (const Advice& a : pointless_) found_.push_back(a);
  for (const Advice& a : found_) to.add(a);
  std::set<std::uint32_t> labels;
  for (const Section& s : sections_) labels.insert(s.label);
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    const Section& s = sections_[i];
    for (const auto& [target, line] : s.jumps) {
      const auto found = s.twice.find(target);
      Origin origin;
      origin.line = line;
      if (found == s.twice.end()) to.add(AlarmId::jump_to_nowhere, origin, 0, double(target));
      else if (found->second > 1) to.add(AlarmId::jump_to_two, origin, 0, double(target));
    }
    if (s.after_end && !s.has_targets && !has_o_words_ && !def().has_lines_alone())
      to.add(AlarmId::lines_unreachable, *s.after_end, 0, double(s.lines_after_end));
    // a program with at least this number may be called by a code that a parameter defines, so the text need not call it
    constexpr std::uint32_t of_codes = 9000;
    if (i > 0 && s.returns && !s.ends_program && s.label < of_codes && !calls_by_value_ && !calls_.contains(s.label))
      to.add(AlarmId::subprogram_uncalled, s.begins, 0, double(s.label));
  }
  for (const auto& [function, last] : switched_on_) {
    const Function on = function;
    const auto mode = std::find_if(modes.begin(), modes.end(), [&](const Mode& m) { return m.on == on; });
    if (!stated_.contains(mode->off) && !stated_.contains(on))
      to.add(AlarmId::mode_left_on, last.first, 'G', std::string_view(last.second));
  }
}

}  // namespace kadr
