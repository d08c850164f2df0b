#pragma once
// grbl_proof: compares what a controller states of itself with what a program needs of it, row by row, before anything moves.

#include <string>
#include <vector>

#include "drive/grbl/grbl_job.h"
#include "drive/grbl/grbl_settings.h"

namespace kadr::drive {

enum class Verdict : std::uint8_t {
  right,    // the controller has what the program needs
  note,     // the program runs, but not as it states: the user should know
  refused,  // the program would do something else, or damage: nothing moves unless the user accepts the row
};

struct ProofRow {
  std::string id;          // by which the user accepts the row: "travel-x"
  std::string what;        // in the language of the thread
  std::string controller;  // what the controller has
  std::string program;     // what the program needs
  Verdict verdict = Verdict::right;
  std::string why;  // a sentence; empty if the row is right
};

///   setup    the user's set-up, whose work offsets must be those of the controller, as far as it states them
///   homed    the machine position is known: homing was done in this conversation
std::vector<ProofRow> grbl_proof(const GrblSettings& settings, const JobNeeds& needs, const Setup& setup, bool homed);

}  // namespace kadr::drive
