#pragma once
// Prepares the collision check of the machine's bodies in a cut. Used by cli/cut and view/part_run.

#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "session/cutting/machine_watch.h"
#include "session/session.h"

namespace kadr {

/// A blank or fixture, as the user has named it.
struct NamedWork {
  std::string name;
  std::string text;  // as body_of() reads it
  std::shared_ptr<const Blank> body;
};

/// Blank and fixtures of the job, in this order.
///   stock, fixtures  texts that describe them
///   shown            the texts of the fixtures as messages show them
std::vector<NamedWork> work_of(const CutJob& cut, const std::string& stock, const std::vector<std::string>& fixtures,
                               const std::vector<std::string>& shown);

/// Creates the watch of the bodies of the session's machine; returns nullptr if the machine has none.
///   most_bytes  limit for the memory of their meshes
///   notes       receives what had to be repaired in their files
///   door        opens their files
///   returns     an error sentence if they cannot be watched
tl::expected<std::unique_ptr<MachineWatch>, std::string> watch_bodies(const Session& session, const CutJob& cut,
                                                                      const std::vector<NamedWork>& work, double most_bytes,
                                                                      std::vector<std::string>& notes, const FileDoor* door = nullptr);

}  // namespace kadr
