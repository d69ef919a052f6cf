#include "report/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text.h"
namespace knitmech::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Page, GivenTextWithMarkupWhenWrittenThenItIsShownAndNotObeyed) {
  Page page("a < b & \"c\"", "<script>alert(1)</script>");
  page.add_section("x > y", "<p>html</p>");
  const std::string html = page.html("end");
  EXPECT_THAT(html, HasSubstr("<title>a &lt; b &amp; &quot;c&quot;</title>"));
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, HasSubstr("<p>html</p>"));
}

TEST(Page, GivenSectionsWhenWrittenThenTheListAtTheTopLeadsToEach) {
  Page page("t", "s");
  page.add_section("First", "");
  page.add_section("Second", "");
  const std::string html = page.html("");
  EXPECT_THAT(html, HasSubstr("<a href=\"#s2\">Second</a>"));
  EXPECT_THAT(html, HasSubstr("<h2 id=\"s2\">Second</h2>"));
}

TEST(Page, GivenControlCharactersWhenEscapedThenTheyAreSpaces) {
  EXPECT_EQ(base::in_markup("a\x01\nb"), "a  b");
}

TEST(Table, GivenAColumnOfNumbersWhenWrittenThenItIsSetToTheRightAndOneOfWordsIsNot) {
  const std::string html = table({{"name", "value", "mixed"}, {"a", "1.5", "2"}, {"b", "", "none"}});
  EXPECT_THAT(html, HasSubstr("<th>name</th><th class=\"number\">value</th><th>mixed</th>"));
  EXPECT_THAT(html, HasSubstr("<td>a</td><td class=\"number\">1.5</td><td>2</td>"));
}

TEST(Table, GivenNoRowsWhenWrittenThenThereIsNothing) {
  EXPECT_EQ(table({}), "");
}

// RFC 4648, section 10: "foobar" is Zm9vYmFy.
TEST(InlinePng, GivenBytesWhenWrittenThenTheyStandInThePageAsBase64) {
  EXPECT_EQ(inline_png("foobar", "a \"b\""), "<img alt=\"a &quot;b&quot;\" src=\"data:image/png;base64,Zm9vYmFy\">");
}

}  // namespace
}  // namespace knitmech::report
