#include "run/run_start.h"

#include <fmt/format.h>

#include <utility>

#include "base/errors.h"
#include "model/build_model.h"
#include "model/case_file.h"
#include "model/parameters.h"
#include "model/parameters_text.h"

namespace knitmech::run {
namespace {

namespace fs = std::filesystem;

std::string value_text(const model::Case& input, const model::Parameter& parameter) {
  const model::Value value = model::value_in(input, parameter);
  const bool is_empty = std::holds_alternative<std::monostate>(value);
  return is_empty ? "not given or \"auto\"" : model::toml_text(parameter, value);
}

void refuse_another_case(const fs::path& file, const model::Case& now, model::Case before) {
  before.output.checkpoint_every = now.output.checkpoint_every;
  const model::Parameter* const other = model::first_difference(now, before);
  if (other == nullptr) return;
  throw InputError(fmt::format("{}: {} is {}, but was {} when the run began; put it back, or start the run anew.",
                               file.string(), other->key, value_text(now, *other), value_text(before, *other)));
}

}  // namespace

fs::path default_folder(const fs::path& file) {
  const fs::path whole = fs::absolute(file).lexically_normal();
  const fs::path name = whole.filename();
  const bool named_by_folder = (name == "case.toml" || name == "study.toml") && whole.parent_path().has_filename();
  return "results" / (named_by_folder ? whole.parent_path().filename() : whole.stem());
}

std::optional<double> RunStart::resumed_at() const {
  if (!checkpoint) return std::nullopt;
  return checkpoint->record.history.back().strain;
}

RunStart new_run(const fs::path& case_file, const fs::path& folder) {
  return new_run(load_case(case_file), folder.empty() ? default_folder(case_file) : folder);
}

RunStart new_run(LoadedCase loaded, const fs::path& folder) {
  std::string text = model::write_case(loaded.input);
  return {std::move(loaded), std::move(text), folder, {}};
}

RunStart run_of(const model::Case& input, const fs::path& folder) {
  return new_run({.input = input, .model = model::build_model(input)}, folder);
}

RunStart earlier_run(const fs::path& folder) {
  results::Checkpoint checkpoint = results::read_checkpoint(folder);
  const fs::path file = folder / "case.toml";
  LoadedCase loaded = load_case(file);
  refuse_another_case(file, loaded.input, model::parse_case(checkpoint.case_text, file.string(), folder));
  std::string text = checkpoint.case_text;
  return {std::move(loaded), std::move(text), folder, std::move(checkpoint)};
}

}  // namespace knitmech::run
