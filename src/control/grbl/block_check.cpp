// Reads and checks the words of a block, as steps 2 and 3 of gc_execute_line in gcode.c of Grbl 1.1 do.

#include "control/grbl/block_check.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "base/code_literals.h"
#include "base/units.h"
#include "control/block_context.h"
#include "control/grbl/arc_readings.h"
#include "control/grbl/grbl.h"

namespace kadr::grbl {
namespace {

constexpr double most_tool = 255;
constexpr std::int32_t max_systems = 6;
constexpr std::int32_t no_motion = 80_g;  // G80

constexpr std::uint64_t bits(std::string_view letters) {
  std::uint64_t all = 0;
  for (const char letter : letters) all |= letter_bit(letter);
  return all;
}

/// A code number in the form in which gcode.c stores it: int_value and mantissa. The whole part has one byte. What exceeds one byte counts
/// as a fraction, so that G257 gives error:23.
struct CodeNumber {
  std::int32_t whole = 0;
  std::int32_t hundredths = 0;  // fraction of the code number in hundredths, 0 to 65535; for G38.2 it is 20
};
CodeNumber code_number(double value) {
  const double near = std::clamp(value, -1e6, 1e6);
  const std::int32_t whole = byte_of(near);
  return {whole, static_cast<std::uint16_t>(std::lround(100 * (near - whole)))};
}

class BlockCheck {
 public:
  BlockCheck(const BlockContext& m, const Grbl& control, bool is_jog, std::optional<Alarm>& parted)
      : m_(m), control_(control), block_(*m.block), is_jog_(is_jog), parted_(parted) {
    const Modal& modal = m.modal;
    if (is_jog) all_.motion = 1_g;
    else if (modal.motion_row >= 0) all_.motion = m.def.codes[static_cast<std::size_t>(modal.motion_row)].tenth;
    else all_.motion = no_motion;
    all_.inch = modal.inch;
    all_.absolute = modal.absolute;
    all_.inverse_time = !is_jog && modal.feed_mode == FeedMode::inverse_time;
    all_.plane = modal.plane == Plane::xy ? 17_g : modal.plane == Plane::zx ? 18_g : 19_g;
  }

  Result<CheckedBlock> run() {
    for (std::uint32_t i = 0; i < block_.word_count; ++i) KADR_TRY(word(block_.words[i]));
    if (block_.broken) return fail(*block_.broken);
    all_.has_axis = (block_.letters & bits("XYZ")) != 0;
    if (all_.has_axis && all_.axis_command == AxisCommand::none) all_.axis_command = AxisCommand::motion;
    if (m_.has('N')) return fail(alarm(AlarmId::block_number_large, m_.where('N'), value('N')));
    take_start();
    KADR_TRY(feed());
    KADR_TRY(dwell());
    KADR_TRY(length());
    KADR_TRY(non_modal());
    KADR_TRY(motion());
    KADR_TRY(words_used());
    if (is_jog_) KADR_TRY(jog_codes());
    KADR_TRY(within_travel(m_, control_, all_, is_jog_));
    return all_;
  }

 private:
  // ---- first group of checks: single words, in the order in which the block has them (spec/grbl 1.3, 3)

  Status word(const Word& w) {
    if (w.address == 'G') return g_code(w);
    if (w.address == 'M') return m_code(w);
    if (w.address == 'T' && w.value > most_tool) return fail(alarm(AlarmId::tool_number_large, w.where, w.value));
    const bool twice = (values_ & letter_bit(w.address)) != 0 || (w.address == 'N' && block_.has_number);
    if (twice) return fail(alarm(AlarmId::address_twice, w.where, w.address));
    values_ |= letter_bit(w.address);
    const bool unsigned_word = (letter_bit(w.address) & bits("FNPST")) != 0;
    if (unsigned_word && w.value < 0) return fail(alarm(AlarmId::value_below_zero, w.where, w.address, w.value));
    return {};
  }

  tl::unexpected<Alarm> unknown(const Word& w) const { return fail(alarm(AlarmId::code_unknown, w.where, block_.text_of(w.where))); }
  tl::unexpected<Alarm> two_commands(const Word& w) const {
    return fail(alarm(AlarmId::not_together, w.where, axis_code_, block_.text_of(w.where)));
  }

  /// Records that a code uses the axis words. G10, G28 and similar codes conflict with motion codes, because both need axis words; G28.1
  /// does not need axis words.
  Status takes_axes(const Word& w, AxisCommand command) {
    if (all_.axis_command != AxisCommand::none) return two_commands(w);
    all_.axis_command = command;
    axis_code_ = std::string(block_.text_of(w.where));
    return {};
  }

  Status g_code(const Word& w) {
    const auto [whole, hundredths] = code_number(w.value);
    bool may_have_fraction = false;
    switch (whole) {
      case 10:
      case 28:
      case 30:
      case 92:
        if (hundredths == 0) KADR_TRY(takes_axes(w, AxisCommand::offsets));
        may_have_fraction = whole != 10;
        if (may_have_fraction && hundredths != 0 && hundredths != 10) return unknown(w);
        all_.non_modal = whole * 10 + (may_have_fraction ? hundredths / 10 : 0);
        break;
      case 4:
      case 53: all_.non_modal = whole * 10; break;
      case 0:
      case 1:
      case 2:
      case 3:
      case 38:
        KADR_TRY(takes_axes(w, AxisCommand::motion));
        may_have_fraction = whole == 38;
        if (may_have_fraction && (hundredths % 10 != 0 || hundredths < 20 || hundredths > 50)) return unknown(w);
        all_.motion = whole * 10 + (may_have_fraction ? hundredths / 10 : 0);
        break;
      case 80: all_.motion = no_motion; break;
      case 17:
      case 18:
      case 19: all_.plane = whole * 10; break;
      case 90:
      case 91:
        may_have_fraction = hundredths != 0;
        if (may_have_fraction && (hundredths != 10 || whole == 90)) return unknown(w);
        if (!may_have_fraction) all_.absolute = whole == 90;
        break;
      case 93:
      case 94:
        leaves_inverse_ = all_.inverse_time && whole == 94;
        all_.inverse_time = whole == 93;
        break;
      case 20:
      case 21: all_.inch = whole == 20; break;
      case 40: break;
      case 43:
      case 49:
        KADR_TRY(takes_axes(w, AxisCommand::length));
        may_have_fraction = whole == 43;
        if (may_have_fraction && hundredths != 10) return unknown(w);
        length_by_word_ = whole == 43;
        break;
      case 54:
      case 55:
      case 56:
      case 57:
      case 58:
      case 59: all_.system = whole * 10; break;
      case 61:
        if (hundredths != 0) return unknown(w);
        break;
      default: return unknown(w);
    }
    if (hundredths != 0 && !may_have_fraction) return fail(alarm(AlarmId::word_not_integer, w.where, 'G', w.value));
    return one_of_group(w);
  }

  /// Checks an M code. M7 is an alarm, because it needs a special build of Grbl; M6 is an alarm, because Grbl has no M6 (spec/grbl 3).
  Status m_code(const Word& w) {
    if (code_number(w.value).hundredths != 0) return fail(alarm(AlarmId::word_not_integer, w.where, 'M', w.value));
    return one_of_group(w);
  }

  Status one_of_group(const Word& w) {
    const std::int32_t row = w.code < 0 ? -1 : m_.def.row_of(w.address, w.code);
    if (row < 0) return unknown(w);
    const std::uint64_t bit = std::uint64_t{1} << m_.def.codes[static_cast<std::size_t>(row)].group;
    if ((groups_ & bit) != 0) {
      const std::string other = code_of_group(w);
      return fail(alarm(AlarmId::group_conflict, w.where, other, block_.text_of(w.where)));
    }
    groups_ |= bit;
    if (!is_jog_) return {};
    const std::string& group = m_.def.groups[m_.def.codes[static_cast<std::size_t>(row)].group].name;
    const bool allowed = group == "3" || group == "6" || (group == "0" && all_.non_modal == 53_g);
    if (!allowed && jog_fault_ == nullptr) jog_fault_ = &w;
    return {};
  }

  /// Returns the code that is before the word in the block and belongs to the same modal group.
  std::string code_of_group(const Word& w) const {
    const auto group = [&](const Word& of) {
      const std::int32_t row = of.code < 0 ? -1 : m_.def.row_of(of.address, of.code);
      return row < 0 ? 0 : int{m_.def.codes[static_cast<std::size_t>(row)].group};
    };
    for (const Word& before : block_.words)
      if (&before == &w || group(before) == group(w)) return std::string(block_.text_of(before.where));
    return {};
  }

  // ---- second group of checks: the block as a whole (spec/grbl 4)

  bool has(std::string_view letters) const { return (values_ & bits(letters)) != 0; }
  void use(std::string_view letters) { values_ &= ~bits(letters); }
  double value(char letter) const { return m_.has(letter) ? m_.word(letter)->value : 0; }
  double unit() const { return all_.inch ? mm_per_inch : 1; }
  /// Returns the value of a word in mm, as a 32-bit number as in Grbl.
  float single_value(char letter) const {
    constexpr auto mm = static_cast<float>(mm_per_inch);
    if (!m_.has(letter)) return 0;
    const float v = single_of(block_, *m_.word(letter));
    return all_.inch ? v * mm : v;
  }
  bool is_arc() const { return all_.motion == 2_g || all_.motion == 3_g; }
  bool is_probe() const { return all_.motion > 38_g && all_.motion < 39_g; }
  tl::unexpected<Alarm> no_feed() const { return fail(alarm(AlarmId::feed_missing, block_.where)); }

  /// Determines the feed. In G93 each block with a motion needs a word F, and so does the first block with a motion after the return to G94
  /// (spec/grbl 4.2).
  Status feed() {
    if (is_jog_) {
      if (!has("F")) return no_feed();
      feed_ = value('F');
      return {};
    }
    const bool own_time = all_.inverse_time && all_.axis_command == AxisCommand::motion && all_.motion != 0_g && all_.motion != no_motion;
    if (own_time && !has("F")) return no_feed();
    const bool feed_in_force = !all_.inverse_time && !leaves_inverse_ && m_.modal.feed_mode == FeedMode::per_minute && m_.modal.feed_known;
    feed_ = has("F") ? value('F') : feed_in_force ? m_.modal.feed : 0;
    return {};
  }

  /// Sets the start position of the motion, in coordinates of the work system that the block selects.
  void take_start() {
    all_.start = m_.position.programmed;
    const std::size_t system = work_system();
    if (system == m_.modal.work_zero) return;
    for (std::size_t a = 0; a < axes; ++a) all_.start[a] += m_.tables.zeros[m_.modal.work_zero][a] - m_.tables.zeros[system][a];
  }

  std::size_t work_system() const {
    return all_.system < 0 ? std::size_t{m_.modal.work_zero} : static_cast<std::size_t>((all_.system - 530) / 10);
  }

  Status dwell() {
    if (all_.non_modal != 40) return {};
    if (!has("P")) return fail(alarm(AlarmId::word_missing, block_.where, 'P', "G4"));
    use("P");
    return {};
  }

  Status length() const {
    if (!length_by_word_ || (block_.letters & bits("XYZ")) == bits("Z")) return {};
    return fail(alarm(AlarmId::length_axis_wrong, block_.where));
  }

  Status non_modal() {
    if (all_.non_modal == 100) return offsets();
    if (all_.non_modal == 920 && !all_.has_axis) return fail(alarm(AlarmId::no_axis_word, block_.where, "G92"));
    if (all_.non_modal == 53_g && all_.motion != 0_g && all_.motion != 1_g) return fail(alarm(AlarmId::machine_motion_mode, block_.where));
    if (all_.axis_command != AxisCommand::length) targets();
    return {};
  }

  /// Checks G10 (spec/grbl 4.13).
  Status offsets() {
    if (!all_.has_axis) return fail(alarm(AlarmId::no_axis_word, block_.where, "G10"));
    if (!has("LP")) return fail(alarm(AlarmId::word_missing, block_.where, 'L', "G10"));
    if (byte_of(value('P')) > max_systems) return fail(alarm(AlarmId::system_number_large, m_.where('P'), value('P')));
    const std::int32_t kind = byte_of(value('L'));
    if (kind != 20 && kind != 2) return fail(alarm(AlarmId::illegal_address, m_.where('L'), 'L'));
    if (kind == 2 && has("R")) return fail(alarm(AlarmId::illegal_address, m_.where('R'), 'R'));
    use("LP");
    return {};
  }

  void targets() {
    const bool by_machine = all_.non_modal == 53_g;
    const Float32State& float32_state = control_.state.float32_state;
    all_.target = by_machine ? m_.position.machine : all_.start;
    all_.single_target = float32_state.position.single;
    for (std::size_t a = 0; a < axes; ++a) {
      const char letter = m_.letters.axis_letter[a];
      if (!m_.has(letter)) continue;
      const double v = value(letter) * unit();
      all_.target[a] = all_.absolute || by_machine ? v : all_.target[a] + v;
      const float single = single_value(letter);
      all_.single_target[a] = by_machine ? single : float32_state.target(a, single, work_system(), all_.absolute);
    }
  }

  Status motion() {
    if (all_.motion == no_motion) {
      if (all_.has_axis) return fail(alarm(AlarmId::no_motion_mode, first_axis(), block_.text_of(first_axis()).substr(0, 1)));
      return {};
    }
    if (all_.axis_command != AxisCommand::motion) return {};
    all_.moves = all_.has_axis;
    if (all_.motion == 0_g) return {};
    if (feed_ == 0) return no_feed();
    if (is_arc()) return arc();
    if (!is_probe()) return {};
    if (!all_.has_axis) return fail(alarm(AlarmId::no_axis_word, block_.where, "G38"));
    if (all_.target == all_.start) return fail(alarm(AlarmId::probe_too_close, block_.where, 0.0, 0.0));
    return {};
  }

  Span first_axis() const {
    for (std::uint32_t i = 0; i < block_.word_count; ++i)
      if ((letter_bit(block_.words[i].address) & bits("XYZ")) != 0) return block_.words[i].where;
    return block_.where;
  }

  // ---- arcs (5)

  Status arc() {
    const PlaneAxes plane = axes_of(all_.plane == 17_g ? Plane::xy : all_.plane == 18_g ? Plane::zx : Plane::yz);
    const auto letter = [&](std::size_t axis) { return letter_bit(m_.letters.axis_letter[axis]); };
    const auto center_letter = [&](std::size_t axis) { return m_.letters.center_letter[axis]; };
    if (!all_.has_axis) return fail(alarm(AlarmId::no_axis_word, block_.where, "G2, G3"));
    if ((block_.letters & (letter(plane.first) | letter(plane.second))) == 0)
      return fail(alarm(AlarmId::arc_without_plane_word, block_.where));
    ArcWords words;
    words.from = {all_.start[plane.first], all_.start[plane.second]};
    words.to = {all_.target[plane.first], all_.target[plane.second]};
    const Float32Triple& standing = control_.state.float32_state.position.single;
    words.single_from = {standing[plane.first], standing[plane.second]};
    words.single_to = {all_.single_target[plane.first], all_.single_target[plane.second]};
    words.same_point = all_.target == all_.start;
    words.single_same_point = all_.single_target == standing;
    words.turn = all_.motion == 2_g ? Turn::cw : Turn::ccw;
    words.tolerance = static_cast<float>(control_.state.settings.arc_tolerance);
    words.where = block_.where;
    words.by_radius = has("R");
    if (words.by_radius) {
      use("R");
      words.radius = value('R') * unit();
      words.single_radius = single_value('R');
      words.radius_where = m_.where('R');
      return found(read_arc(words));
    }
    const char first = center_letter(plane.first), second = center_letter(plane.second);
    if (!m_.has(first) && !m_.has(second)) return fail(alarm(AlarmId::center_missing, block_.where, first, second));
    use("IJK");
    words.offset = {value(first) * unit(), value(second) * unit()};
    words.single_offset = {single_value(first), single_value(second)};
    return found(read_arc(words));
  }

  Status found(const ArcReading& reading) {
    parted_ = reading.parted;
    if (reading.refused) return fail(*reading.refused);
    all_.arc = reading.arc;
    all_.segments = reading.segments;
    return {};
  }

  // ---- last group of checks: words and codes that the block must not have

  /// Refuses words that no code of the block uses (spec/grbl 4.10). A code that uses axis words uses all axis words of the block.
  Status words_used() {
    use(is_jog_ ? "FN" : "FNST");
    if (all_.axis_command != AxisCommand::none) use("XYZ");
    for (std::uint32_t i = 0; i < block_.word_count; ++i)
      if (const Word& w = block_.words[i]; (values_ & letter_bit(w.address)) != 0)
        return fail(alarm(AlarmId::word_unused, w.where, w.address));
    return {};
  }

  /// Refuses codes that are not allowed in a jog: only G20 G21 G90 G91 G53 are allowed (spec/grbl 9).
  Status jog_codes() const {
    if (jog_fault_ != nullptr) return fail(alarm(AlarmId::jog_code, jog_fault_->where, block_.text_of(jog_fault_->where)));
    return {};
  }

  const BlockContext& m_;
  const Grbl& control_;
  const Block& block_;
  const bool is_jog_;
  std::optional<Alarm>& parted_;
  CheckedBlock all_;
  std::string axis_code_;  // text of the code that uses the axis words of the block
  std::uint64_t groups_ = 0;
  std::uint64_t values_ = 0;  // letters of the words that no code has used yet, one bit per letter
  double feed_ = 0;
  bool leaves_inverse_ = false, length_by_word_ = false;
  const Word* jog_fault_ = nullptr;
};

}  // namespace

Result<CheckedBlock> check(const BlockContext& m, const Grbl& control, bool is_jog, std::optional<Alarm>& parted) {
  return BlockCheck(m, control, is_jog, parted).run();
}

}  // namespace kadr::grbl
