#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "beam/internal_force.h"
#include "beam/nodal_inertia.h"
#include "beam_case.h"
#include "contact/yarn_contact.h"
#include "relax.h"
#include "solve/integrate.h"

namespace knitmech::test {

/// Yarns in contact, stepped by explicit dynamics under the loads and holds of a test.
struct ContactBench {
  model::Model model;
  beam::Elements elements;
  beam::NodalInertia inertia;
  contact::YarnContact contact;
  model::State state;
  model::NodalLoads loads;
  beam::ElementWork work;
  double step;  ///< [s]

  /// \param share of the stable step of the beams alone; contact no stiffer than the beams' EA / L0 leaves room for 0.4
  explicit ContactBench(model::Model of, double share = 0.4)
      : model(std::move(of)),
        elements(beam::make_elements(model, 1.0, 0.0)),
        inertia(beam::lump_inertia(elements, 1.0)),
        contact(model),
        state(state_of(model)),
        loads(model.nodes.size()),
        work(model.nodes.size()),
        step(share * 2 / std::sqrt(inertia.highest_frequency_squared)) {}

  /// One step. \param extra what acts besides beams and contact   \param mass_damping [1/s]
  void advance(const ExtraLoads& extra, double mass_damping = 0) {
    forces(step);
    extra(state, loads);
    solve::integrate(inertia, loads, {step, step}, mass_damping, state);
  }

  /// Forces of beams and contact in the present state. \param since [s] since they were computed last
  void forces(double since) {
    beam::set_internal_force(elements, state, since, work, loads);
    contact.add_forces(state, since, loads);
  }

  /// Brings the yarns to rest. \param slowest angular frequency of the slowest vibration [1/s]; damped critically
  /// \return largest speed at the end over the largest speed on the way [-]: how well they rest
  double settle(double slowest, const ExtraLoads& extra) {
    const long n_steps = std::lround(40 / (slowest * step));
    double largest = 0;
    for (long i = 0; i < n_steps; ++i) {
      advance(extra, 2 * slowest);
      largest = std::max(largest, solve::largest_speed_squared(state));
    }
    return std::sqrt(solve::largest_speed_squared(state) / largest);
  }

  /// What the contact alone does to the nodes in the present state.
  [[nodiscard]] model::NodalLoads contact_loads() {
    model::NodalLoads only(model.nodes.size());
    contact.add_forces(state, 0, only);
    return only;
  }

  /// Sum of the contact forces on a yarn [N].
  [[nodiscard]] Eigen::Vector3d contact_force_on(std::size_t yarn) {
    const model::NodalLoads only = contact_loads();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = first_node(yarn); i <= last_node(yarn); ++i) sum += vector_at(only.force, i);
    return sum;
  }

  /// Stored, moving and lost [mJ]; loads must be those of the present state.
  [[nodiscard]] double energy() const {
    return beam::strain_energy(elements, state) + solve::kinetic_energy(inertia, loads, {step, step}, state) +
           contact.energy() + contact.friction_loss();
  }

  [[nodiscard]] Eigen::Vector3d momentum() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < inertia.mass.size(); ++i) sum += inertia.mass[i] * vector_at(state.velocity, i);
    return sum;
  }

  [[nodiscard]] std::size_t first_node(std::size_t yarn) const {
    return static_cast<std::size_t>(model.yarns[yarn].first_node);
  }
  [[nodiscard]] std::size_t last_node(std::size_t yarn) const {
    return first_node(yarn) + static_cast<std::size_t>(model.yarns[yarn].n_nodes) - 1;
  }

  /// Axial force of an element [N], from the stretch of its chord.
  [[nodiscard]] double tension(std::size_t element) const {
    const double length = (vector_at(state.position, element + 1) - vector_at(state.position, element)).norm();
    return elements.axial[element] * (length * elements.inverse_length[element] - 1);
  }
};

/// The monofilament of the main example: D 0.12 mm, E 1700 MPa, nu 0.39.
inline yarn::Section monofilament() {
  return section(19.2265, 6.17, 0.0173039, 0.0124488, 1.29e-11, 0.12);
}

/// A model without yarns yet. \param stiffness of the contact [N/mm]
inline model::Model empty_model(const yarn::Section& section, double friction, double stiffness,
                                model::Centreline centreline) {
  model::Model model;
  model.sections = {section};
  model.friction = friction;
  model.contact_stiffness = stiffness;
  model.centreline = centreline;
  return model;
}

/// Holds the position of a node, free to turn.
inline void pin(model::NodalLoads& loads, std::size_t node) {
  loads.force.set(node, {0, 0, 0});
}

}  // namespace knitmech::test
