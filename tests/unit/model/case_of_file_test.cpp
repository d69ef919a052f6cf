#include "model/case_of_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/errors.h"
#include "curves/write_lines.h"
#include "model/build_model.h"
#include "model/case_file.h"

namespace knitmech::model {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kYarnAndTest =
    "[yarn]\ndiameter = \"0.12 mm\"\ndensity = \"1140 kg/m^3\"\nyoungs_modulus = \"1700 MPa\"\npoissons_ratio = 0.39\n"
    "[contact]\nfriction = 0.1\n";

/// Two parallel yarns of a wave each.
std::vector<curves::YarnLine> two_waves() {
  std::vector<curves::YarnLine> yarns(2);
  for (int i = 0; i <= 20; ++i) {
    yarns[0].points.emplace_back(0.5 * i, (i % 5) - 2, 0);
    yarns[1].points.emplace_back(0.5 * i, (i % 5) + 1, 0);
  }
  return yarns;
}

class CaseOfFile : public testing::Test {
 protected:
  CaseOfFile() {
    std::string name = (fs::temp_directory_path() / "knitmech-test-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    write("waves.csv", curves::csv_text(two_waves()));
    write("waves.bcc", curves::bcc_text(two_waves()));
  }
  ~CaseOfFile() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  [[nodiscard]] std::string complaint(const std::string& fabric, const std::string& more = "") const {
    try {
      static_cast<void>(parse_case(text(fabric) + more, "my.toml", folder_));
    } catch (const InputError& error) {
      return error.what();
    } catch (const FileError& error) {
      return std::string("file error: ") + error.what();
    }
    return "";
  }

  [[nodiscard]] static std::string text(const std::string& fabric) {
    return "title = \"Waves\"\n[fabric]\n" + fabric + kYarnAndTest;
  }

  fs::path folder_;
};

TEST_F(CaseOfFile, GivenATable_ThenTheCaseHoldsItsYarnsAndNeedsNoLoop) {
  const Case input = parse_case(text("yarns = \"waves.csv\"\n"), "my.toml", folder_);
  ASSERT_NE(input.fabric.yarn_file, nullptr);
  EXPECT_EQ(input.fabric.yarn_file->lines.yarns.size(), 2U);
  EXPECT_EQ(input.fabric.yarns, "yarns.csv");
  EXPECT_EQ(input.fabric.yarns_checksum, curves::checksum_of(input.fabric.yarn_file->bytes));
}

TEST_F(CaseOfFile, GivenACaseFileElsewhere_ThenThePathBeginsAtItsFolder) {
  fs::create_directories(folder_ / "cases");
  write("cases/my.toml", text("yarns = \"../waves.bcc\"\nfile_unit = \"2 mm\"\n"));
  const Case input = read_case_file(folder_ / "cases" / "my.toml");
  EXPECT_EQ(input.fabric.yarn_file->ending, ".bcc");
  EXPECT_EQ(input.fabric.file_unit, 2.0);
}

TEST_F(CaseOfFile, GivenTheTextOfACase_WhenItIsWrittenBesideACopy_ThenItReadsAsTheSameCase) {
  const Case input = parse_case(text("yarns = \"waves.bcc\"\nfile_unit = \"1 mm\"\n"), "my.toml", folder_);
  const std::string written = write_case(input);
  EXPECT_THAT(written, AllOf(HasSubstr("yarns = \"yarns.bcc\""), HasSubstr("yarns_checksum = "),
                             Not(HasSubstr("\n[loop]")), Not(HasSubstr("wales = ")), Not(HasSubstr("edge_yarn"))));
  write("yarns.bcc", input.fabric.yarn_file->bytes);
  const Case again = parse_case(written, "case.toml", folder_);
  EXPECT_EQ(first_difference(input, again), nullptr);
  EXPECT_EQ(write_case(again), written);
}

TEST_F(CaseOfFile, GivenAnotherFileThanTheChecksumIsOf_ThenItIsRefused) {
  EXPECT_THAT(complaint("yarns = \"waves.csv\"\nyarns_checksum = \"0123456789abcdef\"\n"),
              AllOf(HasSubstr("my.toml, line 3"), HasSubstr("is not the file that the case was written")));
}

TEST_F(CaseOfFile, GivenNoFolder_ThenTheTextIsRefusedWithAWayOut) {
  const auto mistakes = mistakes_in(text("yarns = \"waves.csv\"\n"), "case");
  ASSERT_EQ(mistakes.size(), 1U);
  EXPECT_EQ(mistakes[0].key(), "fabric.yarns");
  EXPECT_THAT(mistakes[0].what(), AllOf(HasSubstr("stands in no folder"), HasSubstr("knitmech run")));
}

TEST_F(CaseOfFile, GivenLoopsBesideAFile_ThenEachOfThemIsAMistake) {
  const std::string fabric = "yarns = \"waves.csv\"\nwales = 3\n";
  EXPECT_THAT(complaint(fabric), AllOf(HasSubstr("line 4: fabric.wales"), HasSubstr("beside fabric.yarns")));
  EXPECT_THAT(complaint("yarns = \"waves.csv\"\n", "[loop]\nheight = \"7 mm\"\n"), HasSubstr("loop.height"));
  EXPECT_THAT(complaint("yarns = \"waves.csv\"\n", "[edge_yarn]\ndiameter = \"1 mm\"\n"), HasSubstr("edge_yarn.dia"));
}

TEST_F(CaseOfFile, GivenAKeyOfAFileWithoutAFile_ThenItIsAMistake) {
  EXPECT_THAT(complaint("grip_depth = \"1 mm\"\n"), AllOf(HasSubstr("fabric.grip_depth"), HasSubstr("only with")));
}

TEST_F(CaseOfFile, GivenNoUnitOrTwo_ThenItIsRefused) {
  EXPECT_THAT(complaint("yarns = \"waves.bcc\"\n"), AllOf(HasSubstr("fabric.file_unit is missing"), HasSubstr("1 mm")));
  EXPECT_THAT(complaint("yarns = \"waves.csv\"\nfile_unit = \"1 mm\"\n"), HasSubstr("says its unit itself"));
}

TEST_F(CaseOfFile, GivenAClosedYarn_ThenItIsRefused) {
  std::vector<curves::YarnLine> yarns = two_waves();
  yarns[1].closed = true;
  write("ring.csv", curves::csv_text(yarns));
  EXPECT_THAT(complaint("yarns = \"ring.csv\"\n"), AllOf(HasSubstr("yarn 2 is closed"), HasSubstr("cut it open")));
}

TEST_F(CaseOfFile, GivenAFileThatIsMissingDamagedOrOfAnotherKind_ThenTheMessageNamesItAndTheLine) {
  EXPECT_THAT(complaint("yarns = \"none.csv\"\n"),
              AllOf(HasSubstr("file error: my.toml, line 3"), HasSubstr("none.csv"), HasSubstr("no such file")));
  EXPECT_THAT(complaint("yarns = \".\"\n"), HasSubstr("the ending tells the format"));
  EXPECT_THAT(complaint("yarns = \"waves.obj\"\n"), HasSubstr(".csv, .bcc or .yarns"));
  write("cut.bcc", curves::bcc_text(two_waves()).substr(0, 99));
  EXPECT_THAT(complaint("yarns = \"cut.bcc\"\nfile_unit = \"1 mm\"\n"),
              AllOf(HasSubstr("my.toml, line 3"), HasSubstr("cut.bcc: is damaged or cut off")));
}

TEST_F(CaseOfFile, GivenAnEndingInCapitals_ThenTheFileIsRead) {
  write("WAVES.CSV", curves::csv_text(two_waves()));
  EXPECT_EQ(complaint("yarns = \"WAVES.CSV\"\n"), "");
}

// The published test vectors of FNV-1a with 64 bits.
TEST(Checksum, GivenThePublishedTexts_ThenItIsFnv1a) {
  EXPECT_EQ(curves::checksum_of(""), "cbf29ce484222325");
  EXPECT_EQ(curves::checksum_of("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(curves::checksum_of("foobar"), "85944171f73967e8");
}

}  // namespace
}  // namespace knitmech::model
