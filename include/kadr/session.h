#pragma once
// Session: a program that is being executed, with the positions of the axes over time, and snapshot and restore. Built on it: stepping,
// access to any line of a long program, continuing in mid-program, the control's own block search, and the next axis positions for a
// servo clock.

#include "session/block_search.h"
#include "session/checkpoints.h"
#include "session/player.h"
#include "session/restart.h"
#include "session/session.h"
#include "session/stepping.h"
