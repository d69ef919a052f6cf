#include "picture/fabric_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cstdlib>
#include <limits>

#include "../../support/straight_yarn.h"
#include "base/errors.h"

namespace knitmech::picture {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class FabricPicture : public testing::Test {
 protected:
  const model::Model model_ = test::straight_yarn();
  model::Frame frame_ = test::undeformed(model_);
  PictureOptions options_{.width = 300, .height = 400, .threads = 1};
};

/// Blue stands out of the backdrop and its grey shadow only where there is yarn of the plain colour.
bool is_yarn(const Colour& colour) {
  return colour[2] > 1.5F * colour[0];
}

TEST_F(FabricPicture, AStraightYarnCoversItsWidthAndLength) {
  const Image image = draw_fabric(model_, frame_, options_);
  ASSERT_EQ(image.width(), 300);
  ASSERT_EQ(image.height(), 400);
  int rows = 0;
  double columns = 0;
  for (int row = 0; row < image.height(); ++row) {
    int in_row = 0;
    for (int column = 0; column < image.width(); ++column) {
      in_row += is_yarn(image.at(column, row)) ? 1 : 0;
    }
    rows += in_row > 0 ? 1 : 0;
    columns += in_row;
  }
  // The yarn is 20 mm long with round ends of 0.5 mm: 21 mm high and 1 mm wide, so 21 times as high as wide.
  const double width = columns / rows;
  const double pixels_per_mm = rows / 21.0;
  EXPECT_GT(rows, 300) << "the yarn fills the height but for the margins";
  EXPECT_NEAR(width, pixels_per_mm, 0.15 * pixels_per_mm + 1);
}

TEST_F(FabricPicture, IsLitFromTheUpperLeft) {
  const Image image = draw_fabric(model_, frame_, options_);
  const int row = 200;
  const auto brightness = [&](int column) { return image.at(column, row).sum(); };
  // The yarn stands in the middle; at a sixth of its width inside its left and its right edge:
  EXPECT_TRUE(is_yarn(image.at(145, row)) && is_yarn(image.at(155, row)));
  EXPECT_GT(brightness(145), 1.2F * brightness(155));
}

TEST_F(FabricPicture, ThrowsAShadowOnTheBackdrop) {
  const Image image = draw_fabric(model_, frame_, options_);
  const float backdrop = image.at(20, 200).sum();
  float darkest = backdrop;
  for (int column = 170; column < 300; ++column) {
    darkest = std::min(darkest, image.at(column, 200).sum());
  }
  EXPECT_LT(darkest, 0.95F * backdrop);
}

TEST_F(FabricPicture, IsTheSameInEveryRunAndWithAnyNumberOfThreads) {
  frame_.curvature.assign(11, 0.3);
  options_.colour_by = ColourBy::curvature;
  options_.caption = "strain 22 % \xC2\xB7 test";
  const std::string first = png_bytes(draw_fabric(model_, frame_, options_));
  EXPECT_EQ(png_bytes(draw_fabric(model_, frame_, options_)), first);
  options_.threads = 3;
  EXPECT_EQ(png_bytes(draw_fabric(model_, frame_, options_)), first);
}

TEST_F(FabricPicture, TheColourTellsTheValue) {
  // Given z = 0 along the yarn and a range in which that is the highest value: the yarn is yellow, without blue.
  options_.colour_by = ColourBy::out_of_plane;
  options_.range = {-1, 0};
  options_.width = 500;
  const Image image = draw_fabric(model_, frame_, options_);
  int yellow = 0;
  for (int column = 0; column < 250; ++column) {
    const Colour& colour = image.at(column, 200);
    yellow += colour[0] > 3 * colour[2] ? 1 : 0;
  }
  EXPECT_GT(yellow, 5);
}

TEST_F(FabricPicture, TheEdgeYarnHasAColourOfItsOwn) {
  // Given a yarn whose upper half is of another section: blue below, ochre, without much blue, above.
  model::Model model = model_;
  model.sections.push_back(model.sections.front());
  std::fill(model.element_section.begin() + 5, model.element_section.end(), 1);
  const Image image = draw_fabric(model, frame_, options_);
  int blue_above = 0, blue_below = 0, ochre_above = 0, ochre_below = 0;
  for (int column = 0; column < image.width(); ++column) {
    const auto is_ochre = [](const Colour& colour) { return colour[0] > 2 * colour[2]; };
    blue_above += is_yarn(image.at(column, 100)) ? 1 : 0;
    ochre_above += is_ochre(image.at(column, 100)) ? 1 : 0;
    blue_below += is_yarn(image.at(column, 260)) ? 1 : 0;
    ochre_below += is_ochre(image.at(column, 260)) ? 1 : 0;
  }
  EXPECT_EQ(blue_above, 0);
  EXPECT_GT(ochre_above, 5);
  EXPECT_GT(blue_below, 5);
  EXPECT_EQ(ochre_below, 0);
}

TEST_F(FabricPicture, AWindowShowsAPartLarger) {
  const auto yarn_pixels = [&] {
    const Image image = draw_fabric(model_, frame_, options_);
    int count = 0;
    for (int column = 0; column < image.width(); ++column) {
      count += is_yarn(image.at(column, 150)) ? 1 : 0;
    }
    return count;
  };
  const int whole = yarn_pixels();
  options_.window = {.left = 0, .right = 1, .bottom = 0.25, .top = 0.75};
  EXPECT_NEAR(yarn_pixels(), 2.0 * whole, 4);
}

TEST_F(FabricPicture, WritesAPngThatOtherProgramsRead) {
  const std::string path = testing::TempDir() + "knitmech_fabric_picture_test.png";
  write_fabric_picture(path, model_, frame_, options_);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&header, path.c_str()), 0);
  EXPECT_EQ(header.width, 300U);
  EXPECT_EQ(header.height, 400U);
  header.format = PNG_FORMAT_RGB;
  std::vector<png_byte> pixels(PNG_IMAGE_SIZE(header));
  ASSERT_NE(png_image_finish_read(&header, nullptr, pixels.data(), 0, nullptr), 0);
  const Image image = draw_fabric(model_, frame_, options_);
  const std::size_t middle = 3 * (std::size_t{200} * 300 + 150);
  EXPECT_EQ(pixels[middle], to_srgb_byte(image.at(150, 200)[0]));
  EXPECT_EQ(pixels[middle + 2], to_srgb_byte(image.at(150, 200)[2]));
  EXPECT_EQ(std::remove(path.c_str()), 0);
}

TEST_F(FabricPicture, AnUnwritablePathIsAFileError) {
  EXPECT_THAT([&] { write_fabric_picture("/no/such/folder/fabric.png", model_, frame_, options_); },
              ThrowsMessage<FileError>(HasSubstr("/no/such/folder/fabric.png")));
}

TEST_F(FabricPicture, ImpossibleOptionsAreInputErrors) {
  const auto drawing = [&](const PictureOptions& options) {
    return [this, options] { static_cast<void>(draw_fabric(model_, frame_, options)); };
  };
  EXPECT_THAT(drawing({.height = 10}), ThrowsMessage<InputError>(HasSubstr("10 px")));
  EXPECT_THAT(drawing({.width = 30000}), ThrowsMessage<InputError>(HasSubstr("30000")));
  PictureOptions backwards = options_;
  backwards.range = {2, 1};
  EXPECT_THAT(drawing(backwards), ThrowsMessage<InputError>(HasSubstr("2 to 1")));
  PictureOptions outside = options_;
  outside.window.right = 1.5;
  EXPECT_THAT(drawing(outside), ThrowsMessage<InputError>(HasSubstr("1.5")));
}

TEST_F(FabricPicture, AFrameWithoutAnyKnownPositionIsAnInputError) {
  for (Eigen::Vector3d& point : frame_.points) {
    point.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  EXPECT_THAT([&] { static_cast<void>(draw_fabric(model_, frame_, options_)); },
              ThrowsMessage<InputError>(HasSubstr("nothing to draw")));
}

TEST_F(FabricPicture, AYarnThrownFarAwayDoesNotBlowUpThePage) {
  frame_.points[10] = {1e7, 20, 0};
  options_.width = 0;
  EXPECT_LE(draw_fabric(model_, frame_, options_).width(), 5 * options_.height);
}

}  // namespace
}  // namespace knitmech::picture
