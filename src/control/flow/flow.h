#pragma once
// Flow: the program flow, that is, the order in which blocks are executed. It has the readers, the call stack, repetitions, jumps, and the
// limit for a program that never ends.

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "config/control/control_def.h"
#include "control/flow/program_file.h"
#include "control/state/control_state.h"
#include "control/state/run_limits.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// An open call or repetition.
struct CallFrame {
  enum class Kind : std::uint8_t { subprogram, cycle_body, repetition, macro, interrupt };
  Kind kind = Kind::subprogram;
  Position start;  // position of the first block that is called or repeated
  Position back;   // position of the block at which the caller continues
  // number of the file that contains the block at `start`: 0 the program, 1 the bodies of canned cycles, 2 and more other files
  std::uint16_t reader = 0;
  std::uint16_t back_reader = 0;
  std::uint32_t name = 0;  // subprogram number
  std::uint32_t left = 0;  // number of passes that remain to be executed, including the present one
  std::uint32_t done = 0;  // number of passes started
  bool repeating = false;  // true from the second pass of the repetition on
  Origin caller;
  std::uint16_t work_zero = 0;  // work offset of the caller, which is restored on return (2С42)
  Axes zero_shift{};
  std::int16_t work_offset_row = -1;
  std::array<std::int16_t, 3> then{-1, -1, -1};  // code rows of the calling block that are executed on return: M17, M20, M2; -1: none
  // nct
  std::uint8_t modal_calls = 0;  // number of modal macro calls that are in force in the caller (nct 23.3.2)
  bool opened_level = false;     // the call is an interrupt macro that has its own local variables
  // M99 P: number of the caller's block at which the caller continues; -1: M99 has no P, and the caller continues after the call
  std::int32_t return_to = -1;
  char called_by = 0;             // address of the word that called; inside the call this address calls no macro (nct 23.3.4–23.3.8)
  std::int32_t called_code = -1;  // code number of the word that called, in tenths
};

class Flow {
 public:
  Flow(const ControlDef& def, Program program, RunLimits limits);

  /// Reads the next block to execute, or finds the end of the program.
  Result<BlockReader::Got> next(Block*& block);

  // ---- a block that is read but not executed yet
  /// The state of reading before a block, from which the block can be read again.
  struct Mark {
    Position position;
    BlockReader::Memory memory;
    std::uint64_t blocks = 0, repeated = 0;
    bool ended = false;
  };
  Mark mark() const;
  /// Restores the state of reading that was saved before a block (`before`), so that the block is read again.
  void unread(const Mark& before);

  // ---- a line entered by the operator (MDI)
  /// Makes this line the next block. After it the program continues at the block that would have been next.
  void enter(std::string line);
  /// Returns true while the entered line is being executed.
  bool in_entered() const { return now_.entered.on; }
  /// Returns the number of calls that were open when the line was entered.
  std::size_t entered_depth() const { return now_.entered.depth; }
  /// Ends the entered line, so that the program continues. Returns false if no line was entered.
  bool leave_entered();

  // ---- snapshot
  struct Entered {
    bool on = false;
    bool ended = false, started = false;  // state of the program when the line was entered
    std::uint16_t reader = 0;             // number of the line as a file; 0: no line has been entered yet
    std::uint16_t back_reader = 0;
    Position back;
    std::size_t depth = 0;
    std::string line;
  };
  /// The data of Flow that remain valid from one block to the next.
  struct Counts {
    std::uint16_t reader = 0;
    std::vector<CallFrame> frames;
    CallFrame left;  // call or repetition that was closed last
    std::set<std::uint32_t> passed;
    bool ended = false;
    bool jumped_back = false;
    std::uint32_t restarts = 0;
    std::uint64_t blocks = 0;
    std::uint64_t repeated = 0;
    bool started = false;  // a block that begins with '%' has been seen
    Entered entered;
  };
  struct File {
    std::string name;  // path of the file; for a built-in program, the name of the program
    bool built_in = false;
    ProgramFile::Memory memory;
  };
  struct Memory {
    Counts now;
    Position position;
    std::vector<File> files;            // open files by number; [0] is the program; [1] is unused
    std::vector<std::uint32_t> called;  // numbers of those subprograms in the program's file that were called
  };
  Memory memory() const;
  /// Restores the state stored in `memory`.
  ///   alarms  file_missing: a file that the program had called is missing; then nothing has changed
  Status resume_from(const Memory& memory);

  // ---- jumps
  /// The state of the program flow: the open calls and the position in the program. It is stored before a block that may change the flow,
  /// and restored if this block fails.
  struct Place {
    std::vector<CallFrame> frames;
    Position position;
    std::uint16_t reader = 0;
    std::uint32_t restarts = 0;
    bool ended = false;
  };
  Place place() const { return {now_.frames, position(), now_.reader, now_.restarts, now_.ended}; }
  void back_to(const Place& place);
  /// Calls a subprogram of the program's file `times` times.
  ///   alarms  subprogram_missing, label_twice, call_too_deep
  Status call(std::uint32_t subprogram, std::uint32_t times, const Origin& caller, Span where);
  Status call_body(const CycleRow& cycle, std::uint32_t times, const Origin& caller, Span where);
  Status repeat(std::uint32_t times, const Origin& caller, Span where);
  /// Calls the subprogram that starts at `start` in the file with the number `reader` (from open_program). `frame` has the other data of
  /// the call: kind, left, caller, …
  ///   alarms  call_too_deep
  Status call_at(std::uint16_t reader, Position start, const CallFrame& frame, Span where);
  /// Returns the position of the label `Onnnn` in the main file; nullopt if the label is missing or not unique.
  std::optional<Position> label_of(std::uint32_t number);
  /// Returns true if the program has a subprogram with this number.
  bool has_subprogram(std::uint32_t number) {
    if (!indexed_) make_index();
    return labels_.contains(number);
  }
  /// Opens the file with this path in the program memory, unless the file is open already, and returns the number of the file; nullopt if
  /// the file cannot be read.
  std::optional<std::uint16_t> open_program(const std::string& path);
  /// Opens a built-in program of the control (macros/), and returns its file number; nullopt if there is no built-in program with this
  /// name.
  std::optional<std::uint16_t> open_built_in(const std::string& name);
  /// Returns the file being read.
  ProgramFile& program_file() { return *files_[now_.reader]; }
  std::uint16_t reader() const { return now_.reader; }
  /// Continues at another block of the file being read. A jump back may be a loop, so from then on the blocks of the file are kept in
  /// memory.
  void jump(Position position);
  /// Returns the innermost open call or repetition; nullptr if there is none.
  CallFrame* innermost() { return now_.frames.empty() ? nullptr : &now_.frames.back(); }
  /// Returns true if the block number of M99 P exists: the file that made the innermost call has a block with this number (nct).
  bool caller_has(std::uint32_t number) {
    const CallFrame& top = now_.frames.back();
    return files_[top.back_reader] && files_[top.back_reader]->find_number(number, top.back).has_value();
  }
  /// Ends a pass of the innermost subprogram. Returns nullptr if another pass follows. If not, returns the call that was closed, as a
  /// pointer that is valid until the next call of this function.
  ///   alarms  return_without_call, repeat_end_missing
  Result<const CallFrame*> end_subprogram(Span where);
  Status end_repetition(Span where);
  /// Starts another pass of the main program at the block `from`. Returns false if no further pass is allowed (RunLimits::restarts).
  bool restart(Position from);
  std::uint32_t passes() const { return now_.restarts + 1; }  // number of passes of the main program that were started
  void end() { now_.ended = true; }
  /// Records that the main program itself has executed the block with this label, which is its own name or the start of a subprogram. The
  /// label then counts as called.
  void pass_label(std::uint32_t label) {
    if (now_.passed.size() < 1000) now_.passed.insert(label);
  }

  bool ended() const { return now_.ended; }
  /// Closes the innermost call or repetition, whose end was not found. If a repetition is closed, the program continues at the position
  /// `again`.
  void abandon(std::optional<Position> again);
  std::string shown(std::string_view text, Span& place) const {
    return visiting_ ? elsewhere_->shown(text, place) : now_.reader != 1 ? files_[now_.reader]->shown(text, place) : std::string(text);
  }
  bool in_body() const { return now_.reader == 1; }
  std::size_t depth() const { return now_.frames.size(); }
  const std::vector<CallFrame>& frames() const { return now_.frames; }
  std::vector<CallFrame>& frames() { return now_.frames; }
  /// Returns the path of the file being read; in a cycle body, the path of the program.
  const std::string& file() const { return files_[now_.reader == 1 ? 0 : now_.reader]->path(); }
  /// Returns the file with this number (as in Origin::file and reader()).
  const ProgramFile& file(std::uint16_t reader) const { return *files_[reader]; }
  /// Returns true if a file has this number. The number of the cycle bodies is not the number of a file.
  bool has_file(std::uint32_t reader) const { return reader < files_.size() && files_[reader] != nullptr; }
  /// Returns the numbers of the files that the program has called (as in Origin::file), in the order of opening.
  std::vector<std::uint16_t> called_files() const;
  /// Returns the paths of all opened files; the first one is that of the program.
  std::vector<std::string> paths() const;
  const std::string& main_file() const { return files_[0]->path(); }
  const RunLimits& limits() const { return limits_; }
  /// Returns true once a block that begins with '%' has been read.
  bool started() const { return now_.started; }
  void set_started(bool started) { now_.started = started; }
  /// Records that the warnings of a kept block were reported (ProgramFile::note_warned).
  void note_warned(const Block& block) {
    if (now_.reader != 1) files_[now_.reader]->note_warned(block);
  }
  std::uint64_t blocks() const { return now_.blocks; }
  /// Counts blocks that were executed again, but were not read with next().
  void pass(std::uint64_t blocks) {
    now_.blocks += blocks;
    now_.repeated += blocks;
  }
  /// Returns how many blocks may still be executed again (RunLimits::repeated_blocks).
  std::uint64_t repeats_left() const { return limits_.repeated_blocks - std::min(limits_.repeated_blocks, now_.repeated); }
  // Number of blocks that were executed again: after a jump back, or in a further call or pass.
  std::uint64_t repeated() const { return now_.repeated; }
  std::uint64_t bytes_read() const { return program().offset(); }
  std::uint64_t bytes() const { return program().size(); }
  const BlockReader& program() const { return files_[0]->reader(); }
  /// Returns the position directly after the block that was read last.
  Position position() const { return now_.reader == 1 ? bodies_->position() : files_[now_.reader]->position(); }

  /// Reads the subprograms that were never called, in the order of their numbers, and calls `visit` for each block.
  void each_uncalled(const std::function<void(Result<BlockReader::Got>, const Block&)>& visit);

  static std::string name_of(const ControlDef& def, const CallFrame& frame);

 private:
  struct Label {
    Position position;
    bool twice = false;
    bool called = false;
  };
  Result<CallFrame*> push(const CallFrame& frame, Span where);
  Status count_repeated(const Block& last);
  void make_index();
  BlockReader& elsewhere();
  void go_to(std::uint16_t reader, Position position);

  const ControlDef& def_;
  RunLimits limits_;
  // readers of the files by file number; element [1] is reserved for the bodies of canned cycles
  std::vector<std::unique_ptr<ProgramFile>> files_;
  std::map<std::string, std::uint16_t> opened_, built_in_;
  std::unique_ptr<BlockReader> elsewhere_;  // a second reader of the program's file; the first one still has the text of the current block
  Grammar body_grammar_;
  std::unique_ptr<BlockReader> bodies_;
  Block body_block_;
  std::map<std::string, Position> body_starts_;
  Counts now_;
  std::map<std::uint32_t, Label> labels_;
  bool indexed_ = false;
  bool visiting_ = false;  // true while each_uncalled() reads the subprograms that were never called, with the reader `elsewhere_`
};

}  // namespace kadr
