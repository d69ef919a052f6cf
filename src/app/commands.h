#pragma once

#include <optional>
#include <string>
#include <vector>

namespace knitmech::app {

/// How the program ends, for scripts.
using ExitCode = int;
inline constexpr ExitCode kDone = 0;
inline constexpr ExitCode kWrongInput = 2;   ///< a case file or the command line
inline constexpr ExitCode kNotFinished = 3;  ///< the simulation was interrupted or could not go on
inline constexpr ExitCode kFileTrouble = 4;  ///< a file cannot be read or written

struct NewOptions {
  std::string file;    ///< empty: to standard output
  bool force = false;  ///< replaces a file that is there
  bool json = false;
};

struct CheckOptions {
  std::string case_file;
  bool json = false;
};

struct RunOptions {
  std::string case_file;
  std::string folder;  ///< empty: results/<name of the case>
  std::string resume;  ///< folder of a run to go on with, in place of case_file and folder; empty: a new run
  bool quiet = false;
  bool json = false;
  bool pictures = true;
  std::optional<int> threads;  ///< empty: as many as serve the fabric
};

struct ReportOptions {
  std::string folder;  ///< of a run
  bool json = false;
};

struct StudyOptions {
  std::string study_file;
  std::string folder;          ///< empty: results/<name of the study>
  std::optional<int> jobs;     ///< runs at a time; empty: one per processor
  std::optional<int> threads;  ///< of each run; empty: its share of the processors
  bool list = false;           ///< only says what would be run
  bool quiet = false;
  bool json = false;
};

struct ExportOptions {
  std::string source;  ///< a case file or the folder of a run
  std::string format;
  std::string file;              ///< empty: to standard output
  std::optional<int> frame;      ///< of a run; empty with strain empty: the last one
  std::optional<double> strain;  ///< [-]; the nearest stored frame
  int sides = 12;                ///< of a tube
  bool json = false;
};

struct LintOptions {
  std::string file;  ///< a deck
  bool json = false;
};

/// Quantities are texts with a unit, empty where they are not given.
struct YarnOptions {
  std::vector<std::string> files;
  std::string diameter, linear_density, density;
  std::string gauge_length;
  std::string load_column, extension_column;  ///< names in the files
  std::string from_force;                     ///< the strain is counted from this force on
  std::vector<double> range{0, 0.1};          ///< two strains, over which E is fitted
  std::optional<double> poissons_ratio;
  bool curve = false;  ///< the section block has the measured curve in place of E
  std::string folder;  ///< empty: results/<name of the first file>
  bool json = false;
};

/// Texts are the words of the command line, empty where they are not given.
struct RenderOptions {
  std::string run;               ///< folder of the run
  std::optional<int> frame;      ///< empty with strain empty: the last one
  std::optional<double> strain;  ///< [-]; the nearest stored frame
  std::string colour = "plain", view = "front";
  std::vector<double> window;                      ///< left, right, bottom, top; empty: the whole fabric
  int width = 0;                                   ///< [px]; 0: as the proportions of the fabric ask for
  std::optional<int> height;                       ///< [px]
  std::vector<double> range;                       ///< two ends of the colours; empty: of what is drawn
  std::string film;                                ///< "stretch" or "turn"; empty: a picture
  bool contact_map = false, side_profile = false;  ///< one of these in place of a picture
  double pictures_per_second = 20;
  double seconds = 4;       ///< that the film takes
  bool same_range = false;  ///< the colours span the values of all stored frames
  std::string file;         ///< empty: in the folder pictures/ of the run
  bool json = false;
};

/// Quantities are texts with a unit, empty where they are not given.
struct CompareOptions {
  std::string run;  ///< folder
  std::vector<std::string> files;
  std::string gauge_length, width;            ///< of the specimens; empty: those of the run
  std::string load_column, extension_column;  ///< names in the files
  std::vector<std::string> samples;           ///< names of the specimens to take; empty: all
  std::vector<double> at;                     ///< strains
  std::string offset;                         ///< a strain, or "auto"; empty: none
  std::string folder;                         ///< empty: `compare` in the folder of the run
  bool json = false;
};

struct UiOptions {
  std::string named;   ///< a case file or the folder of a run to begin with; empty: the first example
  std::string folder;  ///< of the cases; empty: the present one
  std::string host = "127.0.0.1";
  std::optional<int> port;  ///< empty: the usual one if it is free
  bool browser = true;      ///< opens the page in one
};

struct ParametersOptions {
  bool markdown = false;
  bool json = false;
};

/// Each command does what its help says and returns the exit code; InputError and FileError are for the caller to
/// report.
ExitCode run_command(const NewOptions& options);
ExitCode run_command(const CheckOptions& options);
ExitCode run_command(const RunOptions& options);
ExitCode run_command(const ReportOptions& options);
ExitCode run_command(const StudyOptions& options);
ExitCode run_command(const ExportOptions& options);
ExitCode run_command(const LintOptions& options);
ExitCode run_command(const YarnOptions& options);
ExitCode run_command(const RenderOptions& options);
ExitCode run_command(const CompareOptions& options);
ExitCode run_command(const UiOptions& options);
ExitCode run_command(const ParametersOptions& options);

}  // namespace knitmech::app
