#pragma once
// Alarms as data, and what a person is told of them.

#include "base/alarm.h"
#include "base/result.h"
#include "config/alarm_texts.h"
#include "out/text/alarm_print.h"  // an alarm with its place: AlarmReport
