#include "base/thread_team.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace knitmech::base {
namespace {

/// Also more threads than the computer has processors.
class ThreadTeams : public testing::TestWithParam<std::size_t> {
 protected:
  std::size_t size_ = GetParam();
  ThreadTeam team_{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(Sizes, ThreadTeams, testing::Values(1, 2, 3, 7, 24));

TEST_P(ThreadTeams, GivenManyRounds_ThenEveryPartIsDoneOnceInEach) {
  // Parts write to plain integers, so that a part that is done twice, or after its round, is a data race too.
  constexpr int kRounds = 1000;
  std::vector<int> done(size_, 0);
  for (int round = 1; round <= kRounds; ++round) {
    const bool waits = round % 2 == 0;  // so that other threads come in time to take a part
    team_.run([&](std::size_t part) {
      if (waits) std::this_thread::yield();
      ++done[part];
    });
    ASSERT_EQ(done, std::vector<int>(size_, round));
  }
}

TEST_P(ThreadTeams, GivenARound_ThenItsPartsSeeWhatAllPartsOfTheRoundBeforeWrote) {
  std::vector<long> before(size_, 1);
  std::vector<long> after(size_, 0);
  long expected = 1;
  for (int round = 0; round < 200; ++round) {
    team_.run([&](std::size_t part) {
      long sum = 0;
      for (const long value : before) sum += value;
      std::this_thread::yield();
      after[part] = sum % 1009;
    });
    expected = expected * static_cast<long>(size_) % 1009;
    ASSERT_EQ(after, std::vector<long>(size_, expected));
    std::swap(before, after);
  }
}

TEST_P(ThreadTeams, GivenARange_ThenItIsCutAtGrainsIntoOneRangePerThreadAtMost) {
  constexpr std::size_t kGrain = 10;
  for (const std::size_t n : {0U, 1U, 9U, 10U, 11U, 99U, 1000U, 1234U}) {
    std::vector<int> covered(n, 0);
    std::atomic<std::size_t> n_ranges = 0;
    team_.for_ranges(n, kGrain, [&](std::size_t begin, std::size_t end) {
      ++n_ranges;
      EXPECT_EQ(begin % kGrain, 0U);
      EXPECT_LT(begin, end);
      for (std::size_t i = begin; i < end; ++i) ++covered[i];
    });
    EXPECT_EQ(covered, std::vector<int>(n, 1)) << n;
    EXPECT_LE(n_ranges, size_);
  }
}

TEST_P(ThreadTeams, GivenPartsThatThrow_ThenTheLowestIsHeardAfterAllHaveEndedAndTheTeamGoesOn) {
  for (int round = 0; round < 100; ++round) {
    std::atomic<std::size_t> begun = 0;
    std::string heard;
    try {
      team_.run([&](std::size_t part) {
        ++begun;
        if (part > 0 || size_ == 1) throw std::runtime_error(std::to_string(part));
      });
    } catch (const std::runtime_error& error) {
      heard = error.what();
    }
    EXPECT_EQ(heard, size_ == 1 ? "0" : "1");
    EXPECT_EQ(begun, size_);
    EXPECT_NO_THROW(team_.run([](std::size_t) {}));
  }
}

TEST_P(ThreadTeams, GivenATeamThatHasHadTimeToFallAsleep_ThenItWorks) {
  for (int round = 0; round < 5; ++round) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    std::vector<int> done(size_, 0);
    team_.run([&](std::size_t part) { ++done[part]; });
    EXPECT_EQ(done, std::vector<int>(size_, 1));
  }
}

TEST_P(ThreadTeams, GivenATeamThatHasMoved_ThenItWorks) {
  const ThreadTeam moved = std::move(team_);
  EXPECT_EQ(moved.size(), size_);
  std::atomic<std::size_t> done = 0;
  moved.run([&](std::size_t) { ++done; });
  EXPECT_EQ(done, size_);
}

TEST(ThreadTeam, GivenTwoPartsThatWaitForEachOther_ThenTwoThreadsAreAtWork) {
  const ThreadTeam team(2);
  std::vector<std::thread::id> thread(2);
  // A thread that comes late finds its part done by the other; so the first part waits until the second has begun.
  std::atomic<bool> has_begun = false;
  team.run([&](std::size_t part) {
    thread[part] = std::this_thread::get_id();
    if (part == 1) has_begun = true;
    while (!has_begun) std::this_thread::yield();
  });
  EXPECT_NE(thread[0], thread[1]);
}

TEST(ThreadTeam, GivenATeamOfOne_ThenTheCallingThreadDoesTheWork) {
  const ThreadTeam team(1);
  std::thread::id worker;
  team.run([&](std::size_t) { worker = std::this_thread::get_id(); });
  EXPECT_EQ(worker, std::this_thread::get_id());
}

}  // namespace
}  // namespace knitmech::base
