#include "core/server/embedded/simulator_files.h"

#include <QFile>
#include <QSaveFile>

#include "core/server/embedded/program_files.h"
#include "core/sim/world/world_generator.h"
#include "core/sim/world/world_reader.h"

namespace usar::server {

Result<sim::World> loadWorld(const QString& name_or_folder) {
    if (const auto seeded = seededWorld(name_or_folder))
        return sim::makeWorld(seeded->generator.toStdString(), seeded->seed, worldsFolder().toStdString());
    return findWorld(name_or_folder).and_then([](const QString& folder) {
        return sim::readWorld(folder.toStdString());
    });
}

sim::RobotsRead loadRobots() {
    return sim::readRobots(robotsFolder().toStdString());
}

Result<std::unique_ptr<sim::Simulation>> resumeSimulation(const QString& path,
                                                          std::shared_ptr<const sim::RobotCatalog> robots,
                                                          const sim::Simulation::ResumeWatch& watch) {
    constexpr qint64 most_bytes = qint64(512) << 20;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure("cannot read the snapshot: " + file.errorString().toStdString(), path.toStdString(),
                       "Check the path");
    if (file.size() > most_bytes)
        return failure("this is larger than any snapshot", path.toStdString(), "Choose a snapshot file");
    const auto snapshot = sim::readSnapshot(file.readAll().toStdString());
    const auto inFile = [&](const Error& error) {
        return failure(error.where + ": " + error.what, path.toStdString(), error.mend);
    };
    if (!snapshot)
        return inFile(snapshot.error());
    auto world = loadWorld(QString::fromStdString(snapshot->options.world_source));
    if (!world)
        return inFile(world.error());
    auto simulation = sim::Simulation::resume(*std::move(world), std::move(robots), *snapshot, watch);
    if (!simulation)
        return inFile(simulation.error());
    return simulation;
}

Result<void> saveSnapshot(const sim::Simulation& simulation, const QString& path) {
    const auto snapshot = simulation.snapshot();
    if (!snapshot)
        return tl::unexpected(snapshot.error());
    const std::string bytes = sim::write(*snapshot);
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(bytes.data(), qint64(bytes.size())) == qint64(bytes.size()) &&
        file.commit())
        return {};
    return failure("the snapshot cannot be written: " + file.errorString().toStdString(), path.toStdString(),
                   "Choose another folder");
}

QStringList textsOf(const std::vector<std::string>& texts) {
    QStringList list;
    for (const std::string& text : texts)
        list << QString::fromStdString(text);
    return list;
}

Result<std::vector<sim::Fault>> readFaults(const QStringList& texts) {
    std::vector<sim::Fault> faults;
    for (const QString& text : texts) {
        auto fault = sim::readFault(text.toStdString());
        if (!fault)
            return failure(fault.error().what, "fault \"" + text.toStdString() + "\"", fault.error().mend);
        faults.push_back(*std::move(fault));
    }
    return faults;
}

usage::Section faultSection() {
    const auto shown = [](std::string_view text) { return QString::fromUtf8(text.data(), qsizetype(text.size())); };
    usage::Section section{.title = "Faults",
                           .text =
                               "Each is a kind and what is said of it, as in \"sensor_bias robot=R1 sensor=INS x=0.5 "
                               "from=60 for=30\" (seconds; robot and sensor by name or type, all where none is "
                               "said). Of each number there is its usual value and its range.",
                           .in_help = true};
    for (const sim::FaultDescription& kind : sim::faultKinds()) {
        QString help = shown(kind.help);
        for (const sim::FaultNumber& number : kind.numbers)
            help += QString("; %1=%2 (%3 to %4%5)")
                        .arg(shown(number.name))
                        .arg(number.usual)
                        .arg(number.smallest)
                        .arg(number.largest)
                        .arg(number.unit.empty() ? QString() : ' ' + shown(number.unit));
        section.entries.emplace_back(shown(kind.word), help);
    }
    return section;
}

} // namespace usar::server
