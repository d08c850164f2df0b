#pragma once
// TextWatch: finds problems in the text of a program without executing it, by reading it block by block from beginning to end.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/stop_token.h"
#include "config/control/control_def.h"
#include "lang/block/block_reader.h"
#include "session/checklist/advice.h"
#include "session/checklist/table_check.h"

namespace kadr {

class TextWatch {
 public:
  /// `most_rpm`: the highest spindle speed of the machine, rev/min; 0: unknown. A higher S word is reported, since a control may reduce the
  /// speed without a message.
  TextWatch(std::shared_ptr<const ControlDef> def, double most_rpm) : definition_(std::move(def)), most_rpm_(most_rpm) {}

  /// A place between two blocks of the text, at which a reader can continue.
  struct Place {
    Position position;
    BlockReader::Memory reader;
  };
  /// Reads the whole text. A request to stop is checked every few thousand blocks.
  ///   from  a place up to which this object, or the one of which it is a copy, has read the text already
  ///   meet  receives a place every thousand blocks; a copy of this object, made then, can continue there
  void read(BlockReader reader, const StopToken& stop, const std::optional<Place>& from = {},
            const std::function<void(const Place&)>& meet = {});
  void finish(Advices& to);
  /// Returns the number of teeth by tool number, from comments such as "4 FLUTE" or "4FL".
  const std::map<std::uint32_t, int>& teeth() const { return teeth_; }
  const NamedInText& named() const { return named_; }
  /// True if the program contains a code that ends the program, repeats it or returns from it.
  bool has_end() const;

 private:
  /// A program or subprogram in the text, which extends from one O number to the next.
  struct Section {
    std::uint32_t label = 0;
    Origin begins;
    bool ends_program = false, returns = false;
    std::map<std::uint32_t, std::uint32_t> jumps;  // block number that is the target of a jump → line of the jump
    // Block number to which a block jumps → number of blocks that have this block number. They are counted when the text is read a second
    // time.
    std::map<std::uint32_t, std::uint32_t> twice;
    std::optional<Origin> after_end;  // location of the first motion after the end of the program
    std::uint32_t lines_after_end = 0;
    bool has_targets = false;  // true: some block refers to a block number, so lines after the end of the program may be reachable
  };
  void take(const Block& block);
  void take_points(const Block& block);
  void take_codes(const Block& block);
  void take_cycle(const Block& block);
  void take_levels(const Block& block, const Word& cycle);
  void take_flow(const Block& block);
  void take_comments(const Block& block);
  void take_numbers(const Word& word);
  void note_call(const Block& block, const Word& code);
  const ControlDef& def() const { return *definition_; }
  bool is_axis(char letter) const;
  bool moves(const Block& block) const;
  const CodeRow* row(const Word& word) const;
  static Origin origin_of(const Block& block);
  template <class... Args>
  void add(AlarmId id, const Origin& origin, Span where, Args... args);

  std::shared_ptr<const ControlDef> definition_;
  const double most_rpm_;
  NamedInText named_;
  std::vector<Advice> found_;
  // Two counts for the finding about missing decimal points: numbers with a decimal point, and numbers without.
  std::size_t with_point_ = 0, without_point_ = 0;
  std::vector<Advice> pointless_;
  bool inch_ = false;
  // State of the drilling cycle at the present block of the text. The member absolute_ is true if G90 is in force, and false if that is
  // uncertain. The member in_xy_ is true if G17 is in force.
  bool in_cycle_ = false, absolute_ = true, in_xy_ = true;
  // finding about a canned cycle that a motion code (e.g. G0) has cancelled; it is reported only if G80 follows later
  std::optional<Advice> cancelled_;
  // true: blocks after the cancelled cycle contain only positions, as if the cycle were still in force; the control does not drill there
  bool lost_ = false;
  std::optional<double> level_, bottom_;
  // modes that the text has set so far
  bool began_ = false;         // true: a motion has been read
  std::set<Function> stated_;  // functions that the text states before its first motion
  // Function that the text has switched on and not off → location of the block that switched it on last, and its code.
  std::map<Function, std::pair<Origin, std::string>> switched_on_;
  bool main_over_ = false;  // true: the end of the main program has been read
  // flow of the program: jumps, calls and ends
  std::vector<Section> sections_;
  std::set<std::uint32_t> calls_;
  bool calls_by_value_ = false, has_o_words_ = false;
  bool ended_ = false;
  bool repeats_ = false;  // true: a code repeats the program from the beginning
  // tool number → number of teeth that a comment states
  std::map<std::uint32_t, int> teeth_;
  std::uint32_t tool_ = 0;
  int loose_teeth_ = 0;
};

}  // namespace kadr
