// The program's standard output and error. Nothing that only tells may end a run: both are written without exceptions,
// and what stdout could not take is asked for once, when everything else is safe.
#pragma once

#include <string_view>

namespace validate {

/// Before anything is opened: a closed standard descriptor would become that of the next file. A reader that has gone,
/// or a limit on the size of files, becomes a failed write.
void prepare_streams();

/// Results, to stdout, at once.
void print_result(std::string_view text);

/// Remarks, to stderr; nobody misses what it could not take.
void print_remark(std::string_view text);

/// Throws Error (file failed) where a print_result() has failed since the start.
void check_results_printed();

}  // namespace validate
