#include "serve/request_guard.h"

#include <gtest/gtest.h>

namespace knitmech::serve {
namespace {

constexpr int kPort = 8642;
const std::string kToken = "0123456789abcdef0123456789abcdef";

/// A request as the page makes it.
RequestHead of_the_page() {
  static const std::string path = "/" + kToken + "/api/runs";
  return {"POST", path, "127.0.0.1:8642", "http://127.0.0.1:8642", "application/json"};
}

int status_of(const RequestHead& request, bool is_loopback = true) {
  const auto refusal = RequestGuard(kToken, "127.0.0.2", kPort, is_loopback).refusal(request);
  return refusal ? refusal->status : 200;
}

TEST(RequestGuard, LetsThePageIn) {
  EXPECT_EQ(status_of(of_the_page()), 200);
}

TEST(RequestGuard, LetsABrowserOpenTheAddress) {
  // Given the first request of a browser, which has neither origin nor content.
  RequestHead request = of_the_page();
  request.method = "GET";
  request.origin = request.content_type = "";
  EXPECT_EQ(status_of(request), 200);
  for (const char* host : {"localhost:8642", "[::1]:8642", "127.0.0.2:8642"}) {
    request.host = host;
    EXPECT_EQ(status_of(request), 200) << host;
  }
}

TEST(RequestGuard, RefusesAWrongSecret) {
  RequestHead request = of_the_page();
  for (const char* path : {"/", "/api/runs", "//api/runs", "/0123456789abcdef0123456789abcdee/api/runs",
                           "/0123456789abcdef0123456789abcde/api/runs", ""}) {
    request.path = path;
    EXPECT_EQ(status_of(request), 403) << path;
  }
}

TEST(RequestGuard, RefusesOtherPagesOfTheBrowser) {
  RequestHead request = of_the_page();
  for (const char* origin : {"http://example.org", "http://127.0.0.1:8643", "https://127.0.0.1:8642", "null"}) {
    request.origin = origin;
    EXPECT_EQ(status_of(request), 403) << origin;
  }
}

TEST(RequestGuard, RefusesNamesThatAreMadeToPointHere) {
  // Given a page whose own name has been turned to 127.0.0.1 ("DNS rebinding"): host and origin agree.
  RequestHead request = of_the_page();
  request.host = "evil.example:8642";
  request.origin = "http://evil.example:8642";
  EXPECT_EQ(status_of(request), 403);
  request.host = "";
  EXPECT_EQ(status_of(request), 403);
}

TEST(RequestGuard, AnswersToAnyNameWhereOthersAreLetIn) {
  RequestHead request = of_the_page();
  request.host = "workstation:8642";
  request.origin = "http://workstation:8642";
  EXPECT_EQ(status_of(request, false), 200);
  request.origin = "http://example.org";
  EXPECT_EQ(status_of(request, false), 403);
}

TEST(RequestGuard, RefusesWhatAFormOfAnotherPageCouldSend) {
  RequestHead request = of_the_page();
  for (const char* type : {"", "text/plain", "multipart/form-data", "application/x-www-form-urlencoded"}) {
    request.content_type = type;
    EXPECT_EQ(status_of(request), 415) << type;
  }
}

TEST(RequestGuard, HasAnotherSecretEachTime) {
  const std::string token = random_token();
  EXPECT_EQ(token.size(), 32U);
  EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(token, random_token());
}

}  // namespace
}  // namespace knitmech::serve
