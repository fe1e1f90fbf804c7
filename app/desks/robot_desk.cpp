#include "app/desks/robot_desk.h"

#include <algorithm>
#include <functional>

#include "core/mission/fleet/roster.h"
#include "core/protocol/commands/spawn.h"
#include "widgets/window/map_commands.h"

namespace usar::app {

namespace {

constexpr double drop_height_m = 0.5; ///< so that wheels and feet are above the ground
const QString draft_subject = QStringLiteral("spawn draft");

} // namespace

RobotDesk::RobotDesk(const DeskContext& context)
    : Desk(context)
    , presenter_(context.control, context.views, context.selection)
    , heights_(context.control) {
    listClasses();
}

void RobotDesk::registerCommands() {
    for (int number = 1; number <= mission::Roster::robots_with_a_key; ++number)
        add(
            widgets::commandSpec(QString("robot.select_%1").arg(number)),
            [this, number] { return control_.robot({number}) != nullptr; },
            [this, number] { selection_.select({number}); });
    commands_.offer([this] { return offers(); });
    const auto lost = [this] {
        return robot() && !robot()->isReplay() && !robot()->view().figures.spawned &&
               robot()->view().link.state == link::LinkState::Connected;
    };
    add("robot.spawn_again", lost, [this] { control_.spawnAgain(selection_.id()); });
    add(
        "robot.remove", [this] { return selection_.id().valid(); }, [this] { control_.remove(selection_.id()); });
    add("map.selected_heights", [this](bool only) {
        views_.layers->heightControls()->setScope(only ? mapping::HeightScope::SelectedRobot
                                                       : mapping::HeightScope::AllRobots);
    });
    registerTraceCommands();
}

void RobotDesk::registerTraceCommands() {
    const auto traceable = [this] {
        return robot() && robot()->view().figures.spawned && !robot()->isReplay() &&
               robot()->view().figures.dialect != protocol::Dialect::Udk;
    };
    add("robot.trace", traceable, [this](bool on) { trace(on); });
    for (const auto& [word, color] : protocol::wire_words<protocol::TraceColor>) {
        const QString name = QString::fromUtf8(word).toLower();
        add({"robot.trace_" + name,
             tr("Trace in %1").arg(name),
             tr("Robots"),
             tr("Makes the selected robot leave marks of this color from now on"),
             "",
             {}},
            traceable, [this, color = color] {
                views_.world->setTraceColor(color);
                trace(true);
            });
    }
    add(
        "map.wipe_trace", [this] { return !views_.map->traces().empty(); },
        [this] {
            views_.map->clearTraceMarks();
            commands_.refresh();
        });
}

void RobotDesk::wire() {
    wireRobots();
    wireSpawning();
    wireMarks();
    wireHeights();
    connect(&selection_, &Selection::changed, this, [this](RobotId id) {
        heights_.select(id);
        presenter_.select(id);
        views_.robots->selectRobot(id);
        showTrace();
    });
    connect(views_.robots, &widgets::RobotList::robotSelected, &selection_, &Selection::select);
    connect(views_.robots, &widgets::RobotList::removeRequested, &control_, &MissionControl::remove);
    connect(&views_.map->gestures(), &widgets::MapGestures::robotClicked, this, &RobotDesk::select);
}

void RobotDesk::wireRobots() {
    connect(&control_, &MissionControl::robotAdded, this, &RobotDesk::welcome);
    connect(&control_, &MissionControl::robotRemoved, this, &RobotDesk::dismiss);
    connect(&control_, &MissionControl::robotLinkChanged, this, [this](RobotId id) {
        presenter_.showRow(id);
        if (id == selection_.id())
            presenter_.showLinkState(id);
    });
    connect(&control_, &MissionControl::behaviorFinished, this, [this](RobotId id) { presenter_.showRow(id); });
    connect(&control_, &MissionControl::linkUpdated, this, std::bind_front(&RobotPresenter::showLink, &presenter_));
    connect(&control_, &MissionControl::robotUpdated, this, std::bind_front(&RobotPresenter::show, &presenter_));
    connectUpdates([this](const auto&) { showTrace(); });
}

void RobotDesk::wireSpawning() {
    connect(&control_, &MissionControl::startPosesKnown, this,
            [this](const protocol::StartPoses& poses) { views_.map->setStartPoses(poses.poses); });
    connect(&control_, &MissionControl::classesChanged, this, &RobotDesk::listClasses);
    auto* const card = views_.spawn_card;
    connect(views_.map, &widgets::MapView::spawnRequested, this,
            [this, card](int pose) { spawn(card->lastChoice(pose, control_.nextRobotName())); });
    widgets::wireSpawnCard(views_, [this] { return control_.nextRobotName(); });
    connect(card, &widgets::SpawnCard::spawnRequested, this, &RobotDesk::spawn);
    const auto show = [this](const std::optional<Pose>& draft) {
        widgets::showSpawnDraft(views_, draft, control_.nextRobotName());
    };
    connect(&views_.map->gestures(), &widgets::MapGestures::draftPlaced, this,
            [this, show](const auto& before, const auto& after) {
                show(after);
                control_.history().addStep(
                    mission::valueEdit<std::optional<Pose>>(draft_subject, tr("place robot"), before, after, show));
            });
    const auto count = [this, card] {
        card->setRoom(static_cast<int>(control_.robots().size()), mission::Roster::most_robots);
    };
    connect(&control_, &MissionControl::robotAdded, card, count);
    connect(&control_, &MissionControl::robotRemoved, card, count);
    count();
}

void RobotDesk::wireMarks() {
    connect(views_.world, &widgets::WorldPanel::traceColorChosen, this, [this] {
        if (presenter_.tracing(selection_.id()))
            trace(true);
    });
    connect(&control_.simulator(), &server::SimulatorHost::marksLeft, this,
            [this](const std::vector<sim::TraceMark>& marks) {
                const bool none_before = views_.map->traces().empty();
                for (const sim::TraceMark& mark : marks)
                    views_.map->addTraceMark(mark.position_in_map_m.head<2>(), widgets::traceColor(mark.color));
                if (none_before)
                    commands_.refresh();
            });
}

void RobotDesk::wireHeights() {
    widgets::HeightLayer* const layer = &views_.map->heights();
    connect(&heights_, &mission::ShownHeights::begun, layer, &widgets::HeightLayer::clear);
    connect(&heights_, &mission::ShownHeights::grown, layer, &widgets::HeightLayer::take);
    connect(views_.layers->heightControls(), &widgets::HeightControls::scopeChanged, this,
            [this](mapping::HeightScope scope) {
                heights_.setScope(scope);
                action("map.selected_heights")->setChecked(scope == mapping::HeightScope::SelectedRobot);
            });
    connect(views_.layers->heightControls(), &widgets::HeightControls::lookChanged, this,
            [this](const widgets::HeightLook& look) { control_.setPictureLook(look); });
    views_.map->setScannedBy([this](const Vec2& point_in_map_m) { return heights_.knowing(point_in_map_m); });
    views_.map->setAgeOf([this](const Vec2& point_in_map_m) { return ageAt(point_in_map_m); });
    // A new link may count its lines from the beginning.
    connect(&control_, &MissionControl::robotLinkChanged, this, [this] { line_times_.clear(); });
    connect(&views_.map->gestures(), &widgets::MapGestures::writerAsked, this, &RobotDesk::showWriter);
}

std::optional<Seconds> RobotDesk::ageAt(const Vec2& point_in_map_m) {
    constexpr std::size_t most_times = 1000;
    if (line_times_.size() > most_times)
        line_times_.clear();
    std::optional<Seconds> youngest;
    for (const auto& [id, probe] : heights_.sourcesAt(point_in_map_m)) {
        const mission::RobotView& view = control_.robot(id)->view();
        const auto [known, is_new] = line_times_.try_emplace({view.connection, probe.line});
        if (is_new)
            known->second = views_.messages->timeOf(view.connection, probe.line);
        if (!known->second)
            continue;
        const Seconds age = std::max(view.figures.now - *known->second, Seconds{0.0});
        youngest = std::min(youngest.value_or(age), age);
    }
    return youngest;
}

void RobotDesk::showWriter(const Vec2& point_in_map_m) {
    const auto sources = heights_.sourcesAt(point_in_map_m);
    for (const auto& [id, probe] : sources)
        if (const ConnectionId connection = control_.connectionOf(id);
            views_.messages->timeOf(connection, probe.line)) {
            raise(views_.messages_dock);
            if (views_.messages->jumpToLine(connection, probe.line))
                return notices_.cure("cell");
        }
    if (sources.empty())
        return notices_.note("cell", tr("No robot knows the height of this place."));
    const auto& [id, probe] = sources.front();
    notices_.note("cell",
                  probe.line == LineNumber{}
                      ? tr("This height comes from an earlier run, whose lines are not here.")
                      : tr("Line %1 of %2 wrote this height, but the messages do not keep it any longer. Replay "
                           "the recording to see it.")
                            .arg(probe.line.value)
                            .arg(nameOf(*control_.robot(id))));
}

std::vector<widgets::PaletteOffer> RobotDesk::offers() {
    std::vector<widgets::PaletteOffer> offers;
    for (const Robot* const robot : control_.robots())
        offers.push_back({tr("Select %1").arg(nameOf(*robot)),
                          tr("Robots"),
                          {"robot", "choose", "show", "switch"},
                          [this, id = robot->view().id] { selection_.select(id); }});
    int number = 0;
    for (const protocol::StartPose& pose : control_.startPoses())
        offers.push_back(
            {tr("Spawn a robot at %1").arg(QString::fromStdString(pose.name)),
             tr("Robots"),
             {"add", "new", "create", "place", "start"},
             [this, at = number++] { spawn(views_.spawn_card->lastChoice(at, control_.nextRobotName())); }});
    return offers;
}

void RobotDesk::listClasses() {
    views_.spawn_card->setRobots(control_.robotsToSpawn());
}

void RobotDesk::welcome(RobotId id) {
    presenter_.showRow(id);
    const mission::RobotView& view = control_.robot(id)->view();
    const std::string& name = view.recorded_name.empty() ? view.spawn.robot_name : view.recorded_name;
    if (!preferred_.valid() && !name.empty() && name == preferred_name_)
        preferred_ = id;
    const bool keeps = preferred_.valid() && preferred_ != id && selection_.id() == preferred_;
    if (!keeps)
        selection_.select(id);
    if (!control_.robot(id)->isReplay())
        views_.hint->setDone(widgets::FirstStep::Spawn);
}

void RobotDesk::dismiss(RobotId id, const QString& name, RobotId instead) {
    const RobotId next = id == selection_.id() ? instead : selection_.id();
    views_.robots->removeRobot(id); // The list then selects a neighbor of that row by itself.
    presenter_.remove(name);
    selection_.select(next);
}

void RobotDesk::spawn(const widgets::SpawnChoice& choice) {
    std::optional<Pose> start = views_.map->content().startOf(choice.start_pose);
    const bool drawn = choice.start_pose == widgets::SpawnChoice::at_draft;
    if (!start)
        return;
    if (drawn)
        start->position_m.z() = control_.ground_m(start->position_m.head<2>(), robot()) + drop_height_m;
    const auto id = control_.spawn({choice.class_name.toStdString(), choice.robot_name.toStdString(), *start});
    if (!id)
        return notices_.complain("spawn", id.error());
    if (drawn) {
        views_.map->gestures().setDraft({});
        control_.history().lock([](const QString& subject) { return subject == draft_subject; },
                                tr("The robot was spawned."));
    }
    control_.history().note(tr("spawn %1").arg(choice.robot_name));
    if (!choice.behavior_id.isEmpty())
        views_.behavior->chooseBehavior(choice.behavior_id.toStdString());
}

void RobotDesk::select(const QString& name) {
    for (const Robot* robot : control_.robots())
        if (name == nameOf(*robot))
            selection_.select(robot->view().id);
}

void RobotDesk::trace(bool on) {
    constexpr Seconds interval{0.2};
    Robot* robot = selection_.robot();
    if (!robot)
        return;
    if (on)
        robot->send(protocol::Trace{true, interval, views_.world->traceColor()}, by::Operator{"trace"});
    else
        robot->send(protocol::Trace{false, {}, {}}, by::Operator{"trace"});
}

void RobotDesk::showTrace() {
    const auto color = presenter_.tracing(selection_.id());
    action("robot.trace")->setChecked(color.has_value());
    if (color)
        views_.world->setTraceColor(*color);
}

} // namespace usar::app
