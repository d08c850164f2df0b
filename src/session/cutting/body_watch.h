#pragma once
// The bodies of the machine in a cut. For cli/cut and view/part_run.

#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "session/cutting/machine_watch.h"
#include "session/session.h"

namespace kadr {

/// Blank or fixture, as a person has named it.
struct NamedWork {
  std::string name;
  std::string text;  // of body_of()
  std::shared_ptr<const Blank> body;
};

/// Blank and fixtures of the job, in their order.
///   stock, fixtures  their words
///   shown            the words of a fixture as they are told
std::vector<NamedWork> work_of(const CutJob& cut, const std::string& stock, const std::vector<std::string>& fixtures,
                               const std::vector<std::string>& shown);

/// Who watches the bodies of the session's machine; nullptr: it has none.
///   most_bytes  that their meshes may take
///   notes       gets what of their files had to be repaired
///   door        opens their files
///   returns     an error sentence: they cannot be watched
tl::expected<std::unique_ptr<MachineWatch>, std::string> watch_bodies(const Session& session, const CutJob& cut,
                                                                      const std::vector<NamedWork>& work, double most_bytes,
                                                                      std::vector<std::string>& notes, const FileDoor* door = nullptr);

}  // namespace kadr
