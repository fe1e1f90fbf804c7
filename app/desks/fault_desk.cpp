#include "app/desks/fault_desk.h"

#include <algorithm>
#include <cmath>

#include "core/server/embedded/simulator_files.h"
#include "widgets/style/empty_state.h"

namespace usar::app {

namespace {

/// Types of lines that a robot sends but that belong to no sensor.
const QStringList no_sensors{"STA", "MISSTA", "GEO", "CONF", "RES", "NFO"};

std::vector<widgets::FaultKindInfo> kindsOf(std::span<const sim::FaultDescription> kinds) {
    std::vector<widgets::FaultKindInfo> infos;
    for (const sim::FaultDescription& kind : kinds) {
        widgets::FaultKindInfo info{
            QString::fromUtf8(kind.word), QString::fromUtf8(kind.help), kind.of_robot, kind.of_sensor, {}};
        for (const sim::FaultNumber& number : kind.numbers)
            info.quantities.push_back({QString::fromUtf8(number.name), QString::fromUtf8(number.unit), number.smallest,
                                       number.largest, number.usual, QString::fromUtf8(number.help)});
        infos.push_back(std::move(info));
    }
    return infos;
}

QString withoutTimes(const sim::Fault& fault) {
    return QString::fromStdString(writeWithoutTimes(fault));
}

widgets::FaultRow rowOf(const sim::FaultStatus& status) {
    const sim::Fault& fault = status.fault;
    return {status.id, withoutTimes(fault), static_cast<widgets::FaultState>(status.phase),
            widgets::faultTimes(fault.from, fault.lasts)};
}

/// Rounded for readability; infinite times stay infinite.
Seconds roundedToMs(Seconds time) {
    return Seconds{std::round(time.count() * 1e3) / 1e3};
}

/// Returns the part of a fault that is still to come at `now`, with times relative to now, for a new run.
sim::Fault restOf(sim::Fault fault, Seconds now) {
    const Seconds begin = fault.from - now;
    fault.from = roundedToMs(std::max(Seconds{0.0}, begin));
    fault.lasts = roundedToMs(fault.lasts + std::min(Seconds{0.0}, begin));
    return fault;
}

} // namespace

void FaultDesk::registerCommands() {
    const auto possible = [this] { return control_.simulator().running(); };
    add("faults.inject", possible, [this] { inject(); });
    const auto selected = [this, possible] { return possible() && views_.faults->endable() != 0; };
    add("faults.end", selected, [this] { control_.simulator().endFault(views_.faults->endable()); });
    const auto any = [this, possible] { return possible() && views_.faults->anyToEnd(); };
    add("faults.end_all", any, [this] {
        for (const sim::FaultStatus& fault : faults_)
            control_.simulator().endFault(fault.id);
    });
}

void FaultDesk::wire() {
    auto* const panel = views_.faults;
    panel->setKinds(kindsOf(sim::faultKinds()));
    panel->setActions(action("faults.inject"), action("faults.end"));
    panel->emptyState()->setAction(action("link.connect"));
    connect(panel, &widgets::FaultPanel::selectionChanged, &commands_, &widgets::CommandRegistry::refresh);
    connect(&views_.sensors->model(), &QAbstractItemModel::rowsInserted, this, [this](const QModelIndex& branch) {
        if (!branch.isValid())
            showChoices();
    });
    connect(&control_.simulator(), &server::SimulatorHost::faultsChanged, this, &FaultDesk::list);
    connect(&control_.simulator(), &server::SimulatorHost::figuresChanged, this,
            [this](const server::SimulatorFigures& figures) { now_ = figures.now; });
    connect(&control_, &MissionControl::linkChanged, this, &FaultDesk::showChoices);
    connect(&control_, &MissionControl::worldKnown, this, &FaultDesk::showChoices);
    connect(&control_, &MissionControl::robotAdded, this, &FaultDesk::showChoices);
    connect(&control_, &MissionControl::robotRemoved, this, &FaultDesk::showChoices);
}

void FaultDesk::list(const std::vector<sim::FaultStatus>& faults) {
    faults_ = faults;
    std::vector<widgets::FaultRow> rows;
    for (const sim::FaultStatus& fault : faults)
        rows.push_back(rowOf(fault));
    views_.faults->setFaults(rows);
}

void FaultDesk::inject() {
    if (const auto added = control_.addFaults({views_.faults->text()}); !added)
        return notices_.complain("fault", added.error());
    notices_.cure("fault");
}

void FaultDesk::showChoices() {
    views_.faults->setAvailable(control_.simulator().running());
    views_.faults->setRobots(control_.liveNames());
    QStringList sensors;
    for (const QString& type : views_.sensors->model().types())
        if (!no_sensors.contains(type))
            sensors << type;
    views_.faults->setSensors(sensors);
}

std::vector<std::string> FaultDesk::texts() const {
    std::vector<std::string> texts;
    for (const sim::FaultStatus& one : faults_) {
        const sim::Fault rest = restOf(one.fault, now_);
        if (one.phase != sim::FaultPhase::Over && rest.lasts > Seconds{0.0})
            texts.push_back(sim::write(rest));
    }
    return texts;
}

void FaultDesk::begin(const QStringList& faults) {
    if (faults.isEmpty())
        return;
    QStringList texts;
    for (const sim::Fault& fault : server::readFaults(faults).value_or(std::vector<sim::Fault>()))
        texts << withoutTimes(fault);
    for (const sim::FaultStatus& one : faults_)
        if (one.phase != sim::FaultPhase::Over && texts.contains(withoutTimes(one.fault)))
            control_.simulator().endFault(one.id);
    if (const auto added = control_.addFaults(faults); !added)
        notices_.say(Severity::Warning, "mission-faults",
                     tr("The mission's faults are left out: %1").arg(QString::fromStdString(added.error().text())));
}

} // namespace usar::app
