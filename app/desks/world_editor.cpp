#include "app/desks/world_editor.h"

#include <algorithm>

#include "core/mission/world/world_edits.h"
#include "core/sim/world/object_kinds.h"

namespace usar::app {

namespace {

using widgets::MapObject;
using widgets::MapTool;
using widgets::ObjectForm;

constexpr std::chrono::milliseconds seen_polling{200};
constexpr std::chrono::milliseconds map_polling{500};
constexpr double spin_rad_s = radians(30.0);

/// The map has the same shapes as the simulator, in the same order.
ObjectForm formOf(const sim::ObjectKind& kind) {
    return static_cast<ObjectForm>(kind.shape);
}

std::vector<widgets::PaletteKind> palette() {
    std::vector<widgets::PaletteKind> kinds;
    for (const sim::ObjectKind& kind : sim::objectKinds()) {
        const QString name = QString::fromUtf8(kind.name);
        kinds.push_back({name, widgets::kindIcon(name), formOf(kind), kind.size_m, kind.conveyor});
    }
    return kinds;
}

std::optional<Vec3> sizeOfKind(std::string_view class_name) {
    const sim::ObjectKind* const kind = sim::findObjectKind(class_name);
    return kind ? std::optional(kind->size_m) : std::nullopt;
}

/// `time_factor`: simulated seconds per wall second; converts the speed to simulated time.
MapObject onMap(const mission::WorldThing& thing, std::vector<Vec2> way_m, double time_factor) {
    MapObject object;
    object.name = QString::fromStdString(thing.name);
    object.kind = QString::fromStdString(thing.class_name);
    if (const sim::ObjectKind* const kind = sim::findObjectKind(thing.class_name)) {
        object.form = formOf(*kind);
        object.size_m = kind->size_m;
        object.carries = kind->conveyor;
    }
    object.size_m = thing.size_m.value_or(object.size_m);
    object.body_in_map = thing.body_in_map;
    object.speed_m_s = thing.velocity_in_map_m_s.norm() / time_factor;
    object.waypoints_in_map_m = std::move(way_m);
    return object;
}

protocol::Token tokenOf(const QString& name) {
    return mission::tokenOf(name.toStdString());
}

} // namespace

WorldEditor::WorldEditor(const DeskContext& context)
    : Desk(context)
    , inventory_(sizeOfKind)
    , edits_(
          context.control.history(), [this](const protocol::Command& command) { link_.send(command); },
          [this](const std::string& name) { return inventory_.creationOf(name); }) {
    setClasses();
    views_.world->setKinds(palette());
}

void WorldEditor::registerCommands() {
    const auto one = [this] { return selected() != nullptr; };
    add("world.turn_left", one, [this] { turn(radians(15.0)); });
    add("world.turn_right", one, [this] { turn(radians(-15.0)); });
    add("world.spin", one, [this] {
        const bool spins = inventory_.toggleSpin(selected_.toStdString());
        link_.send(protocol::SpinObject{tokenOf(selected_), Vec3(0.0, 0.0, spins ? spin_rad_s : 0.0)});
    });
    add("world.delete", one, [this] { remove(selected_); });
    const auto any = [this] { return !shown_.empty(); };
    add("world.delete_all", any, [this] {
        QStringList names;
        for (const MapObject& object : shown_)
            names << object.name;
        removeNamed(names, protocol::KillAllObjects{});
    });
    registerWayCommands();
}

void WorldEditor::registerWayCommands() {
    const auto one = [this] { return selected() != nullptr; };
    const auto has_way = [this] { return selected() && !selected()->waypoints_in_map_m.empty(); };
    const auto can_go = [this, has_way] { return has_way() || (selected() && selected()->carries); };
    add(
        "world.waypoints", [this, one] { return one() && !driving_; },
        [this](bool on) {
            views_.map->setTool(on ? MapTool::Waypoint : MapTool::Pan);
            if (on)
                views_.map->setFocus(); // So that it receives Escape.
        });
    add("world.clear_way", has_way, [this] { setWay({}); });
    add("world.go", can_go, [this] { follow(true); });
    add("world.halt", can_go, [this] { follow(false); });
}

void WorldEditor::setDriving(bool drives) {
    driving_ = drives;
    if (drives && views_.map->tool() == MapTool::Waypoint)
        views_.map->setTool(MapTool::Pan);
    action("world.waypoints")
        ->setToolTip(drives ? tr("Not while you drive, because W drives forward. Give control back first.")
                            : widgets::tooltipText(widgets::commandSpec("world.waypoints")));
    commands_.refresh();
}

/// Gives the panel's buttons words that are short enough to stand below their icons.
void WorldEditor::nameButtons() {
    const std::pair<const char*, QString> words[] = {{"world.turn_left", tr("Left")},
                                                     {"world.turn_right", tr("Right")},
                                                     {"world.spin", tr("Spin")},
                                                     {"world.delete", tr("Delete")},
                                                     {"world.delete_all", tr("Delete all")},
                                                     {"world.waypoints", tr("Add")},
                                                     {"world.clear_way", tr("Clear")},
                                                     {"world.go", tr("Start")},
                                                     {"world.halt", tr("Stop")}};
    for (const auto& [id, word] : words)
        action(id)->setIconText(word);
}

void WorldEditor::wire() {
    nameButtons();
    views_.world->setActions(
        {action("world.turn_left"), action("world.turn_right"), action("world.spin"), nullptr, action("edit.undo"),
         action("world.delete"), action("world.delete_all")},
        {action("world.waypoints"), action("world.clear_way"), action("world.go"), action("world.halt")},
        action("robot.trace"));
    connect(&control_, &MissionControl::linkChanged, this, &WorldEditor::setServer);
    connect(&control_, &MissionControl::worldKnown, this, &WorldEditor::setWorld);
    connect(&link_, &mission::WorldLink::changed, this, &WorldEditor::show);
    connect(&link_, &mission::WorldLink::noticed, this, [this](const mission::Notice& notice) {
        const QString key = QString::fromStdString(notice.topic);
        if (notice.over)
            notices_.cure(key);
        else
            notices_.say(notice.severity, key, QString::fromStdString(notice.text));
    });
    connect(views_.world_dock, &QDockWidget::visibilityChanged, this, [this](bool seen) {
        dock_seen_ = seen;
        if (!seen)
            views_.world->disarm();
        refresh();
    });
    connect(views_.world, &widgets::WorldPanel::choiceChanged, this, &WorldEditor::arm);
    connect(views_.world, &widgets::WorldPanel::objectSelected, this, &WorldEditor::select);
    connect(views_.world, &widgets::WorldPanel::removeRequested, this, &WorldEditor::remove);
    connect(views_.layers, &widgets::LayersPanel::layerChanged, this, &WorldEditor::refreshPolling);
    connect(&control_.simulator(), &server::SimulatorHost::figuresChanged, this,
            [this](const server::SimulatorFigures& figures) { real_time_factor_ = figures.real_time_factor; });
    connect(&control_.simulator(), &server::SimulatorHost::objectRefused, &link_, &mission::WorldLink::refuse);
    wireMap();
    showState();
}

void WorldEditor::wireMap() {
    connect(&views_.map->gestures(), &widgets::MapGestures::placeRequested, this, &WorldEditor::place);
    connect(&views_.map->gestures(), &widgets::MapGestures::waypointAdded, this, &WorldEditor::addWaypoint);
    connect(&views_.map->gestures(), &widgets::MapGestures::objectClicked, this, &WorldEditor::select);
    connect(&views_.map->gestures(), &widgets::MapGestures::objectMoved, this, &WorldEditor::moveTo);
    connect(views_.map, &widgets::MapView::objectRemovalRequested, this, &WorldEditor::remove);
    connect(&views_.map->gestures(), &widgets::MapGestures::toolChanged, this, [this](MapTool tool) {
        if (tool != MapTool::Place)
            views_.world->disarm();
        action("world.waypoints")->setChecked(tool == MapTool::Waypoint);
    });
}

void WorldEditor::setServer(const link::LinkStatus& status) {
    const bool same = status.host == host_ && status.port == port_ && port_ != 0;
    if (status.state == link::LinkState::Disconnected) {
        port_ = 0;
        if (std::exchange(opened_, false))
            link_.close();
        inventory_.clear();
        edits_.forget();
        setClasses();
    } else if (status.state == link::LinkState::Connected && !same) {
        host_ = status.host;
        port_ = status.port;
        opened_ = false;
    }
    refresh();
}

void WorldEditor::setWorld(const server::WorldPicture& world) {
    std::map<std::string, std::string> own;
    for (const auto& [name, class_name] : world.objects)
        own.emplace(name.toStdString(), class_name.toStdString());
    inventory_.setOwn(std::move(own));
    setClasses();
}

/// Sets the classes that the server is asked about, to learn which objects belong to each.
void WorldEditor::setClasses() {
    std::vector<std::string> kinds;
    for (const sim::ObjectKind& kind : sim::objectKinds())
        kinds.emplace_back(kind.name);
    link_.setClasses(inventory_.classesToAskFor(std::move(kinds)));
}

void WorldEditor::refresh() {
    if (dock_seen_ && port_ != 0 && !opened_) {
        opened_ = true;
        link_.open(host_, port_);
    }
    refreshPolling();
    showState();
    commands_.refresh();
}

void WorldEditor::refreshPolling() {
    if (dock_seen_)
        link_.setPolling(seen_polling);
    else if (!shown_.empty() && views_.map->layer(widgets::MapLayer::Objects).visible)
        link_.setPolling(map_polling);
    else
        link_.setPolling(std::nullopt);
}

void WorldEditor::showState() {
    const mission::WorldView& view = link_.view();
    if (port_ == 0)
        return views_.world->setTrouble(tr("No world yet"), tr("Connect to a server; then things can be put into its "
                                                               "world from here."));
    if (view.state == mission::WorldState::Refused)
        return views_.world->setTrouble(tr("No world controller"), QString::fromStdString(view.trouble));
    if (view.state != mission::WorldState::Ready && view.things.empty())
        return views_.world->setTrouble(tr("Asking the server…"), QString::fromStdString(view.trouble));
    views_.world->setTrouble({}, {});
}

std::vector<MapObject> WorldEditor::objects() const {
    const double factor = control_.simulator().running() && real_time_factor_ > 0.01 ? real_time_factor_ : 1.0;
    std::vector<MapObject> objects;
    for (const mission::WorldThing& thing : inventory_.things())
        objects.push_back(onMap(thing, inventory_.way_m(thing.name), factor));
    return objects;
}

void WorldEditor::show() {
    const bool none_before = shown_.empty();
    inventory_.setThings(link_.view().things);
    shown_ = objects();
    views_.map->setObjects(shown_);
    if (dock_seen_)
        views_.world->setObjects(shown_);
    if (!selected())
        selected_.clear();
    if (std::ranges::find(shown_, awaited_, &MapObject::name) != shown_.end())
        select(std::exchange(awaited_, {}));
    showState();
    if (none_before != shown_.empty())
        refreshPolling();
    commands_.refresh();
}

const MapObject* WorldEditor::selected() const {
    const auto found = std::ranges::find(shown_, selected_, &MapObject::name);
    return found == shown_.end() ? nullptr : &*found;
}

void WorldEditor::select(const QString& name) {
    selected_ = name;
    views_.map->selectObject(name);
    views_.world->selectObject(name);
    commands_.refresh();
}

/// Lets the map place the object chosen in the palette; ends placing if none is chosen.
void WorldEditor::arm() {
    const auto choice = views_.world->choice();
    if (!choice) {
        views_.map->setGhost({});
        if (views_.map->tool() == MapTool::Place)
            views_.map->setTool(MapTool::Pan);
        return;
    }
    MapObject ghost;
    ghost.name = ghost.kind = choice->class_name;
    ghost.form = choice->form;
    ghost.size_m = choice->size_m;
    ghost.carries = choice->conveyor;
    views_.map->setGhost(ghost);
    views_.map->setTool(MapTool::Place);
}

void WorldEditor::place(const Vec2& at_m, bool again) {
    const auto choice = views_.world->choice();
    if (!choice)
        return;
    if (const Rectangle& world = control_.world().extent_in_map; !world.empty() && !world.contains(at_m))
        return say(tr("There is no ground outside the world's frame. Drop the object inside it."));
    const std::string class_name = choice->class_name.toStdString();
    const std::string name = inventory_.unusedName(class_name);
    const auto created =
        mission::placed({class_name, name, choice->size_m, choice->scale, choice->conveyor}, at_m, ground()(at_m));
    if (!created)
        return say(QString::fromStdString(created.error().text()));
    inventory_.useName(name);
    edits_.place(*created);
    awaited_ = QString::fromStdString(name);
    if (!again)
        views_.world->disarm();
}

void WorldEditor::moveTo(const QString& name, const Vec2& center_m) {
    select(name);
    const mission::WorldThing* const thing = inventory_.find(name.toStdString()); // The map's has been moved already.
    if (const MapObject* const object = selected(); object && thing)
        edits_.move(thing->name, thing->body_in_map, mission::movedTo(object->body_in_map, center_m, ground()));
}

void WorldEditor::turn(double angle_rad) {
    edits_.turn(selected_.toStdString(), angle_rad);
}

void WorldEditor::remove(const QString& name) {
    if (inventory_.find(name.toStdString()))
        removeNamed(QStringList(name), protocol::KillObject{tokenOf(name)});
}

/// Deletes the objects with these names by sending `deletion`.
void WorldEditor::removeNamed(const QStringList& names, const protocol::Command& deletion) {
    std::vector<protocol::CreateObject> kept;
    QStringList lost;
    for (const QString& name : names)
        if (auto created = inventory_.creationOf(name.toStdString()))
            kept.push_back(*std::move(created));
        else
            lost << name;
    if (!lost.isEmpty())
        say(tr("%1 cannot be brought back: the server does not tell of which class it was. Put another object there "
               "if one is needed.")
                .arg(lost.join(", ")));
    edits_.remove(deletion, std::move(kept));
}

void WorldEditor::addWaypoint(const Vec2& at_m) {
    if (!selected())
        return say(tr("Select an object first; then its waypoints are set by clicks on the map."));
    std::vector<Vec2> way_m = inventory_.way_m(selected_.toStdString());
    way_m.push_back(at_m);
    setWay(way_m);
}

void WorldEditor::setWay(const std::vector<Vec2>& way_m) {
    const std::string name = selected_.toStdString();
    edits_.setWay(name, inventory_.way_m(name), way_m, [this, name](const std::vector<Vec2>& now_m) {
        const mission::WorldThing* const thing = inventory_.find(name);
        if (!thing)
            return;
        const bool grows = now_m.size() == inventory_.way_m(name).size() + 1; // Then its motion goes on.
        inventory_.setWay(name, now_m);
        std::vector<Vec3> points_m;
        for (std::size_t i = grows ? now_m.size() - 1 : 0; i < now_m.size(); ++i)
            points_m.push_back(mission::waypointAt(thing->body_in_map, now_m[i], ground()));
        if (!grows)
            link_.send(protocol::ClearWaypoints{mission::tokenOf(name)});
        if (!points_m.empty())
            link_.send(protocol::AddWaypoints{mission::tokenOf(name), points_m});
        show();
    });
}

/// Starts or stops the selected object's motion along its waypoints; a conveyor without waypoints runs its belt.
void WorldEditor::follow(bool moving) {
    const MapObject* const object = selected();
    if (!object)
        return;
    const bool has_way = !object->waypoints_in_map_m.empty();
    const bool is_conveyor = object->carries;
    if ((has_way || !is_conveyor) && views_.map->tool() == MapTool::Waypoint)
        views_.map->setTool(MapTool::Pan);
    link_.send(mission::motionOf(selected_.toStdString(), is_conveyor, has_way,
                                 {views_.world->speed_m_s(), views_.world->loop(), moving}));
}

mission::GroundHeight WorldEditor::ground() const {
    mission::GroundSources sources;
    if (const auto& terrain = control_.world().ground; terrain && !terrain->empty())
        sources.terrain_m = [terrain](const Vec2& at_m) {
            return terrain->extent().contains(at_m) ? std::optional(terrain->height_m(at_m)) : std::nullopt;
        };
    if (const Robot* const robot = selection_.robot()) {
        sources.tiles = &robot->view().tiles;
        sources.cell_size_m = robot->view().cell_size_m;
    }
    sources.start_poses = control_.startPoses();
    return [sources](const Vec2& at_m) { return mission::groundHeight_m(sources, at_m); };
}

} // namespace usar::app
