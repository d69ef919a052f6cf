#include "results/write_queue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <stdexcept>
#include <vector>

#include "results/constants.h"

namespace knitmech::results {
namespace {

using testing::ElementsAre;
using testing::ThrowsMessage;

/// A job that lasts until it is let go.
class Gate {
 public:
  [[nodiscard]] std::function<void()> job() {
    return [this] { opened_.wait(); };
  }
  void open() { promise_.set_value(); }

 private:
  std::promise<void> promise_;
  std::shared_future<void> opened_{promise_.get_future()};
};

TEST(WriteQueue, DoesJobsInTheirOrderAndFinishWaitsForThem) {
  std::vector<int> done;
  WriteQueue queue;
  for (const int i : {1, 2, 3, 4, 5}) queue.add([&done, i] { done.push_back(i); });
  queue.finish();
  EXPECT_THAT(done, ElementsAre(1, 2, 3, 4, 5));
}

TEST(WriteQueue, JobsRunBesideWhoeverAddsThem) {
  // Given a job that only ends when the caller says so: were it done by the caller, add() would never return.
  WriteQueue queue;
  Gate gate;
  queue.add(gate.job());
  gate.open();
  queue.finish();
}

TEST(WriteQueue, NeverHoldsMoreJobsThanItsLimit) {
  // Given as many jobs as may be pending, none of which can end.
  WriteQueue queue;
  Gate gate;
  for (std::size_t i = 0; i < kMostPendingWrites; ++i) queue.add(gate.job());
  // When somebody adds another.
  auto another = std::async(std::launch::async, [&queue] { queue.add([] {}); });
  // Then that has to wait, until the first may end. (A queue without a limit takes it at once.)
  EXPECT_EQ(another.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout);
  gate.open();
  another.get();
  queue.finish();
}

TEST(WriteQueue, AnErrorReachesTheCallerAndDropsWhatIsBehindIt) {
  // Given a job that fails while another waits behind it.
  WriteQueue queue;
  Gate gate;
  bool later = false;
  queue.add([wait = gate.job()] {
    wait();
    throw std::runtime_error("disk full");
  });
  queue.add([&later] { later = true; });
  EXPECT_NO_THROW(queue.check());
  gate.open();
  // Then every call from now on says so, and the other job is not done.
  EXPECT_THAT([&] { queue.finish(); }, ThrowsMessage<std::runtime_error>("disk full"));
  EXPECT_THAT([&] { queue.check(); }, ThrowsMessage<std::runtime_error>("disk full"));
  EXPECT_THAT([&] { queue.add([] {}); }, ThrowsMessage<std::runtime_error>("disk full"));
  EXPECT_FALSE(later);
}

TEST(WriteQueue, GoesOnlyWhenWhatIsPendingIsDone) {
  int done = 0;
  {
    WriteQueue queue;
    queue.add([&done] { ++done; });
    queue.add([&done] { ++done; });
  }
  EXPECT_EQ(done, 2);
}

}  // namespace
}  // namespace knitmech::results
