#pragma once
// Prepares the collision check of the machine's solid bodies during a cut. It is used by cli/cut and view/part_run.

#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "session/cutting/machine_watch.h"
#include "session/session.h"

namespace kadr {

/// A blank or fixture, with the text by which the user has described it.
struct NamedWork {
  std::string name;
  std::string text;                   // description of the solid, in the form that body_of() reads
  std::shared_ptr<const Blank> body;  // nullptr: the work is cut exactly, as a body of revolution
};

/// Returns the blank of the job, followed by its fixtures.
///   stock, fixtures  descriptions of the blank and of each fixture
///   shown            descriptions of the fixtures as messages show them
std::vector<NamedWork> work_of(const CutJob& cut, const std::string& stock, const std::vector<std::string>& fixtures,
                               const std::vector<std::string>& shown);

/// Creates the collision check for the bodies of the session's machine. Returns nullptr if the machine has no bodies.
///   max_bytes  memory limit for the meshes of the bodies
///   notes      receives a sentence for each repair of a mesh file
///   door       opens the mesh files
///   returns    an error sentence if the bodies cannot be checked
tl::expected<std::unique_ptr<MachineWatch>, std::string> watch_bodies(const Session& session, const CutJob& cut,
                                                                      const std::vector<NamedWork>& work, double max_bytes,
                                                                      std::vector<std::string>& notes, const FileAccess* door = nullptr);

}  // namespace kadr
