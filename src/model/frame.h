#pragma once

#include <Eigen/Core>
#include <vector>

namespace knitmech::model {

/// One row of the history: everything that is a single number at one instant.
struct HistoryRow {
  double time = 0;                 ///< [s]
  double displacement = 0;         ///< [mm], of the driven grip
  double strain = 0;               ///< [-]
  double force_top = 0;            ///< [N], along y, pull positive, summed over the driven grip
  double force_bottom = 0;         ///< [N], along y, pull positive, summed over the held grip
  double external_work = 0;        ///< [mJ], done by the driven grip
  double internal_energy = 0;      ///< [mJ], strain energy of the beams
  double kinetic_energy = 0;       ///< [mJ], translation and rotation, scaled mass included
  double contact_energy = 0;       ///< [mJ], stored in the contact penalty and the elastic stick
  double friction_loss = 0;        ///< [mJ]
  double damping_loss = 0;         ///< [mJ], bulk viscosity and mass damping
  double width = 0;                ///< [mm], extent along x at mid-height of the fabric
  int contacts = 0;                ///< contact points with a force
  double largest_penetration = 0;  ///< [mm]
  double step = 0;                 ///< [s], time step in use
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
  std::vector<double> curvature;               ///< [1/mm], element, change since the stress-free shape, magnitude
  std::vector<Eigen::Vector3d> contact_force;  ///< [N], node
  std::vector<double> gap;  ///< [mm], node, least gap to another piece of yarn; +infinity where none is near
};

}  // namespace knitmech::model
