// Functions that are not done yet say so.

#include "control/functions.h"

namespace kadr::functions {

Status machine_axis(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status increment_axis(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status argument_only(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status auxiliary_word(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status spindle_word(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status spindle_axis_word(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status tool_call(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status length_number(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status radius_number(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status thread(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status dwell_or_turns(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status smoothing(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status cylinder_mode(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status set_tables(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status set_tables_end(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status diameter_switch(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status polar_surface_on(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status polar_surface_off(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status polar_data_on(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status polar_data_off(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status select_plane(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status work_area_on(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status work_area_off(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status reference_return(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status measure(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status measure_length(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status radius_side(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status length_comp(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status mirror_on(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status mirror_off(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status transform_off(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status local_system(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status machine_move(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status work_system(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status work_system_extended(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status new_system(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status feed_control(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status css_on(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status css_off(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status drilling(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status drilling_off(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status turning_cycle(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status turning_simple(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status not_available(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status macro_call(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status macro_modal(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status macro_modal_off(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status spindle_code(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status gear_range(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status exchange_tool(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status interrupt_on(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status interrupt_off(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status call_program(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }
Status return_program(Machinery&, const Call& call) { return fail(alarm(AlarmId::not_available, call.where, call.row != nullptr ? call.row->code : std::string())); }

}  // namespace kadr::functions
