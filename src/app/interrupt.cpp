#include "app/interrupt.h"

#include <array>
#include <atomic>
#include <csignal>

namespace knitmech::app {
namespace {

// A signal handler can reach nothing but a variable like this one; it stays in this file.
std::atomic<bool> requested_flag = false;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait for a lock");

constexpr std::array kSignals = {SIGINT, SIGTERM};

extern "C" void on_signal(int /*signal*/) {
  requested_flag = true;
}

}  // namespace

InterruptWatch::InterruptWatch() {
  requested_flag = false;
  struct sigaction action = {};
  action.sa_handler = on_signal;
  // The handler is for one signal; what was usual before holds for the next. Writing of files goes on undisturbed.
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  for (const int signal : kSignals) sigaction(signal, &action, nullptr);
}

InterruptWatch::~InterruptWatch() {
  for (const int signal : kSignals) std::signal(signal, SIG_DFL);
}

bool InterruptWatch::requested() {
  return requested_flag;
}

}  // namespace knitmech::app
