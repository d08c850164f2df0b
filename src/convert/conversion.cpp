// Converts a program from a source control to a target control. Used by cli/convert; tested by tests/convert.py and tests/convert.

#include "convert/conversion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/machine/machine_codes.h"
#include "convert/code_match.h"
#include "convert/flat/klartext_program.h"
#include "convert/proving.h"
#include "convert/source_comments.h"
#include "convert/word_by_word.h"
#include "lang/text/text_spool.h"
#include "out/program/words.h"
#include "texts/conversion.h"

namespace kadr {
namespace {

/// Writes the whole program as flat blocks (single motions) in the form that FlatForm selects.
class Writing {
 public:
  Writing(const ConversionSpec& spec, ConvertedAs as)
      : spec_(spec),
        blocks_(*spec.to,
                [this](std::string_view line) {
                  text_.append(line);
                  return text_.size() <= max_made;
                }),
        comments_(spec.source_text) {
    made_.as = as;
  }

  tl::expected<ConversionTry, std::string> write() {
    auto opened = spec_.source(spec_.setup);
    if (!opened) return tl::unexpected(opened.error());
    session_ = std::move(*opened);
    const FlatForm form = made_.as == ConvertedAs::contours  ? FlatForm::contours
                          : made_.as == ConvertedAs::lengths ? FlatForm::lengths
                                                             : FlatForm::plain;
    Control& control = session_->control();
    control.return_each_block();
    std::unique_ptr<FlatWriter> written;
    if (spec_.to->grammar.klartext_blocks) written = std::make_unique<KlartextProgram>(blocks_, flat_source_of(*session_, *spec_.to), form);
    else written = std::make_unique<FlatProgram>(blocks_, flat_source_of(*session_, *spec_.to), form);
    FlatWriter& flat = *written;
    flat_ = &flat;
    Outlets& outlets = session_->outlets();
    outlets.stop = spec_.stop;
    if (form == FlatForm::contours) {
      outlets.programmed = [this](const Action& action) { take(action); };
      outlets.step = [](const Step&) {};
    } else {
      outlets.step = [this](const Step& step) { take(step.action); };
    }
    note(flat.begin(session_->stand(), control.placement()));
    // Before a block the control is in the state after the previous block, which may have selected other offsets without an action
    if (is_lathe(*spec_.to))
      control.holds_before = [&](const Origin&) {
        if (!made_.cannot_express) note(flat.note_offsets(offsets_of(control, session_->def())));
        return false;
      };
    while (!made_.cannot_express && session_->go_on() == Session::State::running) {
    }
    control.holds_before = nullptr;
    if (!made_.cannot_express) note(flat.finish());
    made_.counts_from = flat.counts_from();
    for (const std::string& comment : comments_.rest())
      if (!made_.cannot_express) blocks_.comment(comment), note(blocks_.end());
    if (!made_.cannot_express) made_.text = text_.source();
    return std::move(made_);
  }

 private:
  void note(const Status& status) {
    if (!status && !made_.cannot_express) made_.cannot_express = status.error(), made_.at = at_;
  }

  void take(const Action& action) {
    if (made_.cannot_express) return;
    const Origin& origin = action.origin;
    if (origin.number != at_.number || origin.line != at_.line || origin.file != at_.file) {
      note(flat_->end_block());
      at_ = origin;
      bool may_change = origin.file != 0;
      if (origin.file == 0) {
        for (const std::string& comment : comments_.up_to(origin.line)) blocks_.comment(comment), note(blocks_.end());
        may_change = comments_.names_rows();
      }
      // Reading the offsets takes longer than the block itself, so they are read only after a change
      if (may_change || has_changed_) now_ = offsets_of(session_->control(), session_->def());
      has_changed_ = may_change;
      if (origin.has_block && origin.file == 0 && origin.line != numbered_) blocks_.set_number(origin.block);
      numbered_ = origin.line;
    }
    note(flat_->take(action, now_));
  }

  const ConversionSpec& spec_;
  ConversionTry made_;
  TextSpool text_;
  BlockMaker blocks_;
  SourceComments comments_;
  std::unique_ptr<Session> session_;
  FlatWriter* flat_ = nullptr;
  Origin at_;
  std::uint32_t numbered_ = 0;  // line of the last block that received a block number
  bool has_changed_ = true;     // the previous block may have changed the offsets in force
  OffsetsInForce now_;
};

/// Proves the text from further states: set-ups with additional values, which the given set-up does not state.
///   returns  an error sentence if a session could not be opened
tl::expected<void, std::string> prove_in_others(const Proving& proving, ConversionTry& one) {
  auto other = proving.from_others(one.text, one.as, one.counts_from);
  if (!other) return tl::unexpected(other.error());
  if (other->differs) {
    one.proof = std::move(other->proof);
    one.differs_elsewhere = other->is_elsewhere, one.differs_unstated = !other->is_elsewhere;
  } else {
    one.proven_states = other->proven, one.zero_by_operator = other->by_operator;
  }
  return {};
}

tl::expected<ConversionTry, std::string> one_try(const ConversionSpec& spec, ConvertedAs as, const ProgramShape& shape,
                                                 const Proving& proving) {
  if (as == ConvertedAs::words) return word_by_word(spec, shape, proving);
  ConversionTry one;
  one.as = as;
  if (as == ConvertedAs::as_it_stands) {
    one.text = spec.source_text;
  } else {
    auto written = Writing(spec, as).write();
    if (!written) return tl::unexpected(written.error());
    one = std::move(*written);
  }
  if (one.cannot_express || spec.stop.requested()) return one;
  auto proof = proving.from_given(one.text, as);
  if (!proof) return tl::unexpected(proof.error());
  one.proof = std::move(*proof);
  if (!one.is_equal() || spec.stop.requested()) return one;
  if (const auto result = prove_in_others(proving, one); !result) return tl::unexpected(result.error());
  return one;
}

bool is_written_so(ByteSource& text, const WrittenLetters& letters) {
  return each_piece(text, [&](std::string_view piece) { return kadr::is_written_so(piece, letters); });
}

/// Replaces letters that the target control lacks, then reads and proves the changed text once more.
tl::expected<void, std::string> write_in_letters(const ConversionSpec& spec, ConversionTry& one, const Proving& proving) {
  const WrittenLetters letters = spec.letters.value_or(spec.to->letters);
  if (is_written_so(*one.text, letters)) return {};
  TextSpool text;
  std::size_t characters = 0;
  (void)each_piece(*one.text, [&](std::string_view piece) {
    const Transliterated made = transliterated(piece, letters);
    text.append(made.text), characters += made.characters;
    return !spec.stop.requested();
  });
  if (characters == 0 || spec.stop.requested()) return {};
  one.transliterated = characters;
  one.text = text.source();
  const std::size_t passed = one.proof.passed_messages;
  // the messages of the programs are not compared, because letters in them have been replaced
  auto proof = proving.from_given(one.text, one.as, false);
  if (!proof) return tl::unexpected(proof.error());
  one.proof = std::move(*proof);
  one.proof.passed_messages = passed;
  return {};
}

std::string sentence_of(const MachineCodes::Fault& fault) {
  return translated(texts::conversion::no_machine_function, fault.control, fault.code, fault.there, fault.other);
}

/// True for the code of an exact stop, and for the code that ends exact stops by rounding corners again. These codes differ between
/// controls that have exact stops.
bool is_of_exact_stop(const CodeRow& row) {
  return row.function == Function::exact_stop_block || row.function == Function::exact_stop_mode ||
         row.function == Function::constant_velocity || (row.function == Function::feed_control && row.arg == continuous_cutting);
}

/// True if expanded blocks of a target control with these path modes can express the code.
bool is_written_there(const CodeRow& code, const PathModes& there) {
  if (there.exact && is_of_exact_stop(code)) return true;
  return (there.speeds && code.function == Function::feed_control) || (there.smoothing && code.function == Function::smoothing);
}

}  // namespace

double usual_tolerance(const ControlDef& from, const ControlDef& to, bool arcs) {
  const auto half_increment = [&](char letter) {
    double coarser = 0;
    for (const ControlDef* const def : {&from, &to})
      if (const Words form(*def, letter); form.known()) coarser = std::max(coarser, form.increment());
    return coarser / 2;
  };
  constexpr std::pair<char, char> axes[] = {{'X', 'I'}, {'Y', 'J'}, {'Z', 'K'}};
  // Sums of squared rounding errors, mm², of lines and of arcs. The increments differ by axis: in spec/gost 3 only Z has hundredths.
  double lines = 0, around = 0;
  for (const auto& [axis, centre] : axes) {
    const double end = half_increment(axis), off = end + 2 * half_increment(centre);
    lines += end * end;
    if (axis != 'Z') around += off * off - end * end;
  }
  return std::sqrt(lines + (arcs ? around : 0));
}

tl::expected<Converted, std::string> converted(const ConversionSpec& spec) {
  Converted all;
  auto session = spec.source(spec.setup);
  if (!session) return tl::unexpected(session.error());
  const std::unique_ptr<Session> opened = std::move(*session);
  if (const auto fault = MachineCodes(opened->def(), *spec.to).fault()) return tl::unexpected(sentence_of(*fault));
  const ProgramShape shape(spec.source_text, opened->def(), spec.stop);
  const CodeMatch match(opened->def(), *spec.to);
  all.wear_is_zero = turns(opened->def(), *spec.to) && !wears_alike(opened->def(), *spec.to);
  const PathModes there = path_modes_of(*spec.to);
  for (const std::size_t row : shape.path_modes()) {
    const CodeRow& code = opened->def().codes[row];
    if (is_written_there(code, there)) continue;
    all.path_modes.push_back(code.code);
    if (match.of(code) == nullptr) all.path_modes_unknown.push_back(code.code);
  }
  if (shape.rounds_corners() && !there.tolerance)
    for (auto* const codes : {&all.path_modes, &all.path_modes_unknown}) codes->emplace_back("G64 P");
  CompareRules rules;
  rules.stop = spec.stop;
  rules.tolerance = all.tolerance = spec.tolerance > 0 ? spec.tolerance : usual_tolerance(opened->def(), *spec.to, shape.has_arcs());
  rules.feeds_at_speed = true;
  if (const Words form(*spec.to, 'F'); form.known()) rules.feed_step = form.increment();
  rules.tools_by_hand = all.tools_by_hand = !changes_tools(*spec.to);
  rules.first_only = true;
  rules.times = false;
  rules.messages = shows_same_messages(opened->def(), *spec.to);
  const Proving proving(spec, *opened, shape, rules);
  all.setup = proving.setup_of(ConvertedAs::words), all.plain_setup = proving.setup_of(ConvertedAs::plain);
  for (const ConvertedAs as :
       {ConvertedAs::as_it_stands, ConvertedAs::words, ConvertedAs::contours, ConvertedAs::lengths, ConvertedAs::plain}) {
    if (spec.flat && (as == ConvertedAs::as_it_stands || as == ConvertedAs::words)) continue;
    if (spec.only && as != *spec.only) continue;
    if (as == ConvertedAs::words && is_lathe(opened->def()) != is_lathe(*spec.to)) {
      ConversionTry& one = all.tries.emplace_back();
      one.as = as, one.cannot_express = alarm(AlarmId::function_has_no_code, {}, "T0101");
      continue;
    }
    // Conversational blocks have no counterparts among words, so only the motions themselves can be written.
    if (as == ConvertedAs::words && opened->def().grammar.klartext_blocks != spec.to->grammar.klartext_blocks) {
      ConversionTry& one = all.tries.emplace_back();
      one.as = as, one.cannot_express = alarm(AlarmId::function_has_no_code, {}, "L");
      continue;
    }
    auto one = one_try(spec, as, shape, proving);
    if (!one) return tl::unexpected(one.error());
    if (one->is_proven()) {
      if (const auto result = write_in_letters(spec, *one, proving); !result) return tl::unexpected(result.error());
    }
    const bool is_proven = one->is_proven(), never = one->proof.stopped_a.has_value();
    all.tries.push_back(std::move(*one));
    if (is_proven) all.taken = all.tries.size() - 1;
    if (is_proven || never || spec.stop.requested()) break;
  }
  return all;
}

}  // namespace kadr
