#pragma once

#include <tuple>

namespace knitmech::base {

/// The members of a class that its serialize() leaves out: those that never change after the constructor, and those
/// that are made anew before they are used.
///
/// A class whose state goes into a checkpoint names all its members in serialize(), in or out, so that a member that
/// was forgotten can be told from one that is left out (tests/support/member_check.h):
///
///     template <class Archive>
///     void serialize(Archive& archive) {
///       archive(left_out(model_), state_, steps_);
///     }
template <class... Members>
struct LeftOut {
  std::tuple<const Members*...> members;

  template <class Archive>
  void serialize(Archive& /*archive*/) {}
};

template <class... Members>
[[nodiscard]] LeftOut<Members...> left_out(const Members&... members) {
  return {{&members...}};
}

}  // namespace knitmech::base
