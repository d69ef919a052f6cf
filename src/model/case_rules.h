#pragma once

#include <optional>
#include <string>

#include "model/case.h"

namespace knitmech::model {

/// A case that breaks a rule between parameters: the key where it shows, and what is wrong and what would be right.
struct BrokenRule {
  std::string key;
  std::string complaint;
};

/// The first rule between parameters that a case breaks; each value for itself is taken as allowed.
///
/// The yarn is given either by E and nu or by EA, EI and GJ; frames lie within the test; the model is not larger than
/// kMostElements.
[[nodiscard]] std::optional<BrokenRule> broken_rule(const Case& input);

/// Takes away the frames beyond the end of the test, for a case in which the user asked for none: the default frames
/// are those of a long test.
void cut_frames_to_test(Case& input);

}  // namespace knitmech::model
