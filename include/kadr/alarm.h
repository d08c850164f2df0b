#pragma once
// Alarms as data, and their texts for people.

#include "base/alarm.h"
#include "base/result.h"
#include "config/alarm_texts.h"
#include "out/text/alarm_print.h"  // AlarmReport: an alarm with its location
