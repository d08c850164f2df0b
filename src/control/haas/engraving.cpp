// Engraves text with G47 (spec/haas 7.2): P0 engraves the text of the comment, P1 the serial number in #599, P32 to P126 a single
// character. INFERRED: the shape of the letters, and the motions between strokes: the tool moves at rapid at the R level, and plunges at
// the start of each stroke. Tested by tests/cases/haas/cycles.cases.

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "control/fanuc/fanuc.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"
#include "control/haas/letters.h"

namespace kadr::functions {
namespace {

constexpr double usual_height = mm_per_inch;  // height of the text in mm, if J is missing
constexpr double text_itself = 0, serial_number = 1, first_character = 32, last_character = 126;  // values of P
constexpr int serial_variable = 599;
// greatest number of digits of the serial number: a double stores whole numbers of 15 digits exactly
constexpr std::size_t max_digits = 15;

/// Engraves one line of text.
class EngravedText {
 public:
  EngravedText(Emitter& m, const Call& call) : m_(m), call_(call) {}

  Status run() {
    KADR_TRY(choose_text());
    if (only_counts_) return {};
    KADR_TRY(words());
    KADR_TRY(m_.feed_known(call_.where));
    m_.warn(warning(AlarmId::engraving_font, call_.where, call_.row->code));
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const auto strokes = haas::strokes_of(text_[i]);
      for (const auto& stroke : *strokes) KADR_TRY(draw(stroke, static_cast<double>(i) * haas::letter_advance));
    }
    KADR_TRY(over({static_cast<double>(text_.size()) * haas::letter_advance, 0}));
    if (p_ == serial_number) set_serial(serial_ + 1);
    return to_level(level_, MotionKind::rapid);
  }

 private:
  /// Determines the text to engrave from P.
  ///     alarms  value_out_of_range; word_missing: there is no comment
  Status choose_text() {
    p_ = m_.has('P') ? m_.value('P') : text_itself;
    if (p_ >= first_character && p_ <= last_character && p_ == std::floor(p_)) {
      text_ = static_cast<char>(p_);
      return {};
    }
    if (p_ != text_itself && p_ != serial_number) return fail(alarm(AlarmId::value_out_of_range, m_.where('P'), 'P', p_));
    if (m_.block->comments.empty()) return fail(alarm(AlarmId::word_missing, call_.where, '(', call_.row->code));
    text_ = std::string(m_.block->text_of(m_.block->comments.front()));
    return p_ == serial_number ? choose_serial() : Status();
  }

  /// Determines the serial number to engrave. With the comment `(####)`, the number of characters # is the number of digits of #599 to
  /// engrave. A longer number loses its first digits; a shorter number gets leading zeros. Then #599 is increased by 1. The comment
  /// `(1234)` sets #599 and engraves nothing.
  ///     alarms  not_available: the comment has other characters
  Status choose_serial() {
    const auto consists_of = [&](std::string_view signs) {
      return !text_.empty() && text_.size() <= max_digits && text_.find_first_not_of(signs) == std::string::npos;
    };
    only_counts_ = consists_of("0123456789");
    if (only_counts_) {
      set_serial(std::stod(text_));
      return {};
    }
    if (!consists_of("#")) return fail(alarm(AlarmId::not_available, m_.block->comments.front(), std::string_view(text_)));
    const double stored = macro_b_of(m_).variables.common(serial_variable);
    serial_ = is_vacant(stored) ? 0 : std::round(std::fabs(stored));
    const double shown = std::fmod(serial_, std::pow(10.0, static_cast<double>(text_.size())));
    text_ = fmt::format("{:0{}.0f}", shown, text_.size());
    return {};
  }

  void set_serial(double number) {
    macro_b_of(m_).endless.note_change();
    macro_b_of(m_).variables.set_common(serial_variable, number);
  }

  /// Reads the words of G47.
  ///   alarms  not_available (the font lacks a letter), word_missing, value_out_of_range
  Status words() {
    for (const char letter : {'R', 'Z'})
      if (!m_.has(letter)) return fail(alarm(AlarmId::word_missing, call_.where, letter, call_.row->code));
    const Span where = m_.block->comments.empty() ? call_.where : m_.block->comments.front();
    for (const char letter : text_) {
      const std::string shown = std::string(call_.row->code) + " '" + letter + "'";
      if (!haas::strokes_of(letter)) return fail(alarm(AlarmId::not_available, where, std::string_view(shown)));
    }
    const double height = m_.has('J') ? m_.length_value('J') : usual_height;
    if (!(height > 0)) return fail(alarm(AlarmId::value_out_of_range, m_.where('J'), 'J', height));
    unit_ = height / haas::letter_height;
    along_ = sincos_deg(m_.has('I') ? m_.value('I') : 0);
    level_ = m_.length_value('R');
    if (m_.has('E')) plunge_ = m_.length_value('E');
    Axes to;
    AxisMask named = 0;
    KADR_TRY(m_.target(to, named));
    start_ = {to[plane_.first], to[plane_.second]};
    bottom_ = to[plane_.normal];
    return {};
  }

  Status draw(const std::vector<Vec2>& stroke, double from) {
    KADR_TRY(over(stroke.front() + Vec2{from, 0}));
    KADR_TRY(to_level(level_, MotionKind::rapid));
    KADR_TRY(to_level(bottom_, MotionKind::feed));
    for (std::size_t i = 1; i < stroke.size(); ++i) KADR_TRY(to_point(stroke[i] + Vec2{from, 0}, MotionKind::feed));
    return to_level(level_, MotionKind::rapid);
  }

  Status over(Vec2 point) { return to_point(point, MotionKind::rapid); }

  /// Moves to a point of the text, which is given in units of the font.
  Status to_point(Vec2 point, MotionKind kind) {
    Axes to = m_.position.programmed;
    to[plane_.first] = start_.x + unit_ * (point.x * along_.cos - point.y * along_.sin);
    to[plane_.second] = start_.y + unit_ * (point.x * along_.sin + point.y * along_.cos);
    return m_.straight(kind, to, AxisMask{1} << plane_.first | AxisMask{1} << plane_.second);
  }

  Status to_level(double level, MotionKind kind) {
    Axes to = m_.position.programmed;
    if (to[plane_.normal] == level) return {};
    to[plane_.normal] = level;
    KADR_TRY(m_.straight(kind, to, AxisMask{1} << plane_.normal));
    if (kind == MotionKind::feed && plunge_ > 0) std::get<Motion>(m_.batch->back().what).feed = plunge_;
    return {};
  }

  Emitter& m_;
  const Call& call_;
  PlaneAxes plane_ = m_.modal.axes;
  double p_ = text_itself, serial_ = 0;
  bool only_counts_ = false;
  std::string text_;
  Vec2 start_;
  SinCos along_{};
  double unit_ = 0, level_ = 0, bottom_ = 0, plunge_ = 0;
};

}  // namespace

Status engraved_text(Emitter& m, const Call& call) { return EngravedText(m, call).run(); }

}  // namespace kadr::functions
