#pragma once

#include <cstddef>
#include <cstdint>

#include "base/vectorise.h"
#include "contact/element_line.h"
#include "model/state.h"

namespace knitmech::contact {

/// What a contact does to the nodes of an element; nothing where there is no element.
struct ElementLoad {
  static constexpr std::int32_t kNone = -1;
  std::int32_t element = kNone;
  EndLoads loads{};
};

/// Whether one of the nodes from begin to before end is of an element, if it is one.
KNITMECH_INLINE bool has_nodes_within(std::int32_t element, std::size_t begin, std::size_t end) {
  return element != ElementLoad::kNone && static_cast<std::size_t>(element) < end &&
         static_cast<std::size_t>(element) + 1 >= begin;
}

/// Adds what a load does to the nodes from begin to before end: threads that have nodes of their own add the same
/// loads, in the same order.
KNITMECH_INLINE void add_within(const ElementLoad& load, std::size_t begin, std::size_t end, model::NodalLoads& loads) {
  if (!has_nodes_within(load.element, begin, end)) return;
  const auto i = static_cast<std::size_t>(load.element);
  if (i >= begin && i < end) {
    loads.force.add(i, load.loads.start_force);
    loads.moment.add(i, load.loads.start_moment);
  }
  if (i + 1 >= begin && i + 1 < end) {
    loads.force.add(i + 1, load.loads.end_force);
    loads.moment.add(i + 1, load.loads.end_moment);
  }
}

}  // namespace knitmech::contact
