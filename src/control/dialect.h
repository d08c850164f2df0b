#pragma once
// Dialect: what a control does that no row of its file can say (`dialect = "…"` in controls/*.toml). One object a channel; it stands where
// the interpreter asks, block by block or motion by motion, never word by word. Each default here is what all controls do: ISO 6983. A
// control whose file says everything has these defaults (make_iso_dialect()).

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "base/result.h"
#include "base/vec.h"
#include "config/control_def.h"
#include "config/setup.h"
#include "config/setup_file.h"
#include "config/state_file.h"
#include "control/block/arc.h"
#include "control/control.h"
#include "control/state/far_axis.h"
#include "lang/block/block.h"

namespace kadr {

class Interpreter;
struct Call;
struct Commons;
struct Plan;
struct RunLimits;
struct SearchRules;

/// When the machine's logic and an interrupt macro are looked at.
enum class BlockMoment : std::uint8_t { start, end };

/// What a block may change, and so what is kept of the state before it: an alarm takes the block back.
enum class BlockChanges : std::uint8_t {
  position,  // nothing else: the motion either fails before, or is made
  little,    // motion code and feed
  cycle,     // those, and the words of a drilling cycle
  anything,
};

/// What the machine, its logic and its operator tell a control that can be told it, and ask of it. NCT 11.7, 11.8, 20.2, 23.1, 23.4.
class MachineSide {
 public:
  virtual ~MachineSide() = default;
  virtual void set_signal(const std::string& name, double value) = 0;
  /// To the question of a message (#3107).
  virtual void set_answer(double answer) = 0;
  /// Spindle `slave` follows `master`; 0: no more. `slave` 0: all spindles.
  virtual void synchronise(int slave, int master) = 0;
  virtual void couple_axis(Interpreter& m, const std::string& name, AxisLink link, bool on) = 0;
  // ---- axes that hang on those of other channels: Control has the same
  virtual const std::vector<FarAxis>& far_axes() const = 0;
  virtual void drop_far(Interpreter& m, const FarAxis& axis) = 0;
  virtual void lead_axis(Interpreter& m, std::size_t axis, double machine) = 0;
  virtual bool may_exchange(const Interpreter& m, std::size_t axis) const = 0;
  virtual void exchange_far(std::size_t axis, double machine, bool on) = 0;
  virtual bool is_parked(std::size_t axis) const = 0;
  virtual bool rolls_over(std::size_t axis) const = 0;
  virtual void convert_spindle(int number, bool to_axis) = 0;
  /// ms since the start of the run, and ms at feed since the last call.
  virtual void set_time(double now_ms, double cut_ms) = 0;
  virtual RunState run_state(const Interpreter& m) const = 0;
  virtual SearchRules search_rules() const = 0;
  /// Waiting codes have no effect.
  virtual bool waiting_suspended() const = 0;
};

/// What a dialect remembers, in a snapshot.
struct DialectState {
  virtual ~DialectState() = default;
};

class Dialect {
 public:
  virtual ~Dialect() = default;

  /// All that it remembers, between two blocks.
  virtual std::shared_ptr<const DialectState> snapshot() const { return nullptr; }
  /// Goes on from a snapshot of its like; the interpreter has been restored.
  ///   alarms  file_write: a file that the program was writing cannot be gone on with
  virtual Status restore(Interpreter& m, const DialectState& from);

  /// nullptr: there is no machine whose logic, operator or parameters are known.
  virtual MachineSide* machine_side() { return nullptr; }
  /// What the program has written: path, bytes.
  virtual const WrittenFiles& files_written() const;

  // ---- start and end

  /// Power-on, instead of the codes that the file's groups begin with. true: done.
  virtual bool start(Interpreter& m, const Setup& setup);
  /// The modal codes of a set-up are carried out one by one, not as one block.
  virtual bool starts_code_by_code() const { return false; }
  /// What the set-up says, after its modal codes.
  virtual void take_setup(Interpreter& m, const Setup& setup);
  /// Words carried out behind the power-on codes, before those of the set-up.
  virtual std::string start_words() const { return {}; }
  /// The tool stands where the set-up says.
  virtual void started(Interpreter& m);
  /// Limits of an axis that a file of the machine says, machine coordinates; ±1e300: none. Those of the set-up and of a machine file
  /// count before them.
  virtual std::pair<double, double> limits_by_file(std::size_t axis) const;
  /// M2, M30, instead of the file's end codes. true: done.
  virtual bool end_program(Interpreter& m);
  /// The run has stopped with an alarm; all that the block had changed is as it was.
  virtual void failed(Interpreter&) {}
  /// Power off and on: what only the power kept is lost. false: nothing is known of that.
  virtual bool lose_power(Interpreter& m);
  /// Variables that hold something, and those that are asked for.
  virtual void add_variables(Interpreter& m, Ending& ending, const std::vector<std::string>& watch);
  /// Tables as a set-up would give them (control/tables_now). false: they are those of the interpreter.
  virtual bool add_tables(const Interpreter&, Setup&) const { return false; }
  /// What the block changed of the things that survive power-off.
  virtual StateChanges take_changes(Interpreter& m);
  /// What the channels of a machine have in common besides Commons: goes up as it changes.
  virtual std::uint64_t common_version() const { return 0; }
  /// Of another channel, a dialect of the same kind; between two blocks.
  virtual void take_common(Interpreter&, const Dialect&) {}

  // ---- a block

  /// Something is to be finished before the next block is read.
  virtual bool has_unfinished() const { return false; }
  /// Does a part of it. true: the next block must wait.
  virtual Result<bool> finish(Interpreter& m);
  /// The block's expressions ask the time: it must be that of the moment.
  virtual bool reads_clock(const Block& block) const;
  /// A block with `/`, whether it is skipped or not.
  virtual void note_skip_mark(Interpreter& m);
  /// A block that is skipped is not read: what is wrong in it does not count.
  virtual bool skips_unread() const { return false; }
  /// Blocks are looked at one by one: an interrupt macro may come.
  virtual bool watches_blocks() const { return false; }
  virtual bool in_interrupt() const { return false; }
  /// Calls the interrupt macro where it is asked for. true: it was called.
  virtual Result<bool> interrupt(Interpreter& m, BlockMoment moment);
  /// Numbered lines are data (of a G10), not blocks.
  virtual bool takes_data() const { return false; }
  /// IF, WHILE, GOTO, #1=…: a block that is no words. false: IF … THEN holds, and the words behind it are to be carried out.
  virtual Result<bool> statement(Interpreter& m);
  virtual void begin_block(Interpreter& m);
  /// The words have their values. true: the block is done with that (its words were arguments of a macro, data …).
  virtual Result<bool> takes_block(Interpreter& m);
  /// Row of the motion code that axis words alone would carry out; -1: none.
  virtual std::int16_t motion_row(const Interpreter& m) const;
  virtual BlockChanges changes_of(const Interpreter& m, const Plan& plan) const;
  /// Before and after each function of the block; `code` is the tenth of the word's number, -1: none.
  virtual void before_function(Interpreter& m, Function function);
  virtual void after_code(Interpreter& m, const CodeRow& row, std::int32_t code);
  virtual Status after_block(Interpreter& m);
  /// The block may change anything: what of it is kept here.
  virtual void keep(Interpreter& m);
  /// The block was faulty: what it had changed here, as it was; then, when all the rest is as it was before.
  virtual void take_back(Interpreter& m);
  virtual void taken_back(Interpreter& m);

  /// A line of nothing but `%` (Grammar::percent_encloses). true: dealt with.
  virtual Result<bool> sign_of_file(Interpreter& m);
  /// The program's file is over, without a code that ends it. true: dealt with.
  virtual Result<bool> end_of_file(Interpreter& m);
  /// Comments that do something, before the block's words.
  virtual Status comments(Interpreter& m);
  /// The control's own words for what is reported, where no row of [alarms] can have them.
  virtual void reword(const Interpreter& m, AlarmReport& report) const;

  /// A subprogram of the program has the number of a cycle, which is called instead. `where`: the call, or its first block.
  virtual void note_shadowed(Interpreter& m, std::uint32_t number, Span where);

  // ---- after a faulty block, for people who check

  virtual void note_fault(Interpreter& m, bool may_have_steered);
  /// A main program begins again: what was noted of its passes is forgotten.
  virtual void begin_again() {}
  /// The innermost call is left although its end is missing. true: done.
  virtual bool leave_call(Interpreter& m);

  // ---- motion and frames

  /// End point by the block's axis words.
  virtual Status target(const Interpreter& m, Axes& to, AxisMask& named) const;
  /// The block has words that add to its motion; add_to_motion() does. Returns the axes it moves besides those of the words.
  virtual bool adds_to_motion(const Interpreter& m) const;
  virtual Result<AxisMask> add_to_motion(Interpreter& m);
  /// The block has words that make of G0, G1 something else: then straight() carries it out.
  virtual bool shapes_lines(const Interpreter& m) const;
  virtual Status straight(Interpreter& m, const Call& call, MotionKind kind);
  /// The words only shift the start point: nothing moves.
  virtual bool only_shifts(const Interpreter& m) const;
  virtual Status arc(Interpreter& m, const Call& call, Turn turn);
  /// A straight motion where the plane is a surface (PathSurface).
  virtual Status surface_line(Interpreter& m, MotionKind kind, const Axes& programmed, AxisMask named);
  /// Blocks that give only the end point of a motion, its centre, a feed that is in force, go on as the block before did: neither words,
  /// modes nor anything else that is known here has to be looked at again (control/block/motion_run).
  virtual bool lines_follow(const Interpreter&) const { return false; }
  /// Axes for which this does not hold.
  virtual AxisMask rolling_axes(const Interpreter&) const { return 0; }
  /// How it reads the centre of an arc in such blocks.
  virtual ArcRule arc_rule(const Interpreter& m) const;
  /// Such a block has been carried out.
  virtual void note_line(Interpreter&) {}
  /// These axes may be moved.
  virtual Status may_move(const Interpreter& m, AxisMask named) const;
  virtual void note_motion(Interpreter& m, Motion& motion);
  /// Feed of a motion programmed in inches.
  virtual double inch_feed(const Interpreter& m, const Motion& motion, const Axes& from) const;
  /// A feed of its own comes into force.
  virtual void note_feed(Interpreter& m);
  /// Feeds per minute and per revolution stand side by side; else a change of the unit forgets the feed.
  virtual bool keeps_both_feeds() const { return false; }
  /// M3, M4, M5 are for other spindles than the first one: it has commanded them.
  virtual Result<bool> turns_spindle(Interpreter&, SpindleDir, Span) { return false; }
  virtual SurfaceSpeed surface_speed(const Interpreter& m) const;
  /// Origin, length, shifts by the tables and the modal state.
  virtual void refresh_frames(Interpreter& m);
  /// What of the origin in force is a shift of the work system, and no zero of its table (G52, G92), mm.
  virtual Axes shift_of_origin(const Interpreter& m) const;
  /// The zero may move under a contour that is being compensated.
  virtual bool zero_may_move() const { return false; }
  /// mm: of lengths in the machine's own tables.
  virtual double machine_unit() const { return 1; }
  /// G20 and G21 may come while a contour is being compensated.
  virtual bool units_may_change() const { return false; }
  /// Positions as they are shown: axes that roll over within their turn.
  virtual void roll(const Interpreter& m, Axes& positions) const;
  virtual Status take_answer(Interpreter& m, const ProbeAnswer& answer);
  /// Its drilling cycles emit their motions alone: nothing here is asked about them.
  virtual bool drills_plainly() const { return false; }
  /// M codes of the machine.
  virtual Status machine_code(Interpreter& m, const Call& call);

  // ---- variables beyond those that the file lists

  virtual Result<double> read_variable(Interpreter& m, double number, Span where) const;
  /// #n=… of a control without levels of locals.
  virtual Status write_variable(Interpreter& m, double number, double value, Span where);
  /// Number of an element of a variable with a name.
  virtual Result<double> number_of_element(const Interpreter& m, double symbol, double index, Span where) const;
  /// A parameter of the control; NaN bit, index: left out.
  virtual Result<double> control_value(Interpreter& m, double number, double bit, double index, Span where) const;
};

// Each stands in the folder of its name.
std::unique_ptr<Dialect> make_s2c42_dialect();
std::unique_ptr<Dialect> make_correctors_dialect(const Interpreter& m, const Setup& setup);
std::unique_ptr<Dialect> make_grbl_dialect(const Setup& setup);
std::unique_ptr<Dialect> make_mach3_dialect(const RunLimits& limits);
std::unique_ptr<Dialect> make_linuxcnc_dialect(Interpreter& m, const Setup& setup, const RunLimits& limits);
std::unique_ptr<Dialect> make_nct_dialect(Interpreter& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons);

/// Of a control whose file says everything: each answer is the default.
std::unique_ptr<Dialect> make_iso_dialect();

/// The dialect that the control's file names. `commons`: variables that all channels of the machine share.
std::unique_ptr<Dialect> make_dialect(Interpreter& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons);

}  // namespace kadr
