#pragma once
// Plc: the machine's logic and its operator, scripted by the events of a set-up (tests/golden/README.md, "Events"). The input is blocks,
// actions and the end of the program. The output is commands, which apply() passes to the controls of the channels.
//
// Order in which the input arrives; a command takes effect immediately:
//   block start ─▶ execution of the block ─▶ actions of the block ─▶ block end ─▶ next block

#include <string>
#include <variant>
#include <vector>

#include "action/action.h"
#include "config/setup/setup.h"

namespace kadr {

struct SetSignal {
  std::string name;  // name of the signal: "CP_MINT"
  double value;
};
struct SetSkip {
  int number;
  bool on;
};
struct AnswerBox {
  double value;  // the operator's answer to a message, for #3107: 0 cancel, 1 OK, 2 yes, 3 no
};
struct Start {};  // the operator presses START after a stop; Kadr also continues without this command
struct PowerCycle {};
/// Makes spindle `slave` follow spindle `master`. With master 0 the slave stops following; slave 0 means all spindles.
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

  /// Returns an error sentence about an event of the set-up that this class does not support; an empty text if it supports all events.
  const std::string& error() const { return error_; }
  /// Returns true if the set-up has no events, so that the caller need not pass anything to this object.
  bool idle() const { return events_.empty(); }

  /// The functions block(), action() and program_end() return the commands of the events that occur at this block, action or end, in the
  /// order of the set-up. The returned reference is valid until the next call of one of these functions.
  const std::vector<PlcCommand>& block(const Origin& origin, bool at_end);
  /// An event that names a code occurs whichever channel issues the code. An event with an answer occurs only at a message that asks the
  /// operator for an answer.
  const std::vector<PlcCommand>& action(const Action& action);
  const std::vector<PlcCommand>& program_end();

 private:
  struct Event {
    SetupEvent::When when;
    bool main_block;  // true if the event names a main block, with ':' instead of N
    char letter;      // address letter of the event's code
    double number;    // number of the event's block, or of its code
    int count;        // number of the occurrence of the block or code at which the event occurs; 0: at every occurrence
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
