#pragma once
// Kadr's own sinks of Steps. A sink of your own is any function that accepts a Step.

#include "out/picture/plot.h"  // SVG, PNG
#include "out/text/summary.h"  // Statistics
#include "out/trace/trace.h"   // JSON Lines
