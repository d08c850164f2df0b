#pragma once
// The user's options, as given on the command line.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "control/control.h"
#include "out/trace/sample_options.h"
#include "session/milling/mill_request.h"

namespace kadr::cli {

/// Exit status.
enum Exit : int { ok = 0, alarms = 1, wrong_usage = 2 };

struct Options {
  std::vector<std::string> programs;
  std::string control;     // id of the control, or its file; empty: the control is guessed
  bool remembers = false;  // save the control in the file .kadr.toml of the program's folder
  std::string machine;     // machine id; empty: the generic machine
  std::string setup;
  std::string encoding;
  std::string trace;                           // output file of the trace; "-": stdout
  std::string plot;                            // output file of the picture, .svg or .png
  std::string samples;                         // output file of the axis positions; "-": stdout
  std::string samples_tip;                     // output file of the tool tip positions
  double rate = 1000;                          // rate of the samples, Hz
  double max_time = SampleOptions{}.max_time;  // end of the samples, s
  std::vector<OverrideChange> overrides;
  std::string colour;                    // colour of the plot by speed or limit; empty: by the type of motion
  std::string plot_speed;                // output file of the speed diagram, .svg or .png
  bool why = false;                      // print the program lines that lose most time
  bool json = false;                     // print the summary as JSON, and nothing else on standard output
  std::string files;                     // folder for files that the program writes; empty: it writes none
  std::string state;                     // file with the data that survives power-off; empty: none is kept
  std::string lang;                      // "ru", "en"; empty: by the environment variable LANG
                                         // options of check
  std::string format = "text";           // text, json, sarif
  std::string output;                    // output file of the findings; empty: text to stderr, other formats to stdout
  std::string baseline;                  // file with known findings, as --format json writes it
  std::vector<std::string> exclude;      // patterns of paths in folders that are not checked
  std::vector<std::string> control_for;  // PATTERN=ID: control of the files that match
  bool guesses_silently = false;         // print no message about a guessed control
  std::string table;                     // tools file to check the programs against; empty: the file next to each program
  bool strict = false;                   // warnings count as errors
  std::string explained;                 // id of a finding to explain; the check is not run
  bool every = false;                    // print every finding in full, even if many are alike
  std::vector<std::string> disabled;     // ids of warnings and notes that are not reported
  std::vector<int> skip;                 // numbers of the block-skip switches that are on
  std::uint32_t program = 0;             // number of the program on a tape with several; 0: the first one, for check all of them
  bool optional_stop = false;
  bool quiet = false;
  std::string from, to;  // first line (LINE[:PASS]) and last line (LINE) to execute; empty: the whole program
  RunLimits limits;
  std::vector<std::string> tools, zeros, correctors;  // override the set-up: "1:r8,l100", "G54=X-400", "17=-0.35"
};

Lang language(const Options& options);

/// Prints a message of Kadr itself (error, remark) to stderr.
void complain(const std::string& text);
/// Reports which output cannot be written, and why. Reports nothing if the reader of a pipe has closed it (`| head`): it has read enough.
///   error  errno
void complain_of_writing(const std::string& name, int error);

int run(const Options& options);
int debug(const Options& options);
int check(const Options& options);

struct CutOptions {
  Options run;
  std::string stock, tools;  // blank: description of a body, or `guess`; tools: the tools file, or `guess`
  double resolution = 0;     // cell size, mm; 0: chosen automatically
  std::vector<std::string> fixtures;
  std::string stock_zero;    // name of a work system; empty: that of the first motion at feed
  std::string until;         // LINE, or SECONDS followed by s; empty: the end of the program
  double max_memory = 1000;  // memory limit, MB
  int threads = 0;           // number of threads; 0: as many as the processor has
  bool coolant = false;      // report cuts that are made without coolant
  std::string part;          // file of the target part; empty: no comparison
  double allow = -1;         // mm, allowed depth of a gouge; below 0: default
  double allow_left = -1;    // mm, allowed remaining stock; below 0: unlimited
  std::string window;        // box to be cut finely, X0,Y0,Z0,X1,Y1,Z1; empty: none
  std::string deviation;     // output file of the deviations, .ply
  double simplify = 0;       // mm by which the mesh of --out may be simplified; 0: exact
  std::string out, json;
  std::string blocks;  // output file for the table of what each block removes
};
int cut(const CutOptions& options);

struct DiffOptions {
  std::string a, b;
  Options both;  // options of both programs, except those in the next line
  std::string control_a, control_b, setup_a, setup_b;
  double tolerance = 0.001;  // greatest distance of equal paths, mm
  bool all = false;          // print all differences instead of the first one
  bool no_messages = false, tools_by_hand = false, feeds_at_speed = false, feeds_rounded = false;  // rules of kadr convert: CompareRules
  std::string plot;                                                                                // file, .svg or .png
};
int diff(const DiffOptions& options);

struct ConvertOptions {
  std::string program;
  Options run;  // how the program runs under its own control
  std::string from, to, out, setup_out, way, encoding_out;
  bool flat = false, force = false, explain = false;
  double tolerance = 0;  // allowed distance of the paths, mm; 0: usual_tolerance() of convert
};
int convert(const ConvertOptions& options);

struct ReportOptions {
  CutOptions cut;  // includes the options of the run; without a blank, the program only runs
  std::string out;
};
int report(const ReportOptions& options);
/// Prints the licences of the libraries that Kadr contains to standard output.
int print_licences();

struct ServeOptions {
  std::string state{};  // file with the saved states of the machines that clients operate; empty: none
  std::string folder = ".";
  std::string host = "127.0.0.1";
  int port = 8437;  // TCP port; 0: any free port
  bool no_browser = false;
  bool open = false;         // anyone may watch, without the access token
  double max_memory = 2000;  // memory limit of all sessions together, MB
  std::string lang;
};
int serve(const ServeOptions& options);

struct ExplainOptions {
  std::string control;
  std::string code;  // code to explain; empty: the whole control
  std::string lang;
  bool markdown = false;  // print the page of docs/controls as Markdown
};
int explain(const ExplainOptions& options);
///   id  control whose codes are listed; empty: list all controls, one per line
int list_controls(const std::string& id, const std::string& lang);
///   id  machine whose axes are described; empty: list all machines, one per line
int list_machines(const std::string& id);

struct SetupOptions {
  Options program;
  std::string output;  // output file; empty: stdout
  bool tools = false;  // write a tools file for kadr cut instead of a set-up
};
int write_setup(const SetupOptions& options);

struct TapeOptions {
  bool decode = true;
  std::string code;  // iso, eia; empty: detected when reading, iso when writing
  std::string input, output;
  std::string encoding;      // encoding of the text file
  std::size_t leader = 100;  // number of blank tape rows before the program
  std::string lang;
};
int tape(const TapeOptions& options);

struct StateOptions {
  std::string file;
  bool recover = false;
  std::string out;      // output file of recover; empty: FILE.recovered
  std::string control;  // control of recover, if the damaged file does not name it
  std::string lang;
};
int state(const StateOptions& options);

/// The options of kadr mill. Lengths are in mm; a negative value means that the option was not given.
struct MillOptions : MillRequest {
  std::string contour, control, output, plot, lang;
  bool quiet = false;
};
int mill(const MillOptions& options);

}  // namespace kadr::cli
