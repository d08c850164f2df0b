#pragma once
// The functions with which command_line.cpp assembles the command line. Each function adds commands or options. Their texts are in the
// language of the calling thread.

#include <array>

#include "cli/options/command_line.h"

namespace kadr::cli {

/// Adds the commands run, debug, check and setup (program_commands.cpp).
void add_run(CLI::App& app, Commands& commands);
void add_debug(CLI::App& app, Commands& commands);
void add_check(CLI::App& app, Commands& commands);
void add_setup(CLI::App& app, Commands& commands);
/// Adds the command mill (mill_command.cpp).
void add_mill(CLI::App& app, Commands& commands);

/// Adds the command cut (cut_command.cpp).
void add_cut(CLI::App& app, Commands& commands);

/// Adds the command diff (diff.cpp).
void add_diff(CLI::App& app, Commands& commands);
/// Adds the command convert (convert.cpp).
void add_convert(CLI::App& app, Commands& commands);
/// Adds the command edit (edit_command.cpp).
void add_edit(CLI::App& app, Commands& commands);

/// Adds the command report (report_command.cpp).
void add_report(CLI::App& app, Commands& commands);

/// Adds the options --stock, --tools and --fixture of the commands cut and report, and returns the first two (cut_command.cpp).
std::array<CLI::Option*, 2> blank_options(CLI::App& app, CutOptions& options);
/// Adds the option --resolution.
void cell_option(CLI::App& app, CutOptions& options);

/// Adds the command serve (serve.cpp).
void add_serve(CLI::App& app, Commands& commands);
/// Adds the command drive (drive_command.cpp).
void add_drive(CLI::App& app, Commands& commands);
/// Adds the command dnc (dnc_command.cpp).
void add_dnc(CLI::App& app, Commands& commands);
/// Adds the commands lsp and dap (lsp_command.cpp).
void add_lsp(CLI::App& app, Commands& commands);

/// Adds the argument for the program and the options of the program, for all commands that read a program (program_commands.cpp).
void program_argument(CLI::App& app, Options& options);
void program_options(CLI::App& app, Options& options);
/// Adds --files, the folder of the program memory, for commands during which the program itself writes no files.
void memory_option(CLI::App& app, Options& options);

void control_option(CLI::App& app, std::string& control);
void language_option(CLI::App& app, std::string& lang);
void quiet_option(CLI::App& app, bool& quiet);

}  // namespace kadr::cli
