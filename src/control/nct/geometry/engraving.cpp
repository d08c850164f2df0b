// Engraved text G47 P0 (spec/haas 7.2). INFERRED: the letters, and the way between them: at rapid at R; each stroke is plunged into.

#include <string>

#include "control/functions/functions.h"
#include "control/nct/geometry/letters.h"
#include "control/nct/nct.h"
#include "control/nct/words/coordinates.h"

namespace kadr::functions {
namespace {

constexpr double usual_height = mm_per_inch;  // without J

/// One text along a line.
class EngravedText {
 public:
  EngravedText(Interpreter& m, const Call& call) : m_(m), call_(call) {}

  Status run() {
    KADR_TRY(words());
    KADR_TRY(m_.feed_known(call_.where));
    m_.warn(warning(AlarmId::engraving_font, call_.where, call_.row->code));
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const auto strokes = nct::strokes_of(text_[i]);
      for (const auto& stroke : *strokes) KADR_TRY(draw(stroke, static_cast<double>(i) * nct::letter_advance));
    }
    KADR_TRY(over({static_cast<double>(text_.size()) * nct::letter_advance, 0}));
    return to_level(level_, MotionKind::rapid);
  }

 private:
  /// alarms  not_available (a serial number, a letter that the font has not), word_missing, value_out_of_range
  Status words() {
    if (m_.has('P') && m_.value('P') != 0) return fail(alarm(AlarmId::not_available, m_.where('P'), m_.block->text_of(m_.where('P'))));
    for (const char letter : {'R', 'Z'})
      if (!m_.has(letter)) return fail(alarm(AlarmId::word_missing, call_.where, letter, call_.row->code));
    if (m_.block->comments.empty()) return fail(alarm(AlarmId::word_missing, call_.where, '(', call_.row->code));
    text_ = std::string(m_.block->text_of(m_.block->comments.front()));
    for (const char letter : text_) {
      const std::string shown = std::string(call_.row->code) + " '" + letter + "'";
      if (!nct::strokes_of(letter)) return fail(alarm(AlarmId::not_available, m_.block->comments.front(), std::string_view(shown)));
    }
    const double height = m_.has('J') ? m_.length_value('J') : usual_height;
    if (!(height > 0)) return fail(alarm(AlarmId::value_out_of_range, m_.where('J'), 'J', height));
    unit_ = height / nct::letter_height;
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

  /// A point of the text, in the units of its letters.
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

  Interpreter& m_;
  const Call& call_;
  PlaneAxes plane_ = m_.modal.axes;
  std::string text_;
  Vec2 start_;
  SinCos along_{};
  double unit_ = 0, level_ = 0, bottom_ = 0, plunge_ = 0;
};

}  // namespace

Status engraved_text(Interpreter& m, const Call& call) { return EngravedText(m, call).run(); }

}  // namespace kadr::functions
