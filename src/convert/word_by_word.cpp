// Rewrites a program, proves the result, expands the lines that fail, and repeats these steps. Used by convert/conversion; tested by
// tests/convert.

#include "convert/word_by_word.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "config/language.h"
#include "convert/proving.h"
#include "convert/rewriting.h"
#include "lang/text/text_spool.h"

namespace kadr {
namespace {

constexpr int max_rounds = 100;  // greatest number of rounds; each round rewrites the whole program and proves it once
// Number of rounds (rewritings of the whole program) at the beginning that stop soon after a line that cannot be expressed.
constexpr int early_rounds = 3;
constexpr std::size_t max_work = 6'000'000;  // greatest number of lines, blocks and motions processed in all rounds together

class WordByWord {
 public:
  WordByWord(const ConversionSpec& spec, const ProgramShape& shape, const Proving& proving)
      : spec_(spec), shape_(shape), proving_(proving) {
    made_.as = ConvertedAs::words;
  }

  tl::expected<ConversionTry, std::string> write() {
    auto session = spec_.source(spec_.setup);
    if (!session) return tl::unexpected(session.error());
    from_ = &(*session)->def();
    opened_ = std::move(*session);
    write_out_calls();
    for (int round = 0; round < max_rounds && !spec_.stop.requested(); ++round) {
      auto grown = one_round(round < early_rounds);
      if (!grown) return tl::unexpected(grown.error());
      work_ += shape_.lines() + 1 + made_.proof.moves_a + made_.proof.moves_b;
      if (!*grown && (made_.is_proven() || is_hopeless() || !begin_again())) return std::move(made_);
      if (work_ > max_work) break;
    }
    if (!spec_.stop.requested()) unsayable(alarm(AlarmId::conversion_takes_long, {}), 0);
    return std::move(made_);
  }

 private:
  static std::shared_ptr<ByteSource> with_head(const std::string& head, std::shared_ptr<ByteSource> text) {
    if (head.empty()) return text;
    TextSpool whole;
    whole.append(head);
    (void)each_piece(*text, [&](std::string_view piece) {
      whole.append(piece);
      return true;
    });
    return whole.source();
  }

  /// Rewrites and proves the program once. Returns true if more lines must be expanded.
  tl::expected<bool, std::string> one_round(bool ends_early) {
    made_.text = text_source({}), made_.cannot_express.reset(), made_.proof = {};
    made_.proven_states.reset(), made_.differs_elsewhere = made_.differs_unstated = false;
    std::vector<FlatRange> places;
    if (!places_.empty()) {
      for (const auto& [first, last] : places_) places.push_back({{first, last}, follows({first, last}, places)});
      auto source = spec_.source(spec_.setup);
      if (!source) return tl::unexpected(source.error());
      const auto blocks =
          write_flat_ranges(**source, *spec_.to, places, centres_, shape_.goes_straight_on_after(places.back().lines.last), spec_.stop);
      if (!blocks) {
        unsayable(blocks.error(), 0);
        return false;
      }
      work_ += *blocks;
      if (const auto result = look_elsewhere(places); !result) return tl::unexpected(result.error());
      for (const FlatRange& place : places)
        if (!place.settled()) {
          why_ = place.cannot, varies_ = place.differs;
          if (grow(place.lines)) return true;
          unsayable(place.cannot ? *place.cannot : alarm(AlarmId::function_has_no_code, {}, "GOTO"), place.lines.first);
          return false;
        }
    }
    const RewriteSpec rewriting{spec_.source_text, from_,
                                spec_.to,          &places,
                                &left_out_,        shape_.variables(),
                                shape_.macros(),   spec_.stop,
                                ends_early,        has_russian(spec_.letters.value_or(spec_.to->letters)) ? thread_language() : Lang::en};
    TextSpool text;
    const auto written = rewrite(rewriting, [&text](std::string_view line) {
      text.append(line);
      return text.size() <= max_made;
    });
    if (!written) {
      unsayable(written.error(), 0);
      return false;
    }
    made_.text = with_head(written->head, text.source());
    if (!written->unsaid.empty()) return write_out_unsaid(*written);
    return prove(*written);
  }

  /// Finds ranges whose coordinates change with what a probe touches, or with values that the set-up does not state. Such ranges must not
  /// be expanded.
  tl::expected<void, std::string> look_elsewhere(std::vector<FlatRange>& places) const {
    for (const Setup& witness : proving_.witnesses()) {
      std::vector<FlatRange> others;
      for (const FlatRange& place : places) others.push_back({place.lines, place.follows});
      auto source = spec_.source(witness);
      if (!source) return tl::unexpected(source.error());
      if (!write_flat_ranges(**source, *spec_.to, others, centres_, shape_.goes_straight_on_after(others.back().lines.last), spec_.stop))
        continue;
      for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i].text == others[i].text || places[i].times != others[i].times || places[i].cannot) continue;
        places[i].cannot = places[i].probed ? alarm(AlarmId::function_has_no_code, {}, "probe") : alarm(AlarmId::conversion_unstated, {});
      }
    }
    return {};
  }

  bool write_out_unsaid(const Rewritten& written) {
    bool any = false;
    for (const InexpressibleLine& unsaid : written.unsaid) {
      if (is_left_out(unsaid.line)) continue;
      why_ = unsaid.why, varies_ = false;
      if (write_out({unsaid.line, unsaid.line})) {
        any = true;
      } else {
        unsayable(unsaid.why, unsaid.line);
        return false;
      }
    }
    return any || !written.unsaid.empty();
  }

  tl::expected<bool, std::string> prove(const Rewritten& written) {
    auto proof = proving_.from_given(made_.text, ConvertedAs::words);
    if (!proof) return tl::unexpected(proof.error());
    made_.proof = std::move(*proof);
    if (made_.proof.stopped_a) return false;
    if (made_.is_equal()) {
      auto other = proving_.from_others(made_.text, ConvertedAs::words, std::nullopt);
      if (!other) return tl::unexpected(other.error());
      if (!other->differs) {
        made_.proven_states = other->proven, made_.zero_by_operator = other->by_operator;
        return false;
      }
      made_.proof = std::move(other->proof);
      made_.differs_elsewhere = other->is_elsewhere, made_.differs_unstated = !other->is_elsewhere;
    }
    why_.reset(), varies_ = false;
    const auto line = place_of_failure(written);
    return line && write_out({*line, *line});
  }

  /// Returns the line of the source program at which the two programs begin to differ.
  std::optional<std::uint32_t> place_of_failure(const Rewritten& written) const {
    const Comparison& proof = made_.proof;
    std::uint32_t line = 0;
    if (proof.stopped_b && proof.differences.size() < 2) line = written.lines.of(proof.stopped_b->origin.line);
    if (line == 0 && !proof.differences.empty()) {
      const CourseDifference& first = proof.differences.front();
      line = first.a.origin.file == 0 ? first.a.origin.line : 0;
      if (line == 0) line = written.lines.of(first.b.origin.line);
    }
    return line == 0 ? std::nullopt : std::optional(line);
  }

  void write_out_calls() {
    for (const std::uint32_t line : shape_.calls_outside()) add({line, line});
  }

  /// Starts the rounds again, now with lines expanded from the first round on that often cannot be rewritten: at the first restart
  /// contours, at the second one lines that rotate, mirror or scale, at the third one both. Returns false if no restart is left.
  bool begin_again() {
    const bool has_contours = !shape_.contours().empty(), has_transforms = !shape_.transforms().empty();
    for (++stage_; stage_ <= 3; ++stage_) {
      centres_ = has_contours && stage_ != 2;
      const bool frames = has_transforms && stage_ >= 2;
      if ((stage_ == 1 && !centres_) || (stage_ == 2 && !frames) || (stage_ == 3 && !(centres_ && frames))) continue;
      places_.clear(), left_out_.clear(), steps_back_.clear(), made_.written_out.clear();
      why_.reset(), varies_ = false, made_.proof = {};
      write_out_calls();
      if (frames)
        for (const std::uint32_t line : shape_.transforms())
          if (!is_in_place(line)) add({line, line});
      if (centres_)
        for (const TextLines& contour : shape_.contours()) add(contour);
      return true;
    }
    return false;
  }

  bool is_left_out(std::uint32_t line) const {
    return std::any_of(left_out_.begin(), left_out_.end(), [&](const TextLines& gone) { return gone.holds(line); });
  }
  std::optional<TextLines> place_at(std::uint32_t line) const {
    const auto after = places_.upper_bound(line);
    if (after == places_.begin() || std::prev(after)->second < line) return std::nullopt;
    return TextLines{std::prev(after)->first, std::prev(after)->second};
  }
  bool is_in_place(std::uint32_t line) const { return place_at(line).has_value(); }
  /// Removes the expanded ranges that begin in these lines.
  void erase_places(TextLines lines) { places_.erase(places_.lower_bound(lines.first), places_.upper_bound(lines.last)); }
  /// True if neither a further round nor a restart can succeed.
  bool is_hopeless() const {
    return made_.proof.stopped_a || (made_.cannot_express && made_.cannot_express->id == AlarmId::conversion_too_long);
  }

  void unsayable(const Alarm& why, std::uint32_t line) {
    made_.cannot_express = why;
    made_.at.line = line;
  }

  /// Expands these lines and the lines that belong to them. Returns false if nothing can be added to the range.
  bool write_out(TextLines lines) {
    if (shape_.is_edge(lines.first)) return grow(lines);
    if (const auto place = place_at(lines.first)) return grow_back(*place) || grow(*place);
    if (const auto subprogram = shape_.subprogram_of(lines.first); subprogram && is_left_out(lines.first)) {
      constexpr int most_deep = 16;  // greatest nesting depth of subprogram calls
      if (deep_ >= most_deep) return false;
      ++deep_;
      bool any = false;
      for (const std::uint32_t caller : shape_.callers_of(*subprogram))
        any = (!subprogram->holds(caller) && write_out({caller, caller})) || any;
      --deep_;
      return any;
    }
    add(lines);
    return true;
  }

  bool follows(TextLines lines, const std::vector<FlatRange>& before) const {
    return !before.empty() && before.back().lines.holds(shape_.block_before(lines.first));
  }

  /// Also expands earlier blocks, because they may cause the difference: one block before the range, then twice as many at each attempt.
  bool grow_back(TextLines lines) {
    constexpr int max_steps = 6;
    int& steps = steps_back_[lines.first];
    if (steps >= max_steps) return false;
    bool any = false;
    std::uint32_t line = lines.first;
    for (int left = 1 << steps++; left > 0; --left) {
      do line = shape_.block_before(line);
      while (line != 0 && is_in_place(line));
      if (line == 0 || shape_.is_edge(line) || shape_.subprogram_of(line) != shape_.subprogram_of(lines.first)) break;
      add({line, line});
      any = true;
    }
    return any;
  }

  /// Enlarges an expanded range that still fails: first to the loop that contains it, then to the calls of its subprogram.
  bool grow(TextLines lines) {
    if (const auto loop = shape_.loop_around(lines)) {
      add(*loop);
      return true;
    }
    const auto subprogram = shape_.subprogram_of(lines.first);
    if (!subprogram) return false;
    const std::vector<std::uint32_t> callers = shape_.callers_of(*subprogram);
    if (callers.empty()) return false;
    erase_places(*subprogram);
    left_out_.push_back(*subprogram);
    bool any = false;
    for (const std::uint32_t caller : callers) any = (subprogram->holds(caller) ? false : write_out({caller, caller})) || any;
    return any;
  }

  void add(TextLines lines) {
    const bool differs = !why_ && !varies_ && !made_.proof.differences.empty();
    made_.written_out.push_back({lines, why_, differs ? std::optional(made_.proof.differences.front()) : std::nullopt, varies_});
    erase_places(lines);
    places_[lines.first] = lines.last;
  }

  const ConversionSpec& spec_;
  const ProgramShape& shape_;
  const Proving& proving_;
  const ControlDef* from_ = nullptr;
  std::unique_ptr<Session> opened_;                // session that keeps the definition of the source control in memory
  std::map<std::uint32_t, std::uint32_t> places_;  // expanded ranges, as first line → last line
  std::vector<TextLines> left_out_;                // subprograms that are left out, because all lines that call them are expanded
  std::map<std::uint32_t, int> steps_back_;        // number of blocks by which a range has grown backwards, by the range's first line
  ConversionTry made_;
  std::size_t work_ = 0;
  std::optional<Alarm> why_;  // the reason why the next lines are expanded: the alarm that the target control cannot express them
  bool varies_ = false;
  int deep_ = 0;
  int stage_ = 0;
  bool centres_ = false;
};

}  // namespace

tl::expected<ConversionTry, std::string> word_by_word(const ConversionSpec& spec, const ProgramShape& shape, const Proving& proving) {
  return WordByWord(spec, shape, proving).write();
}

}  // namespace kadr
