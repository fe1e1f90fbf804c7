#include "app/desks/fault_desk.h"

#include <cmath>

#include "core/server/embedded/simulator_files.h"
#include "widgets/style/empty_state.h"

namespace usar::app {

namespace {

/// Types of lines that a robot sends but that belong to no sensor.
const QStringList no_sensors{"STA", "MISSTA", "GEO", "CONF", "RES", "NFO"};

QString textOf(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

std::vector<widgets::FaultKindInfo> kindsOf(std::span<const sim::FaultDescription> kinds) {
    std::vector<widgets::FaultKindInfo> infos;
    for (const sim::FaultDescription& kind : kinds) {
        widgets::FaultKindInfo info{textOf(kind.word), textOf(kind.help), kind.of_robot, kind.of_sensor, {}};
        for (const sim::FaultNumber& number : kind.numbers)
            info.quantities.push_back({textOf(number.name), textOf(number.unit), number.smallest, number.largest,
                                       number.usual, textOf(number.help)});
        infos.push_back(std::move(info));
    }
    return infos;
}

/// The fault as text without its times, which the list shows in a column of their own.
QString withoutTimes(sim::Fault fault) {
    fault.from = Seconds{0.0};
    fault.lasts = sim::without_end;
    return QString::fromStdString(write(fault));
}

widgets::FaultRow rowOf(const sim::FaultStatus& status) {
    const sim::Fault& fault = status.fault;
    QString when = widgets::FaultPanel::tr("From %1 s of the simulation's clock").arg(fault.from.count(), 0, 'f', 1);
    if (std::isfinite(fault.lasts.count()))
        when += widgets::FaultPanel::tr(" for %1 s").arg(fault.lasts.count(), 0, 'f', 1);
    return {status.id, withoutTimes(fault), static_cast<widgets::FaultState>(status.phase), when};
}

} // namespace

void FaultDesk::registerCommands() {
    const auto possible = [this] { return desk_.control.simulator().running(); };
    desk_.commands.add(
        {"faults.inject",
         tr("Inject fault"),
         tr("Faults"),
         tr("The fault that is set up in the faults dock begins, now or when its time comes"),
         "",
         {}},
        [this](bool) { inject(); }, possible);
    desk_.commands.add(
        {"faults.end",
         tr("End fault"),
         tr("Faults"),
         tr("The selected fault; what it has broken stays broken"),
         "",
         {}},
        [this](bool) { desk_.control.simulator().endFault(desk_.views.faults->endable()); },
        [this, possible] { return possible() && desk_.views.faults->endable() != 0; });
    desk_.commands.add(
        {"faults.end_all", tr("End all faults"), tr("Faults"), tr("Those to come, too"), "", {}},
        [this](bool) {
            for (const sim::FaultStatus& fault : faults_)
                desk_.control.simulator().endFault(fault.id);
        },
        [this, possible] { return possible() && desk_.views.faults->anyToEnd(); });
}

void FaultDesk::wire() {
    auto* const panel = desk_.views.faults;
    panel->setKinds(kindsOf(sim::faultKinds()));
    panel->setActions(desk_.commands.action("faults.inject"), desk_.commands.action("faults.end"));
    panel->emptyState()->setAction(desk_.commands.action("link.connect"));
    connect(panel, &widgets::FaultPanel::selectionChanged, &desk_.commands, &widgets::CommandRegistry::refresh);
    connect(&desk_.views.sensors->model(), &QAbstractItemModel::rowsInserted, this, [this](const QModelIndex& branch) {
        if (!branch.isValid())
            showChoices();
    });
    connect(&desk_.control.simulator(), &server::SimulatorHost::faultsChanged, this, &FaultDesk::list);
    connect(&desk_.control, &MissionControl::linkChanged, this, &FaultDesk::showChoices);
    connect(&desk_.control, &MissionControl::worldKnown, this, &FaultDesk::showChoices);
    connect(&desk_.control, &MissionControl::robotAdded, this, &FaultDesk::showChoices);
    connect(&desk_.control, &MissionControl::robotRemoved, this, &FaultDesk::showChoices);
}

void FaultDesk::list(const std::vector<sim::FaultStatus>& faults) {
    faults_ = faults;
    std::vector<widgets::FaultRow> rows;
    for (const sim::FaultStatus& fault : faults)
        rows.push_back(rowOf(fault));
    desk_.views.faults->setFaults(rows);
}

void FaultDesk::inject() {
    if (const auto added = desk_.control.addFaults({desk_.views.faults->text()}); !added)
        return desk_.notices.complain("fault", added.error());
    desk_.notices.cure("fault");
}

void FaultDesk::showChoices() {
    desk_.views.faults->setAvailable(desk_.control.simulator().running());
    QStringList names;
    for (const Robot* robot : desk_.control.robots())
        if (!robot->isReplay())
            names << QString::fromStdString(robot->view().spawn.robot_name);
    desk_.views.faults->setRobots(names);
    QStringList sensors;
    for (const QString& type : desk_.views.sensors->model().types())
        if (!no_sensors.contains(type))
            sensors << type;
    desk_.views.faults->setSensors(sensors);
}

void FaultDesk::begin(const QStringList& faults) {
    if (faults.isEmpty())
        return;
    QStringList texts;
    for (const sim::Fault& fault : server::readFaults(faults).value_or(std::vector<sim::Fault>()))
        texts << withoutTimes(fault);
    for (const sim::FaultStatus& one : faults_)
        if (one.phase != sim::FaultPhase::Over && texts.contains(withoutTimes(one.fault)))
            desk_.control.simulator().endFault(one.id);
    if (const auto added = desk_.control.addFaults(faults); !added)
        desk_.notices.say(
            Severity::Warning, "mission-faults",
            tr("The mission's faults are left out: %1").arg(QString::fromStdString(added.error().text())));
}

} // namespace usar::app
