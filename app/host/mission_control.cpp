#include "app/host/mission_control.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/host/true_figures.h"
#include "core/mission/fleet/robot.h"
#include "core/server/embedded/program_files.h"
#include "core/server/embedded/simulator_files.h"

namespace usar::app {

MissionControl::MissionControl(QObject* parent) : Fleet(server::behaviorHostProgram(), parent) {
    connect(this, &MissionControl::serverLeft, this, &MissionControl::leave);
    connect(this, &MissionControl::nextConnected, this, &MissionControl::goOnWithNext);
    connect(&simulator_, &server::SimulatorHost::ready, this, &MissionControl::enter);
    connect(&simulator_, &server::SimulatorHost::robotLearned, this, [this](const QString&, const auto&... robot) {
        world_.learn(robot...);
        emit classesChanged();
    });
    connect(&simulator_, &server::SimulatorHost::failed, this, [this](const QString& reason) {
        note(Severity::Error, "simulator", tr("The embedded simulator did not start. %1").arg(reason));
    });
    connect(&simulator_, &server::SimulatorHost::noted, this,
            [this](const QString& sentence) { note(Severity::Note, "simulator-log", sentence); });
    connect(&simulator_, &server::SimulatorHost::robotRefused, this,
            [this](const QString& sentence) { note(Severity::Warning, "robot-file", sentence); });
    connect(&simulator_, &server::SimulatorHost::movedPort, this,
            [this](const QString& sentence) { note(Severity::Warning, "simulator-port/" + sentence, sentence); });
    connect(&simulator_, &server::SimulatorHost::faultTurned, this, &MissionControl::noteFault);
    connect(&simulator_, &server::SimulatorHost::robotsChanged, this,
            [this](const std::vector<sim::RobotTruth>& truths) {
                for (const sim::RobotTruth& truth : truths)
                    setTruth(truth.name, trueFiguresOf(truth));
            });
}

/// Ends the sessions while the simulator still runs, so that every robot is stopped.
MissionControl::~MissionControl() {
    endSessions();
}

void MissionControl::connectTo(const ServerTarget& target) {
    disconnectFromServer();
    target_ = target;
    if (!target.embedded)
        return openLink(target.host, target.port, false, server::equipmentAdvice());
    if (target.simulator.snapshot.isEmpty()) // a snapshot has its own seed
        setSeed(target.simulator.seed);
    simulator_.start(target.simulator);
}

void MissionControl::enter(quint16 port, const server::WorldPicture& world,
                           const std::vector<sim::Simulation::Orphan>& waiting) {
    waiting_ = waiting;
    world_ = world;
    setWorldExtent(world.extent_in_map);
    setDryAbove(world.dry_above_m);
    setTruthMaker(truthMakerOf(world.world));
    emit worldKnown(world);
    emit classesChanged();
    openLink("127.0.0.1", port, true);
}

void MissionControl::leave() {
    waiting_.clear();
    simulator_.stop();
    world_ = {};
    emit classesChanged();
}

std::vector<agent::RobotDescription> MissionControl::robotsToSpawn() const {
    std::vector<agent::RobotDescription> robots = plugins().kinds();
    for (const QString& name : world_.robot_classes) {
        const std::string class_name = "USARBot." + name.toStdString();
        if (std::ranges::count(robots, class_name, &agent::RobotDescription::class_name) == 0)
            robots.push_back({class_name, name.toStdString(), {}, {}});
    }
    return robots;
}

void MissionControl::setPace(server::Pace pace, double factor) {
    simulator_.setPace(pace, std::isinf(factor) ? 1.0 : factor);
    expectSilence(simulator_.running() && pace == server::Pace::Paused);
}

void MissionControl::goOnWithNext() {
    if (waiting_.empty())
        return;
    const sim::Simulation::Orphan orphan = waiting_.front();
    waiting_.erase(waiting_.begin());
    if (const auto id = spawn({orphan.class_name, orphan.name, orphan.base_in_map}); !id) {
        note(Severity::Warning, "snapshot",
             tr("The snapshot goes on without some of its robots. %1").arg(QString::fromStdString(id.error().text())));
        waiting_.clear();
        simulator_.letOrphansGo();
    }
}

Result<void> MissionControl::addFaults(const QStringList& texts) {
    if (!simulator_.running())
        return failure("faults are possible only in the embedded simulator", "", "Connect to it first");
    auto faults = server::readFaults(texts);
    if (!faults)
        return tl::unexpected(faults.error());
    simulator_.addFaults(*faults);
    return {};
}

} // namespace usar::app
