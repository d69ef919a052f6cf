#pragma once

#include <string>

#include "results/read_run.h"
#include "run/export_case.h"
#include "serve/request_words.h"

namespace knitmech::serve {

/// One file of an export, since a download takes one at a time. Throws InputError like run::exported(), Refusal with
/// 404 if the format has no file of that ending.
[[nodiscard]] std::string exported_file(const run::ExportSource& source, const std::string& format,
                                        const std::string& ending);

/// The same of a stored frame of a run. \param words "format", "ending", and "frame" (else the last)
[[nodiscard]] std::string run_geometry(const results::StoredRun& run, const RequestWords& words);

}  // namespace knitmech::serve
