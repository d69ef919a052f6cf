#include <gtest/gtest.h>

#include "runs_fixture.h"
#include "serve/new_folder.h"
#include "serve/refusal.h"

namespace knitmech::serve {
namespace {

namespace fs = std::filesystem;

/// A run beside the folder of runs, which nobody may reach.
class HostileIds : public RunsTest {
 protected:
  HostileIds() {
    Runs other(top_ / "outside", kQuick);
    wait_for_end(other, other.start(case_text(), "secret"));
    fs::create_directories(root_);
  }
};

TEST_F(HostileIds, GivenAnIdThatIsAPath_ThenItIsNoRun) {
  fs::create_directory_symlink(top_ / "outside" / "secret", root_ / "link");
  fs::create_directory_symlink(top_, root_ / "up");
  fs::create_directory_symlink(".", root_ / "self");
  fs::copy(top_ / "outside" / "secret", root_ / ".hidden", fs::copy_options::recursive);
  Runs runs(root_, kQuick);
  const std::string outside = (top_ / "outside" / "secret").string();
  for (const std::string& id :
       {std::string(), std::string("."), std::string(".."), std::string("../outside/secret"), outside,
        std::string("..\\outside"), std::string("link"), std::string("up"), std::string("up/outside/secret"),
        std::string("self"), std::string(".hidden"), std::string("a/b"), std::string("a\nb"), std::string("a\0b", 3),
        std::string("no-such-run"), std::string(100000, 'a'), std::string("a..b")}) {
    const auto expect_none = [&](const auto& call) {
      try {
        call();
        ADD_FAILURE() << "took " << id.substr(0, 100);
      } catch (const Refusal& refusal) {
        EXPECT_EQ(refusal.status(), 404) << refusal.what();
      }
    };
    expect_none([&] { static_cast<void>(runs.folder_of(id)); });
    expect_none([&] { static_cast<void>(runs.detail_json(id)); });
    expect_none([&] { static_cast<void>(runs.history_json(id, 0)); });
    expect_none([&] { static_cast<void>(runs.model_blob(id)); });
    expect_none([&] { static_cast<void>(runs.frame_blob(id, 0)); });
    expect_none([&] { static_cast<void>(runs.live_blob(id)); });
    expect_none([&] { static_cast<void>(runs.picture_png(id, {})); });
    expect_none([&] { runs.pause(id); });
    expect_none([&] { runs.resume(id); });
    expect_none([&] { runs.stop(id); });
    expect_none([&] { runs.write_report(id); });
  }
  EXPECT_EQ(runs.list_json(), "[]");
}

TEST_F(HostileIds, GivenALinkToARunInTheFolder_ThenThatIsARun) {
  fs::copy(top_ / "outside" / "secret", root_ / "mine", fs::copy_options::recursive);
  fs::create_directory_symlink("mine", root_ / "alias");
  Runs runs(root_, kQuick);
  EXPECT_EQ(Json::parse(runs.list_json()).size(), 2U);
  EXPECT_EQ(status(runs, "alias"), "completed");
}

TEST(FolderName, GivenAnyName_ThenItIsFitForAFolder) {
  EXPECT_EQ(folder_name("Jersey 7 x 5.toml"), "Jersey-7-x-5.toml");
  EXPECT_EQ(folder_name(""), "run");
  EXPECT_EQ(folder_name("..."), "run");
  EXPECT_EQ(folder_name("../../etc"), "etc");
  EXPECT_EQ(folder_name("a..b"), "a.b");
  EXPECT_EQ(folder_name("<script>&\"'"), "script");
  EXPECT_EQ(folder_name(std::string("a\0b", 3)), "ab");
}

}  // namespace
}  // namespace knitmech::serve
