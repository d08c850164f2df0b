#pragma once
// What the user asked for on the command line.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "control/control.h"

namespace kadr::cli {

/// Exit status (design.md 5).
enum Exit : int { ok = 0, alarms = 1, wrong_usage = 2 };

struct Options {
  std::vector<std::string> programs;
  std::string control;  // empty: guessed
  std::string machine;  // empty: generic
  std::string setup;
  std::string encoding;
  std::string trace;            // file, "-": stdout
  std::string plot;             // .svg or .png
  std::string state;            // file that keeps what survives power-off; empty: nothing is kept
  std::string lang;             // "ru", "en"; empty: by LANG
  std::string format = "text";  // of check: text, json, sarif
  std::vector<int> skip;        // switches that are on
  bool optional_stop = false;
  bool quiet = false;
  RunLimits limits;
};

Lang language(const Options& options);

/// Message of the program itself, to stderr.
void complain(const std::string& text);

int run(const Options& options);
int check(const Options& options);

struct ExplainOptions {
  std::string control;
  std::string code;  // empty: the whole control
  std::string lang;
  bool markdown = false;  // the page of docs/controls
};
int explain(const ExplainOptions& options);
int list_controls(const std::string& lang);

struct TapeOptions {
  bool decode = true;
  std::string input, output;
  std::string encoding;      // of the text
  std::size_t leader = 100;  // rows of blank tape
  std::string lang;
};
int tape(const TapeOptions& options);

}  // namespace kadr::cli
