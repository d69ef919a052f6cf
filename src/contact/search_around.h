#pragma once

#include <cstdint>
#include <vector>

#include "contact/centreline.h"
#include "contact/contact_elements.h"
#include "contact/neighbour_search.h"

namespace knitmech::contact {

/// The pairs of pieces of a few elements that are due, of which the lines are nearer than the sum of their radii plus a
/// skin, ascending; the same as find_neighbours() finds, but for some that are farther apart than that. Their middles
/// are compared with those of all elements, and only curves that are near are looked at: for few elements that is
/// faster than to sort all of them into a grid. \param due elements of the model, ascending   \param skin [mm]
[[nodiscard]] std::vector<ElementPair> search_around(const std::vector<std::int32_t>& due,
                                                     const ContactElements& pieces, const Centreline& line,
                                                     double skin);

}  // namespace knitmech::contact
