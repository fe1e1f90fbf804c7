#include "app/desks/robot_presenter.h"

#include <utility>

#include "core/mission/fleet/robot.h"
#include "core/mission/fleet/robot_words.h"
#include "core/mission/session/update_order.h"
#include "core/protocol/commands/spawn.h"
#include "core/protocol/fields.h"
#include "widgets/style/theme.h"

namespace usar::app {

widgets::ControlWords controlWords(const MissionControl& control, const Robot* robot) {
    using widgets::Driver;
    if (!robot)
        return {};
    const mission::ControlState& state = robot->view().figures.control;
    if (robot->isReplay() || state.reins == mission::Reins::Nobody)
        return {nameOf(*robot), Driver::Nobody, {}};
    if (state.reins == mission::Reins::Hand)
        return {nameOf(*robot), Driver::Person, mission::deviceText(state)};
    const agent::BehaviorDescription* const behavior = control.plugins().behavior(state.behavior_id);
    return {nameOf(*robot), Driver::Behavior, QString::fromStdString(behavior ? behavior->name : state.behavior_id)};
}

widgets::MapRobot RobotPresenter::onMap(const RobotView& view) {
    return {QString::fromStdString(view.spawn.robot_name),
            view.id.value,
            view.base_in_map.value_or(view.spawn.start_in_map),
            mission::isStale(view),
            protocol::isStation(view.spawn.class_name),
            footprints_.of(QString::fromStdString(view.spawn.class_name), control_.world().robot_outlines,
                           heard_[view.connection].instruments.fitting().dimensions_m())};
}

void RobotPresenter::show(RobotId id, const std::shared_ptr<const mission::SessionUpdate>& shared) {
    const mission::SessionUpdate& update = *shared;
    const bool selected = id == selection_.id();
    const RobotView& view = control_.robot(id)->view();
    if (update.rewound)
        restart(view, selected);
    extendTrail(view, update);
    showRow(id);
    showOnMap(view, update, selected);
    const std::vector<mission::TraceSpot> spots = traces_[view.connection].take(update);
    if (!control_.simulator().running() || !view.recording.isEmpty()) // Otherwise the simulator reports all marks.
        for (const mission::TraceSpot& spot : spots)
            views_.map->addTraceMark(spot.position_in_map_m.head<2>(), widgets::traceColor(spot.color));
    feedMessages(view.connection, update);
    Heard& heard = heard_[view.connection];
    for (const protocol::InfoLine& line : update.lines) {
        heard.newest.take(line, update.figures.now);
        heard.instruments.take(line, update.figures.now);
        heard.questions.take(line, update.figures.now);
        views_.plots->take(QString::fromStdString(view.spawn.robot_name), line, update.figures.now);
    }
    ask(*control_.robot(id));
    if (!selected)
        return;
    showTraffic(update.figures);
    if (update.ground)
        views_.terrain->setProfile(*update.ground);
    showInstruments(view);
    for (const protocol::InfoLine& line : update.lines)
        views_.sensors->take(line, update.figures.now);
    views_.sensors->setNow(update.figures.now);
}

std::optional<protocol::TraceColor> RobotPresenter::tracing(RobotId id) const {
    const auto trace = traces_.find(control_.connectionOf(id));
    return id.valid() && trace != traces_.end() && trace->second.on() ? std::optional(trace->second.color())
                                                                      : std::nullopt;
}

void RobotPresenter::restart(const RobotView& view, bool selected) {
    views_.map->removeRobot(QString::fromStdString(view.spawn.robot_name));
    heard_.erase(view.connection);
    views_.plots->restart(QString::fromStdString(view.spawn.robot_name));
    if (!selected)
        return;
    select(view.id);
    views_.map->clearMarks(QString::fromStdString(view.spawn.robot_name)); // The update contains those that exist now.
    views_.status->clear(QObject::tr("Replay"));
}

void RobotPresenter::showRow(RobotId id) {
    const Robot* robot = control_.robot(id);
    if (!robot)
        return;
    const RobotView& view = robot->view();
    if (view.base_in_map || view.recording.isEmpty()) // A replayed robot has no place before its first message.
        views_.map->setRobot(onMap(view));
    widgets::RobotRow row;
    row.id = id;
    row.number = id.value;
    row.name = QString::fromStdString(view.spawn.robot_name);
    row.class_name = QString::fromStdString(view.spawn.class_name).section('.', -1);
    row.state = mission::stateText(view);
    row.stale = mission::isStale(view);
    row.driver = controlWords(control_, robot);
    row.battery_pct = robot->batteryLeft_pct();
    views_.robots->updateRobot(row);
}

/// All poses of a fast simulation belong to the trail, in their order, and not only the newest one, which is painted.
void RobotPresenter::extendTrail(const RobotView& view, const mission::SessionUpdate& update) {
    const QString name = QString::fromStdString(view.spawn.robot_name);
    const bool station = protocol::isStation(view.spawn.class_name);
    for (const agent::Published& published : update.published)
        if (const auto* estimate = std::get_if<agent::PoseEstimate>(&published))
            views_.map->setRobot({name, view.id.value, estimate->base_in_map, false, station});
    if (view.status) // Then the behavior estimates the place.
        return;
    for (const protocol::InfoLine& line : update.lines)
        if (const auto* ins = std::get_if<protocol::InsReading>(&line.message))
            views_.map->setRobot({name, view.id.value, ins->base_in_map, false, station});
}

void RobotPresenter::showOnMap(const RobotView& view, const mission::SessionUpdate& update, bool selected) {
    const QString name = QString::fromStdString(view.spawn.robot_name);
    if (mission::newestPublished<agent::CurrentGoal>(update))
        views_.map->setGoal(name, view.goal_m);
    if (!update.last_hits.empty())
        views_.map->setLaserHits(name, update.last_hits);
    views_.map->setRobotArea(name, view.area_in_map);
    views_.map->setCorrectedPath(name, view.corrected_path_m);
    std::vector<agent::MapMark> marks;
    for (const agent::Published& published : update.published)
        if (const auto* mark = std::get_if<agent::MapMark>(&published))
            marks.push_back(*mark);
    views_.map->addMarks(name, marks);
    if (!selected)
        return;
    if (const auto* path = mission::newestPublished<agent::PlannedPath>(update))
        views_.map->setLanes(path->points_in_map_m);
}

/// While nobody else asks the robot; a replay answers nothing.
void RobotPresenter::ask(Robot& robot) {
    const mission::SessionFigures& figures = robot.view().figures;
    if (robot.isReplay() || mission::isStale(robot.view()) || !figures.spawned ||
        figures.control.reins != mission::Reins::Nobody)
        return;
    for (const protocol::Command& question : heard_[robot.view().connection].questions.next(figures.now))
        robot.send(question, by::Other{"instruments"});
}

void RobotPresenter::showInstruments(const RobotView& view) {
    showStatus(view);
    const mission::Equipment& has = view.equipment;
    views_.status->setAbilities(has.kind(), has.mayRecharge());
    widgets::RobotInstruments& instruments = heard_[view.connection].instruments;
    if (const auto& world = control_.world().world; world && world->water && view.recording.isEmpty())
        instruments.setWater(world->water->surface_z_m);
    views_.terrain->setVisible(!view.tiles.empty() || (has.mayFly() && instruments.scan()));
    showLinkState(view.id);
}

/// Shows this robot's figures and no others: those of its last behavior after the end, dashes before the first.
void RobotPresenter::showStatus(const RobotView& view) {
    widgets::StatusStrip& strip = *views_.status;
    const Robot& robot = *control_.robot(view.id);
    strip.setRobot(nameOf(robot));
    if (view.status)
        strip.setStatus(*view.status);
    else
        strip.clear(QObject::tr("Idle"));
    if (view.finished)
        strip.setIdle(QString::fromStdString(view.finished->reason),
                      view.finished->success ? widgets::StateShape::Good : widgets::StateShape::Bad);
    else if (!view.figures.behavior_running)
        strip.setIdle(QObject::tr("Idle"));
    strip.setBattery(robot.batteryLeft_pct());
    strip.setCoverage(robot.coverage_pct());
}

void RobotPresenter::showLinkState(RobotId id) {
    const Robot* robot = control_.robot(id);
    const bool stale = robot && mission::isStale(robot->view());
    views_.status->setStale(stale && (robot->view().status || robot->batteryLeft_pct())); // Dashes are not out of date.
    views_.terrain->setStale(stale);
    views_.sensors->setLinked(!stale);
    if (!robot)
        return views_.instruments->clear();
    const RobotView& view = robot->view();
    const bool judged = view.zones && view.figures.behavior_running;
    views_.instruments->showRobot(heard_[view.connection].instruments, view.figures.now, !stale,
                                  judged ? &*view.zones : nullptr);
}

/// Adds lines and commands in the order in which they were received and sent.
void RobotPresenter::feedMessages(ConnectionId connection, const mission::SessionUpdate& update) {
    if (update.rewound)
        views_.messages->clear();
    std::uint64_t& told = not_shown_[connection];
    if (const std::uint64_t not_shown = update.figures.lines_not_shown; not_shown > told)
        views_.messages->takeNotShown(not_shown - std::exchange(told, not_shown), connection);
    mission::inOrder(
        update,
        [&](const protocol::InfoLine& line) {
            views_.messages->takeLine(line, protocol::timeOf(line.message).value_or(update.figures.now), connection);
        },
        [&](const mission::SentCommand& command) {
            views_.messages->takeCommand(command.text, command.cause, command.time, connection);
        });
}

void RobotPresenter::showLink(const std::shared_ptr<const mission::SessionUpdate>& update) {
    feedMessages(control_.connectionOf({}), *update);
    if (!selection_.id().valid())
        showTraffic(update->figures);
}

void RobotPresenter::showTraffic(const mission::SessionFigures& figures) {
    views_.connection->panel()->setFigures(
        {figures.traffic, figures.rates, figures.lines_not_shown, figures.round_trip});
    views_.traffic->setText(widgets::trafficSummary(figures.traffic));
}

void RobotPresenter::select(RobotId id) {
    views_.sensors->clear();
    views_.instruments->clear();
    views_.terrain->clear();
    const Robot* robot = control_.robot(id);
    views_.map->selectRobot(robot ? QString::fromStdString(robot->view().spawn.robot_name) : QString());
    if (!robot) {
        views_.status->setRobot({});
        views_.status->setAbilities({}, true);
        return views_.status->clear(QObject::tr("No robot yet"));
    }
    const RobotView& view = robot->view();
    const QString name = QString::fromStdString(view.spawn.robot_name);
    views_.plots->setRobot(name);
    views_.map->clearMarks(name); // The map may have been cleared, and a replay may have been rewound.
    views_.map->addMarks(name, view.marks);
    if (robot->running())
        views_.map->setLanes(view.planned_m);
    for (const widgets::CountedLine& heard : heard_[view.connection].newest.lines())
        views_.sensors->take(heard.line, heard.now);
    views_.sensors->setNow(view.figures.now);
    if (view.ground)
        views_.terrain->setProfile(*view.ground);
    showInstruments(view);
}

} // namespace usar::app
