#pragma once
// The user's options, as given on the command line.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "control/control.h"
#include "out/trace/sample_options.h"
#include "session/milling/mill_wish.h"

namespace kadr::cli {

/// Exit status.
enum Exit : int { ok = 0, alarms = 1, wrong_usage = 2 };

struct Options {
  std::vector<std::string> programs;
  std::string control;     // empty: guessed
  bool remembers = false;  // saves the control in the folder's .kadr.toml
  std::string machine;     // empty: generic
  std::string setup;
  std::string encoding;
  std::string trace;                           // file, "-": stdout
  std::string plot;                            // .svg or .png
  std::string samples;                         // file, "-": stdout
  std::string samples_tip;                     // file
  double rate = 1000;                          // of the samples, Hz
  double max_time = SampleOptions{}.max_time;  // of the samples, s
  std::vector<OverrideChange> overrides;
  std::string colour;      // of the plot: speed, limit; empty: by the type of motion
  std::string plot_speed;  // .svg or .png
  bool why = false;        // prints the lines that lose most time
  bool json = false;       // prints the summary as JSON, alone on standard output
  std::string files;       // folder for what the program writes; empty: it writes nothing
  std::string state;       // file that keeps what survives power-off; empty: nothing is kept
  std::string lang;        // "ru", "en"; empty: by LANG
  // options of check
  std::string format = "text";           // text, json, sarif
  std::string output;                    // for the findings; empty: text to stderr, other formats to stdout
  std::string baseline;                  // known findings: a list as --format json writes it
  std::vector<std::string> exclude;      // patterns of paths that are left out of folders
  std::vector<std::string> control_for;  // PATTERN=ID
  bool guesses_silently = false;         // prints no message about a guessed control
  std::string table;                     // a tools file that the programs are checked against; empty: the file next to each program
  bool strict = false;                   // warnings count as errors
  std::string explained;                 // id of a finding to be explained, instead of a check
  bool every = false;                    // prints every finding in full, however many are alike
  std::vector<std::string> disabled;     // ids of warnings and notes that are not reported
  std::vector<int> skip;                 // switches that are on
  std::uint32_t program = 0;             // number of the program on a tape with several; 0: the first, for check all
  bool optional_stop = false;
  bool quiet = false;
  std::string from, to;  // LINE[:PASS], LINE; empty: from the beginning, to the end
  RunLimits limits;
  std::vector<std::string> tools, zeros, correctors;  // applied over the set-up: "1:r8,l100", "G54=X-400", "17=-0.35"
};

Lang language(const Options& options);

/// Prints a message of Kadr itself to stderr.
void complain(const std::string& text);
/// Reports what cannot be written, and why. A reader that has gone (`| head`) is not reported: it has read enough.
///   error  errno
void complain_of_writing(const std::string& name, int error);

int run(const Options& options);
int debug(const Options& options);
int check(const Options& options);

struct CutOptions {
  Options run;
  std::string stock, tools;  // the value of --stock; the tools file
  double resolution = 0;     // mm; 0: chosen automatically
  std::vector<std::string> fixtures;
  std::string stock_zero;    // name of a work system; empty: the one of the first motion at feed
  std::string until;         // LINE or SECONDSs; empty: the end
  double max_memory = 1000;  // MB
  int threads = 0;           // 0: as many as the processor has
  bool coolant = false;      // coolant is required
  std::string part;          // a file; empty: the result is not compared
  double allow = -1;         // mm, allowed depth of a gouge; below 0: default
  double allow_left = -1;    // mm, allowed remaining stock; below 0: unlimited
  std::string window;        // X0,Y0,Z0,X1,Y1,Z1; empty: none
  std::string deviation;     // a file .ply
  double simplify = 0;       // mm by which the mesh of --out may differ; 0: it is exact
  std::string out, json;
  std::string blocks;  // file for a table of what each block removes
};
int cut(const CutOptions& options);

struct DiffOptions {
  std::string a, b;
  Options both;  // for both programs, except
  std::string control_a, control_b, setup_a, setup_b;
  double tolerance = 0.001;  // mm
  bool all = false;          // print all differences, not only the first
  bool no_messages = false, tools_by_hand = false, feeds_at_speed = false, feeds_rounded = false;  // as kadr convert proves: CompareRules
  std::string plot;                                                                                // .svg or .png
};
int diff(const DiffOptions& options);

struct ConvertOptions {
  std::string program;
  Options run;  // for the program under its own control
  std::string from, to, out, setup_out, way, encoding_out;
  bool flat = false, force = false, explain = false;
  double tolerance = 0;  // mm; 0: usual_tolerance() of convert
};
int convert(const ConvertOptions& options);

struct ReportOptions {
  CutOptions cut;  // with the options of the run; without a blank nothing is cut
  std::string out;
};
int report(const ReportOptions& options);
/// Prints the licence notices of Kadr's parts to standard output.
int print_licences();

struct ServeOptions {
  std::string state{};  // file with the states of machines at their panels; empty: none
  std::string folder = ".";
  std::string host = "127.0.0.1";
  int port = 8437;  // 0: a free one
  bool no_browser = false;
  bool open = false;         // anyone may look, without the token
  double max_memory = 2000;  // MB, of all sessions together
  std::string lang;
};
int serve(const ServeOptions& options);

struct ExplainOptions {
  std::string control;
  std::string code;  // empty: the whole control
  std::string lang;
  bool markdown = false;  // print the page of docs/controls
};
int explain(const ExplainOptions& options);
///   id  the control whose codes are listed; empty: all controls, one per line
int list_controls(const std::string& id, const std::string& lang);
///   id  the machine whose axes are described; empty: all machines, one per line
int list_machines(const std::string& id);

struct SetupOptions {
  Options program;
  std::string output;  // empty: stdout
  bool tools = false;  // write a tools file for kadr cut instead of a set-up
};
int write_setup(const SetupOptions& options);

struct TapeOptions {
  bool decode = true;
  std::string code;  // iso, eia; empty: detected from the rows; iso when writing
  std::string input, output;
  std::string encoding;      // of the text
  std::size_t leader = 100;  // rows of blank tape
  std::string lang;
};
int tape(const TapeOptions& options);

struct StateOptions {
  std::string file;
  bool recover = false;
  std::string out;      // of recover; empty: FILE.recovered
  std::string control;  // of recover, if the file no longer states it
  std::string lang;
};
int state(const StateOptions& options);

/// Lengths in mm; a negative length was not given.
struct MillOptions : MillWish {
  std::string contour, control, output, plot, lang;
  bool quiet = false;
};
int mill(const MillOptions& options);

}  // namespace kadr::cli
