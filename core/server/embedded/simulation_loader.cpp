#include "core/server/embedded/simulation_loader.h"

#include <algorithm>
#include <utility>

#include <QElapsedTimer>
#include <QThread>

#include "core/base/text.h"
#include "core/link/across_threads.h"
#include "core/protocol/commands/spawn.h"
#include "core/sim/robots/footprint.h"

namespace usar::server {

namespace {

constexpr qint64 progress_interval_ms = 100;

std::shared_ptr<const sim::RobotCatalog> readRobots(const QStringList& further_files, LoadedSimulation& loaded) {
    sim::RobotsRead read = loadRobots();
    for (const QString& file : further_files) {
        auto robot = sim::readRobot(file.toStdString());
        if (!robot) {
            read.refused.push_back(robot.error());
            continue;
        }
        std::erase_if(read.robots, [&](const auto& one) { return sameWord(one.class_name, robot->class_name); });
        read.robots.push_back(*std::move(robot));
    }
    for (const Error& refused : read.refused)
        loaded.refused_robots << QString::fromStdString(refused.text());
    for (const sim::RobotModel& robot : read.robots) {
        loaded.robot_classes << QString::fromStdString(robot.class_name);
        if (hasCamera(robot))
            loaded.camera_classes << loaded.robot_classes.back();
        loaded.robot_outlines[loaded.robot_classes.back()] = sim::footprintOf(robot);
    }
    loaded.robot_classes << QString::fromStdString(std::string(protocol::station_class)).section('.', -1);
    return std::make_shared<const sim::RobotCatalog>(std::move(read.robots));
}

} // namespace

bool hasCamera(const sim::RobotModel& robot) {
    return std::ranges::any_of(robot.sensors,
                               [](const sim::SensorModel& sensor) { return sameWord(sensor.type, "Camera"); });
}

Result<LoadedSimulation> loadSimulation(const SimulatorSpec& spec, const sim::Simulation::ResumeWatch& watch) {
    LoadedSimulation loaded;
    auto catalog = readRobots(spec.robot_files, loaded);
    const auto keep = [&](Result<std::unique_ptr<sim::Simulation>> made) -> Result<LoadedSimulation> {
        if (!made)
            return tl::unexpected(made.error());
        loaded.simulation = *std::move(made);
        return std::move(loaded);
    };
    if (!spec.snapshot.isEmpty())
        return keep(resumeSimulation(spec.snapshot, std::move(catalog), watch));
    Result<sim::World> world = loadWorld(spec.world);
    if (!world)
        return tl::unexpected(world.error());
    return keep(sim::Simulation::make(std::move(*world), {.seed = spec.seed,
                                                          .battery_life = spec.battery_life,
                                                          .robots = std::move(catalog),
                                                          .faults = spec.faults,
                                                          .world_source = spec.world.toStdString()}));
}

SimulationLoader::~SimulationLoader() {
    giveUp();
    for (QThread* thread : findChildren<QThread*>())
        thread->wait();
}

void SimulationLoader::giveUp() {
    if (stop_)
        *stop_ = true;
    stop_.reset();
}

void SimulationLoader::load(const SimulatorSpec& spec) {
    giveUp();
    stop_ = std::make_shared<std::atomic<bool>>(false);
    auto* const thread = QThread::create([this, spec, stop = stop_] {
        QElapsedTimer since_told;
        const auto watch = [&](Seconds done, Seconds whole) {
            if (!since_told.isValid() || since_told.elapsed() >= progress_interval_ms) {
                since_told.start();
                link::post(this, [this, stop, done, whole] {
                    if (stop == stop_)
                        emit progressed(done, whole);
                });
            }
            return !*stop;
        };
        auto made = std::make_shared<Result<LoadedSimulation>>(loadSimulation(spec, watch));
        link::post(this, [this, stop, spec, made] {
            if (stop != stop_)
                return; // It was canceled meanwhile.
            stop_.reset();
            if (!*made)
                return emit refused(QString::fromStdString(made->error().text()));
            SimulatorSpec ready = spec;
            ready.loaded = std::make_shared<LoadedSimulation>(std::move(**made));
            emit loaded(ready);
        });
    });
    thread->setParent(this);
    thread->setObjectName("loader");
    connect(thread, &QThread::finished, thread, &QObject::deleteLater);
    thread->start();
}

} // namespace usar::server
