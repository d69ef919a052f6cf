#include "solve/broken_yarns.h"

#include <algorithm>

#include "model/places.h"

namespace knitmech::solve {

void BrokenYarns::cut(const std::vector<std::size_t>& elements) {
  if (!cut_) cut_ = whole_;
  for (const std::size_t element : elements) elements_.push_back(static_cast<int>(element));
  std::ranges::sort(elements_);
  cut_->yarns = model::pieces_of_yarns(whole_, elements_);
}

int BrokenYarns::whole_yarn(int piece) const {
  const model::ModelYarn& nodes = model().yarns[static_cast<std::size_t>(piece)];
  return model::yarn_of_node(whole_, static_cast<std::size_t>(nodes.first_node));
}

double BrokenYarns::start_of(int piece) const {
  const model::ModelYarn& nodes = model().yarns[static_cast<std::size_t>(piece)];
  const model::ModelYarn& whole = whole_.yarns[static_cast<std::size_t>(whole_yarn(piece))];
  return whole_.arc_length[static_cast<std::size_t>(nodes.first_node)] -
         whole_.arc_length[static_cast<std::size_t>(whole.first_node)];
}

model::Ravelling BrokenYarns::ravelling_of(const contact::RavelEvent& event) const {
  const model::ModelYarn& piece = model().yarns[static_cast<std::size_t>(event.yarn)];
  const int yarn = whole_yarn(event.yarn);
  const model::ModelYarn& whole = whole_.yarns[static_cast<std::size_t>(yarn)];
  const bool is_last = event.end == contact::YarnEnd::last_node;
  const int node = piece.first_node + (is_last ? piece.n_nodes - 1 : 0);
  const int whole_node = whole.first_node + (is_last ? whole.n_nodes - 1 : 0);
  model::Ravelling ravelling{.yarn = yarn,
                             .is_last_end = is_last,
                             .broken_end = {},
                             .other_yarn = whole_yarn(event.other_yarn),
                             .other_place = event.arc_length,
                             .position = {event.place.x, event.place.y, event.place.z}};
  if (node != whole_node) ravelling.broken_end = node;
  return ravelling;
}

void BrokenYarns::name_whole_yarns(std::vector<model::ContactRecord>& contacts) const {
  if (!cut_) return;
  for (model::ContactRecord& contact : contacts) {
    contact.first_place += start_of(contact.first_yarn);
    contact.second_place += start_of(contact.second_yarn);
    contact.first_yarn = whole_yarn(contact.first_yarn);
    contact.second_yarn = whole_yarn(contact.second_yarn);
  }
}

}  // namespace knitmech::solve
