// Copies data of the machine and the set-up into a cutting job. This file is used by cli/cut and view/part_run.

#include "session/cutting/cut_setup.h"

#include <algorithm>

#include "config/machine/rapid_path.h"

namespace kadr {

void take_session(const Session& session, bool starts_known, CutJob& cut) {
  const Setup& setup = session.setup();
  const std::vector<std::string>& axes = session.control().axes();
  take_unit(session.control().machine_unit(), cut.tools);
  cut.tool = std::uint32_t(std::max(setup.tool, 0));
  cut.rpm = setup.spindle().rpm;
  const std::string& dir = setup.spindle().dir;
  cut.spindle = dir == "cw" ? SpindleDir::cw : dir == "ccw" ? SpindleDir::ccw : SpindleDir::stop;
  cut.disabled = setup.disabled;
  cut.starts_known = starts_known;
  const bool lathe = session.def().behaviour.lathe != Lathe::none;  // lengths of a lathe contain the wear, which makes the size right
  for (const auto& [number, offset] : setup.offsets)
    if (!lathe && number > 0 && offset.length != 0) cut.lengths[std::uint32_t(number)] = offset.length;
  cut.machine = std::make_shared<MachineTree>(session.machine(), axes);
  if (rapids_apart(session.def(), setup, axes)) cut.apart = rates_of(session.machine(), setup, axes).rapid;
}

}  // namespace kadr
