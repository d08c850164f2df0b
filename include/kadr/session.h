#pragma once
// Session: a program being run; step, snapshot, restore; the axes in time.

#include "session/session.h"
