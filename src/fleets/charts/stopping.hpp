#pragma once

namespace rubicon::charts {

/// What a robot needs to stop before something that it sees on its way. Lengths in m, times in s.
struct Stopping {
  double braking = 0;   ///< m/s2; 0: nothing was said of stopping
  double scan = 0;      ///< from one scan to the next
  double reaction = 0;  ///< from a scan to the brakes
  double standoff = 0;  ///< between the robot that stands and what it saw
  double sensing = 0;   ///< how far its sensors see; 0: not said

  bool is_known() const { return braking > 0; }
};

/// How far a robot has to see at one speed (m/s). All in m.
struct SensingNeed {
  double speed = 0;
  /// Driven on at full speed: something comes into sight just after a scan, and is seen by the
  /// next.
  double until_brakes = 0;
  double braked = 0;     ///< speed^2 / (2 braking)
  double to_stop = 0;    ///< both, and the standoff
  double two_scans = 0;  ///< if a second scan has to confirm the first before it brakes
  /// If what it sees drives towards it just as fast and stops by the same rules.
  double oncoming = 0;
};

SensingNeed sensing_need(const Stopping& stopping, double speed);

/// The speed (m/s) at which the need to stop is the range (m); 0 if that is the standoff or less.
double greatest_speed(const Stopping& stopping, double range);

}  // namespace rubicon::charts
