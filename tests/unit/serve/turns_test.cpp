#include "serve/turns.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace knitmech::serve {
namespace {

TEST(Turns, GivenMoreThanMayGo_ThenNoMoreGoAtOnce_AndAllGoInTheEnd) {
  Turns turns(3);
  std::atomic<int> now = 0, most = 0, done = 0;
  {
    std::vector<std::jthread> threads;
    threads.reserve(20);
    for (int i = 0; i < 20; ++i) {
      threads.emplace_back([&, ticket = turns.line_up()](const std::stop_token& stop) {
        if (!turns.take(ticket, stop)) return;
        const int going = ++now;
        for (int seen = most; going > seen && !most.compare_exchange_weak(seen, going);) continue;
        ++done;
        --now;
        turns.give_back();
      });
    }
    for (std::jthread& thread : threads) thread.join();
  }
  EXPECT_LE(most, 3);
  EXPECT_EQ(done, 20);
  EXPECT_FALSE(turns.is_alone());
}

TEST(Turns, GivenALine_ThenItGoesInItsOrder_AndOneWhoStopsLeavesIt) {
  Turns turns(1);
  const std::stop_source go_on;
  ASSERT_TRUE(turns.take(turns.line_up(), go_on.get_token()));
  EXPECT_TRUE(turns.is_alone());
  const Turns::Ticket second = turns.line_up();
  const Turns::Ticket third = turns.line_up();
  EXPECT_FALSE(turns.is_alone());
  std::atomic<bool> third_has_gone = false;
  std::jthread waiting([&] {
    third_has_gone = turns.take(third, go_on.get_token());
    turns.give_back();
  });
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(turns.take(second, stop.get_token()));
  EXPECT_FALSE(third_has_gone);
  turns.give_back();
  waiting.join();
  EXPECT_TRUE(third_has_gone);
}

TEST(Turns, GivenOneWhoIsAskedToStop_ThenHeTakesNoTurnThatIsFree) {
  Turns turns(1);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(turns.take(turns.line_up(), stop.get_token()));
  const std::stop_source go_on;
  EXPECT_TRUE(turns.take(turns.line_up(), go_on.get_token()));
}

TEST(Turns, GivenThatTheyAreClosed_ThenNobodyGetsTheTurnThatIsGivenBack) {
  Turns turns(1);
  const std::stop_source go_on;
  ASSERT_TRUE(turns.take(turns.line_up(), go_on.get_token()));
  std::atomic<bool> has_gone = false;
  std::jthread waiting([&, ticket = turns.line_up()] { has_gone = turns.take(ticket, go_on.get_token()); });
  turns.close();
  turns.give_back();
  waiting.join();
  EXPECT_FALSE(has_gone);
}

}  // namespace
}  // namespace knitmech::serve
