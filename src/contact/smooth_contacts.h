#pragma once

#include <vector>

#include "base/thread_team.h"
#include "contact/contact_elements.h"
#include "contact/contact_step.h"
#include "contact/followed_contacts.h"
#include "model/state.h"

namespace knitmech::contact {

/// The forces of contacts on the smooth centreline; what it keeps from step to step is only room to compute in.
class SmoothForces {
 public:
  SmoothForces();
  ~SmoothForces();
  SmoothForces(const SmoothForces& other);
  SmoothForces& operator=(const SmoothForces& other);

  /// Brings the followed places up to date with the centreline and adds their normal and friction forces to the nodes.
  /// The same to the last bit for any number of threads.
  ContactStep add(const StepOfContacts& step, const ContactElements& pieces, const base::ThreadTeam& team,
                  FollowedContacts& contacts, model::NodalLoads& loads);

 private:
  struct Work;
  void evaluate(const StepOfContacts& step, std::vector<Crossing>& crossings, std::size_t begin, std::size_t end,
                Work& work, ContactStep& done);
  void flush(const StepOfContacts& step, std::vector<Crossing>& crossings, Work& work, ContactStep& done);

  std::vector<ElementLoad> on_crossings_;        ///< of this step, two for each
  std::vector<std::int32_t> crossing_elements_;  ///< on which these are: a short list, quick to go through
  std::vector<ContactStep> done_;                ///< by the shares of the threads
  std::vector<Work> works_;                      ///< one for each thread
};

}  // namespace knitmech::contact
