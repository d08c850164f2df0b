#pragma once
// BlockRun: executes the items of one block with names (spec/sinumerik 2, 3, 5, 12). Only src/control/sinumerik includes this file.

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "control/sinumerik/sinumerik.h"

namespace kadr::sinumerik {

template <std::size_t n>
bool among(const std::string_view (&list)[n], std::string_view name) {
  return std::find(std::begin(list), std::end(list), name) != std::end(list);
}

/// Returns true for a name of the control that Kadr does not execute.
bool is_refused_name(std::string_view name);

class BlockRun {
 public:
  BlockRun(Interpreter& m, Sinumerik& own, const NamedBlock& read) : m_(m), own_(own), read_(read), block_(*m.block) {}

  /// Returns true if nothing of the block is left to execute.
  Result<bool> run();

 private:
  static Result<bool> done(const Status& status) {
    if (!status) return fail(status.error());
    return true;
  }

  /// Executes an item. Returns false if the rest of the block is not executed: a jump was made.
  Result<bool> item(std::size_t& i);
  static Result<bool> all_right(const Status& status) {
    if (!status) return fail(status.error());
    return true;
  }

  Result<double> number_of(const NamedItem& item);
  Status word(const NamedItem& item);
  bool axis_of(char letter) const;
  Status unknown(const NamedItem& item) const;
  Status system_word(const NamedItem& item);
  Status assign(const NamedItem& item, const std::shared_ptr<Variable>& variable);
  Status assign_component(const NamedItem& item, const std::shared_ptr<Variable>& to);
  Result<bool> executed_text();
  Status assign_list(const NamedItem& item, const std::shared_ptr<Variable>& variable, const NamedStep& last);
  Status assign_sign(const NamedItem& item, const std::shared_ptr<Variable>& to);
  Status parameter(const NamedItem& item);
  Status store(const std::string& name, double value, const NamedItem& item);
  Status long_word(const NamedItem& item);
  /// S[1]=…, M[1]=…, G[8]=2.
  Status bracketed(const NamedItem& item, double value);
  Status add(char letter, double value, const NamedItem& item);
  Status add_code(char letter, double code, const NamedItem& item);
  Status code_word(const NamedItem& item, char letter, double code);
  Status m_word(const NamedItem& item, double code);
  Status tool(const NamedItem& item);
  Status edge(const NamedItem& item, double value) const;
  Status numbered_call(const NamedItem& item);
  Result<bool> name(const NamedItem& item, std::size_t& i);
  Status message(const NamedItem& item);
  /// SETAL(n): stops with the program's own alarm; 62000 to 62999 and from 67000 on it is only shown (spec/sinumerik 9.4).
  Status own_alarm(const NamedItem& item);
  Result<bool> modal_call(std::size_t& i);
  /// DIAMON, DIAM90, DIAMOF: words of X are diameters (spec/sinumerik 10). Returns false for any other name.
  bool diameters(const std::string& name);
  Status master_spindle(const NamedItem& item);
  /// M2=3, S2=500: a spindle other than the master. The words of a block act together at its end.
  Status spindle_word(const NamedItem& item, double value);
  void start_spindles();
  /// AX[name]=10: the axis is the value of a variable (spec/sinumerik 3.1).
  Status axis_by_variable(const NamedItem& item);
  /// OVR=, FB=, LIMS= (spec/sinumerik 5, 12.1).
  Status feed_word(const NamedItem& item);
  double unit_of_feed() const;
  /// MEAS=1, MEAS=-2: the motion of the block ends where the probe touches (spec/sinumerik 17).
  Status measure(const NamedItem& item);
  /// FGROUP(X,Y,Z): the feed of the geometry axes, as without it.
  Status feed_group(const NamedItem& item);
  /// POS[X]=5, FA[X]=200: a positioning axis (spec/sinumerik 3.1).
  Status positioning(const NamedItem& item);
  Status position_axes();
  /// G58, G59: the coarse and the fine shift of the programmable frame (spec/sinumerik 11.2).
  Status shift_frame();
  Status to_fixed_point();
  /// G25, G26: limits of the speed with S, of the working area with axes (spec/sinumerik 5, 10).
  Status limits();
  /// OFFN: an allowance on the radius of the tool under G41, G42 (spec/sinumerik 13.2).
  Status normal_offset(const NamedItem& item);
  Result<bool> finish();
  void scale_feed();
  Status dwell();
  /// G110, G111, G112: the pole from the last position, the zero of the system, the last pole (spec/sinumerik 12.3).
  Status pole();
  /// AP and RP are modal: the one that is left out keeps its value.
  Status polar_words();
  /// ANG=a: a line by its angle and one coordinate of its end (spec/sinumerik 12.4).
  Status angle_word();
  Status angle_word(const std::string& name);
  Status coordinate(std::size_t axis, double value, Span where);
  Status first_of_two_lines();
  Status tool_direction();
  /// G53, G153, SUPA: the words are positions in the machine, with the tool length in them. They are converted to programmed coordinates.
  Status machine_words();
  Status to_reference();
  /// G331, G332: tapping with the spindle as an axis: the feed is the speed times the lead (spec/sinumerik 12.5).
  Status tap();
  Status thread();
  Status begin_chuck();
  void orient(double angle);
  Status corner_words() const;

  // Smooth approach and retraction (block_approach.cpp).
  struct Way {
    double reach = 0, clearance = 0, down = 0;  // DISR, DISCL in mm; FAD in mm/min
    bool rapid = false, has_code = false;
  };
  struct Ahead {
    std::optional<int> motion;
    std::optional<bool> absolute;
    std::map<std::string, std::pair<double, WordForm>> words;
  };
  Status approach();
  Status arrive(const Way& way, bool left);
  Status retract(const Way& way);
  Status set_axis(std::size_t axis, double value);
  std::optional<Ahead> words_ahead(Block& block);
  /// Reads the next block that has words. Returns nullopt if it is no block of motions.
  std::optional<Ahead> block_ahead();
  Result<Vec2> direction_after(const Axes& from);
  /// CIP and CT: worked out as G2 or G3 with a centre (spec/sinumerik 12.2).
  Status named_arc();
  Status line_by_name();
  Result<bool> arc_in_space(const Axes& through, const Axes& to);

  Interpreter& m_;
  Sinumerik& own_;
  const NamedBlock& read_;
  Block& block_;
  std::optional<NamedItem> call_;
  double times_ = 1;
  bool in_dwell_ = false, tapping_ = false, reference_ = false, fixed_point_ = false;
  int limits_ = 0;  // 25, 26
  int pole_ = 0;
  int shift_ = 0;                 // 58, 59
  int approach_ = 0;              // G147 to G348
  bool chuck_ = false;            // G63
  std::optional<double> orient_;  // M19
  std::uint32_t spindles_ = 0;    // spindles whose speed or direction the block changes, one bit each
  AxisMask positioned_ = 0;       // axes of POS
  Axes positions_{};              // programmed coordinates
  std::optional<int> feed_unit_;
};

}  // namespace kadr::sinumerik
