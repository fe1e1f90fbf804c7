// Desk of the time bar: controls the embedded simulator's time and shows the clock.
#pragma once

#include <optional>

#include "app/desks/desk.h"
#include "app/desks/plan_desk.h"

namespace usar::app {

/// Pauses, steps and paces simulated time for all robots. A halted plan pauses it, too. Without a robot time runs at
/// most at real time, so that the clock does not run away. GUI thread.
class TimeDesk : public Desk {
    Q_OBJECT
public:
    TimeDesk(const DeskContext& context, PlanDesk& plan) : Desk(context), plan_(plan) {}

    void registerCommands() override;
    void wire() override;
    /// Prepares for another server. `steerable`: it is the embedded simulator, the only one whose time can be
    /// controlled.
    void begin(bool steerable);
    /// `speed`: simulated seconds per real second; infinite: as fast as possible.
    void setSpeed(double speed);
    /// Limits the speed to real time, because the user drives a robot by hand.
    void slowDown();

signals:
    void pausedChanged(bool paused);

private:
    void pause(bool paused);
    /// Pauses time while a plan is halted, and lets it run again unless the user has paused it meanwhile.
    void hold(bool hold);
    /// Makes one tick, or one cycle of the plans that are halted.
    void step();
    /// Lets the simulator run at the chosen speed, or at most at real time while there is no robot.
    void run();
    /// Notes whether there is a robot, ours or another program's, and changes the pace if that has changed.
    void lookForRobots();
    /// Returns to real time once no behavior runs, because a fast clock would only drain batteries.
    void returnToRealTime();
    /// Shows the selected robot's time, or else the simulator's, or else that of any robot.
    void showClock();

    PlanDesk& plan_;
    std::optional<Seconds> server_now_; ///< the embedded simulator's clock; nullopt: unknown
    bool others_ = false;               ///< the embedded simulator has robots, of whatever program
    bool held_by_plan_ = false;         ///< time was paused by a plan, not by the user
};

} // namespace usar::app
