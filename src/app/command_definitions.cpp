#include "app/command_definitions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/text.h"
#include "picture/picture_words.h"
#include "run/export_case.h"

namespace knitmech::app {
namespace {

constexpr int kMostThreads = 1024;

/// The type of an option whose words are checked elsewhere, as CLI::IsMember writes it.
std::string choices(const std::vector<std::string_view>& words) {
  return fmt::format("TEXT:{{{}}}", fmt::join(words, ","));
}

template <class Options>
void on_parse(CLI::App& command, Action& action, std::shared_ptr<Options> options) {
  command.callback([&action, options] { action = [options] { return run_command(*options); }; });
}

void add_new(CLI::App& app, Action& action) {
  auto options = std::make_shared<NewOptions>();
  CLI::App& command = *app.add_subcommand("new", "Write a commented case file");
  command.add_option("FILE", options->file, "Where to; without it, to standard output");
  command.add_flag("--force", options->force, "Replace FILE if it is there");
  command.add_flag("--json", options->json, "Write which file was written as JSON, for scripts, and nothing else");
  on_parse(command, action, options);
}

void add_check(CLI::App& app, Action& action) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App& command = *app.add_subcommand("check", "Read a case, build its fabric and say what would be run");
  command.add_option("CASE", options->case_file, "Case file")->required();
  command.add_flag("--json", options->json, "Write the outcome as JSON, for scripts, and nothing else");
  on_parse(command, action, options);
}

void add_run(CLI::App& app, Action& action) {
  auto options = std::make_shared<RunOptions>();
  CLI::App& command = *app.add_subcommand("run", "Simulate the test of a case and leave a folder of results");
  CLI::Option* const new_case = command.add_option("CASE", options->case_file, "Case file");
  CLI::Option* const folder =
      command
          .add_option(
              "-o,--output", options->folder,
              "Folder for the results (default: results/ and the name of CASE, or of its folder if it is called "
              "case.toml); an earlier run in it is replaced")
          ->type_name("FOLDER");
  command.add_option("--resume", options->resume, "Go on with the run in this folder from its last checkpoint")
      ->type_name("FOLDER")
      ->excludes(new_case, folder);
  command.add_flag("--quiet", options->quiet, "Write nothing but errors");
  command.add_flag("--json", options->json, "Write the outcome as JSON, for scripts, and nothing else");
  command.add_flag_callback(
      "--no-pictures", [options] { options->pictures = false; }, "Draw no pictures, and write no report");
  command
      .add_option("--threads", options->threads,
                  "Threads of the solver (default: one per processor, or fewer where the fabric is too small to keep "
                  "them busy); the results are the same for any number")
      ->check(CLI::Range(1, kMostThreads));
  command.footer(
      "Ctrl-C ends the run and keeps what was computed, and --resume goes on from there; a second one ends the program "
      "at once.");
  command.callback([&action, options] {
    if (options->case_file.empty() && options->resume.empty()) throw CLI::RequiredError("CASE");
    action = [options] { return run_command(*options); };
  });
}

void add_report(CLI::App& app, Action& action) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App& command = *app.add_subcommand("report", "Write the report of a run: one page, and its figures as files");
  command.add_option("RUN", options->folder, "Folder of the run")->required();
  command.add_flag("--json", options->json, "Write which file was written as JSON, for scripts, and nothing else");
  on_parse(command, action, options);
}

void add_study(CLI::App& app, Action& action) {
  auto options = std::make_shared<StudyOptions>();
  CLI::App& command = *app.add_subcommand("study", "Run many cases that differ in some parameters; leaves one table");
  command.add_option("STUDY", options->study_file, "Study file")->required();
  command
      .add_option("-o,--output", options->folder,
                  "Folder for the results (default: results/ and the name of STUDY, or of its folder if it is called "
                  "study.toml)")
      ->type_name("FOLDER");
  command.add_option("--jobs", options->jobs, "Runs at the same time (default: one per processor)")
      ->check(CLI::Range(1, kMostThreads));
  command.add_option("--threads", options->threads, "Threads of each run (default: its share of the processors)")
      ->check(CLI::Range(1, kMostThreads));
  command.add_flag("--list", options->list, "Only say what would be run");
  command.add_flag("--quiet", options->quiet, "Write nothing but errors");
  command.add_flag("--json", options->json, "Write the table as JSON, for scripts, and nothing else");
  command.footer(
      "Ctrl-C ends the study and keeps what was computed. The same command goes on with it: what is done is not done "
      "again.");
  on_parse(command, action, options);
}

std::vector<std::string_view> format_names() {
  std::vector<std::string_view> names;
  for (const run::ExportFormat& each : run::export_formats()) names.emplace_back(each.name);
  return names;
}

std::string formats_text() {
  std::string text = "Formats:\n";
  for (const run::ExportFormat& each : run::export_formats()) {
    text += fmt::format("  {:<16} {} ({})\n", each.name, each.label, fmt::join(each.endings, ", "));
  }
  return text;
}

void add_export(CLI::App& app, Action& action) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App& command = *app.add_subcommand("export", "Write the model of a case for other programs");
  command.add_option("CASE", options->source, "Case file, or the folder of a run")->required();
  command.add_option("-f,--format", options->format, "One of those below")
      ->required()
      ->type_name(choices(format_names()));
  command
      .add_option("-o,--output", options->file,
                  "Where to; without it, to standard output. Several files get this name with their own endings")
      ->type_name("FILE");
  CLI::Option* const frame = command.add_option(
      "--frame", options->frame, "Of a run and a geometry: number of a stored frame (default: the last)");
  command.add_option("--strain", options->strain, "Take the stored frame that is nearest to this strain, as 0.16")
      ->excludes(frame);
  command.add_option("--sides", options->sides, "Of the polygon that stands for a round yarn (default: 12)");
  command.footer(formats_text());
  command.add_flag("--json", options->json, "Write which files were written as JSON, for scripts, and nothing else");
  on_parse(command, action, options);
}

void add_lint(CLI::App& app, Action& action) {
  auto options = std::make_shared<LintOptions>();
  CLI::App& command = *app.add_subcommand("lint", "Check an Abaqus deck against the syntax of its keywords");
  command.add_option("DECK", options->file, "Input file for Abaqus/Explicit")->required();
  command.add_flag("--json", options->json, "Write the findings as JSON, for scripts, and nothing else");
  on_parse(command, action, options);
}

void add_column_options(CLI::App& command, std::string& load, std::string& extension) {
  command.add_option("--load-column", load,
                     "Name of the column to take, where it does not say force or stress, as \"Fmax\"; with its unit "
                     "behind it where the file has none, as \"Fmax [N]\"");
  command.add_option("--extension-column", extension, "The same for strain or displacement, as \"axial_strain [-]\"");
}

void add_yarn(CLI::App& app, Action& action) {
  auto options = std::make_shared<YarnOptions>();
  CLI::App& command = *app.add_subcommand("yarn", "Read tensile tests of a yarn and make the [yarn] section of a case");
  command.add_option("CURVE", options->files, "Files of tensile curves (CSV), one or several specimens each")
      ->required();
  command.add_option("--diameter", options->diameter,
                     "Of the yarn, as \"0.12 mm\"; for E and for stresses in the files");
  command.add_option("--linear-density", options->linear_density,
                     "As \"20 tex\"; for forces per tex in the files. Two of diameter, linear density and density tell "
                     "the third");
  command.add_option("--density", options->density, "As \"1140 kg/m^3\"");
  command.add_option("--gauge-length", options->gauge_length,
                     "Length between the grips, as \"100 mm\"; for displacements in the files");
  add_column_options(command, options->load_column, options->extension_column);
  command.add_option("--from-force", options->from_force,
                     "Count the strain from where the force stays above this, as \"5 mN\"; takes slack away");
  command.add_option("--range", options->range, "Two strains between which E is fitted (default: 0 0.1)")->expected(2);
  command.add_option("--poissons-ratio", options->poissons_ratio, "For the section (default: 0.39)");
  command.add_flag("--curve", options->curve, "Put the measured curve into the section, in place of E");
  command
      .add_option(
          "-o,--output", options->folder,
          "Folder for yarn.toml, yarn.svg and mean-curve.csv (default: results/ and the name of the first CURVE)")
      ->type_name("FOLDER");
  command.add_flag("--json", options->json, "Write the result as JSON, for scripts, and nothing else");
  on_parse(command, action, options);
}

void add_render(CLI::App& app, Action& action) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App& command = *app.add_subcommand("render", "Draw pictures and films of a finished run");
  command.add_option("RUN", options->run, "Folder of the run")->required();
  CLI::Option* const frame =
      command.add_option("--frame", options->frame, "Number of a stored frame (default: the last)");
  command.add_option("--strain", options->strain, "Take the stored frame that is nearest to this strain, as 0.16")
      ->excludes(frame);
  command
      .add_option("--colour,--color", options->colour,
                  fmt::format("What the colour tells: {}", base::alternatives(picture::colour_words())))
      ->type_name(choices(picture::colour_words()));
  command.add_option("--view", options->view, "From where it is seen")->type_name(choices(picture::view_words()));
  CLI::Option* const map = command.add_flag(
      "--contact-map", options->contact_map,
      "Draw a map of the contacts (SVG): discs as large as the normal force, coloured by stick and slip");
  CLI::Option* const profile = command.add_flag("--side-profile", options->side_profile,
                                                "Draw the fabric from the side as a chart (SVG): z over y");
  profile->excludes(map);
  command
      .add_option("--animate", options->film,
                  "Make a film: stretch, the stored frames one after the other and what is between them on straight "
                  "lines; turn, one frame turning about y")
      ->excludes(map, profile)
      ->check(CLI::IsMember({"stretch", "turn"}));
  command.add_option("--fps", options->pictures_per_second, "Pictures of the film per second (default: 20)");
  command.add_option("--seconds", options->seconds, "That the film takes (default: 4)");
  command
      .add_option("--window", options->window,
                  "Part of the fabric: its left, right, bottom and top as shares of the whole, as 0 0.5 0.5 1")
      ->expected(4);
  command.add_option("--width", options->width, "Of the picture in px (default: as the fabric asks for)");
  command.add_option("--height", options->height, "Of the picture in px (default: 1400, of a film 720)");
  CLI::Option* const range = command.add_option("--range", options->range,
                                                "Values at the two ends of the colours (default: those of the frame)");
  range->expected(2);
  command.add_flag("--same-range", options->same_range, "Let the colours span the values of all frames of the run")
      ->excludes(range);
  command
      .add_option("-o,--output", options->file,
                  "Where to: a .png, a film a .webp, a map or a chart a .svg (default: in the folder pictures of "
                  "RUN, named by what it shows)")
      ->type_name("FILE");
  command.add_flag("--json", options->json, "Write which file was written as JSON, for scripts, and nothing else");
  on_parse(command, action, options);
}

void add_compare(CLI::App& app, Action& action) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App& command =
      *app.add_subcommand("compare", "Lay a simulated curve over measured ones and say how far they are apart");
  command.add_option("RUN", options->run, "Folder of a run")->required();
  command.add_option("CURVE", options->files, "Files of measured curves (CSV), one or several specimens each")
      ->required();
  command.add_option(
      "--gauge-length", options->gauge_length,
      "Length between the grips of the specimens, as \"100 mm\", for displacements in the files (default: "
      "that of the run)");
  command.add_option("--width", options->width,
                     "Of the specimens, as \"50 mm\", for forces in the files (default: that of the run's fabric)");
  add_column_options(command, options->load_column, options->extension_column);
  command
      .add_option("--sample", options->samples, "Name of a specimen to take, of several in the files; may be repeated")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--at", options->at, "Strains at which to tell the difference, as 0.1 0.2 (default: four)");
  command.add_option("--offset", options->offset,
                     "Slack of the specimens, a strain that is taken from theirs, as 0.02; auto: that with the least "
                     "difference (default: none)");
  command
      .add_option("-o,--output", options->folder,
                  "Folder for compare.csv, compare.json and compare.svg (default: compare in RUN)")
      ->type_name("FOLDER");
  command.add_flag("--json", options->json, "Write the result as JSON, for scripts, and nothing else");
  on_parse(command, action, options);
}

void add_ui(CLI::App& app, Action& action) {
  auto options = std::make_shared<UiOptions>();
  CLI::App& command = *app.add_subcommand("ui", "Open the page: design, run and explore fabrics in the browser");
  command.add_option("CASE_OR_RUN", options->named, "Case file or folder of a run to begin with");
  command
      .add_option("--folder", options->folder,
                  "Folder that the page may read and write, with the runs in its folder results (default: the "
                  "present one)")
      ->type_name("FOLDER");
  command.add_option("--port", options->port, "Port to listen at; 0: any that is free (default: 8642, or any)")
      ->check(CLI::Range(0, 65535));
  command
      .add_option("--host", options->host,
                  "Address to listen at. Any other than 127.0.0.1 lets other computers in: whoever knows the "
                  "address that is printed can write to the folder")
      ->capture_default_str();
  command.add_flag("!--no-browser", options->browser, "Open no browser, only print the address");
  on_parse(command, action, options);
}

void add_parameters(CLI::App& app, Action& action) {
  auto options = std::make_shared<ParametersOptions>();
  CLI::App& command = *app.add_subcommand("parameters", "List every key of a case file with unit, default and range");
  command.add_flag("--markdown", options->markdown, "As the page docs/input-reference.md");
  command.add_flag("--json", options->json, "Write the table as JSON, for scripts, and nothing else");
  on_parse(command, action, options);
}

}  // namespace

void define_commands(CLI::App& app, Action& action) {
  add_new(app, action);
  add_check(app, action);
  add_run(app, action);
  add_report(app, action);
  add_render(app, action);
  add_compare(app, action);
  add_study(app, action);
  add_yarn(app, action);
  add_export(app, action);
  add_lint(app, action);
  add_ui(app, action);
  add_parameters(app, action);
}

}  // namespace knitmech::app
