// An exploring P2DX: its state, senses and acts. Both the C++ behavior and the POSH plan use it.
#pragma once

#include <optional>
#include <vector>

#include "core/agent/timed_behavior.h"
#include "robots/p2dx/surroundings.h"
#include "robots/p2dx/track.h"

namespace usar::p2dx {

/// Senses describe the situation and acts return the DRIVE command of a tick; call `perceive` once per tick before
/// them. The robot roams until it is in danger. Then it backs away as far as it knows the ground there, turns away from
/// the nearer side until the way is free, and drives straight on for a moment. Owned by one behavior.
///
/// If the scanner repeats itself while the robot moves, it is frozen, and the robot stops. A scanner that froze with
/// nothing in reach cannot be distinguished from one that looks over an empty plain: beams without an echo have no
/// noise, and on a plain there is no echo for a long way. The sonars do not help to tell, because low objects make them
/// hear what no scan shows. In that case only the sonars turn the robot back from what is ahead, and it may touch what
/// is beside it.
class Explorer : public agent::TimedDecider<Settings> {
public:
    explicit Explorer(const agent::BehaviorContext& context)
        : TimedDecider(context)
        , area_in_map_(context.task.area_in_map) {}

    /// Stores scan, sonar echoes and INS reading of an info line. As in the thesis, the robot does not use the modules.
    void hear(const protocol::InfoLine& line);
    /// Evaluates what was heard since the last tick.
    void perceive(const agent::Tick& tick);

    // Senses.
    /// Time since the newest scan; huge before the first scan and while the scanner is frozen.
    Seconds scanAge() const;
    /// Whether the newest scan is older than 2 s, so that the robot must stop.
    bool blind() const { return scanAge() > Seconds{2.0}; }
    /// Whether the user paused the robot or it has not rested long enough to start.
    bool waiting() const { return run_.paused || !run_.began || run_.elapsed() < Seconds(settings_.rest_time_s); }
    /// Whether something ahead is too close, the ground falls too steeply, or the robot is still backing away from
    /// that.
    bool inDanger() const { return maneuver_ == Maneuver::Backing || (maneuver_ == Maneuver::None && tooClose()); }
    /// Whether the robot has stayed in one place for longer than the settings allow.
    bool trapped() const;
    /// Whether the robot has backed away or is turning around and the way is not free yet.
    bool mustTurn() const { return maneuver_ == Maneuver::Turning; }
    /// The third of the scan to head for. It changes only if another third has a clear lead.
    Third open() const { return run_.now < straight_until_ ? Third::Ahead : chosen_; }

    // Acts. Each returns the wheel speeds to send in this tick.
    /// Stops the wheels; the state tells the user why the robot stands.
    protocol::SkidDrive halt();
    /// Begins to back away if no maneuver is under way; turns instead if no ground behind is known to be free.
    protocol::SkidDrive reverse();
    /// Turns in place, to the side that was chosen when the danger was met.
    protocol::SkidDrive turnAway();
    /// These drive at the speed that the free way ahead allows; in a curve the inner wheel is slower.
    protocol::SkidDrive goAhead();
    protocol::SkidDrive steerLeft();
    protocol::SkidDrive steerRight();
    /// Begins to turn around; the second time in the same place it backs away first. Commands no wheels itself.
    void escape();

    agent::BehaviorStatus status() const { return run_.status(Seconds(settings_.drive_time_s), track_.distance_m()); }
    agent::PoseEstimate pose() const { return {run_.now, track_.base_in_map()}; }

private:
    /// A danger leads to Backing and then Turning; without free ground behind the robot it turns at once.
    enum class Maneuver { None, Backing, Turning };

    void takeReadings();
    /// Notices a frozen scanner.
    void watchForIce();
    /// Warns once each time the scanner falls silent or freezes.
    void watchScanner();
    void stepManeuver(Seconds dt);
    /// Ends the turn when the angle is reached and the way is free, or after a full circle.
    void stepTurn();
    bool frozen() const;
    /// True if the scanner, the front sonars or the slope show a danger ahead.
    bool tooClose() const;
    /// True if everything ahead is too far away to become a danger at once.
    bool wayIsFree() const;
    /// Chooses the side to turn to; dangers that closely follow one another keep the side.
    void backAway();
    void beginBacking(double distance_m);
    void beginTurn(double angle_rad);
    double roamingSpeed_m_s() const;
    /// Speed of the inner wheel as a share of the outer one; 1 if that side is blocked.
    double innerShare(double side_m) const;
    protocol::SkidDrive drive(double left_m_s, double right_m_s, Motion motion, const char* state);

    Rectangle area_in_map_;

    std::optional<protocol::RangeScan> scan_;
    /// The newest echo of each sonar, by name.
    std::vector<protocol::NamedRange> sonars_;
    std::optional<Pose> ins_in_map_;
    bool scan_is_new_ = false;
    std::vector<double> former_ranges_m_; ///< ranges of the previous scan
    double moved_with_same_scan_m_ = 0.0; ///< distance driven, plus the distance that the hull's rim turned

    std::optional<Seconds> scan_at_;
    Surroundings around_;
    Track track_;
    Third chosen_ = Third::Ahead;

    Maneuver maneuver_ = Maneuver::None;
    Seconds maneuver_time_{0.0};
    double to_back_m_ = 0.0;
    double backed_m_ = 0.0;
    double to_turn_rad_ = 0.0;
    double turned_rad_ = 0.0;
    bool turns_left_ = false;
    double side_kept_until_m_ = 0.0; ///< distance driven up to which all turns go to the same side
    Seconds straight_until_{0.0};
    Vec2 escaped_from_m_ = Vec2::Constant(1e9); ///< place of the last escape, map frame

    Motion motion_ = Motion::Standing;
    bool blind_told_ = false;
};

} // namespace usar::p2dx
