#pragma once
// Session: a program being run; the axes in time; snapshot, restore. What is made of it: stepping, any line of a long program, going on in
// mid program, the control's own block search, the axes' next position for a servo clock.

#include "session/block_search.h"
#include "session/checkpoints.h"
#include "session/player.h"
#include "session/restart.h"
#include "session/session.h"
#include "session/stepping.h"
