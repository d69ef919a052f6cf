#include "beam/section_results.h"

#include "beam/element.h"

namespace knitmech::beam {

namespace {

double across(Vector3 v, Vector3 axis) {
  return length(v - dot(v, axis) * axis);
}

Quaternion rotation_of(const model::State& state, std::size_t i) {
  const model::RotationArray& q = state.rotation;
  return {q.w[i], {q.x[i], q.y[i], q.z[i]}};
}

}  // namespace

void set_section_results(const Elements& elements, const model::State& state, model::Frame& frame) {
  const std::size_t n = elements.size();
  for (auto* field : {&frame.axial_force, &frame.shear_force, &frame.bending_moment, &frame.torque, &frame.axial_strain,
                      &frame.curvature, &frame.stretch_energy, &frame.bending_energy, &frame.twist_energy}) {
    field->assign(n, 0.0);
  }
  const model::VectorArray& x = state.position;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (elements.axial[i] == 0) continue;  // no element between two yarns
    const ElementProperties element{{elements.axis_x[i], elements.axis_y[i], elements.axis_z[i]},
                                    elements.inverse_length[i],
                                    elements.axial[i],
                                    elements.shear[i],
                                    elements.torsion[i],
                                    elements.bending[i]};
    const Vector3 chord{x.x[i + 1] - x.x[i], x.y[i + 1] - x.y[i], x.z[i + 1] - x.z[i]};
    const ElementState s = element_state(element, chord, rotation_of(state, i), rotation_of(state, i + 1));
    const double twist = dot(s.rotation, element.axis);
    const double bend = across(s.rotation, element.axis);
    frame.axial_force[i] = element.axial * s.axial_strain;
    frame.shear_force[i] = element.shear * length(s.shear_strain);
    frame.torque[i] = dot(s.moment, element.axis);
    frame.bending_moment[i] = across(s.moment, element.axis);
    frame.axial_strain[i] = s.axial_strain;
    frame.curvature[i] = element.inverse_length * bend;
    frame.stretch_energy[i] = stretch_energy(element, s);
    frame.bending_energy[i] = 0.5 * bend * frame.bending_moment[i];
    frame.twist_energy[i] = 0.5 * twist * frame.torque[i];
  }
}

}  // namespace knitmech::beam
