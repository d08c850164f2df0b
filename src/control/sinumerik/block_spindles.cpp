// Executes words other than those of the path: further spindles, positioning axes, DIAMON, G58, G75 (spec/sinumerik 3.1, 5, 10 to 12). Used
// by control/sinumerik.

#include <cmath>

#include "control/sinumerik/block_run.h"

namespace kadr::sinumerik {

bool BlockRun::diameters(const std::string& name) {
  const bool on = name == "DIAMON" || name == "DIAM90";
  if (!on && name != "DIAMOF" && name != "DIAMCYCOF") return false;
  m_.modal.diameter = on ? AxisMask{1} : AxisMask{0};  // X is the axis of diameters
  own_.memory.radius_increments = name == "DIAM90";
  return true;
}

Status BlockRun::master_spindle(const NamedItem& item) {
  if (item.arguments.empty()) return {};
  const auto number = own_.number(m_, read_, item.arguments[0], item.where);
  if (!number) return fail(number.error());
  if (*number != 1) return fail(alarm(AlarmId::not_available, item.where, "SETMS"));
  return {};
}

Status BlockRun::spindle_word(const NamedItem& item, double value) {
  Modes& memory = own_.memory;
  const auto number = static_cast<std::size_t>(item.extension);
  const bool is_speed = item.name == "S";
  const bool known = number < memory.speeds.size() && (is_speed || value == 3 || value == 4 || value == 5);
  if (!known) return fail(alarm(AlarmId::not_available, item.where, std::string_view(item.name + std::to_string(item.extension) + "=")));
  if (is_speed && !(value >= 0)) return fail(alarm(AlarmId::value_out_of_range, item.where, 'S', value));
  if (is_speed) memory.speeds[number] = value;
  else memory.directions[number] = value == 3 ? SpindleDir::cw : value == 4 ? SpindleDir::ccw : SpindleDir::stop;
  spindles_ |= 1U << number;
  return {};
}

void BlockRun::start_spindles() {
  const Modes& memory = own_.memory;
  for (std::size_t n = 0; n < memory.speeds.size(); ++n) {
    if ((spindles_ >> n & 1U) == 0) continue;
    const SpindleDir direction = memory.directions[n];
    m_.emit(Spindle{direction, direction == SpindleDir::stop ? 0 : memory.speeds[n], static_cast<std::uint8_t>(n)});
  }
}

Status BlockRun::positioning(const NamedItem& item) {
  const bool one = item.arguments.size() == 1;
  const auto index = one ? own_.evaluate(m_, read_, item.arguments[0]) : Result<Value>(Value{});
  if (!index) return fail(index.error());
  const auto axis = index->type == Type::axis ? own_.axis_named(m_, index->text) : std::nullopt;
  if (!axis) return fail(alarm(AlarmId::not_available, item.where, std::string_view(item.name + "[ ]")));
  const auto value = own_.number(m_, read_, item.value, item.where);
  if (!value) return fail(value.error());
  if (item.name == "FA") {
    if (!(*value > 0) && !(item.name == "FRCM" && *value == 0)) return fail(alarm(AlarmId::value_out_of_range, item.where, "FA", *value));
    own_.memory.positioning_feed[*axis] = *value;
    return {};
  }
  const bool is_length = (m_.def.rotary >> *axis & 1U) == 0;
  const bool diameter = (m_.modal.diameter >> *axis & 1U) != 0;
  const double coordinate = *value * (is_length ? m_.unit_scale() : 1.0) * (diameter ? 0.5 : 1.0);
  const bool adds = item.form == WordForm::incremental || (item.form != WordForm::absolute && !m_.modal.absolute);
  positions_[*axis] = coordinate + (adds ? m_.position.programmed[*axis] : 0.0);
  positioned_ |= AxisMask{1} << *axis;
  return {};
}

/// INFERRED: each positioning axis moves before the path of its block, alone, at its feed of FA, or at rapid without one.
Status BlockRun::position_axes() {
  for (std::size_t a = 0; a < m_.axis_count; ++a) {
    if ((positioned_ >> a & 1U) == 0) continue;
    Axes to = m_.position.programmed;
    to[a] = positions_[a];
    const double own_feed = own_.memory.positioning_feed[a];
    const Modal kept = m_.modal;
    if (own_feed > 0) m_.modal.feed = own_feed, m_.modal.feed_mode = FeedMode::per_minute;
    const Status moved = m_.straight(own_feed > 0 ? MotionKind::feed : MotionKind::rapid, to, AxisMask{1} << a);
    m_.modal.feed = kept.feed;
    m_.modal.feed_mode = kept.feed_mode;
    KADR_TRY(moved);
  }
  return {};
}

Status BlockRun::shift_frame() {
  Frame frame = own_.memory.programmable;
  for (std::uint32_t i = 0; i < block_.word_count; ++i) {
    const Word& w = block_.words[i];
    if (!axis_of(w.address)) return fail(alarm(AlarmId::statement_not_alone, w.where));
    const auto axis = static_cast<std::size_t>(static_cast<unsigned char>(m_.letters.axis_of[static_cast<std::size_t>(w.address - 'A')]));
    const double unit = (m_.def.rotary >> axis & 1U) == 0 ? m_.unit_scale() : 1.0;
    (shift_ == 58 ? frame.shift : frame.fine)[axis] = w.value * unit;
  }
  return own_.set_programmable(m_, frame, block_.where);
}

/// INFERRED: fixed point n of the machine is the set-up's reference point n + 1, as the first one is that of G74.
Status BlockRun::to_fixed_point() {
  AxisMask named = 0;
  for (std::size_t a = 0; a < m_.axis_count; ++a)
    if (const char letter = m_.letters.axis_letter[a]; letter != 0 && block_.has(letter)) named |= AxisMask{1} << a;
  if (named == 0) return fail(alarm(AlarmId::no_axis_word, block_.where, "G75"));
  const double point = own_.words.has("FP") ? own_.words.number("FP") : 1;
  const std::size_t most = m_.tables.reference.size() - 2;
  if (!(point >= 1 && point <= static_cast<double>(most)) || point != std::round(point))
    return fail(alarm(AlarmId::value_out_of_range, own_.words.where("FP"), "FP", point));
  return m_.to_machine(MotionKind::rapid, m_.tables.reference[static_cast<std::size_t>(point) + 1], named, 0);
}

Status BlockRun::limits() {
  for (std::uint32_t i = 0; i < block_.word_count; ++i) {
    const Word& w = block_.words[i];
    if (axis_of(w.address)) {  // a limit of the working area
      const auto axis = static_cast<std::size_t>(static_cast<unsigned char>(m_.letters.axis_of[static_cast<std::size_t>(w.address - 'A')]));
      const double unit = (m_.def.rotary >> axis & 1U) == 0 ? m_.unit_scale() : 1.0;
      Modes& memory = own_.memory;
      (limits_ == 25 ? memory.area_least : memory.area_most)[axis] = w.value * unit;
      (limits_ == 25 ? memory.area_below : memory.area_above) |= AxisMask{1} << axis;
      continue;
    }
    if (w.address != 'S') return fail(alarm(AlarmId::statement_not_alone, w.where));
    if (!(w.value >= 0)) return fail(alarm(AlarmId::value_out_of_range, w.where, 'S', w.value));
    (limits_ == 25 ? own_.memory.speed_least : own_.memory.speed_most) = w.value;
  }
  if (m_.modal.surface_speed) m_.emit(m_.surface_speed());
  return {};
}

Status BlockRun::axis_by_variable(const NamedItem& item) {
  const bool one = item.arguments.size() == 1 && item.has_equals;
  const auto index = one ? own_.evaluate(m_, read_, item.arguments[0]) : Result<Value>(Value{});
  if (!index) return fail(index.error());
  const auto axis = index->type == Type::axis ? own_.axis_named(m_, index->text) : std::nullopt;
  if (!axis) return fail(alarm(AlarmId::operand_type, item.where, "AX[ ]"));
  const auto value = own_.number(m_, read_, item.value, item.where);
  if (!value) return fail(value.error());
  return add(m_.letters.axis_letter[*axis], *value, item);
}

/// Returns the unit of a feed word, mm.
double BlockRun::unit_of_feed() const {
  return m_.modal.feed_mode == FeedMode::inverse_time || own_.memory.feed_in_mm ? 1.0 : m_.unit_scale();
}

Status BlockRun::feed_word(const NamedItem& item) {
  const auto value = number_of(item);
  if (!value) return fail(value.error());
  if (!(*value > 0)) return fail(alarm(AlarmId::value_out_of_range, item.where, std::string_view(item.name), *value));
  Modes& memory = own_.memory;
  if (item.name == "OVR") {
    if (*value > 200) return fail(alarm(AlarmId::value_out_of_range, item.where, "OVR", *value));
    m_.modal.feed *= *value / memory.override_percent;
    memory.override_percent = *value;
  } else if (item.name == "FRC" || item.name == "FRCM") {
    (item.name == "FRC" ? own_.words.corner_feed : memory.corner_feed) = *value * unit_of_feed();
  } else if (item.name == "LIMS") {
    memory.surface_most = *value;
    if (m_.modal.surface_speed) m_.emit(m_.surface_speed());
  } else {  // FB: the modal feed comes back after the block
    own_.words.block_feed = m_.modal.feed;
    own_.words.block_feed_known = m_.modal.feed_known;
    m_.modal.feed = *value * unit_of_feed() * memory.override_percent / 100;
    m_.modal.feed_known = true;
  }
  return {};
}

Status BlockRun::normal_offset(const NamedItem& item) {
  const auto value = number_of(item);
  if (!value) return fail(value.error());
  own_.memory.normal_offset = *value * m_.unit_scale();
  if (own_.memory.normal_offset < 0 && own_.tool_radius(m_) + own_.memory.normal_offset < 0)
    return fail(alarm(AlarmId::value_out_of_range, item.where, "OFFN", *value));
  own_.set_normal_offset(m_);
  return {};
}

Status BlockRun::feed_group(const NamedItem& item) {
  for (const NamedExpression& each : item.arguments) {
    const auto value = own_.evaluate(m_, read_, each);
    if (!value) return fail(value.error());
    const auto axis = value->type == Type::axis ? own_.axis_named(m_, value->text) : std::nullopt;
    if (!axis || *axis > 2) return fail(alarm(AlarmId::not_available, item.where, "FGROUP"));
  }
  if (!item.arguments.empty() && item.arguments.size() != 3) return fail(alarm(AlarmId::not_available, item.where, "FGROUP"));
  return {};
}

}  // namespace kadr::sinumerik
