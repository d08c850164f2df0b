// Executes what the words of a block mean together: dwells, poles, polar points, SUPA, G331, CIP, CT. Used by control/sinumerik.

#include <cmath>
#include <utility>

#include "base/tolerance.h"
#include "control/sinumerik/block_run.h"

namespace kadr::sinumerik {

Result<bool> BlockRun::finish() {
  if (call_ || block_.word_count > 0) own_.level().acted = true;
  if (call_) {
    const bool alone = block_.word_count == 0 && own_.words.numbers.empty();
    if (!alone) return fail(alarm(AlarmId::statement_not_alone, call_->where));
    if (!(times_ >= 1 && times_ <= 9999) || times_ != std::round(times_)) return fail(alarm(AlarmId::passes_wrong, call_->where, times_));
    return done(own_.call_item(m_, read_, *call_, static_cast<std::uint32_t>(times_), false));
  }
  if (in_dwell_) return done(dwell());
  if (pole_ != 0) return done(pole());
  if (reference_) return done(to_reference());
  if (fixed_point_) return done(to_fixed_point());
  if (shift_ != 0) return done(shift_frame());
  if (limits_ != 0) return done(limits());
  start_spindles();
  if (orient_) orient(*orient_);
  KADR_TRY(position_axes());
  KADR_TRY(polar_words());
  KADR_TRY(angle_word());
  KADR_TRY(tool_direction());
  KADR_TRY(corner_words());
  if (own_.words.has("RNDM")) own_.memory.rounding = own_.words.number("RNDM") * m_.unit_scale();
  if (feed_unit_) own_.memory.feed_in_mm = *feed_unit_ == 1;
  if (block_.has('F')) scale_feed();
  if (tapping_) return done(tap());
  if (own_.memory.motion == NamedMotion::thread && (block_.letters & m_.letters.axes) != 0) return done(thread());
  if (chuck_) KADR_TRY(begin_chuck());
  if (own_.words.edge && !block_.has('M')) {
    const std::uint32_t edge = *std::exchange(own_.words.edge, std::nullopt);
    KADR_TRY(own_.activate_edge(m_, edge, own_.words.edge_where));
  }
  if (approach_ != 0) KADR_TRY(approach());
  KADR_TRY(machine_words());
  KADR_TRY(named_arc());
  return block_.word_count == 0 && own_.words.numbers.empty() && !own_.words.returns;
}

void BlockRun::scale_feed() {
  Word& f = block_.words[block_.at['F' - 'A']];
  if (own_.memory.feed_in_mm) f.value /= mm_per_inch;
  f.value *= own_.memory.override_percent / 100;
}

/// CHR, CHF and RND need a motion in their block (spec/sinumerik 12.4, 18: 10882).
Status BlockRun::corner_words() const {
  if (own_.words.numbers.empty()) return {};
  for (const char* const name : {"CHR", "CHF", "RND"})
    if (own_.words.has(name) && (block_.letters & (m_.letters.axes | letter_bit('I') | letter_bit('J') | letter_bit('K'))) == 0)
      return fail(alarm(AlarmId::corner_illegal, own_.words.where(name)));
  return {};
}

Status BlockRun::dwell() {
  for (std::uint32_t i = 0; i < block_.word_count; ++i) {
    const Word& w = block_.words[i];
    if (w.address == 'F') {
      if (w.value < 0) return fail(alarm(AlarmId::value_out_of_range, w.where, 'F', w.value));
      m_.emit(Dwell{w.value});
    } else if (w.address == 'S') {
      if (!(m_.modal.rpm > 0)) return fail(alarm(AlarmId::speed_missing, w.where));
      m_.emit(Dwell{w.value / m_.modal.rpm * 60});
    } else {
      return fail(alarm(AlarmId::statement_not_alone, w.where));
    }
  }
  if (block_.word_count != 1) return fail(alarm(AlarmId::word_missing, block_.where, 'F', "G4"));
  return {};
}

Status BlockRun::pole() {
  const PlaneAxes plane = m_.modal.axes;
  Memory& memory = own_.memory;
  const Axes& at = m_.position.programmed;
  Vec2 base = pole_ == 110 ? Vec2{at[plane.first], at[plane.second]} : pole_ == 112 ? memory.pole : Vec2{};
  Vec2 by{};
  if (own_.words.has("AP") || own_.words.has("RP")) {
    const SinCos turn = sincos_deg(own_.words.has("AP") ? own_.words.number("AP") : 0);
    const double radius = (own_.words.has("RP") ? own_.words.number("RP") : 0) * m_.unit_scale();
    by = {radius * turn.cos, radius * turn.sin};
  }
  for (std::uint32_t i = 0; i < block_.word_count; ++i) {
    const Word& w = block_.words[i];
    if (w.address == m_.letters.axis_letter[plane.first]) by.x = w.value * m_.unit_scale();
    else if (w.address == m_.letters.axis_letter[plane.second]) by.y = w.value * m_.unit_scale();
    else if ((m_.letters.axes & letter_bit(w.address)) == 0) return fail(alarm(AlarmId::statement_not_alone, w.where));
  }
  memory.pole = base + by;
  return {};
}

Status BlockRun::polar_words() {
  BlockWords& words = own_.words;
  if (!words.has("AP") && !words.has("RP")) return {};
  Memory& memory = own_.memory;
  const PlaneAxes plane = m_.modal.axes;
  for (const std::size_t a : {plane.first, plane.second})
    if (const char letter = m_.letters.axis_letter[a]; block_.has(letter))
      return fail(alarm(AlarmId::polar_with_axes, block_.find(letter)->where, letter));
  if (words.has("AP"))
    memory.polar_angle = words.number("AP") + (words.number_forms["AP"] == WordForm::incremental ? memory.polar_angle : 0);
  if (words.has("RP"))
    memory.polar_radius =
        words.number("RP") * m_.unit_scale() + (words.number_forms["RP"] == WordForm::incremental ? memory.polar_radius : 0);
  if (memory.polar_radius < 0)
    return fail(alarm(AlarmId::polar_radius_negative, words.has("RP") ? words.where("RP") : block_.where, memory.polar_radius));
  // The words of the table see a motion of both axes of the plane; the end point comes from target().
  NamedItem item;
  item.where = words.has("AP") ? words.where("AP") : words.where("RP");
  item.form = WordForm::incremental;
  for (const std::size_t a : {plane.first, plane.second}) KADR_TRY(add(m_.letters.axis_letter[a], 0, item));
  return {};
}

Status BlockRun::angle_word() {
  for (const char* const name : {"ANG", "ANG1", "ANG2"})
    if (own_.words.has(name)) return angle_word(name);
  return {};
}

Status BlockRun::angle_word(const std::string& name) {
  const PlaneAxes plane = m_.modal.axes;
  const char letters[] = {m_.letters.axis_letter[plane.first], m_.letters.axis_letter[plane.second]};
  const Span where = own_.words.where(name);
  const bool whole = block_.has(letters[0]) && block_.has(letters[1]);
  if (whole && name != "ANG") return {};  // the end of the line is written
  if (name == "ANG1" && !block_.has(letters[0]) && !block_.has(letters[1])) return first_of_two_lines();
  if (block_.has(letters[0]) == block_.has(letters[1])) return fail(alarm(AlarmId::not_available, where, std::string_view(name)));
  Axes to;
  AxisMask named = 0;
  KADR_TRY(m_.target(to, named));
  const Axes& at = m_.position.programmed;
  const SinCos turn = sincos_deg(own_.words.number(name));
  const bool has_first = block_.has(letters[0]);
  const std::size_t known = has_first ? plane.first : plane.second, other = has_first ? plane.second : plane.first;
  const double along = has_first ? turn.cos : turn.sin, across = has_first ? turn.sin : turn.cos;
  if (std::fabs(along) <= tol::same_point)
    return fail(alarm(AlarmId::value_out_of_range, where, std::string_view(name), own_.words.number(name)));
  return coordinate(other, at[other] + (to[known] - at[known]) / along * across, where);
}

/// A3= B3= C3=: the direction from the tip to the holder in the frame in force (spec/sinumerik 15), as positions of the rotary axes.
Status BlockRun::tool_direction() {
  Vec3 direction;
  Span where = block_.where;
  double* const parts[] = {&direction.x, &direction.y, &direction.z};
  bool any = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string name{static_cast<char>('A' + i), '3'};
    if (!own_.words.has(name)) continue;
    *parts[i] = own_.words.number(name);
    where = own_.words.where(name);
    any = true;
  }
  if (!any) return {};
  if (!own_.memory.holds_tip) return fail(alarm(AlarmId::no_five_axes, where, "A3 B3 C3"));
  const double size = std::sqrt(dot(direction, direction));
  if (!(size > tol::same_point)) return fail(alarm(AlarmId::direction_zero, where, "A3 B3 C3"));
  const auto positions = own_.rotary_positions(m_, 1 / size * direction, where);
  if (!positions) return fail(positions.error());
  NamedItem item;
  item.where = where;
  item.form = WordForm::absolute;
  for (const auto& [joint, angle] : {std::pair(&own_.rotary.first, positions->first), std::pair(&own_.rotary.second, positions->second)})
    KADR_TRY(add(m_.letters.axis_letter[static_cast<std::size_t>(joint->axis)], angle, item));
  return {};
}

/// Adds a word with a programmed coordinate of the plane, mm.
Status BlockRun::coordinate(std::size_t axis, double value, Span where) {
  NamedItem item;
  item.where = where;
  item.form = WordForm::absolute;
  const double diameter = (m_.modal.diameter >> axis & 1U) != 0 ? 2 : 1;
  return add(m_.letters.axis_letter[axis], value * diameter / m_.unit_scale(), item);
}

/// ANG1=a, and in the next block the end of the second line with ANG2=b: the first line ends where the two meet (spec/sinumerik 12.4).
Status BlockRun::first_of_two_lines() {
  const PlaneAxes plane = m_.modal.axes;
  const Span where = own_.words.where("ANG1");
  const auto second = block_ahead();
  const std::string first_name(1, m_.letters.axis_letter[plane.first]), second_name(1, m_.letters.axis_letter[plane.second]);
  const auto written = [&](const std::string& name) -> const std::pair<double, WordForm>* {
    const auto word = second ? second->words.find(name) : std::map<std::string, std::pair<double, WordForm>>::const_iterator();
    return !second || word == second->words.end() ? nullptr : &word->second;
  };
  const auto *x = written(first_name), *y = written(second_name), *angle = written("ANG2");
  const bool absolute = second && second->absolute.value_or(m_.modal.absolute);
  const auto is_known = [&](const std::pair<double, WordForm>* word) {
    return word != nullptr && (word->second == WordForm::absolute || (word->second == WordForm::plain && absolute));
  };
  if (!is_known(x) || !is_known(y) || angle == nullptr) return fail(alarm(AlarmId::not_available, where, "ANG1"));
  const Axes& at = m_.position.programmed;
  const auto scale = [&](std::size_t axis) { return m_.unit_scale() * ((m_.modal.diameter >> axis & 1U) != 0 ? 0.5 : 1.0); };
  const Vec2 from{at[plane.first], at[plane.second]};
  const Vec2 end{x->first * scale(plane.first), y->first * scale(plane.second)};
  const SinCos one = sincos_deg(own_.words.number("ANG1")), two = sincos_deg(angle->first);
  const Vec2 along{one.cos, one.sin}, back{two.cos, two.sin};
  const double across = cross(along, back);
  const double reach = std::fabs(across) > 1e-9 ? cross(end - from, back) / across : 0;
  const double rest = std::fabs(across) > 1e-9 ? cross(along, end - from) / across : 0;  // from the corner to the end
  if (!(reach > tol::same_point) || !(rest > tol::same_point)) return fail(alarm(AlarmId::contour_no_intersection, where));
  KADR_TRY(coordinate(plane.first, from.x + reach * along.x, where));
  return coordinate(plane.second, from.y + reach * along.y, where);
}

Status BlockRun::machine_words() {
  if (!own_.words.machine) return {};
  Axes work = m_.position.work, machine = m_.position.machine;
  bool any = false;
  for (std::size_t a = 0; a < m_.axis_count; ++a) {
    const char letter = m_.letters.axis_letter[a];
    if (letter == 0 || !block_.has(letter)) continue;
    any = true;
    const bool is_length = m_.def.address(letter).unit == WordUnit::length;
    const double basic = own_.words.basic_off ? 0.0 : m_.tables.common[a];
    const double value = block_.find(letter)->value * (is_length ? m_.unit_scale() : 1.0) + basic;
    work[a] = value - m_.frames.origin[a];
    machine[a] = value + m_.frames.length[a];
  }
  own_.words.machine = own_.words.basic_off = false;
  if (!any) return {};
  // In a turned frame each of the three axes moves, so that those without a word stay where they are in the machine.
  const bool turned = !m_.frames.is_plain() || m_.transform.rotation != 0;
  if (turned) work = m_.frames.work_of(machine);
  const Axes to = m_.transform.to_programmed(work);
  for (std::size_t a = 0; a < m_.axis_count; ++a) {
    const char letter = m_.letters.axis_letter[a];
    if (letter == 0 || (!block_.has(letter) && !(turned && a < 3))) continue;
    const bool is_length = m_.def.address(letter).unit == WordUnit::length;
    const double diameter = (m_.modal.diameter >> a & 1U) != 0 ? 2 : 1;
    const double value = to[a] * diameter / (is_length ? m_.unit_scale() : 1.0);
    NamedItem item;
    item.where = block_.where;
    if (!block_.has(letter)) KADR_TRY(add(letter, value, item));
    block_.words[block_.at[static_cast<std::size_t>(letter - 'A')]].value = value;
    own_.words.forms[static_cast<std::size_t>(letter - 'A')] = WordForm::absolute;
  }
  return {};
}

Status BlockRun::to_reference() {
  AxisMask named = 0;
  for (std::size_t a = 0; a < m_.axis_count; ++a)
    if (const char letter = m_.letters.axis_letter[a]; letter != 0 && block_.has(letter)) named |= AxisMask{1} << a;
  if (named == 0) return fail(alarm(AlarmId::no_axis_word, block_.where, "G74"));
  return m_.to_machine(MotionKind::home, m_.tables.reference[1], named, 0, EndReference::reference_1);
}

Status BlockRun::named_arc() {
  const NamedMotion motion = own_.memory.motion;
  if (motion == NamedMotion::none || (block_.letters & m_.letters.axes) == 0) return {};
  const PlaneAxes plane = m_.modal.axes;
  Axes to;
  AxisMask named = 0;
  KADR_TRY(m_.target(to, named));
  const Axes& at = m_.position.programmed;
  const Vec2 from{at[plane.first], at[plane.second]}, end{to[plane.first], to[plane.second]};
  double code = 1;
  Vec2 middle{};
  if (motion == NamedMotion::through_point) {
    constexpr std::string_view names[] = {"I1", "J1", "K1"};
    Axes between = at;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::string name(names[a]);
      if (!own_.words.has(name)) continue;
      const double value = own_.words.number(name) * m_.unit_scale();
      const WordForm form = own_.words.number_forms[name];
      const bool absolute = form == WordForm::absolute || (form != WordForm::incremental && m_.modal.absolute);
      between[a] = absolute ? value : at[a] + value;
    }
    if (std::fabs(between[plane.normal] - at[plane.normal]) > tol::same_point ||
        std::fabs(to[plane.normal] - at[plane.normal]) > tol::same_point) {
      const auto is_arc = arc_in_space(between, to);
      if (!is_arc) return fail(is_arc.error());
      if (*is_arc) return {};
      return line_by_name();
    }
    const Vec2 a = Vec2{between[plane.first], between[plane.second]} - from, b = end - from;
    const double twice = 2 * cross(a, b);
    if (std::fabs(twice) <= tol::same_point) {
      const bool on_the_way = dot(a, b - a) >= 0;
      if (!on_the_way) return fail(alarm(AlarmId::arc_through_point, block_.where));
    } else {
      const double aa = dot(a, a), bb = dot(b, b);
      middle = {(b.y * aa - a.y * bb) / twice, (a.x * bb - b.x * aa) / twice};
      code = twice > 0 ? 3 : 2;
    }
  } else {
    if (!own_.memory.has_direction || own_.memory.direction_plane != plane) return fail(alarm(AlarmId::not_available, block_.where, "CT"));
    const Vec2 ahead = own_.memory.direction, chord = end - from;
    const double side = cross(ahead, chord);
    if (std::fabs(side) > tol::same_point * length(ahead)) {
      const Vec2 left{-ahead.y, ahead.x};
      middle = dot(chord, chord) / (2 * dot(left, chord)) * left;
      code = side > 0 ? 3 : 2;
    } else if (dot(ahead, chord) < 0) {
      return fail(alarm(AlarmId::arc_through_point, block_.where));
    }
  }
  if (code == 1) return line_by_name();
  NamedItem item;
  item.where = block_.words[0].where;
  KADR_TRY(add_code('G', code, item));
  item.form = WordForm::plain;
  for (const auto& [axis, value] : {std::pair{plane.first, middle.x}, std::pair{plane.second, middle.y}})
    KADR_TRY(add(m_.letters.center_letter[axis], value / m_.unit_scale(), item));
  own_.circle_by_name_ = true;
  return {};
}

/// CIP and CT whose points are on a line.
Status BlockRun::line_by_name() {
  NamedItem item;
  item.where = block_.words[0].where;
  own_.circle_by_name_ = true;
  return add_code('G', 1, item);
}

}  // namespace kadr::sinumerik
