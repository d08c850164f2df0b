#pragma once
// What the user asked for on the command line.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "control/control.h"
#include "out/trace/sample_options.h"
#include "session/milling/mill_wish.h"

namespace kadr::cli {

/// Exit status (design.md 5).
enum Exit : int { ok = 0, alarms = 1, wrong_usage = 2 };

struct Options {
  std::vector<std::string> programs;
  std::string control;     // empty: guessed
  bool remembers = false;  // the control, in the folder's .kadr.toml
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
  std::string colour;      // of the plot: speed, limit; empty: by the kind of motion
  std::string plot_speed;  // .svg or .png
  bool why = false;        // the lines that lose most time
  bool json = false;       // the summary is JSON, alone on standard output
  std::string files;       // folder for what the program writes; empty: it writes nothing
  std::string state;       // file that keeps what survives power-off; empty: nothing is kept
  std::string lang;        // "ru", "en"; empty: by LANG
  // of check
  std::string format = "text";           // text, json, sarif
  std::string output;                    // of its findings; empty: text to stderr, others to stdout
  std::string baseline;                  // known findings: a list as --format json writes it
  std::vector<std::string> exclude;      // patterns of paths in folders
  std::vector<std::string> control_for;  // PATTERN=ID
  bool guesses_silently = false;         // which control: nothing is said of it
  std::string table;                     // a tools file that the programs are held against; empty: what lies beside each
  bool strict = false;                   // warnings count as errors
  std::string explained;                 // a finding's id: what it means, instead of a check
  bool every = false;                    // each finding is printed whole, however many are alike
  std::vector<std::string> disabled;     // ids of warnings and notes that are not told
  std::vector<int> skip;                 // switches that are on
  std::uint32_t program = 0;             // number of one on a tape with several; 0: the first, of check all
  bool optional_stop = false;
  bool quiet = false;
  std::string from, to;  // LINE[:PASS], LINE; empty: from the beginning, to the end
  RunLimits limits;
  std::vector<std::string> tools, zeros, correctors;  // laid over the set-up: "1:r8,l100", "G54=X-400", "17=-0.35"
};

Lang language(const Options& options);

/// Message of the program itself, to stderr.
void complain(const std::string& text);
/// What cannot be written, and why. Of a reader that has gone (`| head`) nothing is said: it has had enough.
///   error  errno
void complain_of_writing(const std::string& name, int error);

int run(const Options& options);
int debug(const Options& options);
int check(const Options& options);

struct CutOptions {
  Options run;
  std::string stock, tools;  // what --stock says; the tools file
  double resolution = 0;     // mm; 0: chosen
  std::vector<std::string> fixtures;
  std::string stock_zero;    // name of a work system; empty: that of the first motion at feed
  std::string until;         // LINE or SECONDSs; empty: the end
  double max_memory = 1000;  // MB
  int threads = 0;           // 0: as many as the processor has
  bool coolant = false;      // is demanded
  std::string part;          // a file; empty: nothing to hold the result against
  double allow = -1;         // mm that a gouge may be deep; below 0: left out
  double allow_left = -1;    // mm that may be left on; below 0: any
  std::string window;        // X0,Y0,Z0,X1,Y1,Z1; empty: none
  std::string deviation;     // a file .ply
  double simplify = 0;       // mm that the mesh of --out may be off; 0: it is exact
  std::string out, json;
  std::string blocks;  // a table of what each block takes away
};
int cut(const CutOptions& options);

struct DiffOptions {
  std::string a, b;
  Options both;  // of both programs, but for
  std::string control_a, control_b, setup_a, setup_b;
  double tolerance = 0.001;                                                                        // mm
  bool all = false;                                                                                // differences; else the first ones
  bool no_messages = false, tools_by_hand = false, feeds_at_speed = false, feeds_rounded = false;  // as kadr convert proves: CompareRules
  std::string plot;                                                                                // .svg or .png
};
int diff(const DiffOptions& options);

struct ConvertOptions {
  std::string program;
  Options run;  // of the program under its own control
  std::string from, to, out, setup_out, way, encoding_out;
  bool flat = false, force = false, explain = false;
  double tolerance = 0;  // mm; 0: usual_tolerance() of convert
};
int convert(const ConvertOptions& options);

struct ReportOptions {
  CutOptions cut;  // with the options of the run; no blank: nothing is cut
  std::string out;
};
int report(const ReportOptions& options);
/// Notices of what the program is made of, to standard output.
int print_licences();

struct ServeOptions {
  std::string state{};  // file in which machines at their panels are kept; empty: none
  std::string folder = ".";
  std::string host = "127.0.0.1";
  int port = 8437;  // 0: a free one
  bool no_browser = false;
  bool open = false;         // who does not know the token may look
  double max_memory = 2000;  // MB, of all sessions together
  std::string lang;
};
int serve(const ServeOptions& options);

struct ExplainOptions {
  std::string control;
  std::string code;  // empty: the whole control
  std::string lang;
  bool markdown = false;  // the page of docs/controls
};
int explain(const ExplainOptions& options);
/// `id`: of the control whose codes are told; empty: all controls, a line each.
int list_controls(const std::string& id, const std::string& lang);
/// `id`: of the machine whose axes are told; empty: all machines, a line each.
int list_machines(const std::string& id);

struct SetupOptions {
  Options program;
  std::string output;  // empty: stdout
  bool tools = false;  // a tools file for kadr cut is written, no set-up
};
int write_setup(const SetupOptions& options);

struct TapeOptions {
  bool decode = true;
  std::string code;  // iso, eia; empty: as the rows say, to be written iso
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
  std::string control;  // of recover, where the file no longer says
  std::string lang;
};
int state(const StateOptions& options);

/// Lengths in mm; what is negative here was not given.
struct MillOptions : MillWish {
  std::string contour, control, output, plot, lang;
  bool quiet = false;
};
int mill(const MillOptions& options);

}  // namespace kadr::cli
