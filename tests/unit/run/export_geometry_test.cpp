#include "run/export_geometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "../../support/straight_yarn.h"
#include "base/errors.h"

namespace knitmech::run {
namespace {

using testing::HasSubstr;

const model::Case kCase;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<ExportFormat> geometry_formats() {
  std::vector<ExportFormat> formats;
  std::ranges::copy_if(export_formats(), std::back_inserter(formats),
                       [](const ExportFormat& format) { return format.kind == ExportKind::geometry; });
  return formats;
}

TEST(ExportGeometry, GivenAnyFormat_ThenItMakesOneFile) {
  const model::Model model = test::straight_yarn();
  ASSERT_EQ(geometry_formats().size(), 8U);
  for (const ExportFormat& format : geometry_formats()) {
    const std::vector<ExportedFile> files = exported({kCase, model}, format);
    ASSERT_EQ(files.size(), 1U) << format.name;
    EXPECT_FALSE(files[0].bytes.empty()) << format.name;
  }
}

TEST(ExportGeometry, GivenAFrame_ThenItsShapeIsWritten) {
  const model::Model model = test::straight_yarn();
  model::Frame frame = test::undeformed(model);
  for (Eigen::Vector3d& point : frame.points) point.x() = 7;
  EXPECT_EQ(lines_of(csv_files({kCase, model})[0]).back(), "1,0,20,0,0.5");
  EXPECT_EQ(lines_of(csv_files({kCase, model, &frame})[0]).back(), "1,7,20,0,0.5");
  for (const ExportFormat& format : geometry_formats()) {
    EXPECT_NE(format.write({kCase, model}), format.write({kCase, model, &frame})) << format.name;
  }
}

TEST(ExportGeometry, GivenABrokenElement_ThenItsTwoPiecesAreYarnsOfTheTable) {
  const model::Model model = test::straight_yarn();
  model::Frame frame = test::undeformed(model);
  frame.broken = {4};
  const std::vector<std::string> lines = lines_of(csv_files({kCase, model, &frame})[0]);
  ASSERT_EQ(lines.size(), 12U);
  EXPECT_EQ(lines[5], "1,0,8,0,0.5");
  EXPECT_EQ(lines[6], "2,0,10,0,0.5");
}

TEST(ExportGeometry, GivenNoWholeElement_ThenEveryFormatSaysSo) {
  const model::Model model = test::straight_yarn();
  model::Frame frame = test::undeformed(model);
  frame.broken = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  for (const ExportFormat& format : geometry_formats()) {
    EXPECT_THROW(static_cast<void>(exported({kCase, model, &frame}, format)), InputError) << format.name;
  }
}

TEST(ExportGeometry, GivenAFrame_ThenTheTitleTellsItsStrain) {
  model::Model model = test::straight_yarn();
  model.title = "A yarn";
  model::Frame frame = test::undeformed(model);
  frame.history.strain = 0.125;
  EXPECT_THAT(obj_files({kCase, model})[0], HasSubstr("# A yarn\n"));
  EXPECT_THAT(obj_files({kCase, model, &frame})[0], HasSubstr("# A yarn, strain 0.125\n"));
  EXPECT_THAT(gltf_files({kCase, model, &frame})[0], HasSubstr("A yarn, strain 0.125"));
}

}  // namespace
}  // namespace knitmech::run
