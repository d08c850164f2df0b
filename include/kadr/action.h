#pragma once
// What a program makes the machine do. An Action is a value; a Step is an Action with its time and the tool's position before it.

#include "action/action.h"
#include "action/curve.h"  // length, points and extents of a motion
#include "action/step.h"
