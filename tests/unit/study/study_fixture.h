#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "study/study_file.h"

namespace knitmech::study {

/// A folder with a base case that takes a tenth of a second: 2 x 2 stitches to 2 % strain.
class StudyFolder {
 public:
  StudyFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "knitmech-study-XXXXXX").string();
    path_ = mkdtemp(name.data());
    write("base.toml", R"(title = "base"
[loop]
height = "7 mm"
width = "3.9 mm"
head_flat = "0.2 mm"
head_radius = "1.1 mm"
foot_flat = "0.2 mm"
foot_radius = "1 mm"
[fabric]
wales = 2
courses = 2
course_spacing = "5 mm"
elements_per_erc = 6
[yarn]
diameter = "0.12 mm"
density = "1140 kg/m^3"
youngs_modulus = "1700 MPa"
poissons_ratio = 0.39
[contact]
friction = 0.1
[test]
kind = "wale-tension"
strain = 0.02
speed = "50 mm/s"
ramp = "5 ms"
[solver]
mass_scaling = 100
[output]
frames_at = [0.01, 0.02]
history_points = 40
)");
  }
  ~StudyFolder() { std::filesystem::remove_all(path_); }
  StudyFolder(const StudyFolder&) = delete;
  StudyFolder& operator=(const StudyFolder&) = delete;
  StudyFolder(StudyFolder&&) = delete;
  StudyFolder& operator=(StudyFolder&&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }

  /// The study of a text, as if it stood in this folder; "base" is given already.
  [[nodiscard]] Study study(const std::string& text) const {
    return parse_study("base = \"base.toml\"\n" + text, path_ / "study.toml");
  }

 private:
  std::filesystem::path path_;
};

}  // namespace knitmech::study
