#include "serve/workspace.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "results/atomic_file.h"
#include "serve/refusal.h"

namespace knitmech::serve {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class WorkspaceTest : public testing::Test {
 protected:
  WorkspaceTest() {
    fs::remove_all(outer_);
    fs::create_directories(outer_ / "work" / "sub");
    write(outer_ / "secret.toml", "[loop]\n");
    write(outer_ / "work" / "jersey.toml", "title = \"My jersey\"\n[loop]\n");
    write(outer_ / "work" / "sub" / "other.toml", "[package]\n");
    fs::create_symlink(outer_ / "secret.toml", outer_ / "work" / "link.toml");
    fs::create_directory_symlink(outer_, outer_ / "work" / "out");
  }
  ~WorkspaceTest() override { fs::remove_all(outer_); }

  static void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

  int refusal_of(const std::string& path) const {
    try {
      (void)Workspace(outer_ / "work").case_json(path);
      return 200;
    } catch (const Refusal& refusal) {
      return refusal.status();
    } catch (const InputError&) {
      return 400;
    }
  }

  fs::path outer_ = fs::path(testing::TempDir()) /
                    fmt::format("knitmech_{}", testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(WorkspaceTest, ListsCasesWithTitlesAndNothingElse) {
  const Json cases = Json::parse(Workspace(outer_ / "work").cases_json()).at("cases");
  ASSERT_EQ(cases.size(), 1U);
  EXPECT_EQ(cases[0].at("path"), "jersey.toml");
  EXPECT_EQ(cases[0].at("title"), "My jersey");
}

TEST_F(WorkspaceTest, BringsTheExamplesAlong) {
  const Json examples = Json::parse(Workspace(outer_ / "work").cases_json()).at("examples");
  ASSERT_GE(examples.size(), 2U);
  EXPECT_EQ(examples[0].at("name"), "01-first-loop");
  const Json first = Json::parse(Workspace::example_json("01-first-loop"));
  EXPECT_EQ(first.at("text").get<std::string>(),
            results::read_file(fs::path(KNITMECH_SOURCE_DIR) / "examples" / "01-first-loop" / "case.toml"));
  EXPECT_TRUE(first.at("path").is_null());
  EXPECT_THROW((void)Workspace::example_json("../01-first-loop"), Refusal);
}

TEST_F(WorkspaceTest, LetsNoPathOut) {
  EXPECT_EQ(refusal_of("jersey.toml"), 200);
  EXPECT_EQ(refusal_of("sub/../jersey.toml"), 200);
  for (const char* path : {"../secret.toml", "link.toml", "out/secret.toml", "/etc/passwd", "", ".", "..",
                           "sub/../../secret.toml", "sub\\..\\..\\secret.toml", "not-there.toml"}) {
    EXPECT_EQ(refusal_of(path), 404) << path;
  }
  EXPECT_EQ(refusal_of((outer_ / "work" / "jersey.toml").string()), 404);
  EXPECT_EQ(refusal_of(std::string("jersey.toml\0.png", 16)), 404);
  EXPECT_EQ(refusal_of(std::string(5000, 'a') + ".toml"), 404);
  EXPECT_EQ(refusal_of("jersey.txt"), 400);
}

TEST_F(WorkspaceTest, SavesOverTheFileThatWasRead) {
  const Workspace workspace(outer_ / "work");
  const Json before = Json::parse(workspace.case_json("jersey.toml"));
  const Json saved =
      Json::parse(workspace.save("jersey.toml", "[loop]\n# new\n", before.at("stamp").get<std::string>()));
  const Json after = Json::parse(workspace.case_json("jersey.toml"));
  EXPECT_EQ(after.at("text"), "[loop]\n# new\n");
  EXPECT_EQ(after.at("stamp"), saved.at("stamp"));
}

TEST_F(WorkspaceTest, KeepsAFileThatAnotherProgramChanged) {
  // Given a case that was read, when another program changes it, then saving is refused and the change stays.
  const Workspace workspace(outer_ / "work");
  const std::string stamp = Json::parse(workspace.case_json("jersey.toml")).at("stamp");
  write(outer_ / "work" / "jersey.toml", "title = \"His jersey\"\n[loop]\n");
  try {
    (void)workspace.save("jersey.toml", "[loop]\n", stamp);
    FAIL() << "saved over it";
  } catch (const Refusal& refusal) {
    EXPECT_EQ(refusal.status(), 409);
    EXPECT_THAT(refusal.what(), testing::HasSubstr("changed by another program"));
  }
  EXPECT_THROW((void)workspace.save("jersey.toml", "[loop]\n", std::nullopt), Refusal);
  EXPECT_THAT(results::read_file(outer_ / "work" / "jersey.toml"), testing::HasSubstr("His jersey"));
}

TEST_F(WorkspaceTest, SavesOnlyCaseFilesInFoldersThatAreThere) {
  const Workspace workspace(outer_ / "work");
  EXPECT_NO_THROW((void)workspace.save("sub/new.toml", "[loop]\n", std::nullopt));
  EXPECT_THROW((void)workspace.save("sub/new.sh", "#!/bin/sh\n", std::nullopt), InputError);
  EXPECT_THROW((void)workspace.save("nowhere/new.toml", "[loop]\n", std::nullopt), InputError);
  EXPECT_THROW((void)workspace.save("out/new.toml", "[loop]\n", std::nullopt), Refusal);
  EXPECT_THROW((void)workspace.save("link.toml", "[loop]\n", std::nullopt), Refusal);
  EXPECT_THROW((void)workspace.save("large.toml", std::string(2'000'000, '#'), std::nullopt), InputError);
  EXPECT_FALSE(fs::exists(outer_ / "new.toml"));
  EXPECT_EQ(results::read_file(outer_ / "secret.toml"), "[loop]\n");
}

}  // namespace
}  // namespace knitmech::serve
