#pragma once
// The options of the user, with the values that the command line states.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "control/control.h"
#include "edit/edits.h"
#include "out/trace/sample_options.h"
#include "session/milling/mill_request.h"

namespace kadr::cli {

/// Exit status.
enum Exit : int { ok = 0, alarms = 1, wrong_usage = 2 };

struct Options {
  std::vector<std::string> programs;
  std::string control;     // id of the control, or name of a control's file; empty: the control is guessed
  bool remembers = false;  // true: the control is stored in the file .kadr.toml of the program's folder
  std::string machine;     // id of the machine; empty: the generic machine is used
  std::string setup;
  std::string encoding;
  std::string trace;                           // output file of the trace; "-": standard output
  std::string plot;                            // output file of the picture, which ends in .svg or .png
  std::string samples;                         // output file of the axis positions; "-": standard output
  std::string samples_tip;                     // output file of the tool tip positions
  double rate = 1000;                          // rate at which positions are sampled, Hz
  double max_time = SampleOptions{}.max_time;  // time of the last sample, s
  std::vector<OverrideChange> overrides;
  std::string colour;      // what the colours of the picture show: speed or limit; empty: the type of motion
  std::string plot_speed;  // output file of the speed diagram, which ends in .svg or .png
  bool why = false;        // true: the program lines that lose the most time are printed
  bool json = false;       // true: standard output contains only the summary as JSON
  std::string files;       // folder for files that the part program writes; empty: it writes no files
  std::string state;       // file with the data that survive power-off; empty: no data is stored
  // language of all output, "ru" or "en"; empty: the environment variable LANG determines the language
  std::string lang;
  // the following options belong to the command check
  std::string format = "text";           // format of the findings: text, json or sarif
  std::string output;                    // output file of the findings; empty: text goes to stderr, other formats go to stdout
  std::string baseline;                  // file with known findings, in the format of --format json
  std::vector<std::string> exclude;      // patterns of paths; matching files in folders are not checked
  std::vector<std::string> control_for;  // texts of the form PATTERN=ID, which state the control of the files whose names match the pattern
  bool guesses_silently = false;         // true: no message about a guessed control is printed
  // tools file with which the tools of the programs are compared; empty: the tools file in the same folder as each program
  std::string table;
  bool strict = false;                // true: warnings count as errors
  std::string explained;              // id of a finding that is explained instead of a check
  bool every = false;                 // true: every finding is printed in full, even if it is repeated often
  std::vector<std::string> disabled;  // ids of warnings and notes that are not reported
  std::vector<int> skip;              // numbers of the block-skip switches that are on
  // number of the program on a tape with several programs; 0: the first program, or all programs for the command check
  std::uint32_t program = 0;
  bool optional_stop = false;
  bool quiet = false;
  std::string from, to;  // first line (LINE[:PASS]) and last line (LINE) that are executed; empty: the whole program
  RunLimits limits;
  std::vector<std::string> tools, zeros, correctors;  // values that override the set-up, e.g. "1:r8,l100", "G54=X-400", "17=-0.35"
};

Lang language(const Options& options);

/// Prints a message of Kadr itself (error, remark) on stderr.
void complain(const std::string& text);
/// Reports which output cannot be written, and the reason. Reports nothing if the reader of a pipe has closed it (`| head`), since that
/// reader needs no more output.
///   error  errno of the write error
void complain_of_writing(const std::string& name, int error);

int run(const Options& options);
int debug(const Options& options);
int check(const Options& options);

struct CutOptions {
  Options run;
  std::string stock, tools;  // blank: description of a solid, or `guess`; tools: name of the tools file, or `guess`
  double resolution = 0;     // cell size of the stock, mm; 0: chosen automatically
  std::vector<std::string> fixtures;
  std::string stock_zero;         // name of the blank's work offset; empty: that of the first motion at feed
  std::string until;              // LINE, or SECONDS followed by s, at which cutting ends; empty: the end of the program
  double max_memory = 1000;       // memory limit, MB
  int threads = 0;                // number of threads; 0: the number of processor cores
  bool coolant = false;           // true: cuts without coolant are reported
  std::string part;               // file of the target part; empty: the result is not compared
  double allow = -1;              // permitted depth of a gouge, mm; less than 0: the default
  double allow_left = -1;         // permitted thickness of remaining stock, mm; less than 0: unlimited
  std::string window;             // box that is cut with finer cells, X0,Y0,Z0,X1,Y1,Z1 in mm; empty: no window
  std::string portion;            // "2/4": the portion of the bricks that this process cuts into the file `out`; empty: it cuts all
  std::vector<std::string> join;  // files of portions that this process joins
  std::string deviation;          // output file of the deviations, which ends in .ply
  double simplify = 0;            // tolerance for simplifying the mesh of --out, mm; 0: the mesh is not simplified
  std::string out, json;
  std::string blocks;  // output file of the table that states what each block removes
};
int cut(const CutOptions& options);

struct DiffOptions {
  std::string a, b;
  Options both;  // options that apply to both programs, except those of the next member
  std::string control_a, control_b, setup_a, setup_b;
  double tolerance = 0.001;  // greatest distance at which paths count as equal, mm
  bool all = false;          // true: all differences are printed; false: only the first ones
  // rules of the comparison for kadr convert: CompareRules
  bool no_messages = false, tools_by_hand = false, feeds_at_speed = false, feeds_rounded = false;
  // output file of the picture, which ends in .svg or .png
  std::string plot;
};
int diff(const DiffOptions& options);

struct ConvertOptions {
  std::string program;
  Options run;  // options with which the program runs on its own control
  std::string from, to, out, setup_out, method, encoding_out;
  bool flat = false, force = false, explain = false;
  double tolerance = 0;  // permitted distance between the two paths, mm; 0: usual_tolerance() of the conversion
};
int convert(const ConvertOptions& options);

struct EditOptions {
  std::string program;
  Options run;  // options with which the program runs
  Edits edits;
  std::string out;       // output file; empty: standard output
  double tolerance = 0;  // permitted distance between the paths of the old and the new program, mm; 0: the usual one
};
int edit(const EditOptions& options);

struct ReportOptions {
  CutOptions cut;  // options of the cut, including those of the run; if no blank is stated, the program only runs
  std::string out;
  std::string live;  // the page of a live report; empty: the report has the results only
};
int report(const ReportOptions& options);
/// Prints on standard output the licences of the libraries that Kadr contains.
int print_licences();

struct ServeOptions {
  std::string state{};  // file with the stored states of the machines that clients operate; empty: no states are stored
  std::string folder = ".";
  std::string host = "127.0.0.1";
  int port = 8437;  // TCP port of the server; 0: any free port
  bool no_browser = false;
  bool open = false;                // true: clients without the access token may watch the sessions
  double max_memory = 2000;         // memory limit of all sessions together, MB
  std::vector<std::string> drives;  // ports with real machines that the pages may use; "found": all under /dev/serial/by-id
  int baud = 115200;                // rate of these ports, bit/s
  std::string drive_log = "kadr-drive.log";
  std::string lang;
};
int serve(const ServeOptions& options);

struct LspOptions {
  bool stdio = false;  // accepted because editors state it; it has no effect
  std::string lang;
};
int serve_language(const LspOptions& options);
int serve_debugging(const LspOptions& options);

/// The options of kadr drive.
struct DriveOptions {
  Options run;
  std::string program;   // empty with --status
  std::string port;      // device, or tcp:HOST:PORT
  std::string settings;  // file with the recorded answers of a controller, which is used instead of a port
  std::string log = "kadr-drive.log";
  int baud = 115200;
  double ahead = 0;  // greatest time of motion in the controller's buffers, s; 0: no limit
  bool go = false, status = false, home = false, unlock = false;
  bool check = false;                 // lets the controller read the whole program in its check mode first
  std::uint32_t from = 0;             // line at which to begin; 0: at the beginning
  std::optional<double> clear;        // height above which the way to this line is free, machine coordinates, mm
  double spin_up = 3;                 // time for the spindle to reach its speed before the tool goes to a line, s
  int feed = 100;                     // feed override at the beginning, %
  std::vector<std::string> accepted;  // rows of the proof that the user accepts
  std::string out;                    // file for the lines that are sent; empty: none
};
int drive_machine(const DriveOptions& options);

/// The options of kadr dnc.
struct DncOptions {
  Options run;
  std::string task;     // send, receive or serve
  std::string file;     // the program, the file for a received program, or the folder of programs
  std::string port;     // device
  std::string profile;  // id of a profile (drive/dnc/dnc_profile.h)
  int baud = 0;         // rate of the line, bit/s; 0: that of the profile
  double silence = 3;   // time after which a received program is complete, s
  bool unchecked = false;
};
int exchange_programs(const DncOptions& options);

struct ExplainOptions {
  std::string control;
  std::string code;  // code that is explained; empty: the whole control is described
  std::string lang;
  bool markdown = false;  // true: the page of docs/controls is printed as Markdown
};
int explain(const ExplainOptions& options);
/// Lists the codes of a control, or all controls.
///   id  the control whose codes are listed; empty: all controls are listed, one per line
int list_controls(const std::string& id, const std::string& lang);
/// Describes a machine, or lists all machines.
///   id  the machine whose axes are described; empty: all machines are listed, one per line
int list_machines(const std::string& id);

struct SetupOptions {
  Options program;
  std::string output;  // output file; empty: stdout
  bool tools = false;  // true: a tools file for kadr cut is written instead of a set-up
};
int write_setup(const SetupOptions& options);

struct TapeOptions {
  bool decode = true;
  std::string code;  // tape code: iso or eia; empty: detected when a tape is read, iso when a tape is written
  std::string input, output;
  std::string encoding;      // encoding of the text file
  std::size_t leader = 100;  // number of blank tape rows before the program
  std::string lang;
};
int tape(const TapeOptions& options);

struct StateOptions {
  std::string file;
  bool recover = false;
  std::string out;      // output file of the command recover; empty: FILE.recovered
  std::string control;  // control for the command recover, if the damaged file does not name the control
  std::string lang;
};
int state(const StateOptions& options);

/// The options of kadr mill. Lengths are in mm. A negative value means that the user has not given the option.
struct MillOptions : MillRequest {
  std::string contour, control, output, plot, lang;
  bool quiet = false;
};
int mill(const MillOptions& options);

}  // namespace kadr::cli
