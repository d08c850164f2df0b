#pragma once
// A real machine of the page: the ports that the server offers, the connection, and the proof before anything moves.

#include <memory>
#include <set>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "drive/grbl/grbl_machine.h"
#include "drive/grbl/grbl_proof.h"
#include "view/opening.h"
#include "view/page/page_json.h"

namespace kadr {

/// The ports with real machines that a server offers to its pages.
struct RealPorts {
  std::vector<std::string> ports;
  bool all_found = false;  // besides `ports`, each serial line under /dev/serial/by-id
  int baud = 115200;
  std::string log;      // the file of the black box
  std::string control;  // id of the control whose programs are the controllers' own

  /// Returns the ports that a page may use now.
  std::vector<std::string> now() const;
  /// Returns the control of a program for the controllers of these ports; nullptr if it is for another control.
  const ControlDef* own(const ControlDef& def) const { return def.id == control ? &def : nullptr; }
};

/// A connected machine, and what the comparison with the program has found.
struct RealConnection {
  std::shared_ptr<drive::GrblMachine> machine;
  std::vector<drive::ProofRow> rows;
  drive::JobNeeds needs;
};

/// Connects a machine and compares it with a program, whose set-up gets what it does not state from the controller. Nothing moves.
///   returns  an error sentence if the connection fails or the program cannot be opened
tl::expected<RealConnection, std::string> connect_machine(const RealPorts& ports, const std::string& port, OpenedProgram& opened,
                                                          const StopToken& stop);
PageJson proof_json(const RealConnection& made);
/// Returns a sentence about the first row that is refused and not accepted; empty if there is none. A row about the program cannot be
/// accepted.
std::string refused_row(const RealConnection& made, const std::set<std::string>& accepted);

}  // namespace kadr
