#pragma once

#include <Eigen/Core>
#include <vector>

namespace knitmech::model {

/// One row of the history: everything that is a single number at one instant. The forces of the grips are freed of fast
/// vibration (solve::ForceWindow).
struct HistoryRow {
  double time = 0;                  ///< [s]
  double displacement = 0;          ///< [mm], of the driven grip
  double strain = 0;                ///< [-]
  double force_top = 0;             ///< [N], along y, pull positive, summed over the driven grip
  double force_bottom = 0;          ///< [N], along y, pull positive, summed over the held grip
  double external_work = 0;         ///< [mJ], done by the driven grip
  double internal_energy = 0;       ///< [mJ], strain energy of the beams
  double stretch_energy = 0;        ///< [mJ], the part of it by axial strain and shear
  double kinetic_energy = 0;        ///< [mJ], translation and rotation, scaled mass included
  double contact_energy = 0;        ///< [mJ], stored in the contact penalty, and the elastic stick
  double friction_loss = 0;         ///< [mJ]
  double damping_loss = 0;          ///< [mJ], bulk viscosity and mass damping
  double break_loss = 0;            ///< [mJ], stored energy that vanished when yarns broke
  double width = 0;                 ///< [mm], extent along x at mid-height of the fabric
  int contacts = 0;                 ///< contact points with a force
  double normal_force = 0;          ///< [N], magnitudes of the normal forces of all contacts, summed
  double largest_elastic_slip = 0;  ///< [mm], motion that the sticks have let through before they slip; see friction
  double largest_penetration = 0;   ///< [mm]
  double step = 0;                  ///< [s], time step in use

  template <class Archive>
  void serialize(Archive& archive) {
    archive(time, displacement, strain, force_top, force_bottom, external_work, internal_energy, stretch_energy,
            kinetic_energy, contact_energy, friction_loss, damping_loss, break_loss, width, contacts, normal_force,
            largest_elastic_slip, largest_penetration, step);
  }
};

/// One place where two yarns, or two parts of one yarn, press on each other. "First" and "second" are the yarns in the
/// order of Model::yarns; a place on a yarn is the arc length from its first node along the stress-free yarn.
struct ContactRecord {
  int first_yarn = 0, second_yarn = 0;       ///< index into Model::yarns
  double first_place = 0, second_place = 0;  ///< [mm]
  Eigen::Vector3d position{0, 0, 0};         ///< [mm], halfway between the two centrelines
  Eigen::Vector3d normal{0, 0, 0};           ///< unit vector, from the first centreline to the second
  double gap = 0;                            ///< [mm], negative: penetration
  double normal_force = 0;                   ///< [N]
  Eigen::Vector3d friction_force{0, 0, 0};   ///< [N], on the second yarn, across the normal
  double elastic_slip = 0;                   ///< [mm], that the stick is stretched by
  double slip = 0;                           ///< [mm], length of the path slid since the contact began
  bool slips = false;                        ///< the Coulomb limit was reached in the last step; else it sticks
  double angle = 0;                          ///< [rad], between the two centrelines, 0 (side by side) to pi / 2
};

/// The state of the fabric at one instant, with its fields. Vectors have one entry per node; element fields follow the
/// rule of Model (entry i belongs to the element that starts at node i, a yarn's last entry is zero).
struct Frame {
  int index = 0;  ///< 0, 1, 2, ... in the order of time
  HistoryRow history;
  std::vector<Eigen::Vector3d> points;         ///< node positions [mm]
  std::vector<Eigen::Vector4d> rotations;      ///< node rotations since the start, unit quaternions (w, x, y, z)
  std::vector<double> axial_force;             ///< [N], element
  std::vector<double> shear_force;             ///< [N], element, magnitude
  std::vector<double> bending_moment;          ///< [N mm], element, magnitude
  std::vector<double> torque;                  ///< [N mm], element, signed
  std::vector<double> axial_strain;            ///< [-], element, stretch positive
  std::vector<double> curvature;               ///< [1/mm], element, change since the stress-free shape, magnitude
  std::vector<double> stretch_energy;          ///< [mJ], element, of axial strain and shear
  std::vector<double> bending_energy;          ///< [mJ], element
  std::vector<double> twist_energy;            ///< [mJ], element
  std::vector<Eigen::Vector3d> contact_force;  ///< [N], node
  std::vector<Eigen::Vector3d> tie_force;      ///< [N], node, by ties to other yarns
  std::vector<double> gap;  ///< [mm], node, least gap to another piece of yarn; +infinity where none is near
  std::vector<ContactRecord> contacts;  ///< those with a force
  std::vector<int> broken;              ///< elements that have broken, ascending; their fields are zero
};

}  // namespace knitmech::model
