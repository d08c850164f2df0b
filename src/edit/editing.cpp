// Edits a program. Used by cli/edit_command; tested by tests/edit.py.

#include "edit/editing.h"

#include <algorithm>

#include "edit/contour_reversal.h"
#include "edit/pattern.h"
#include "texts/edit.h"

namespace kadr {
namespace {

/// Returns a fault if a new tool number is that of another tool of the program.
tl::expected<void, EditFault> check_tools(const EditSpec& spec, const ControlDef& def) {
  if (spec.edits.tools.empty()) return {};
  const ProgramNames names = ProgramShape(spec.source_text, def, spec.stop).names();
  for (const auto& [from, to] : spec.edits.tools) {
    const bool moves_away =
        std::any_of(spec.edits.tools.begin(), spec.edits.tools.end(), [to = to](const auto& one) { return one.first == to; });
    if (!names.tools.contains(from)) return tl::unexpected(EditFault{0, translated(texts::edit::no_such_tool, from)});
    if (names.tools.contains(to) && !moves_away) return tl::unexpected(EditFault{0, translated(texts::edit::tool_is_used, to)});
  }
  return {};
}

tl::expected<void, EditFault> check_shift(const Edits& edits, const std::vector<std::string>& axes, const LineUses& use) {
  for (const auto& [axis, by] : edits.shift) {
    const auto at = std::find(axes.begin(), axes.end(), axis);
    if (at == axes.end()) return tl::unexpected(EditFault{0, translated(texts::edit::no_such_axis, axis)});
    if ((use.diameters() >> (at - axes.begin()) & 1U) != 0)
      return tl::unexpected(EditFault{0, translated(texts::edit::no_shift_of_diameters, axis)});
  }
  return {};
}

tl::expected<void, EditFault> check_systems(const Edits& edits, const ControlDef& def) {
  for (const auto& [from, to] : edits.work_systems)
    for (const SystemCode& system : {from, to})
      if (def.row_of('G', system.code) < 0)
        return tl::unexpected(EditFault{0, translated(texts::edit::no_such_system, system.code / 10.0)});
  return {};
}

/// A map of the XY plane needs the axes X and Y, and words that state no diameters.
tl::expected<void, EditFault> check_plane(const Edits& edits, const ControlDef& def, const std::vector<std::string>& axes) {
  if (!edits.plane && !edits.copies && !edits.reverses) return {};
  if (def.behaviour.lathe != Lathe::none || def.diameter != 0)
    return tl::unexpected(EditFault{0, translated(texts::edit::no_plane_of_lathe)});
  for (const char* const axis : {"X", "Y"})
    if (std::find(axes.begin(), axes.end(), axis) == axes.end())
      return tl::unexpected(EditFault{0, translated(texts::edit::no_such_axis, axis)});
  return {};
}

/// Writes the lines that are repeated or reversed, and notes them in the edits of the proof.
EditStatus patch(EditedSource& source, EditSpec& spec, LinePatches& patches) {
  const auto take = [&](auto&& made) -> EditStatus {
    if (!made) return tl::unexpected(made.error());
    patches = std::move(made->patches), spec.edits.pieces = std::move(made->pieces);
    source.patches = &patches;
    return {};
  };
  if (!spec.edits.places.empty()) return take(pattern_of(source, spec.edits, spec.stop));
  if (spec.edits.reverses) return take(reversed_contour(source, spec.edits, spec.stop));
  return {};
}

}  // namespace

tl::expected<Edited, EditFault> edited(const EditSpec& spec, const EditedSource& program) {
  const ControlDef& def = *program.control;
  if (auto status = check_tools(spec, def); !status) return tl::unexpected(status.error());
  if (auto status = check_systems(spec.edits, def); !status) return tl::unexpected(status.error());
  EditedSource source = program;
  LineUses use;
  if (needs_use(spec.edits)) {
    auto session = spec.old_program(spec.setup);
    if (!session) return tl::unexpected(EditFault{0, session.error()});
    const std::vector<std::string> axes = (*session)->control().axes();
    use = LineUses::of(std::move(*session), spec.stop);
    if (auto status = check_shift(spec.edits, axes, use); !status) return tl::unexpected(status.error());
    if (auto status = check_plane(spec.edits, def, axes); !status) return tl::unexpected(status.error());
    source.use = &use;
  }
  EditSpec proven = spec;
  LinePatches patches;
  if (auto status = patch(source, proven, patches); !status) return tl::unexpected(status.error());
  TextSpool made;
  auto changes = edit_program(source, spec.edits, spec.stop, [&made](std::string_view piece) { made.append(piece); });
  if (!changes) return tl::unexpected(changes.error());
  Edited result;
  result.text = made.source();
  result.changes = *changes;
  auto proof = prove_edit(proven, result.text);
  if (!proof) return tl::unexpected(EditFault{0, proof.error()});
  result.proof = std::move(*proof);
  result.pieces = std::move(proven.edits.pieces);
  return result;
}

}  // namespace kadr
