#pragma once
// Kadr's own sinks of Steps. One of your own: any function that takes a Step.

#include "out/picture/plot.h"  // SVG, PNG
#include "out/text/summary.h"  // Statistics
#include "out/trace/trace.h"   // JSON Lines
