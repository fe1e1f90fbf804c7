#include "app/desks/world_editor.h"

#include <algorithm>

#include "core/mission/fleet/robot_words.h"
#include "core/sim/world/object_kinds.h"

namespace usar::app {

namespace {

using widgets::MapObject;
using widgets::MapTool;
using widgets::ObjectForm;

constexpr std::chrono::milliseconds seen_polling{200};
constexpr std::chrono::milliseconds map_polling{500};

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

} // namespace

WorldEditor::WorldEditor(const DeskContext& context)
    : Desk(context)
    , edits_(context.control.history(),
             {sizeOfKind,
              [this](const protocol::Command& command) {
                  open();
                  link_.send(command);
              },
              [this](const Vec2& at_m) { return control_.ground_m(at_m, robot()); }, [this] { show(); }}) {
    setClasses();
    views_.world->setKinds(palette());
}

void WorldEditor::registerCommands() {
    const auto one = [this] { return selected() && port_ != 0; };
    add("world.turn_left", one, [this] { edits_.turn(selectedName(), radians(15.0)); });
    add("world.turn_right", one, [this] { edits_.turn(selectedName(), radians(-15.0)); });
    add("world.spin", one, [this] { edits_.toggleSpin(selectedName()); });
    add("world.delete", one, [this] { remove(selected_); });
    const auto any = [this] { return !shown_.empty() && port_ != 0; };
    add("world.delete_all", any, [this] { tellLost(edits_.removeAll()); });
    registerWayCommands();
}

void WorldEditor::registerWayCommands() {
    const auto one = [this] { return selected() && port_ != 0; };
    const auto has_way = [this] { return selected() && !selected()->waypoints_in_map_m.empty(); };
    const auto can_go = [this, has_way] { return has_way() || (selected() && selected()->carries); };
    add(
        "world.waypoints", [this, one] { return one() && !driving_; },
        [this](bool on) {
            views_.map->setTool(on ? MapTool::Waypoint : MapTool::Pan);
            if (on)
                views_.map->setFocus(); // So that it receives Escape.
        });
    add("world.clear_way", has_way, [this] { edits_.clearWay(selectedName()); });
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

void WorldEditor::wire() {
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
    connect(views_.layers, &widgets::LayersPanel::layerChanged, this, [this] { link_.setPolling(polling()); });
    connect(&control_.simulator(), &server::SimulatorHost::figuresChanged, this,
            [this](const server::SimulatorFigures& figures) { real_time_factor_ = figures.real_time_factor; });
    connect(&control_.simulator(), &server::SimulatorHost::objectsChanged, this, [this](const auto& objects) {
        if (answers() && polling())
            return; // Its answers and these come from two threads: an older one would take away what was just placed.
        edits_.inventory().setSeen(objects);
        show();
    });
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
    connect(&views_.map->gestures(), &widgets::MapGestures::toolChanged, this,
            [this](MapTool tool) { action("world.waypoints")->setChecked(tool == MapTool::Waypoint); });
}

void WorldEditor::setServer(const link::LinkStatus& status) {
    const bool same = status.host == host_ && status.port == port_ && port_ != 0;
    if (status.state == link::LinkState::Disconnected) {
        port_ = 0;
        if (std::exchange(opened_, false))
            link_.close();
        edits_.clear();
        edits_.inventory().setThings({});
        show();
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
    edits_.inventory().setOwn(std::move(own));
    setClasses();
}

/// Sets the classes that the server is asked about, to learn which objects belong to each.
void WorldEditor::setClasses() {
    std::vector<std::string> kinds;
    for (const sim::ObjectKind& kind : sim::objectKinds())
        kinds.emplace_back(kind.name);
    link_.setClasses(edits_.inventory().classesToAskFor(std::move(kinds)));
}

void WorldEditor::open() {
    if (port_ == 0 || std::exchange(opened_, true))
        return;
    link_.open(host_, port_);
}

void WorldEditor::refresh() {
    if (dock_seen_ || !selected_.isEmpty())
        open();
    link_.setPolling(polling());
    showState();
    commands_.refresh();
}

std::optional<std::chrono::milliseconds> WorldEditor::polling() const {
    if (dock_seen_)
        return seen_polling;
    if (!shown_.empty() && views_.map->layer(widgets::MapLayer::Objects).visible)
        return map_polling;
    return std::nullopt;
}

void WorldEditor::showState() {
    const auto [title, hint] = mission::whyNoObjects(port_ != 0, link_.view());
    views_.world->setTrouble(title, hint);
}

std::vector<MapObject> WorldEditor::objects() const {
    const double factor = control_.simulator().running() && real_time_factor_ > 0.01 ? real_time_factor_ : 1.0;
    std::vector<MapObject> objects;
    for (const mission::WorldThing& thing : edits_.inventory().things())
        objects.push_back(onMap(thing, edits_.inventory().way_m(thing.name), factor));
    return objects;
}

void WorldEditor::show() {
    const bool none_before = shown_.empty();
    if (answers() || !control_.simulator().running())
        edits_.inventory().setThings(link_.view().things);
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
        link_.setPolling(polling());
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
    refresh();
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
    views_.map->setGhost(choice->object());
    views_.map->setTool(MapTool::Place);
}

void WorldEditor::place(const Vec2& at_m, bool again) {
    const auto choice = views_.world->choice();
    if (!choice)
        return;
    if (const Rectangle& world = control_.world().extent_in_map; !world.empty() && !world.contains(at_m))
        return say(tr("There is no ground outside the world's frame. Drop the object inside it."));
    const auto name =
        edits_.place({choice->class_name.toStdString(), {}, choice->size_m, choice->scale, choice->conveyor}, at_m);
    if (!name)
        return say(QString::fromStdString(name.error().text()));
    awaited_ = QString::fromStdString(*name);
    if (!again)
        views_.world->disarm();
}

void WorldEditor::moveTo(const QString& name, const Vec2& center_m) {
    select(name);
    edits_.moveTo(selectedName(), center_m);
}

void WorldEditor::tellLost(const std::vector<std::string>& lost) {
    QStringList names;
    for (const std::string& name : lost)
        names << QString::fromStdString(name);
    if (!names.isEmpty())
        say(tr("%1 cannot be brought back: the server does not tell of which class it was. Put another object there "
               "if one is needed.")
                .arg(names.join(", ")));
}

void WorldEditor::addWaypoint(const Vec2& at_m) {
    if (!selected())
        return say(tr("Select an object first; then its waypoints are set by clicks on the map."));
    edits_.addWaypoint(selectedName(), at_m);
}

/// Starts or stops the selected object's motion along its waypoints; a conveyor without waypoints runs its belt.
void WorldEditor::follow(bool moving) {
    const MapObject* const object = selected();
    if (!object)
        return;
    if ((!object->waypoints_in_map_m.empty() || !object->carries) && views_.map->tool() == MapTool::Waypoint)
        views_.map->setTool(MapTool::Pan);
    edits_.follow(selectedName(), object->carries, {views_.world->speed_m_s(), views_.world->loop(), moving});
}

} // namespace usar::app
