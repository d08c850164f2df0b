#pragma once
// Plc: the machine's logic and its operator, as a script of the events in a set-up (tests/golden/README.md, "Events"). The input is
// blocks, actions and the end of the program; the output is commands, which apply() passes to the controls of the channels.
//
//   block start ─▶ execution of the block ─▶ its actions ─▶ block end ─▶ next block     (a command takes effect immediately)

#include <string>
#include <variant>
#include <vector>

#include "action/action.h"
#include "config/setup/setup.h"

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
  double value;  // answer to a message box, for #3107: 0 cancel, 1 OK, 2 yes, 3 no
};
struct Start {};  // the operator presses START after a stop; the virtual operator does this immediately in any case
struct PowerCycle {};
/// Spindle `slave` follows spindle `master`; master 0 ends this, slave 0 means all spindles.
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
  ///   control_reports_ends  true if the control reports M2, M30, M98 and M99 to the logic, like other M codes (nct 13.1)
  explicit Plc(const std::vector<SetupEvent>& events, bool control_reports_ends = true);

  /// Returns a sentence about an event of the set-up that this class cannot handle; empty if there is none.
  const std::string& error() const { return error_; }
  /// True if there are no events: nothing has to be passed to the logic.
  bool idle() const { return events_.empty(); }

  /// block(), action() and program_end() return the commands of the events that occur there, in the order of the set-up. The reference
  /// is valid until the next call of any of them.
  const std::vector<PlcCommand>& block(const Origin& origin, bool at_end);
  /// An event that names a code fires whichever channel issues the code. An answer fires only at a message that asks a question.
  const std::vector<PlcCommand>& action(const Action& action);
  const std::vector<PlcCommand>& program_end();

 private:
  struct Event {
    SetupEvent::When when;
    bool main_block;  // the event names a main block, with ':' instead of N
    char letter;      // letter of the event's code
    double number;    // number of the event's block or code
    int count;        // the event fires at the n-th occurrence; 0: at every occurrence
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
