// Reads and checks the codes of a block by their modal groups (spec/linuxcnc 2.3, 2.5, 2.7; read_g, read_m, enhance_block of the source),
// and the words of the block (2.8: check_g_codes, check_m_codes, check_other_codes).

#include "control/linuxcnc/block_codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>

#include "base/code_literals.h"
#include "control/block_context.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {
namespace {

bool is_one_of(std::int32_t code, std::initializer_list<std::int32_t> all) { return std::find(all.begin(), all.end(), code) != all.end(); }

class Checker {
 public:
  Checker(BlockContext& m, const LinuxCnc& control) : m_(m), control_(control) {
    codes_.g.fill(-1);
    codes_.m.fill(-1);
    polar_radius_ = sign('@');
    polar_angle_ = sign('^');
    spindle_ = sign('$');
  }

  Result<BlockCodes> run() {
    KADR_TRY(read());
    codes_.has_axis = m_.has_axis_words();
    codes_.has_polar = has(polar_radius_) || has(polar_angle_);
    KADR_TRY(polar());
    KADR_TRY(motion());
    KADR_TRY(group_0());
    KADR_TRY(too_many());
    KADR_TRY(other_planes());
    KADR_TRY(words());
    return codes_;
  }

 private:
  // ---- reading

  Status read() {
    for (std::uint32_t i = 0; i < m_.block->word_count; ++i) {
      const Word& w = m_.block->words[i];
      KADR_TRY(axis_there(w));
      if (w.address == 'G') KADR_TRY(g_code(w));
      else if (w.address == 'M') KADR_TRY(m_code(w));
      else KADR_TRY(value(w));
    }
    return {};
  }

  tl::unexpected<Alarm> wrong(AlarmId id, Span where, std::string text) const { return control_.fault(id, where, std::move(text)); }

  Status g_code(const Word& w) {
    const double tenths = w.value * 10, nearest = std::round(tenths);
    if (nearest < 0) return wrong(AlarmId::rs274_codes, w.where, "Negative g code used");
    if (std::fabs(tenths - nearest) > 0.001 || nearest > 999) return wrong(AlarmId::rs274_codes, w.where, "G-code out of range");
    const std::int32_t code = static_cast<std::int32_t>(nearest);
    const std::int32_t row = m_.def.row_of('G', code);
    if (row < 0) return wrong(AlarmId::rs274_codes, w.where, "Unknown g code used");
    std::int32_t& of_group = codes_.g[control_.groups.number(m_.def.codes[static_cast<std::size_t>(row)].group)];
    if (code == 80_g && of_group >= 0) return {};
    if (of_group >= 0 && of_group != 80_g) return wrong(AlarmId::rs274_codes, w.where, "Two g codes used from same modal group");
    of_group = code;
    return {};
  }

  /// Refuses the letter of an axis that the machine lacks (spec/linuxcnc 1.1), such as U, V or W if neither the set-up nor the ini file
  /// names these axes. Blocks of a turning profile may have A, C, U and W; their U and W are increments (interp_g7x: switch_settings).
  Status axis_there(const Word& w) const {
    const std::size_t axis = axis_letters.find(w.address);
    if (axis == std::string_view::npos || (control_.axes >> axis & 1U) != 0) return {};
    constexpr std::string_view of_profiles = "ACUW";
    if (control_.turning && of_profiles.find(w.address) != std::string_view::npos) return {};
    return wrong(AlarmId::rs274_form, w.where, fmt::format("Bad character '{}' used", static_cast<char>(w.address | 0x20)));
  }

  Status m_code(const Word& w) {
    const double nearest = std::round(w.value);
    if (std::fabs(w.value - nearest) > whole_within) return wrong(AlarmId::rs274_words, w.where, "Non integer value for integer");
    if (nearest < 0) return wrong(AlarmId::rs274_codes, w.where, "Negative m code used");
    const auto code = static_cast<std::int32_t>(nearest);
    if (code > 199) return wrong(AlarmId::rs274_codes, w.where, fmt::format("M-code greater than 199: M{}", code));
    const std::int32_t row = m_.def.row_of('M', code * 10);
    if (row < 0) return wrong(AlarmId::rs274_codes, w.where, fmt::format("Unknown m code used: M{}", code));
    ++m_count_;
    const CodeRow& of = m_.def.codes[static_cast<std::size_t>(row)];
    if (code >= 100) codes_.m[10] = code;
    if (of.group == 0) return {};
    std::int32_t& of_group = codes_.m[control_.groups.number(of.group)];
    if (of_group >= 0) return wrong(AlarmId::rs274_codes, w.where, "Two m codes used from same modal group");
    of_group = code;
    return {};
  }

  /// Checks the value of a word by the rules that LinuxCNC applies directly after reading the word (spec/linuxcnc 2.3).
  Status value(const Word& w) const {
    const auto negative = [&](const char* text) -> Status {
      return w.value < 0 ? Status(wrong(AlarmId::rs274_words, w.where, text)) : Status();
    };
    switch (w.address) {
      case 'F': return negative("Negative f word used");
      case 'S': return negative("Negative spindle speed used");
      case 'T': KADR_TRY(whole(w)); return negative("Negative tool id (tool not found)");
      case 'L': KADR_TRY(whole(w)); return negative("Negative l word used");
      case 'H': KADR_TRY(whole(w)); return w.value < -1 ? Status(wrong(AlarmId::rs274_words, w.where, "Negative h word used")) : Status();
      default: return {};
    }
  }

  Status whole(const Word& w) const {
    if (std::fabs(w.value - std::round(w.value)) <= whole_within) return {};
    return wrong(AlarmId::rs274_words, w.where, "Non integer value for integer");
  }

  /// Checks the polar words @ and ^. The plane that was in force before the block is used.
  Status polar() const {
    if (!codes_.has_polar) return {};
    const auto no = [&](const char* text) { return wrong(AlarmId::rs274_motion, m_.block->where, text); };
    if (m_.modal.plane != Plane::xy || is_plane_of_uvw(m_)) return no("Cannot use polar coordinate except in G17 plane");
    if (m_.has('X')) return no("Cannot specify both polar coordinate and X word");
    if (m_.has('Y')) return no("Cannot specify both polar coordinate and Y word");
    return {};
  }

  // ---- decides which code of the block commands the motion (spec/linuxcnc 2.7)

  Status motion() {
    const bool axes = codes_.has_axis || codes_.has_polar;
    const std::int32_t zero = codes_.g[0];
    const bool takes = is_one_of(zero, {10_g, 28_g, 30_g, 52_g, 92_g});
    const bool needs = zero == 52_g || zero == 92_g;
    const Span at = m_.block->where;
    if (codes_.g1() >= 0) {
      codes_.motion = codes_.g1();
      if (codes_.g1() == 80_g) {
        if (axes && !takes) return wrong(AlarmId::rs274_motion, at, "Cannot use axis values with g80");
        if (!axes && needs) return wrong(AlarmId::rs274_motion, at, "All axes missing with g52 or g92");
      } else if (takes) {
        return wrong(AlarmId::rs274_motion, at, "Cannot use two g codes that both use axis values");
      } else if (!axes && !is_one_of(codes_.g1(), {0_g, 1_g, 2_g, 3_g, 5.2_g, 5.3_g, 70_g, 71_g, 71.1_g, 71.2_g, 72_g, 72.1_g, 72.2_g})) {
        return wrong(AlarmId::rs274_motion, at, "All axes missing with motion code");
      }
      return {};
    }
    if (takes) {
      if (!axes && needs) return wrong(AlarmId::rs274_motion, at, "All axes missing with g52 or g92");
      if (codes_.has_polar) return wrong(AlarmId::rs274_motion, at, "Polar coordinates can only be used for motion");
      codes_.axes_for_group0 = true;
      return {};
    }
    const bool lengths = codes_.g[8] == 43.1_g || codes_.g[8] == 43.2_g;
    const std::int32_t in_force = control_.state.motion;
    if (axes) {
      if (in_force == 80_g || in_force < 0) {
        if (lengths) return {};
        return wrong(AlarmId::rs274_motion, at, "Cannot use axis values without a g code that uses them");
      }
      if (codes_.g[8] != 43.1_g) codes_.motion = in_force;  // the words of G43.1 are tool lengths, so no axis moves
    } else if ((in_force == 2_g || in_force == 3_g) && (m_.has('I') || m_.has('J') || m_.has('K'))) {
      codes_.motion = in_force;
    }
    return {};
  }

  // ---- group 0 (check_g_codes)

  Status group_0() const {
    const std::int32_t zero = codes_.g[0];
    const Span at = m_.block->where;
    if (zero == 4_g) {
      if (codes_.g1() == 2_g || codes_.g1() == 3_g)
        return wrong(AlarmId::rs274_motion, at, "G4 not allowed with G2 or G3 because they both use P");
      if (!(m_.has('P') && m_.word('P')->value != -1)) return wrong(AlarmId::rs274_words, at, "Dwell time missing with g4");
    }
    if (zero == 10_g) KADR_TRY(data());
    if (zero == 53_g) {
      if (codes_.motion != 0_g && codes_.motion != 1_g) return wrong(AlarmId::rs274_motion, at, "Must use g0 or g1 with g53");
      const bool incremental = codes_.g[3] == 91_g || (codes_.g[3] != 90_g && !m_.modal.absolute);
      if (incremental) return wrong(AlarmId::rs274_motion, at, "Cannot use g53 incremental");
    }
    return {};
  }

  /// Checks the words of G10 (spec/linuxcnc 7.8).
  Status data() const {
    const Span at = m_.block->where;
    const int l = m_.has('L') ? static_cast<int>(std::round(m_.word('L')->value)) : -1;
    if (!is_one_of(l, {0, 1, 2, 10, 11, 20}))
      return wrong(AlarmId::rs274_data, at, "Line with G10 does not have L0, L1, L10, L11, L2, or L20");
    if (l == 0) return {};
    const double p = m_.has('P') ? m_.word('P')->value : -1;
    const bool broken = p + 0.0001 - std::round(p) > 0.0002;  // as in LinuxCNC's source, P1.5 to P1.99 are accepted as P2
    if (l == 2 || l == 20) {
      if (broken) return wrong(AlarmId::rs274_data, at, "P value not an integer with G10");
      if (std::round(p) < 0 || std::round(p) > 9)
        return wrong(AlarmId::rs274_data, at, fmt::format("P value out of range (0-9) with G10 L{}", l));
      if (m_.has('I') || m_.has('J')) return wrong(AlarmId::rs274_data, at, "I J words not allowed with G10 L2");
      if (l == 20 && m_.has('R')) return wrong(AlarmId::rs274_data, at, "R not allowed in G10 L20");
      return {};
    }
    if (m_.has('P') && broken) return wrong(AlarmId::rs274_data, at, "P value not an integer with G10");
    if (std::round(p) < 1) return wrong(AlarmId::rs274_data, at, fmt::format("P value out of range with G10 L{}", l));
    bool any = codes_.has_axis;
    for (const char letter : {'R', 'I', 'J', 'Q'}) any = any || m_.has(letter);
    if (!any) return wrong(AlarmId::rs274_data, at, fmt::format("G10 L{} without offsets has no effect", l));
    if (m_.has('Q') && std::fabs(m_.word('Q')->value - std::round(m_.word('Q')->value)) > whole_within)
      return wrong(AlarmId::rs274_data, at, "Q number in G10 is not an integer");
    if (m_.has('Q') && (m_.word('Q')->value < 0 || m_.word('Q')->value > 9))
      return wrong(AlarmId::rs274_data, at, "Invalid tool orientation");
    return {};
  }

  Status other_planes() const {
    const bool arc = codes_.motion == 2_g || codes_.motion == 3_g;
    const std::int32_t plane = codes_.g[2] >= 0 ? codes_.g[2] : control_.code_in_force(m_, 2);
    if (!arc || !is_one_of(plane, {17.1_g, 18.1_g, 19.1_g})) return {};
    return wrong(AlarmId::rs274_arc, m_.block->where, "Cannot do an arc in planes G17.1, G18.1, or G19.1");
  }

  Status too_many() const {
    if (m_count_ > 4) return wrong(AlarmId::rs274_codes, m_.block->where, "Too many m codes on line");
    return {};
  }

  // ---- words that no code uses (check_other_codes)

  Status words() const;
  Status letters_of_cycles() const;
  Status word_p() const;
  Status words_of_orient() const;
  Status required() const;

  bool has(char address) const { return address != 0 && m_.has(address); }
  bool moves(std::initializer_list<std::int32_t> all) const { return is_one_of(codes_.motion, all); }
  bool m_is(std::size_t group, std::initializer_list<std::int32_t> all) const { return is_one_of(codes_.m[group], all); }
  bool user_code() const { return codes_.m[10] >= 100; }
  bool tool_side() const { return codes_.g[7] > 40_g; }
  Status unless(bool used, char letter, const char* text) const {
    if (used || !has(letter)) return {};
    return wrong(AlarmId::rs274_words, m_.where(letter), text);
  }
  char sign(char c) const {
    for (const AddressName& name : m_.def.grammar.names)
      if (name.text[0] == c) return name.address;
    return 0;
  }

  BlockContext& m_;
  const LinuxCnc& control_;
  BlockCodes codes_;
  int m_count_ = 0;
  char polar_radius_ = 0, polar_angle_ = 0, spindle_ = 0;
};

Status Checker::letters_of_cycles() const {
  if (!codes_.is_cycle()) return {};
  for (const char letter : {'A', 'B', 'C'})
    if (has(letter))
      return wrong(AlarmId::rs274_cycle, m_.where(letter),
                   fmt::format("Cannot put an {} in canned cycle", static_cast<char>(letter | 0x20)));
  return {};
}

/// Refuses words that no code of the block uses. The alarm texts and the order of the checks are LinuxCNC's.
Status Checker::words() const {
  KADR_TRY(letters_of_cycles());
  const bool thread = moves({33_g, 33.1_g});
  const bool cycle_l = codes_.is_cycle() && codes_.motion != 74_g;
  KADR_TRY(unless(tool_side() || codes_.g[14] == 96_g || moves({70_g, 71_g, 71.1_g, 71.2_g, 72_g, 72.1_g, 72.2_g}), 'D',
                  "D word with no G41, G41.1, G42, G42.1, G71, G71.1, G71.2 or G96 to use it"));
  const bool spindle_mode = codes_.g[5] == 95_g || is_one_of(codes_.g[14], {96_g, 97_g});
  if (has(spindle_) && !has('S') && !spindle_mode && !m_is(7, {3, 4, 5, 19}) && codes_.m[9] != 51 && !moves({33_g, 33.1_g, 76_g}))
    return wrong(AlarmId::rs274_words, m_.where(spindle_),
                 "$ (spindle selection) word with no M3, M4, M5, M19, M51, G33, G33.1, G76, G95, G96 or G97 to use it");
  KADR_TRY(unless(m_is(5, {66, 67, 68}) || thread || moves({70_g, 76_g}), 'E', "E word with no G70, G76, M66, M67 or M68 to use it"));
  KADR_TRY(unless(is_one_of(codes_.g[8], {43_g, 43.2_g}) || codes_.motion == 76_g, 'H', "H word with no G43 or G76 to use it"));
  const bool data_code = codes_.g[0] == 10_g;
  KADR_TRY(unless(moves({2_g, 3_g, 5_g, 5.1_g, 33.1_g, 71_g, 71.1_g, 71.2_g, 72_g, 72.1_g, 72.2_g, 76_g, 87_g}) || data_code, 'I',
                  "I word with no G2, G3, G5, G5.1, G10, G33.1, G76, or G87 to use it"));
  KADR_TRY(
      unless(moves({2_g, 3_g, 5_g, 5.1_g, 76_g, 87_g}) || data_code, 'J', "J word with no G2, G3, G5, G5.1, G10, G76 or G87 to use it"));
  KADR_TRY(unless(moves({2_g, 3_g, 33_g, 33.1_g, 76_g, 87_g}), 'K', "K word with no G2, G3, G33, G33.1, G76, or G87 to use it"));
  KADR_TRY(unless(
      cycle_l || codes_.motion == 76_g || codes_.motion == 5.2_g || data_code || tool_side() || codes_.m[5] == 66 || codes_.m[4] == 98, 'L',
      "L word with no G10, cutter compensation, canned cycle, digital/analog input, M98 or NURBS code"));
  KADR_TRY(word_p());
  KADR_TRY(unless(moves({5_g, 70_g, 71_g, 71.1_g, 71.2_g, 72_g, 72.1_g, 72.2_g, 73_g, 76_g, 83_g}) || data_code || codes_.g[13] == 64_g ||
                      m_is(7, {19}) || codes_.m[6] == 61 || m_is(5, {66, 67, 68}) || user_code(),
                  'Q', "Q word with no G5, G10, G64, G73, G76, G83, M19, M66, M67, M68 or user M code that uses it"));
  KADR_TRY(unless(moves({2_g, 3_g, 76_g}) || codes_.is_cycle() || data_code || is_one_of(codes_.g[7], {41.1_g, 42.1_g}) || m_is(7, {19}) ||
                      moves({71_g, 71.1_g, 71.2_g, 72_g, 72.1_g, 72.2_g}),
                  'R', "R word with no g code that uses it"));
  KADR_TRY(words_of_orient());
  return required();
}

Status Checker::word_p() const {
  const bool used = moves({2_g, 3_g, 5_g, 5.2_g, 70_g, 74_g, 76_g, 82_g, 84_g, 86_g, 88_g, 89_g}) || codes_.g[0] == 4_g ||
                    codes_.g[0] == 10_g || codes_.g[13] == 64_g || m_is(7, {19}) || m_is(9, {50, 51, 52, 53}) ||
                    m_is(5, {62, 63, 64, 65, 66}) || codes_.m[4] == 98 || user_code();
  KADR_TRY(unless(used, 'P',
                  "P word with no G2 G3 G4 G10 G64 G5 G5.2 G76 G82 G86 G88 G89 or M50 M51 M52 M53 M62 M63 M64 M65 M66 M98 or user M "
                  "code to use it"));
  const bool arc = moves({2_g, 3_g});
  if (!has('P') || (!arc && codes_.m[7] != 19)) return {};
  const double p = m_.word('P')->value;
  const Span at = m_.where('P');
  if (std::fabs(p - std::round(p)) > whole_within) return wrong(AlarmId::rs274_words, at, "P value not an integer with M19 G2 or G3");
  if (codes_.m[7] == 19 && !is_one_of(static_cast<std::int32_t>(std::round(p)), {0, 1, 2}))
    return wrong(AlarmId::rs274_words, at, "P value must be 0,1,or 2 with M19");
  if (arc && std::round(p) < 1) return wrong(AlarmId::rs274_words, at, "P value should be 1 or greater with G2 or G3");
  return {};
}

Status Checker::words_of_orient() const {
  if (codes_.m[7] != 19 || !has('R')) return {};
  const double r = m_.word('R')->value;
  if (r >= 0 && r <= 360) return {};
  return wrong(AlarmId::rs274_words, m_.where('R'), "R value must be within 0..360 with M19");
}

Status Checker::required() const {
  const Span at = m_.block->where;
  if (codes_.g[14] == 96_g && !has('S')) return wrong(AlarmId::rs274_words, at, "S word missing with G96");
  if (moves({33_g, 33.1_g})) {
    if (!has('K')) return wrong(AlarmId::rs274_words, at, "K word missing with g33/g33.1");
    if (has('F')) return wrong(AlarmId::rs274_words, at, "F word used with a g33/g33.1");
  }
  if (codes_.motion == 76_g) {
    if (!has('P')) return wrong(AlarmId::rs274_words, at, "P word missing with G76");
    if (!has('I') || !has('J') || !has('K')) return wrong(AlarmId::rs274_words, at, "I J or K words missing with G76");
  }
  return {};
}

}  // namespace

Result<BlockCodes> codes_of_block(BlockContext& m, const LinuxCnc& control) { return Checker(m, control).run(); }

}  // namespace kadr::linuxcnc
