#include "app/desks/time_desk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace usar::app {

void TimeDesk::registerCommands() {
    const auto steerable = [this] { return control_.simulator().running(); };
    auto* const bar = views_.time;
    add("time.pause", steerable, [this, bar] { pause(!bar->paused()); });
    add(
        "time.step", [bar, steerable] { return steerable() && bar->paused(); }, [this] { step(); });
    add("time.faster", steerable, [bar] { bar->changeSpeed(1); });
    add("time.slower", steerable, [bar] { bar->changeSpeed(-1); });
    add("time.real", steerable, [this] { setSpeed(1.0); });
    add("time.max", steerable, [this] { setSpeed(std::numeric_limits<double>::infinity()); });
}

void TimeDesk::wire() {
    connect(views_.time, &widgets::TimeBar::pauseRequested, this, &TimeDesk::pause);
    connect(views_.time, &widgets::TimeBar::stepRequested, this, &TimeDesk::step);
    connect(views_.time, &widgets::TimeBar::speedRequested, this, &TimeDesk::setSpeed);
    connect(&control_.simulator(), &server::SimulatorHost::figuresChanged, this,
            [this](const server::SimulatorFigures& figures) {
                views_.time->setRealTimeFactor(figures.real_time_factor);
                server_now_ = figures.now;
                showClock();
            });
    connect(&control_, &MissionControl::worldKnown, this, [this] {
        views_.time->setSpeed(1.0);
        views_.time->setPaused(false);
        lookForRobots();
        emit pausedChanged(false);
    });
    connect(&control_.simulator(), &server::SimulatorHost::robotsChanged, this,
            [this](const std::vector<sim::RobotTruth>& robots) {
                others_ = !robots.empty();
                lookForRobots();
            });
    connect(&control_, &MissionControl::robotAdded, this, &TimeDesk::lookForRobots);
    connect(&control_, &MissionControl::robotRemoved, this, &TimeDesk::lookForRobots);
    connectUpdates([this](const auto&) { showClock(); });
    connect(&control_, &MissionControl::behaviorFinished, this, &TimeDesk::returnToRealTime);
    connect(&plan_, &PlanDesk::timeWanted, this, [this](bool runs) { hold(!runs); });
    connect(&plan_, &PlanDesk::cycleWanted, this, [this] { // until a plan halts again; the bar still shows a pause
        if (views_.time->paused())
            run();
    });
}

void TimeDesk::begin(bool steerable) {
    server_now_.reset();
    others_ = false;
    views_.time->setLimited(false);
    views_.time->setSteerable(steerable);
}

void TimeDesk::pause(bool paused) {
    held_by_plan_ = false;
    if (!paused)
        plan_.goOn(); // A plan that stays halted would hold up its server's time.
    views_.time->setPaused(paused);
    emit pausedChanged(paused);
    if (paused)
        control_.setPace(server::Pace::Paused, 1.0);
    else
        setSpeed(views_.time->speed());
    commands_.refresh();
}

void TimeDesk::hold(bool hold) {
    if (!control_.simulator().running())
        return;
    const bool paused = views_.time->paused();
    if (hold && !paused) {
        pause(true);
        held_by_plan_ = true;
    } else if (!hold && held_by_plan_) {
        pause(false);
    } else if (paused) {
        control_.setPace(server::Pace::Paused, 1.0); // A step is over.
    }
}

void TimeDesk::step() {
    if (plan_.anyHalted())
        plan_.stepCycle();
    else
        control_.simulator().stepOnce();
}

void TimeDesk::lookForRobots() {
    const bool none = control_.simulator().running() && !others_ && control_.liveNames().isEmpty();
    if (none == views_.time->limited())
        return;
    views_.time->setLimited(none);
    if (!views_.time->paused() && control_.simulator().running())
        run();
}

void TimeDesk::run() {
    const double speed = views_.time->limited() ? std::min(views_.time->speed(), 1.0) : views_.time->speed();
    control_.setPace(std::isinf(speed) ? server::Pace::Fast : server::Pace::Factor, speed);
}

void TimeDesk::setSpeed(double speed) {
    views_.time->setSpeed(speed);
    if (!views_.time->paused())
        run();
}

void TimeDesk::slowDown() {
    if (views_.time->speed() > 1.0)
        setSpeed(1.0);
}

void TimeDesk::returnToRealTime() {
    if (!control_.anyRunning() && views_.time->speed() > 1.0 && !views_.time->paused())
        setSpeed(1.0);
}

void TimeDesk::showClock() {
    const auto timed = [](const Robot* robot) { return robot && robot->view().figures.now.count() > 0.0; };
    const Robot* const shown = selection_.robot();
    if (shown && (shown->isReplay() || timed(shown)))
        return views_.time->setClock(shown->view().figures.now);
    if (server_now_)
        return views_.time->setClock(*server_now_);
    for (const Robot* robot : control_.robots()) // A base station gets no time; robots on its server do.
        if (!robot->isReplay() && timed(robot))
            return views_.time->setClock(robot->view().figures.now);
}

} // namespace usar::app
