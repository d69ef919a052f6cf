#pragma once

#include <string>

#include "results/read_run.h"
#include "serve/request_words.h"

namespace knitmech::serve {

/// A PNG file of a stored frame as `knitmech render` makes it. \param words "frame" (else the last), "colour", "view",
/// "width" and "height" [px]; each may be missing. Throws InputError for a word that means nothing.
[[nodiscard]] std::string run_picture_png(const results::StoredRun& run, const RequestWords& words);

}  // namespace knitmech::serve
