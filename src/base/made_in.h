#pragma once
// Values made where they stay.

#include <new>
#include <type_traits>

namespace kadr {

/// Overwrites `place` with what `make` returns, built there: no copy. A copy of what has just been stored number by number is loaded
/// in larger pieces, for which the processor waits until all has reached the cache.
///   law  `make` does not look at `place`
template <class T, class Make>
void made_in(T& place, const Make& make) {
  static_assert(std::is_trivially_destructible_v<T> && std::is_same_v<T, std::invoke_result_t<const Make&>>);
  ::new (static_cast<void*>(&place)) T(make());
}

}  // namespace kadr
