#include "serve/server.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

#include "base/errors.h"
#include "results/summary.h"
#include "serve/http.h"
#include "serve/routes.h"

namespace knitmech::serve {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::HasSubstr;

class ServerTest : public testing::Test {
 protected:
  ServerTest() {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "results" / "fake");
    std::ofstream(folder_ / "results" / "fake" / "summary.json")
        << "{\"format\": \"" << results::kSummaryFormat << "\"}";
    std::ofstream(folder_ / "results" / "fake" / "report.html") << "<script>alert(1)</script>";
    std::ofstream(folder_ / "secret.txt") << "secret";
    ServerSettings settings;
    settings.folder = folder_;
    settings.runs_folder = folder_ / "results";
    settings.port = 0;
    settings.version = "test";
    server_ = std::make_unique<Server>(settings);
    const std::string address = server_->address();
    const auto path = address.find('/', std::string("http://").size());
    prefix_ = address.substr(path, address.size() - path - 1);
    client_ = std::make_unique<httplib::Client>(address.substr(0, path));
    client_->set_url_encode(false);
  }
  ~ServerTest() override {
    client_.reset();
    server_.reset();
    fs::remove_all(folder_);
  }

  int get(const std::string& path, const httplib::Headers& headers = {}) {
    const auto answer = client_->Get(path, headers);
    if (!answer) return -1;
    body_ = answer->body;
    return answer->status;
  }
  int post(const std::string& path, const std::string& body, const char* type = "application/json") {
    const auto answer = client_->Post(prefix_ + path, body, type);
    if (!answer) return -1;
    body_ = answer->body;
    return answer->status;
  }

  fs::path folder_ = fs::path(testing::TempDir()) /
                     fmt::format("knitmech_{}", testing::UnitTest::GetInstance()->current_test_info()->name());
  std::unique_ptr<Server> server_;
  std::string prefix_;  ///< "/" and the secret
  std::unique_ptr<httplib::Client> client_;
  std::string body_;  ///< of the last answer
};

TEST_F(ServerTest, ServesThePageAndTheProgram) {
  EXPECT_EQ(get(prefix_ + "/"), 200);
  EXPECT_THAT(body_, HasSubstr("<title>KnitMech</title>"));
  EXPECT_EQ(get(prefix_ + "/page.js"), 200);
  EXPECT_EQ(get(prefix_ + "/api/program"), 200);
  EXPECT_EQ(Json::parse(body_).at("version"), "test");
}

TEST_F(ServerTest, AnswersNobodyWithoutTheSecret) {
  for (const char* path :
       {"/", "/api/program", "/page.js", "/results/fake/report.html", "/00000000000000000000000000000000/"}) {
    EXPECT_EQ(get(path), 403) << path;
    EXPECT_THAT(Json::parse(body_).at("error").at("message").get<std::string>(), HasSubstr("address"));
  }
}

TEST_F(ServerTest, AnswersNoOtherPageAndNoOtherName) {
  EXPECT_EQ(get(prefix_ + "/api/program", {{"Origin", "http://example.org"}}), 403);
  EXPECT_EQ(get(prefix_ + "/api/program", {{"Host", "example.org"}}), 403);
  EXPECT_EQ(post("/api/design", R"({"text": "", "fabric": false})", "text/plain"), 415);
}

TEST_F(ServerTest, LeadsOutOfNoFolder) {
  for (const char* path : {"/runs/fake/../../secret.txt", "/runs/fake/%2e%2e/%2e%2e/secret.txt", "/runs/../secret.txt",
                           "/runs/..%2fsecret.txt/x", "/runs/fake/..%2f..%2fsecret.txt", "/runs/%2e%2e/secret.txt",
                           "/runs/fake//etc/passwd", "/runs/fake/%2fetc%2fpasswd", "/api/case?path=../secret.txt",
                           "/api/case?path=%2e%2e/x.toml", "/api/runs/..", "/api/runs/%2e%2e", "/../secret.txt"}) {
    const int status = get(prefix_ + path);
    EXPECT_TRUE(status == 404 || status == 400 || status == 403) << path << " gives " << status;
    EXPECT_THAT(body_, testing::Not(HasSubstr("root:"))) << path;
    EXPECT_NE(body_, "secret") << path;
  }
}

TEST_F(ServerTest, LetsNoFileOfARunActAsThePage) {
  const auto answer = client_->Get(prefix_ + "/runs/fake/report.html");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
  EXPECT_THAT(answer->get_header_value("Content-Security-Policy"),
              testing::AllOf(HasSubstr("sandbox"), HasSubstr("default-src 'none'")));
}

TEST_F(ServerTest, AnswersNonsenseWithASentence) {
  for (const char* body :
       {"", "{", "[]", "null", "\"text\"", "{\"text\": 3}", "{\"text\": null, \"fabric\": true}",
        "{\"text\": \"\", \"edit\": {}}", "{\"text\": \"\", \"edit\": {\"key\": 1, \"typed\": 2}}"}) {
    EXPECT_EQ(post("/api/design", body), 400) << body;
    EXPECT_FALSE(Json::parse(body_).at("error").at("message").get<std::string>().empty()) << body;
  }
  EXPECT_EQ(post("/api/design", std::string(100000, '[')), 400);
  EXPECT_EQ(post("/api/export", R"({"text": "", "format": "abaqus", "stem": "x", "ending": ".inp"})"), 400);
  EXPECT_EQ(post("/api/runs", R"({"text": "nonsense", "name": "x"})"), 400);
  EXPECT_EQ(post("/api/runs/not-there/stop", "{}"), 404);
  EXPECT_EQ(get(prefix_ + "/api/runs/fake/frames/99999999999999"), 404);
  EXPECT_EQ(get(prefix_ + "/api/nothing"), 404);
  EXPECT_EQ(get(prefix_ + "/api/runs/fake/history?from=-1"), 400);
}

TEST_F(ServerTest, TakesNoRequestThatIsTooLarge) {
  // Given a body longer than is allowed, then it is refused, and the server goes on answering.
  const auto answer = client_->Post(prefix_ + "/api/design", std::string(kLargestRequest + 1, 'x'), "application/json");
  EXPECT_TRUE(!answer || answer->status == 413);
  EXPECT_EQ(get(prefix_ + "/api/program"), 200);
}

TEST_F(ServerTest, AnswersManyAtOnce) {
  std::vector<std::jthread> askers;
  askers.reserve(12);
  std::atomic<int> n_answers = 0;
  for (int i = 0; i < 12; ++i) {
    askers.emplace_back([&] {
      httplib::Client client(server_->address().substr(0, server_->address().find('/', 7)));
      for (int k = 0; k < 10; ++k) {
        const auto answer = client.Get(prefix_ + "/api/runs");
        n_answers += answer && answer->status == 200 ? 1 : 0;
      }
    });
  }
  askers.clear();
  EXPECT_EQ(n_answers, 120);
}

TEST_F(ServerTest, EndsWhileSomebodyListens) {
  // Given a page that waits for events, when the program ends, then it does not wait for the page.
  std::jthread listener([&] {
    httplib::Client client(server_->address().substr(0, server_->address().find('/', 7)));
    client.Get(prefix_ + "/api/events", [&](const char*, std::size_t) { return true; });
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  server_.reset();
}

TEST_F(ServerTest, AnswersAtTheAddressThatItTells) {
  // Given other addresses of this computer, then the one that is printed opens the page.
  for (const char* host : {"127.0.0.2", "localhost", "::1", "0.0.0.0"}) {
    ServerSettings settings;
    settings.folder = folder_;
    settings.runs_folder = folder_;
    settings.host = host;
    settings.port = 0;
    std::unique_ptr<Server> server;
    try {
      server = std::make_unique<Server>(settings);
    } catch (const InputError&) {
      EXPECT_STREQ(host, "::1") << "only a computer without IPv6 may have no such address";
      continue;
    }
    const std::string address = server->address();
    const auto path = address.find('/', std::string("http://").size());
    httplib::Client client(address.substr(0, path));
    const auto answer = client.Get(address.substr(path));
    ASSERT_TRUE(answer) << address;
    EXPECT_EQ(answer->status, 200) << address;
  }
}

TEST_F(ServerTest, TellsWhyItCannotListen) {
  const std::string address = server_->address();
  ServerSettings settings;
  settings.folder = folder_;
  settings.runs_folder = folder_;
  settings.port = std::stoi(address.substr(address.rfind(':') + 1));
  EXPECT_THROW(Server{settings}, InputError);
  settings.port = 0;
  settings.host = "192.0.2.1";  // of no computer (RFC 5737)
  EXPECT_THROW(Server{settings}, InputError);
}

}  // namespace
}  // namespace knitmech::serve
