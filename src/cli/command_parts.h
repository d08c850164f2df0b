#pragma once
// The parts that command_line.cpp assembles: each adds its commands. Their texts are written in both languages (told.h).

#include <array>

#include "cli/command_line.h"

namespace kadr::cli {

/// run, debug, check, setup (program_commands.cpp).
void add_run(CLI::App& app, Commands& commands);
void add_debug(CLI::App& app, Commands& commands);
void add_check(CLI::App& app, Commands& commands);
void add_setup(CLI::App& app, Commands& commands);
/// mill (mill_command.cpp).
void add_mill(CLI::App& app, Commands& commands);

/// cut (cut_command.cpp).
void add_cut(CLI::App& app, Commands& commands);

/// diff (diff.cpp).
void add_diff(CLI::App& app, Commands& commands);
/// convert (convert.cpp).
void add_convert(CLI::App& app, Commands& commands);

/// report (report_command.cpp).
void add_report(CLI::App& app, Commands& commands);

/// --stock and --tools of cut and report, returned in this order, and --fixture (cut_command.cpp).
std::array<CLI::Option*, 2> blank_options(CLI::App& app, CutOptions& options);
/// --resolution.
void cell_option(CLI::App& app, CutOptions& options);

/// serve (serve.cpp).
void add_serve(CLI::App& app, Commands& commands);

/// The argument and the options of a program, for all commands that read one (program_commands.cpp).
void program_argument(CLI::App& app, Options& options);
void program_options(CLI::App& app, Options& options);
/// --files, for the commands in which a program writes nothing.
void memory_option(CLI::App& app, Options& options);

void control_option(CLI::App& app, std::string& control);
void language_option(CLI::App& app, std::string& lang);
void quiet_option(CLI::App& app, bool& quiet);

}  // namespace kadr::cli
