#pragma once

#include "base/left_out.h"

namespace knitmech::solve {

/// What a pace is measured against: the test and the fabric that it pulls.
struct PaceScale {
  double speed = 0;         ///< [mm/s], of pace 1
  double gauge_length = 0;  ///< [mm]
  double strain = 0;        ///< [-], at the end of the test
  double mass = 0;          ///< [t], scaled, of the whole fabric
  double bending = 0;       ///< [mJ], EI / l summed over all half stitches of length l
};

/// What is known of the fabric at a look.
struct PaceSignals {
  double internal = 0;  ///< [mJ], strain energy
  double kinetic = 0;   ///< [mJ]
  double stray = 0;     ///< [mJ], kinetic energy of the motion relative to an even stretch, see EvenStretch
  double force = 0;     ///< [N], mean of the grip that pulls less, since the look before
};

/// All that a pace remembers.
struct PaceState {
  double displacement = 0;              ///< [mm], of the driven grip
  double speed = 0;                     ///< [mm/s], over the last step
  double acceleration = 0;              ///< [mm/s^2], in the last step
  double goal = 0;                      ///< [mm/s], which the speed tends to
  double speeding_up = 0, braking = 0;  ///< [mm/s^2], largest acceleration and deceleration until the next look
  double looked_at = 0;                 ///< [mm], displacement at the last look
  double internal = 0;                  ///< [mJ], mean over the strain of late
  double kinetic = 0;                   ///< [mJ], the same
  double stray = 0;                     ///< [mJ], the same
  double stray_now = 0;                 ///< [mJ], mean over less of it

  template <class Archive>
  void serialize(Archive& archive) {
    archive(displacement, speed, acceleration, goal, speeding_up, braking, looked_at, internal, kinetic, stray,
            stray_now);
  }
};

/// How fast the grip moves where the program chooses mass and speed: as fast as the inertia of the yarns allows, which
/// is slow while the fabric gives without force and where it snaps, and fast once the yarns bear.
///
/// At each look, after a fixed number of steps, the speed v gets a goal: the least of
///
///     kCalmPace speed sqrt(max(1, internal / (kTautEnergy bending))),
///     v sqrt(kStrayGoal / (stray / internal)),  but not less than kCalmPace speed,
///     v sqrt(kKineticGoal / (kinetic / internal)),  but not less than kSlowestPace speed, where the result is judged.
///
/// The energies are means over the strain of late; kinetic energy at one shape of the fabric goes with v^2. Between two
/// looks the speed goes to its goal at a limited acceleration. Nothing but the simulation's own numbers enters.
/// The constants, measured, stand in constants.h. docs/theory.md, section 10.
class Pace {
 public:
  explicit Pace(const PaceScale& scale);

  /// Sets goal and limits of acceleration anew.
  void look(const PaceSignals& now);

  /// Changes the speed towards its goal and moves the grip.
  /// \param h [s], over which the velocities change; after [s], over which the positions do
  /// \return the speed [mm/s]
  double advance(double h, double after);

  [[nodiscard]] const PaceState& state() const { return state_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(base::left_out(scale_), state_);
  }

 private:
  void take_in(const PaceSignals& now);
  [[nodiscard]] double goal(const PaceSignals& now) const;
  [[nodiscard]] double goal_where_judged() const;
  void limit_acceleration(double force);

  PaceScale scale_;
  PaceState state_;
};

}  // namespace knitmech::solve
