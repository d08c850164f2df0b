// --state FILE: stores the memory of a control from one run to the next. This file is used by cli/run.

#include "cli/job/state.h"

#include <fmt/core.h>

#include "cli/options/options.h"
#include "config/state/state_check.h"
#include "texts/job.h"

namespace kadr::cli {
namespace {

/// Adds the stored rows to a table of the set-up. Rows that the set-up already contains are not changed.
template <class Map>
void under(Map& to, const Map& stored) {
  to.insert(stored.begin(), stored.end());
}

}  // namespace

std::optional<StateFile> open_state(const std::string& path, Job& job) {
  if (!job.def->machine_axes()) {
    complain(translated(texts::job::control_keeps_no_state, job.def->id));
    return std::nullopt;
  }
  const bool unchecked = state_is_unchecked(path);
  auto file = StateFile::open(path, job.def->id);
  if (!file) {
    complain(file.error());
    return std::nullopt;
  }
  const auto stored = file->load();
  if (!stored) {
    complain(stored.error());
    return std::nullopt;
  }
  const auto tables = setup_of(*stored);
  if (!tables) {
    complain(fmt::format("{}: {}", path, tables.error()));
    return std::nullopt;
  }
  if (unchecked) complain(translated(texts::job::state_without_checksums, path));
  Setup& setup = job.setup;
  for (const auto& [number, row] : tables->offsets)
    for (const char* const what : {"length", "radius"}) job.stated.insert(fmt::format("offsets.{}.{}", number, what));
  for (const auto& [name, axes] : tables->work_offsets) job.stated.insert("work_offsets." + name);
  under(setup.offsets, tables->offsets);
  under(setup.work_offsets, tables->work_offsets);
  under(setup.variables, tables->variables);
  under(setup.parameters, tables->parameters);
  under(setup.tool_table, tables->tool_table);
  under(setup.place_table, tables->place_table);
  under(setup.form_table, tables->form_table);
  return std::move(*file);
}

}  // namespace kadr::cli
