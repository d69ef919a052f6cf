#include "results/history_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <random>

#include "base/errors.h"
#include "sample_run.h"

namespace knitmech::results {
namespace {

using model::HistoryRow;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<double*> doubles_of(HistoryRow& row) {
  return {&row.time,
          &row.displacement,
          &row.strain,
          &row.force_top,
          &row.force_bottom,
          &row.external_work,
          &row.internal_energy,
          &row.stretch_energy,
          &row.kinetic_energy,
          &row.contact_energy,
          &row.friction_loss,
          &row.damping_loss,
          &row.break_loss,
          &row.width,
          &row.normal_force,
          &row.largest_elastic_slip,
          &row.largest_penetration,
          &row.step};
}

std::string history_of(const std::string& rows) {
  return std::string{kHistoryHeader} + "\n" + rows;
}

TEST(HistoryFile, ReadsBackTheSameBits) {
  // Given rows of doubles of any size, and the extreme ones.
  std::mt19937_64 random(1);
  std::vector<HistoryRow> rows(200);
  for (HistoryRow& row : rows) {
    for (double* value : doubles_of(row)) {
      do {
        *value = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
      } while (!std::isfinite(*value));
    }
    row.contacts = static_cast<int>(random() % 100000);
  }
  rows.front().time = std::numeric_limits<double>::denorm_min();
  rows.front().strain = -std::numeric_limits<double>::max();
  std::string text;
  for (const HistoryRow& row : rows) {
    text += history_line(row);
  }
  // When they are written and read.
  const test::TemporaryFolder folder;
  test::write_text(folder.path() / "history.csv", history_of(text));
  std::vector<HistoryRow> read = read_history(folder.path() / "history.csv");
  // Then every number is the same.
  ASSERT_EQ(read.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double*> expected = doubles_of(rows[i]);
    const std::vector<double*> found = doubles_of(read[i]);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(*found[k]), std::bit_cast<std::uint64_t>(*expected[k]));
    }
    EXPECT_EQ(read[i].contacts, rows[i].contacts);
  }
}

TEST(HistoryFile, PutsEveryColumnUnderItsName) {
  // Given a row in which each number says its place in the header.
  const std::string line = history_line(HistoryRow{.time = 1,
                                                   .displacement = 2,
                                                   .strain = 3,
                                                   .force_top = 4,
                                                   .force_bottom = 5,
                                                   .external_work = 6,
                                                   .internal_energy = 7,
                                                   .stretch_energy = 8,
                                                   .kinetic_energy = 9,
                                                   .contact_energy = 10,
                                                   .friction_loss = 11,
                                                   .damping_loss = 12,
                                                   .break_loss = 13,
                                                   .width = 14,
                                                   .contacts = 15,
                                                   .normal_force = 16,
                                                   .largest_elastic_slip = 17,
                                                   .largest_penetration = 18,
                                                   .step = 19});
  // Then it reads 1, 2, 3, ...
  EXPECT_EQ(line, "1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19\n");
}

TEST(HistoryFile, AcceptsOtherLineEndsAndAnEmptyHistory) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "history.csv";
  test::write_text(path, std::string{kHistoryHeader} + "\r\n1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19\r\n\r\n");
  ASSERT_EQ(read_history(path).size(), 1U);
  EXPECT_EQ(read_history(path).front().step, 19);
  test::write_text(path, history_of(""));
  EXPECT_TRUE(read_history(path).empty());
}

TEST(HistoryFile, SaysWhereAFileIsWrong) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "history.csv";
  const auto reading = [&path](const std::string& text) {
    test::write_text(path, text);
    return [&path] { static_cast<void>(read_history(path)); };
  };
  const std::string good = "1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19\n";
  EXPECT_THAT(reading("time,force\n1,2\n"),
              ThrowsMessage<InputError>(AllOf(HasSubstr(path.string()), HasSubstr("line 1"), HasSubstr("time_s,"))));
  EXPECT_THAT(reading(""), ThrowsMessage<InputError>(HasSubstr("line 1")));
  EXPECT_THAT(reading(history_of(good + "1,2,3\n")),
              ThrowsMessage<InputError>(AllOf(HasSubstr("line 3"), HasSubstr("19 numbers"), HasSubstr("found 3"))));
  EXPECT_THAT(reading(history_of(good + "1,2,3,4x,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19\n")),
              ThrowsMessage<InputError>(AllOf(HasSubstr("line 3"), HasSubstr("force_top_N"), HasSubstr("\"4x\""))));
  EXPECT_THAT(reading(history_of("1,2,3,4,5,6,7,8,9,10,11,12,13,14,15.5,16,17,18,19\n")),
              ThrowsMessage<InputError>(AllOf(HasSubstr("line 2"), HasSubstr("contacts"), HasSubstr("\"15.5\""))));
  EXPECT_THAT([] { static_cast<void>(read_history("/no/such/history.csv")); },
              ThrowsMessage<FileError>(HasSubstr("/no/such/history.csv")));
}

}  // namespace
}  // namespace knitmech::results
