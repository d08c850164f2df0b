// Orients the profile of a turning cycle, inserts its fillets and chamfers, and offsets the profile.

#include "control/linuxcnc/turning/profile.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace kadr::linuxcnc {
namespace {

constexpr double gap = 1e-2;        // if two offset pieces are further apart than this, an arc joins them; in the unit of the program
constexpr int max_steps = 100'000;  // greatest number of steps of an offset; each step is at most half the size of the smallest piece

tl::unexpected<std::string> endless() { return tl::unexpected(std::string()); }

}  // namespace

void Profile::quarter_turn() {
  for (Piece& piece : pieces) piece.quarter_turn();
  turned ^= 4U;
}

void Profile::face_down() {
  const Point delta = pieces.front().end - pieces.back().end;
  if (delta.imag() > 0) {
    for (Piece& piece : pieces) piece.mirror_x();
    turned ^= 2U;
  }
  if (delta.real() < 0) {
    for (Piece& piece : pieces) piece.mirror_z();
    turned ^= 1U;
  }
}

Turned Profile::check_falls() {
  Piece& lead_in = pieces.front();
  if (std::real(lead_in.end - lead_in.start) > 0) lead_in.start.real(lead_in.end.real());
  const bool falls = std::all_of(pieces.begin(), pieces.end(), [](const Piece& piece) { return piece.falls(); });
  return falls ? Turned() : tl::unexpected(std::string("Not monotonic"));
}

Turned Profile::place_corners() {
  for (auto at = std::next(pieces.begin()); at != pieces.end() && at != std::prev(pieces.end()); ++at)
    if (const Turned placed = place_corner(*std::prev(at), *at, *std::next(at)); !placed) return placed;
  pieces.remove_if([](const Piece& piece) { return piece.size() < least_piece; });
  return pieces.empty() ? Turned(endless()) : Turned();
}

/// Executes one step of an offset. The step is so small that it reverses the direction of no piece.
Turned Profile::offset_step(double distance) {
  for (Piece& piece : pieces) piece.offset(distance);
  pieces.remove_if([](const Piece& piece) { return piece.size() < least_piece; });
  if (pieces.empty()) return endless();

  for (auto at = pieces.begin(); at != std::prev(pieces.end()); ++at) {
    const auto after = std::next(at);
    if (std::real(at->end - after->start) <= gap) continue;
    Piece b = *at, a = *after;
    b.offset(-distance);
    a.offset(-distance);
    at = pieces.insert(after, Piece::arc(distance > 0, at->end, (b.end + a.start) / 2.0, after->start));
  }

  int left = max_steps;
  for (auto at = pieces.begin(); at != std::prev(pieces.end()); ++at) {
    if (--left == 0) return endless();
    if (!at->falls()) {
      if (at == pieces.begin()) return endless();
      const auto before = std::prev(at);
      pieces.erase(at->size() < before->size() ? at : before);
      at = pieces.begin();
      if (at == std::prev(pieces.end())) break;
    }
    const auto after = std::next(at);
    if (at->size() < least_piece) {
      pieces.erase(at);
      at = pieces.begin();
      if (at == std::prev(pieces.end())) break;
    } else if (const Turned met = join(*at, *after); !met) {
      return met;
    }
  }
  return {};
}

Turned Profile::offset(double distance) {
  const Point first = pieces.front().end - pieces.front().start, whole = pieces.back().start - pieces.front().start;
  if (std::imag(first / whole) < 0) distance = -distance;
  Piece lead_in = pieces.front();
  pieces.pop_front();
  if (pieces.empty()) return endless();
  double done = 0;
  for (int steps = 0; done != distance; ++steps) {
    if (steps == max_steps) return endless();
    double step = std::abs(distance - done);
    for (const Piece& piece : pieces) step = std::min(step, piece.size() / 2);
    if (distance < 0) step = -step;
    if (const Turned offset = offset_step(step); !offset) return offset;
    done += step;
  }
  for (auto at = pieces.begin(); at != std::prev(pieces.end()); ++at) {
    const auto after = std::next(at);
    at->end = after->start = (at->end + after->start) / 2.0;
  }
  lead_in.end = pieces.front().start;
  pieces.push_front(lead_in);
  return {};
}

Point Profile::on_machine(Point p) const {
  if ((turned & 2U) != 0) p = std::conj(p);
  if ((turned & 1U) != 0) p = -std::conj(p);
  return (turned & 4U) != 0 ? Point(0, 1) * p : p;
}

}  // namespace kadr::linuxcnc
