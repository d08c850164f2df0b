#pragma once
// Opens shared libraries while the program runs: the only place that calls dlopen(). In a browser there are none to open.

namespace kadr {

/// Opens a shared library, whose functions are only found by function_in().
///   whole    true: all functions that the library needs must be there at once; false: each when it is called first
///   returns  nullptr if the library is not installed, or where libraries cannot be opened
void* open_library(const char* file, bool whole = false);
/// Returns the address of a function of an open library; nullptr if the library lacks it.
void* function_in(void* library, const char* name);
/// Closes a library that is not wanted after all.
void close_library(void* library);

}  // namespace kadr
