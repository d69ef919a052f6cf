#include "serve/export_file.h"

#include <fmt/format.h>

#include <utility>

#include "base/errors.h"
#include "base/text.h"
#include "results/read_frame.h"
#include "serve/constants.h"
#include "serve/refusal.h"

namespace knitmech::serve {

std::string exported_file(const run::ExportSource& source, const std::string& format, const std::string& ending) {
  for (run::ExportedFile& file : run::exported(source, run::export_format(format))) {
    if (file.ending == ending) return std::move(file.bytes);
  }
  throw Refusal(404, fmt::format("the format {} has no file that ends in {}", format, base::in_quotes(ending)));
}

std::string run_geometry(const results::StoredRun& run, const RequestWords& words) {
  const int index = whole_number(words, "frame", kMostFrames).value_or(run.frames.back().index);
  const model::Frame frame = results::read_frame(run, index);
  const run::ExportSource source{
      .input = run.input, .model = run.model, .frame = &frame, .stem = run.dir.filename().string()};
  return exported_file(source, word(words, "format").value_or(""), word(words, "ending").value_or(""));
}

}  // namespace knitmech::serve
