#pragma once
// construct_in_place(): constructs a value directly at its destination in memory.

#include <new>
#include <type_traits>

namespace kadr {

/// Overwrites `place` with the result of `make`, constructed there without a copy. A copy would read several numbers at once just after
/// they were written one by one, and the processor would stall until these writes have reached the cache.
///   law  `make` must not read `place`
template <class T, class Make>
void construct_in_place(T& place, const Make& make) {
  static_assert(std::is_trivially_destructible_v<T> && std::is_same_v<T, std::invoke_result_t<const Make&>>);
  ::new (static_cast<void*>(&place)) T(make());
}

}  // namespace kadr
