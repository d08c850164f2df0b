#pragma once
// A sink is a function that receives the Steps of a run. The headers below declare Kadr's own sinks; any function that accepts a Step is a
// sink too.

#include "out/picture/plot/plot.h"  // SVG, PNG
#include "out/text/summary.h"       // Statistics
#include "out/trace/trace.h"        // JSON Lines
