// Computes the state of a finished run at an instant (Instants). Used by view/page/page_session; tested by tests/view/instant_test.cpp.

#include "view/instant.h"

#include <algorithm>

#include "config/language.h"
#include "texts/view.h"

namespace kadr {
namespace {

/// Returns the position of the tool at an instant at which the tool is moving to the vertex with the index `i` of `piece`.
Vec3 place_at(const ViewPiece& piece, std::size_t i, double instant) {
  const auto vec = [](const PathVertex& v) { return Vec3{double(v.at[0]), double(v.at[1]), double(v.at[2])}; };
  const PathVertex& to = piece.vertices[i];
  if (i == 0) return vec(to);
  const PathVertex& from = piece.vertices[i - 1];
  const double begins = PathRecord::time_of(piece, from), ends = PathRecord::time_of(piece, to);
  const double part = ends > begins ? std::clamp((instant - begins) / (ends - begins), 0.0, 1.0) : 1;
  return vec(from) + part * (vec(to) - vec(from));
}

}  // namespace

tl::expected<Session*, std::string> Instants::session(const StopToken& stop) {
  if (session_) return session_.get();
  auto program = run_.opened().program();
  if (!program) return tl::unexpected(program.error());
  auto made = Session::open(run_.opened().spec(std::move(*program), stop));
  if (!made) return tl::unexpected(in_thread_language(made.error().fault.en, made.error().fault.ru));
  session_ = std::move(*made);
  session_->control().holds_before = [this](const Origin& origin) {
    held_ = origin;
    return origin.number >= limit_;
  };
  Outlets& outlets = session_->outlets();
  outlets.silent = true;
  outlets.warning = [](const AlarmReport&) {};
  outlets.alarm = [](const AlarmReport&) { return false; };
  outlets.stop = stop;
  outlets.step = [this](const Step& step) {
    if (const Motion* const motion = step.motion(); motion != nullptr && motion->tool_radius > 0) compensated_by_ = motion->tool_radius;
  };
  return session_.get();
}

Session::State Instants::run(const StopToken& stop) {
  Session::State state = Session::State::running;
  while (state == Session::State::running && !stop.requested()) state = session_->go_on();
  return state;
}

/// Returns the tool radius in mm from the offset tables at the present block. If the program states a radius without an offset number, the
/// result is the radius by which the block's motions are compensated. Returns nullopt if no offset is in force.
std::optional<double> Instants::radius_in_force(const std::vector<InForce>& all) const {
  const auto number = std::find_if(all.begin(), all.end(), [](const InForce& one) { return one.kind == InForce::Kind::offset; });
  if (number != all.end() && number->value > 0) {
    const Setup tables = session_->settled_control().tables_now();
    const auto row = tables.offsets.find(int(number->value));
    return row == tables.offsets.end() ? 0 : row->second.whole_radius();
  }
  return compensated_by_ > 0 ? std::optional(compensated_by_) : std::nullopt;
}

/// Runs the session up to the block `number`, then to the end of this block, and stores what is in force at both instants.
Status Instants::reach(std::uint32_t number, InstantState& state, const StopToken& stop) {
  const auto& all = run_.checkpoints();
  auto from = std::partition_point(all.begin(), all.end(), [&](const RunCheckpoint& c) { return c.blocks <= number; });
  if (from != all.begin()) --from;
  KADR_TRY(session_->restore(from->snapshot));
  limit_ = number;
  held_ = {};
  (void)run(stop);
  if (held_.number == number) state.origin = held_;
  const Control& control = session_->settled_control();
  state.before = control.in_force();
  state.calls = control.calls();
  limit_ = number + 1;
  compensated_by_ = 0;
  (void)run(stop);
  state.after = session_->settled_control().in_force();
  state.lathe = session_->settled_control().lathe_modes();
  state.radius = radius_in_force(state.after);
  return {};
}

/// Returns where the path of a block ends; `otherwise` if the block has no path.
Vec3 Instants::end_of(std::uint32_t number, Vec3 otherwise) const {
  const auto& pieces = run_.path().pieces();
  auto piece = std::partition_point(pieces.begin(), pieces.end(), [&](const ViewPiece& p) { return p.vertices.front().number <= number; });
  if (piece == pieces.begin()) return otherwise;
  --piece;
  const auto after =
      std::partition_point(piece->vertices.begin(), piece->vertices.end(), [&](const PathVertex& v) { return v.number <= number; });
  return after != piece->vertices.begin() && (after - 1)->number == number ? (after - 1)->place() : otherwise;
}

tl::expected<InstantState, std::string> Instants::at(double instant, const StopToken& stop) {
  InstantState state;
  state.at = instant;
  const auto& pieces = run_.path().pieces();
  const auto ends_before = [&](const ViewPiece& p) { return PathRecord::time_of(p, p.vertices.back()) < instant; };
  auto piece = std::partition_point(pieces.begin(), pieces.end(), ends_before);
  if (pieces.empty()) return state;
  state.moves = piece != pieces.end();
  if (!state.moves) --piece;
  auto vertex = std::partition_point(piece->vertices.begin(), piece->vertices.end(),
                                     [&](const PathVertex& v) { return PathRecord::time_of(*piece, v) < instant; });
  if (vertex == piece->vertices.end()) --vertex;
  state.vertex = *vertex;
  state.place = place_at(*piece, std::size_t(vertex - piece->vertices.begin()), instant);
  state.block_end = state.moves ? end_of(vertex->number, state.place) : state.place;
  state.origin.line = vertex->line;
  state.origin.file = vertex->file;
  state.origin.number = vertex->number;
  return complete(std::move(state), vertex->number, stop);
}

tl::expected<InstantState, std::string> Instants::after(std::uint32_t number, const StopToken& stop) {
  InstantState state;
  number = std::min<std::uint32_t>(number, std::uint32_t(run_.blocks()));
  const auto& pieces = run_.path().pieces();
  const auto begins_after = [&](const ViewPiece& p) { return p.vertices.front().number <= number; };
  auto piece = std::partition_point(pieces.begin(), pieces.end(), begins_after);
  if (piece != pieces.begin()) {
    --piece;
    auto vertex =
        std::partition_point(piece->vertices.begin(), piece->vertices.end(), [&](const PathVertex& v) { return v.number <= number; });
    if (vertex != piece->vertices.begin()) --vertex;
    state.vertex = *vertex;
    state.moves = vertex->number == number;
    state.at = PathRecord::time_of(*piece, *vertex);
    state.place = state.block_end = place_at(*piece, std::size_t(vertex - piece->vertices.begin()), state.at);
  }
  state.origin.line = state.vertex.line;
  state.origin.file = state.vertex.file;
  state.origin.number = number;
  return complete(std::move(state), number, stop);
}

tl::expected<InstantState, std::string> Instants::complete(InstantState state, std::uint32_t number, const StopToken& stop) {
  if (!run_.checkpoints().empty()) {
    const auto made = session(stop);
    if (!made) return tl::unexpected(made.error());
    if (const Status reached = reach(number, state, stop); !reached) return tl::unexpected(std::string(name_of(reached.error().id)));
    if (stop.requested()) return tl::unexpected(translated(texts::view::interrupted));
  }
  state.line = run_.control().line_at(state.origin);
  return state;
}

std::vector<Instants::Pass> Instants::passes(std::uint32_t line, std::uint16_t file, std::size_t most, std::size_t& count) const {
  std::vector<Pass> passes;
  count = 0;
  std::uint32_t last = ~std::uint32_t{0};
  double before = 0;
  for (const ViewPiece& piece : run_.path().pieces())
    for (const PathVertex& v : piece.vertices) {
      const double time = PathRecord::time_of(piece, v);
      if (v.line == line && v.file == file) {
        if (v.number != last) {
          if (++count <= most) passes.push_back({before, time, v.number});
        } else if (count <= most && !passes.empty()) {
          passes.back().to = time;
        }
        last = v.number;
      }
      before = time;
    }
  return passes;
}

}  // namespace kadr
