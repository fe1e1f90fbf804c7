#include "app/desks/time_desk.h"

#include <cmath>
#include <limits>

namespace usar::app {

TimeDesk::TimeDesk(const DeskContext& context, PlanDesk& plan) : desk_(context), plan_(plan) {}

void TimeDesk::registerCommands() {
    const auto steerable = [this] { return desk_.control.simulator().running(); };
    auto* const bar = desk_.views.time;
    desk_.commands.add(
        {"time.pause",
         tr("Pause or run the simulator"),
         tr("Time"),
         tr("Stops simulated time for all robots, or lets it run on"),
         "pause",
         {QKeySequence("Ctrl+P")}},
        [this, bar](bool) { pause(!bar->paused()); }, steerable);
    desk_.commands.add(
        {"time.step",
         tr("One tick"),
         tr("Time"),
         tr("One tick of the simulator, while it is paused"),
         "step",
         {QKeySequence("F10")}},
        [this](bool) { step(); }, [bar, steerable] { return steerable() && bar->paused(); });
    desk_.commands.add(
        {"time.faster", tr("Faster"), tr("Time"), tr("The next speed up"), "", {QKeySequence("Ctrl+Shift+Up")}},
        [bar](bool) { bar->changeSpeed(1); }, steerable);
    desk_.commands.add(
        {"time.slower", tr("Slower"), tr("Time"), tr("The next speed down"), "", {QKeySequence("Ctrl+Shift+Down")}},
        [bar](bool) { bar->changeSpeed(-1); }, steerable);
    desk_.commands.add(
        {"time.real", tr("Real time"), tr("Time"), tr("One second a second"), "", {QKeySequence("Ctrl+1")}},
        [this](bool) { setSpeed(1.0); }, steerable);
    desk_.commands.add(
        {"time.max",
         tr("As fast as possible"),
         tr("Time"),
         tr("As fast as this machine can; robots notice nothing"),
         "",
         {QKeySequence("Ctrl+0")}},
        [this](bool) { setSpeed(std::numeric_limits<double>::infinity()); }, steerable);
}

void TimeDesk::wire() {
    connect(desk_.views.time, &widgets::TimeBar::pauseRequested, this, &TimeDesk::pause);
    connect(desk_.views.time, &widgets::TimeBar::stepRequested, this, &TimeDesk::step);
    connect(desk_.views.time, &widgets::TimeBar::speedRequested, this, &TimeDesk::setSpeed);
    connect(&desk_.control.simulator(), &server::SimulatorHost::figuresChanged, this,
            [this](const server::SimulatorFigures& figures) {
                desk_.views.time->setRealTimeFactor(figures.real_time_factor);
                server_now_ = figures.now;
                showClock();
            });
    connect(&desk_.control, &MissionControl::worldKnown, this, [this] {
        desk_.views.time->setSpeed(1.0);
        desk_.views.time->setPaused(false);
        emit pausedChanged(false);
    });
    connect(&desk_.control, &MissionControl::robotUpdated, this, [this](int id) {
        if (id == desk_.selection.id())
            showClock();
    });
    connect(&desk_.control, &MissionControl::behaviorFinished, this, &TimeDesk::returnToRealTime);
    connect(&plan_, &PlanDesk::timeWanted, this, [this](bool runs) { hold(!runs); });
    connect(&plan_, &PlanDesk::cycleWanted, this, &TimeDesk::runOneCycle);
}

void TimeDesk::begin(bool steerable) {
    server_now_.reset();
    desk_.views.time->setSteerable(steerable);
}

void TimeDesk::pause(bool paused) {
    held_by_plan_ = false;
    if (!paused)
        plan_.goOn(); // A plan that stays halted would hold up its server's time.
    desk_.views.time->setPaused(paused);
    emit pausedChanged(paused);
    if (paused)
        desk_.control.setPace(server::Pace::Paused, 1.0);
    else
        setSpeed(desk_.views.time->speed());
    desk_.commands.refresh();
}

void TimeDesk::hold(bool hold) {
    if (!desk_.control.simulator().running())
        return;
    const bool paused = desk_.views.time->paused();
    if (hold && !paused) {
        pause(true);
        held_by_plan_ = true;
    } else if (!hold && held_by_plan_) {
        pause(false);
    } else if (paused) {
        desk_.control.setPace(server::Pace::Paused, 1.0); // A step is over.
    }
}

void TimeDesk::step() {
    if (plan_.anyHalted())
        plan_.stepCycle();
    else
        desk_.control.simulator().stepOnce();
}

void TimeDesk::runOneCycle() {
    if (!desk_.views.time->paused())
        return;
    const double speed = desk_.views.time->speed();
    desk_.control.setPace(std::isinf(speed) ? server::Pace::Fast : server::Pace::Factor, speed);
}

void TimeDesk::setSpeed(double speed) {
    desk_.views.time->setSpeed(speed);
    if (!desk_.views.time->paused())
        desk_.control.setPace(std::isinf(speed) ? server::Pace::Fast : server::Pace::Factor, speed);
}

void TimeDesk::slowDown() {
    if (desk_.views.time->speed() > 1.0)
        setSpeed(1.0);
}

void TimeDesk::returnToRealTime() {
    for (const Robot* robot : desk_.control.robots())
        if (robot->running())
            return;
    if (desk_.views.time->speed() > 1.0 && !desk_.views.time->paused())
        setSpeed(1.0);
}

void TimeDesk::showClock() {
    const auto timed = [](const Robot* robot) { return robot && robot->view().figures.now.count() > 0.0; };
    const Robot* const shown = desk_.selection.robot();
    if (shown && (shown->isReplay() || timed(shown)))
        return desk_.views.time->setClock(shown->view().figures.now);
    if (server_now_)
        return desk_.views.time->setClock(*server_now_);
    for (const Robot* robot : desk_.control.robots()) // A base station gets no time; robots on its server do.
        if (!robot->isReplay() && timed(robot))
            return desk_.views.time->setClock(robot->view().figures.now);
}

} // namespace usar::app
