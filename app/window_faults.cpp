// The faults' part of MainWindow: what goes wrong in the embedded simulator on request.
#include <cmath>

#include "app/main_window.h"
#include "app/simulator_files.h"
#include "widgets/empty_state.h"

namespace usar::app {

namespace {

/// Streams that are lines of a robot, but no sensor's.
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

/// They have a place of their own in the list.
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

void MainWindow::registerFaultCommands() {
    const auto possible = [this] { return control_.simulator().running(); };
    commands_.add(
        {"faults.inject",
         tr("Inject fault"),
         tr("Faults"),
         tr("The fault that is set up in the faults dock begins, now or when its time comes"),
         "",
         {}},
        [this](bool) { injectFault(); }, possible);
    commands_.add(
        {"faults.end",
         tr("End fault"),
         tr("Faults"),
         tr("The selected fault; what it has broken stays broken"),
         "",
         {}},
        [this](bool) { control_.simulator().endFault(views_.faults->endable()); },
        [this, possible] { return possible() && views_.faults->endable() != 0; });
    commands_.add(
        {"faults.end_all", tr("End all faults"), tr("Faults"), tr("Those to come, too"), "", {}},
        [this](bool) {
            for (const sim::FaultStatus& fault : faults_)
                control_.simulator().endFault(fault.id);
        },
        [this, possible] { return possible() && views_.faults->anyToEnd(); });
}

void MainWindow::wireFaults() {
    views_.faults->setKinds(kindsOf(sim::faultKinds()));
    views_.faults->setActions(commands_.action("faults.inject"), commands_.action("faults.end"));
    views_.faults->emptyState()->setAction(commands_.action("link.connect"));
    connect(views_.faults, &widgets::FaultPanel::selectionChanged, this, [this] { commands_.refresh(); });
    connect(&views_.sensors->model(), &QAbstractItemModel::rowsInserted, this, [this](const QModelIndex& branch) {
        if (!branch.isValid())
            showFaultChoices();
    });
    connect(&control_.simulator(), &SimulatorHost::faultsChanged, this,
            [this](const std::vector<sim::FaultStatus>& faults) {
                faults_ = faults;
                std::vector<widgets::FaultRow> rows;
                for (const sim::FaultStatus& fault : faults)
                    rows.push_back(rowOf(fault));
                views_.faults->setFaults(rows);
            });
}

void MainWindow::injectFault() {
    if (const auto added = control_.addFaults({views_.faults->text()}); !added)
        return complain("fault", added.error());
    control_.cure("fault");
}

void MainWindow::showFaultChoices() {
    const bool possible = control_.simulator().running();
    views_.faults->setAvailable(possible);
    QStringList names;
    for (const Robot* robot : control_.robots())
        if (!robot->isReplay())
            names << QString::fromStdString(robot->view().spawn.robot_name);
    views_.faults->setRobots(names);
    QStringList sensors;
    const widgets::SensorModel& streams = views_.sensors->model();
    for (int row = 0; row < streams.rowCount(); ++row) {
        const QString type = streams.index(row, widgets::SensorModel::Name).data().toString().section(' ', 0, 0);
        if (!no_sensors.contains(type))
            sensors << type;
    }
    views_.faults->setSensors(sensors);
}

void MainWindow::beginMissionFaults() {
    if (mission_faults_.isEmpty())
        return;
    QStringList texts;
    for (const sim::Fault& fault : readFaults(mission_faults_).value_or(std::vector<sim::Fault>()))
        texts << withoutTimes(fault);
    for (const sim::FaultStatus& one : faults_) // of an earlier start: two winds would blow twice as hard
        if (one.phase != sim::FaultPhase::Over && texts.contains(withoutTimes(one.fault)))
            control_.simulator().endFault(one.id);
    if (const auto added = control_.addFaults(mission_faults_); !added)
        say(Severity::Warning, "mission-faults",
            tr("The mission's faults are left out: %1").arg(QString::fromStdString(added.error().text())));
}

} // namespace usar::app
