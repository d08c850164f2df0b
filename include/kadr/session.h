#pragma once
// Session: a run of a program, with the positions of the axes over time, and with snapshot and restore. Further functions are built on
// Session: stepping, access to any line of a long program, a start in mid-program, the control's own block search, and the next axis
// positions for a servo clock.

#include "session/block_search.h"
#include "session/checkpoints.h"
#include "session/player.h"
#include "session/restart.h"
#include "session/session.h"
#include "session/stepping.h"
