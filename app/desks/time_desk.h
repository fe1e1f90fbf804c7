// The time bar: the embedded simulator's pace, and the clock that is shown.
#pragma once

#include <optional>

#include <QObject>

#include "app/desks/desk.h"
#include "app/desks/plan_desk.h"

namespace usar::app {

/// Pauses, steps and paces simulated time for all robots; a halted plan may hold it, too. GUI thread.
class TimeDesk : public QObject {
    Q_OBJECT
public:
    TimeDesk(const DeskContext& context, PlanDesk& plan);

    void registerCommands();
    void wire();
    /// Another server is connected to. Only the embedded simulator's time can be steered.
    void begin(bool steerable);
    /// `speed`: simulated seconds per second; infinite: as fast as possible.
    void setSpeed(double speed);
    /// Real time at most: nobody drives faster than the clock on the wall.
    void slowDown();

signals:
    void pausedChanged(bool paused);

private:
    void pause(bool paused);
    /// Holds time while a plan is halted, and releases it unless the user has paused it meanwhile.
    void hold(bool hold);
    /// One tick, or one cycle of the plans that are halted.
    void step();
    /// Time runs until a plan halts again; the bar still shows a pause.
    void runOneCycle();
    /// A fast clock without a behavior only runs batteries down.
    void returnToRealTime();
    /// The selected robot's time, or the simulator's if it has none.
    void showClock();

    DeskContext desk_;
    PlanDesk& plan_;
    std::optional<Seconds> server_now_; ///< the embedded simulator's clock
    bool held_by_plan_ = false;         ///< a plan stopped the time, not the user
};

} // namespace usar::app
