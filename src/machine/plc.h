#pragma once
// Plc: the machine's logic and its operator, as the events of a set-up say (tests/golden/README.md, "Events"). It looks at blocks,
// actions and the program's end and answers with commands; apply() hands these to the channels' controls.
//
//   block start ─▶ block carried out ─▶ its actions ─▶ block end ─▶ next block          (a command acts at once)

#include <string>
#include <variant>
#include <vector>

#include "action/action.h"
#include "config/setup.h"

namespace kadr {

struct SetSignal {
  std::string name;  // "CP_MINT"
  double value;
};
struct SetSkip {
  int number;
  bool on;
};
struct AnswerBox {
  double value;  // of #3107: 0 cancel, 1 OK, 2 yes, 3 no
};
struct Start {};  // of a stop: the virtual operator presses START at once anyway
struct PowerCycle {};
/// Spindle `slave` follows `master`; 0: no more. `slave` 0: all spindles.
struct Synchronise {
  int slave, master;
};
struct CoupleAxes {
  std::vector<std::string> axes;
  AxisLink link;
  bool on;
};
struct ConvertSpindle {
  int number;
  bool to_axis;
};
using PlcCommand = std::variant<SetSignal, SetSkip, AnswerBox, Start, PowerCycle, Synchronise, CoupleAxes, ConvertSpindle>;

class Plc {
 public:
  ///   told_of_ends  the control tells it of M2, M30, M98, M99 too (nct 13.1)
  explicit Plc(const std::vector<SetupEvent>& events, bool told_of_ends = true);

  /// Which event cannot be served: a sentence; empty: all can.
  const std::string& error() const { return error_; }
  /// No events: nothing needs to be shown to it.
  bool idle() const { return events_.empty(); }

  /// Each gives the commands of the events that come, in the order of the set-up; valid until the next call.
  const std::vector<PlcCommand>& block(const Origin& origin, bool at_end);
  /// A code counts whichever channel it comes from. An answer needs a message that asks.
  const std::vector<PlcCommand>& action(const Action& action);
  const std::vector<PlcCommand>& program_end();

 private:
  struct Event {
    SetupEvent::When when;
    bool main_block;  // ':' instead of N
    char letter;      // of the code
    double number;    // of the block or code
    int count;        // n-th time; 0: each time
    int seen = 0;
    PlcCommand command = Start{};
  };
  template <class Matches>
  const std::vector<PlcCommand>& fire(Matches matches);

  std::vector<Event> events_;
  std::vector<PlcCommand> commands_;
  std::string error_;
};

}  // namespace kadr
