#pragma once
// The functions with which command_line.cpp assembles the command line: each adds commands or options. Their texts are in the language that
// is set for the calling thread.

#include <array>

#include "cli/options/command_line.h"

namespace kadr::cli {

/// Adds run, debug, check and setup (program_commands.cpp).
void add_run(CLI::App& app, Commands& commands);
void add_debug(CLI::App& app, Commands& commands);
void add_check(CLI::App& app, Commands& commands);
void add_setup(CLI::App& app, Commands& commands);
/// Adds mill (mill_command.cpp).
void add_mill(CLI::App& app, Commands& commands);

/// Adds cut (cut_command.cpp).
void add_cut(CLI::App& app, Commands& commands);

/// Adds diff (diff.cpp).
void add_diff(CLI::App& app, Commands& commands);
/// Adds convert (convert.cpp).
void add_convert(CLI::App& app, Commands& commands);

/// Adds report (report_command.cpp).
void add_report(CLI::App& app, Commands& commands);

/// Adds --fixture, and returns --stock and --tools, which it adds too: options of cut and report (cut_command.cpp).
std::array<CLI::Option*, 2> blank_options(CLI::App& app, CutOptions& options);
/// Adds --resolution.
void cell_option(CLI::App& app, CutOptions& options);

/// Adds serve (serve.cpp).
void add_serve(CLI::App& app, Commands& commands);

/// Adds the program argument and its options, for all commands that read a program (program_commands.cpp).
void program_argument(CLI::App& app, Options& options);
void program_options(CLI::App& app, Options& options);
/// Adds --files, the folder of the program memory, for commands in which the program writes no files.
void memory_option(CLI::App& app, Options& options);

void control_option(CLI::App& app, std::string& control);
void language_option(CLI::App& app, std::string& lang);
void quiet_option(CLI::App& app, bool& quiet);

}  // namespace kadr::cli
