#pragma once
// A sink is a function that receives the Steps of a run. These are Kadr's own sinks; a sink of yours is any function that accepts a Step.

#include "out/picture/plot/plot.h"  // SVG, PNG
#include "out/text/summary.h"       // Statistics
#include "out/trace/trace.h"        // JSON Lines
