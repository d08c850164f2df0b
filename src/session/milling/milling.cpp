// Converts a drawing to a milling program. This file is used by cli/mill and view/page/page_making, and tested by tests/mill.py and
// tests/session/milling_test.cpp.

#include "session/milling/milling.h"

#include <algorithm>
#include <cmath>

#include "out/program/words.h"
#include "session/program_moves.h"

namespace kadr {
namespace {

tl::expected<MillShape, DrawingFault> shape_to_mill(const MillRequest& request, std::string_view drawing) {
  const auto edges = read_drawing(drawing);
  if (!edges) return tl::unexpected(edges.error());
  auto chains = area::chained(*edges);
  if (!chains) return tl::unexpected(chains.error());
  if (request.task == "slot" && !chains->open.empty()) {
    const double width = request.width < 0 ? request.tool_diameter : request.width;
    const bool wider = width > request.tool_diameter;
    return MillShape{area::slot_zones(chains->open, width / 2), wider ? std::vector<Edges>() : chains->open};
  }
  auto zones = area::zones_of(*chains);
  if (!zones) return tl::unexpected(zones.error());
  if (request.task == "face")
    for (area::Zone& zone : *zones)
      for (Edge& e : zone.loops[0]) e.open = true;
  return MillShape{std::move(*zones), {}};
}

Result<area::Verified> path_over(const MillShape& shape, const area::Job& job) {
  if (shape.lines.empty()) return area::verified_path(shape.zones, job);
  auto path = area::slot_path(shape.lines, job);
  if (!path) return fail(path.error());
  const area::Outcome outcome = area::verified(shape.zones, job, path->moves);
  if (outcome.fault) return fail(*outcome.fault);
  return area::Verified{std::move(*path), outcome};
}

Technology technology_of(const MillRequest& request) {
  Technology technology;
  technology.feed = request.feed;
  technology.plunge_feed = request.plunge_feed < 0 ? std::max(1.0, std::round(request.feed / 3)) : request.plunge_feed;
  technology.speed = request.speed;
  technology.tool = request.tool;
  technology.coolant = request.coolant;
  technology.mark = request.mark;
  return technology;
}

/// Creates the program. Then the control's interpreter executes the program, and the resulting path is verified in the same way as the
/// original path.
Result<PartProgram> written_program(const MillRequest& request, const ControlDef& def, const area::Verified& path, const MillShape& shape,
                                    const area::Job& job) {
  auto program = part_program(def, path.path.moves, technology_of(request));
  if (!program) return program;
  const auto read = program_moves(def, program->text);
  if (!read) return fail(read.error());
  KADR_TRY(same_moves(program->moves, *read));
  if (const auto outcome = area::verified(shape.zones, job, *read); outcome.fault) return fail(*outcome.fault);
  return program;
}

}  // namespace

tl::expected<Milled, DrawingFault> milled(const MillRequest& request, std::string_view drawing, const ControlDef& def,
                                          const area::Watch& watch) {
  if (def.behaviour.lathe != Lathe::none) return drawing_fault(0, alarm(AlarmId::mill_lathe, {}, std::string_view(def.id)));
  auto job = mill_job(request);
  if (!job) return drawing_fault(0, job.error());
  job->watch = watch;
  job->level_step = Words(def, 'Z').increment();
  auto shape = shape_to_mill(request, drawing);
  if (!shape) return tl::unexpected(shape.error());
  auto path = path_over(*shape, *job);
  if (!path) return drawing_fault(0, path.error());
  auto program = written_program(request, def, *path, *shape, *job);
  if (!program) return drawing_fault(0, program.error());
  if (watch.stop.requested()) return drawing_fault(0, alarm(AlarmId::interrupted, {}));
  return Milled{std::move(*job), std::move(*shape), std::move(*path), std::move(*program)};
}

}  // namespace kadr
