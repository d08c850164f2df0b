#pragma once
// Portions: the bricks of a blank's lattice, divided among processes that each cut their own (kadr cut --portion). A process also cuts the
// bricks next to its own, because the surface of a brick depends on them. So the results of all portions together are those of one process,
// bit for bit.
//
//       ┌────┬────┐
//       │ 1  │ 2  │   four portions of a lattice; portion 1 also holds the dotted bricks
//       │    ┊····│
//       ├┄┄┄┄┼────┤
//       │····│    │
//       └────┴────┘

#include "stock/brick/lattice.h"

namespace kadr {

/// One of `count` portions; `number` is 1 to `count`.
struct Portion {
  int number = 1, count = 1;
  bool operator==(const Portion&) const = default;
};

/// Returns the bricks of a portion. The lattice is divided along its two longest axes, into rows and columns of about the same number of
/// bricks, as square as possible. A portion is empty if there are more portions than bricks along an axis.
///   law  each brick belongs to exactly one of the portions   (tests/stock/portion_test)
BrickBox bricks_of(const Lattice& lattice, Portion portion);

/// Returns the box, enlarged by one brick to all sides within `all`; an empty box remains empty.
BrickBox with_neighbours(const BrickBox& box, const BrickBox& all);

/// A box without bricks: of a process that joins what others have cut.
inline constexpr BrickBox no_bricks{};

}  // namespace kadr
