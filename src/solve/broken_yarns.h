#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/left_out.h"
#include "contact/ravel_watch.h"
#include "model/frame.h"
#include "model/model.h"
#include "model/run_outcome.h"

namespace knitmech::solve {

/// The model of a run in which yarns break, and the way back from it to the yarns as they were.
///
/// A broken element is taken out as if its yarn were two: nodes and their numbers stay, and between the last node of
/// one piece and the first of the next there is no element. Contact is made of that model; what it says of yarns is
/// translated here. There is a second model in memory only once something has broken.
class BrokenYarns {
 public:
  explicit BrokenYarns(const model::Model& whole) : whole_(whole) {}

  /// Takes elements out.
  void cut(const std::vector<std::size_t>& elements);

  /// With the pieces in place of the yarns.
  [[nodiscard]] const model::Model& model() const { return cut_ ? *cut_ : whole_; }
  /// All that are out, ascending.
  [[nodiscard]] const std::vector<int>& elements() const { return elements_; }

  /// An event of the pieces as one of the yarns, without its strain. An end that a yarn did not have is a broken end.
  [[nodiscard]] model::Ravelling ravelling_of(const contact::RavelEvent& event) const;
  /// Puts the yarns, and the places on them, into contacts of the pieces.
  void name_whole_yarns(std::vector<model::ContactRecord>& contacts) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(base::left_out(whole_, cut_), elements_);
    if constexpr (Archive::is_loading::value) {
      if (!elements_.empty()) cut({});
    }
  }

 private:
  [[nodiscard]] int whole_yarn(int piece) const;
  /// Arc length from the first node of the whole yarn to the first of the piece [mm].
  [[nodiscard]] double start_of(int piece) const;

  const model::Model& whole_;
  std::optional<model::Model> cut_;
  std::vector<int> elements_;
};

}  // namespace knitmech::solve
