// Smooth approach and retraction: G147, G247, G347 on a line, a quadrant, a half circle to the contour, G148, G248, G348 from it
// (spec/sinumerik 13.3). The way to the contour is worked out here, in programmed coordinates; the last line ends under compensation, so
// that the contour begins on the normal of its first block. Used by control/sinumerik.

#include <cmath>

#include "base/tolerance.h"
#include "control/sinumerik/block_run.h"
#include "lang/block/block_reader.h"
#include "lang/named/named_parser.h"
#include "lang/named/named_reader.h"

namespace kadr::sinumerik {
namespace {

constexpr int most_looked_at = 6;  // blocks without motion in the plane that may follow (10740)

Vec2 left_of(Vec2 direction) { return {-direction.y, direction.x}; }

}  // namespace

/// Reads the words of a block that comes later. Returns nullopt if it is no block of motions.
std::optional<BlockRun::Ahead> BlockRun::words_ahead(Block& block) {
  if (block.statement.kind != StatementKind::named) {
    const Span where = block.where;
    block.statement = {};
    if (!read_named_line(block.text, where.begin, block)) return std::nullopt;
    block.where = where;
  }
  const auto read = read_named_block(block.text, block.statement.text);
  if (!read || read->kind != NamedKind::items) return std::nullopt;
  Ahead ahead;
  for (const NamedItem& item : read->items) {
    if (item.kind == NamedItem::Kind::name && (item.name == "MSG" || item.name == "STOPRE")) continue;
    if (item.kind != NamedItem::Kind::word) return std::nullopt;
    double value = item.number;
    if (item.has_equals) {
      const auto number = own_.number(m_, *read, item.value, item.where);
      if (!number) return std::nullopt;
      value = *number;
    }
    if (item.name == "G" && value <= 3) ahead.motion = static_cast<int>(value);
    else if (item.name == "G" && (value == 90 || value == 91)) ahead.absolute = value == 90;
    else ahead.words[item.name] = {value, item.form};
  }
  return ahead;
}

std::optional<BlockRun::Ahead> BlockRun::block_ahead() {
  const ProgramFile& file = m_.program().file(m_.program().reader());
  BlockReader reader(file.source(), file.grammar(), file.reader().encoding());
  reader.seek(m_.program().position());
  Block block;
  for (int i = 0; i < most_looked_at; ++i) {
    const auto got = reader.next(block);
    if (!got || *got == BlockReader::Got::end) return std::nullopt;
    auto ahead = words_ahead(block);
    if (!ahead || !ahead->words.empty()) return ahead;
  }
  return std::nullopt;
}

/// Returns the direction, of length 1 in programmed coordinates, in which the contour goes on at a point after the block.
Result<Vec2> BlockRun::direction_after(const Axes& from) {
  const PlaneAxes plane = m_.modal.axes;
  const double unit = m_.unit_scale();
  const Vec2 at{from[plane.first], from[plane.second]};
  const ProgramFile& file = m_.program().file(m_.program().reader());
  BlockReader reader(file.source(), file.grammar(), file.reader().encoding());
  reader.seek(m_.program().position());
  Block block;
  int motion = 1;
  bool absolute = m_.modal.absolute;
  for (int i = 0; i < most_looked_at; ++i) {
    const auto got = reader.next(block);
    if (!got || *got == BlockReader::Got::end) break;
    const auto ahead = words_ahead(block);
    if (!ahead) break;
    motion = ahead->motion.value_or(motion);
    absolute = ahead->absolute.value_or(absolute);
    const auto length_of = [&](char letter, double start, bool is_absolute) -> double {
      const auto word = ahead->words.find(std::string(1, letter));
      if (letter == 0 || word == ahead->words.end()) return start;
      const auto [value, form] = word->second;
      const bool whole = form == WordForm::absolute || (form == WordForm::plain && is_absolute);
      return value * unit + (whole ? 0 : start);
    };
    const Vec2 end{length_of(m_.letters.axis_letter[plane.first], at.x, absolute),
                   length_of(m_.letters.axis_letter[plane.second], at.y, absolute)};
    if (motion <= 1) {
      if (length(end - at) <= tol::same_point) continue;
      return 1 / length(end - at) * (end - at);
    }
    const Turn turn = motion == 2 ? Turn::cw : Turn::ccw;
    Vec2 middle{length_of(m_.letters.center_letter[plane.first], at.x, false),
                length_of(m_.letters.center_letter[plane.second], at.y, false)};
    if (const auto radius = ahead->words.find("CR"); radius != ahead->words.end()) {
      const auto arc = arc_by_radius(at, end, radius->second.first * unit, turn, 0.01);
      if (!arc) break;
      middle = arc->center;
    }
    const Vec2 arm = at - middle;
    if (length(arm) <= tol::same_point) break;
    return (turn == Turn::ccw ? 1 : -1) / length(arm) * left_of(arm);
  }
  return fail(alarm(AlarmId::not_available, block_.where, std::string_view("G" + std::to_string(approach_))));
}

/// Emits a straight motion of the approach. `feed`: mm/min; 0: rapid.
Status Sinumerik::approach_step(Emitter& m, const ApproachStep& step) {
  const PlaneAxes plane = m.modal.axes;
  Axes to = m.position.programmed;
  AxisMask named = 0;
  const auto set = [&](std::size_t axis, double value) {
    if (std::fabs(to[axis] - value) > tol::same_point) named |= AxisMask{1} << axis;
    to[axis] = value;
  };
  set(plane.first, step.to.x);
  set(plane.second, step.to.y);
  set(plane.normal, step.height);
  if (named == 0) return {};
  if (!(step.feed > 0)) return m.straight(MotionKind::rapid, to, named);
  const Modal before = m.modal;
  m.modal.feed = step.feed;
  m.modal.feed_mode = FeedMode::per_minute;
  Status moved;
  if (step.turns > 0) emit_arc(m, step.ccw ? Turn::ccw : Turn::cw, PlaneArc{step.centre, step.turns}, to, named);
  else moved = m.straight(MotionKind::feed, to, named);
  m.modal.feed = before.feed;
  m.modal.feed_mode = before.feed_mode;
  return moved;
}

/// Sets the word of an axis of the block, as an absolute position in programmed coordinates.
Status BlockRun::set_axis(std::size_t axis, double value) {
  const char letter = m_.letters.axis_letter[axis];
  const double written = value * ((m_.modal.diameter >> axis & 1U) != 0 ? 2 : 1) / m_.unit_scale();
  NamedItem item;
  item.where = block_.where;
  if (!block_.has(letter)) KADR_TRY(add(letter, written, item));
  block_.words[block_.at[static_cast<std::size_t>(letter - 'A')]].value = written;
  own_.words.forms[static_cast<std::size_t>(letter - 'A')] = WordForm::absolute;
  return {};
}

Status BlockRun::approach() {
  const PlaneAxes plane = m_.modal.axes;
  BlockWords& words = own_.words;
  const std::string code = "G" + std::to_string(approach_);
  const bool arrives = approach_ % 100 == 47;
  const auto has = [&](std::int32_t tenths) {
    for (std::uint32_t i = 0; i < block_.word_count; ++i)
      if (block_.words[i].address == 'G' && block_.words[i].code == tenths) return true;
    return false;
  };
  const bool fits = arrives ? (has(410) || has(420)) && m_.modal.radius_side == 0 : has(400) && m_.modal.radius_side != 0;
  const bool plain = m_.transform.corner_scale(plane) == 1 && !m_.transform.leaves(plane) && m_.modal.feed_mode == FeedMode::per_minute;
  if (!fits || !plain) return fail(alarm(AlarmId::not_available, block_.where, std::string_view(code)));
  if (!words.has("DISR")) return fail(alarm(AlarmId::word_missing, block_.where, "DISR", std::string_view(code)));
  Way way;
  way.rapid = m_.modal.motion == MotionMode::rapid;
  for (std::uint32_t i = 0; i < block_.word_count; ++i)
    if (block_.words[i].address == 'G' && block_.words[i].code <= 10) way.rapid = block_.words[i].code == 0;
  if (const Word* const f = block_.find('F'); f != nullptr) m_.modal.feed = f->value * m_.unit_scale(), m_.modal.feed_known = true;
  KADR_TRY(m_.feed_known(block_.where));
  const double unit = m_.unit_scale();
  way.reach = words.number("DISR") * unit;
  way.clearance = words.has("DISCL") ? words.number("DISCL") * unit : 0;
  way.down = words.has("FAD") ? words.number("FAD") * unit : m_.modal.feed;
  for (const char* const name : {"DISR", "DISCL", "FAD"})
    if (words.has(name) && !(words.number(name) >= 0))
      return fail(alarm(AlarmId::value_out_of_range, words.where(name), std::string_view(name), words.number(name)));
  if (!(way.reach > 0) || !(way.down > 0)) return fail(alarm(AlarmId::value_out_of_range, words.where("DISR"), "DISR", way.reach));
  words.motion_before = MotionBefore{m_.modal.motion, m_.modal.motion_row, m_.modal.rows};
  NamedItem line;
  line.where = block_.where;
  for (std::uint32_t i = 0; i < block_.word_count; ++i)  // the contour itself begins and ends on a line at feed
    if (block_.words[i].address == 'G' && block_.words[i].code <= 10)
      block_.words[i].value = 1, block_.words[i].code = 10, way.has_code = true;
  if (!way.has_code) KADR_TRY(add_code('G', 1, line));
  return arrives ? arrive(way, has(410)) : retract(way);
}

Status BlockRun::arrive(const Way& way, bool left) {
  const PlaneAxes plane = m_.modal.axes;
  Axes to;
  AxisMask named = 0;
  KADR_TRY(m_.target(to, named));
  const auto ahead = direction_after(to);
  if (!ahead) return fail(ahead.error());
  const double side = left ? 1 : -1, radius = m_.radius_in_force();
  const Vec2 point{to[plane.first], to[plane.second]}, normal = side * left_of(*ahead), centre4 = point + radius * normal;
  const Vec2 centre = centre4 + way.reach * normal;
  const int kind = approach_ / 100;
  const Vec2 begin = kind == 1   ? centre4 - (radius + way.reach) * *ahead
                     : kind == 2 ? centre - way.reach * *ahead
                                 : centre + way.reach * normal;
  const double start = m_.position.programmed[plane.normal], bottom = to[plane.normal];
  const double up = start < bottom ? -1 : 1;
  const double high = std::fabs(start - bottom) > way.clearance ? bottom + up * way.clearance : start;
  const double quick = way.rapid ? 0 : m_.modal.feed;
  KADR_TRY(own_.approach_step(m_, {begin, start, quick}));
  KADR_TRY(own_.approach_step(m_, {begin, high, quick}));
  if (own_.memory.approach_in_plane) KADR_TRY(own_.approach_step(m_, {begin, bottom, way.down}));
  if (kind > 1) KADR_TRY(own_.approach_step(m_, {centre4, bottom, m_.modal.feed, centre, kind == 2 ? 0.25 : 0.5, left}));
  // Words of the block were increments from its start, so the end point is written as a position.
  KADR_TRY(set_axis(plane.first, point.x));
  KADR_TRY(set_axis(plane.second, point.y));
  return set_axis(plane.normal, bottom);
}

/// The end is as written; with the infeed axis only, it is above the end of the arc or line, and without any word at the clearance.
Status BlockRun::retract(const Way& way) {
  const PlaneAxes plane = m_.modal.axes;
  if (!own_.memory.has_direction || own_.memory.direction_plane != plane)
    return fail(alarm(AlarmId::not_available, block_.where, std::string_view("G" + std::to_string(approach_))));
  Axes to;
  AxisMask named = 0;
  KADR_TRY(m_.target(to, named));
  const Axes& now = m_.position.programmed;
  const Vec2 ahead = 1 / length(own_.memory.direction) * own_.memory.direction;
  const bool left = m_.modal.radius_side < 0;
  const double radius = m_.radius_in_force();
  const Vec2 point{now[plane.first], now[plane.second]}, normal = (left ? 1.0 : -1.0) * left_of(ahead), centre4 = point + radius * normal;
  const Vec2 centre = centre4 + way.reach * normal;
  const int kind = approach_ / 100;
  const Vec2 end = kind == 1   ? centre4 + (radius + way.reach) * ahead
                   : kind == 2 ? centre + way.reach * ahead
                               : centre + way.reach * normal;
  const bool rises = (named >> plane.normal & 1U) != 0;
  const double bottom = now[plane.normal], top = rises ? to[plane.normal] : bottom + way.clearance;
  const double up = top < bottom ? -1 : 1;
  const double high = std::fabs(top - bottom) > way.clearance ? bottom + up * way.clearance : top;
  const double quick = way.rapid ? 0 : m_.modal.feed;
  const bool in_plane = own_.memory.approach_in_plane;
  const bool moves_in_plane = (named & (AxisMask{1} << plane.first | AxisMask{1} << plane.second)) != 0;
  auto& steps = own_.words.retraction;
  if (kind > 1) steps.push_back({end, in_plane ? bottom : high, m_.modal.feed, centre, kind == 2 ? 0.25 : 0.5, left});
  steps.push_back({end, high, way.down});
  steps.push_back({end, top, quick});
  if (moves_in_plane) steps.push_back({{to[plane.first], to[plane.second]}, top, quick});
  const Vec2 first = kind == 1 ? end : centre4;
  KADR_TRY(set_axis(plane.first, first.x));
  KADR_TRY(set_axis(plane.second, first.y));
  return set_axis(plane.normal, kind == 1 && !in_plane ? high : bottom);
}

}  // namespace kadr::sinumerik
