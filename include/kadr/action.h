#pragma once
// What a program makes the machine do: an Action is a value, a Step an action with where the tool stood before it and when it happens.

#include "action/action.h"
#include "action/curve.h"  // length, points and extents of a motion
#include "action/step.h"
