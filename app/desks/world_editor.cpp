#include "app/desks/world_editor.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/text.h"
#include "core/sim/world/object_kinds.h"

namespace usar::app {

namespace {

using widgets::MapObject;
using widgets::MapTool;
using widgets::ObjectForm;

constexpr std::chrono::milliseconds seen_polling{200};
constexpr std::chrono::milliseconds map_polling{500};
constexpr double drop_height_m = 0.02; ///< new objects start this far above the ground, so that none starts inside it
constexpr double spin_rad_s = radians(30.0);
constexpr std::size_t most_undo = 100;

ObjectForm formOf(const sim::ObjectKind& kind) {
    switch (kind.shape) {
    case sim::ObjectShape::Sphere:
        return ObjectForm::Sphere;
    case sim::ObjectShape::Cylinder:
        return ObjectForm::Cylinder;
    case sim::ObjectShape::Box:
        break;
    }
    return ObjectForm::Box;
}

std::vector<widgets::PaletteKind> palette() {
    std::vector<widgets::PaletteKind> kinds;
    for (const sim::ObjectKind& kind : sim::objectKinds()) {
        const QString name = QString::fromUtf8(kind.name.data(), qsizetype(kind.name.size()));
        kinds.push_back({name, widgets::kindIcon(name), formOf(kind), kind.size_m, kind.conveyor});
    }
    return kinds;
}

protocol::Token tokenOf(const QString& name) {
    return protocol::Token::make(name.toStdString()).value_or(protocol::Token("unnamed"));
}

} // namespace

WorldEditor::WorldEditor(const DeskContext& context)
    : control_(context.control)
    , views_(context.views)
    , commands_(context.commands)
    , notices_(context.notices) {
    setClasses();
    views_.world->setKinds(palette());
}

void WorldEditor::wire() {
    const auto actions = [this](std::initializer_list<const char*> ids) {
        std::vector<QAction*> found;
        for (const char* id : ids)
            found.push_back(*id ? commands_.action(id) : nullptr);
        return found;
    };
    views_.world->setActions(actions({"world.turn_left", "world.turn_right", "world.spin", "", "world.undo",
                                      "world.delete", "world.delete_all"}),
                             actions({"world.waypoints", "world.clear_way", "world.go", "world.halt"}),
                             commands_.action("robot.trace"));
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
    wireMap();
    showState();
}

void WorldEditor::wireMap() {
    connect(views_.map, &widgets::MapView::placeRequested, this, &WorldEditor::place);
    connect(views_.map, &widgets::MapView::waypointAdded, this, &WorldEditor::addWaypoint);
    connect(views_.map, &widgets::MapView::objectClicked, this, &WorldEditor::select);
    connect(views_.map, &widgets::MapView::objectMoved, this, &WorldEditor::moveTo);
    connect(views_.map, &widgets::MapView::objectRemovalRequested, this, &WorldEditor::remove);
    connect(views_.map, &widgets::MapView::toolChanged, this, [this](MapTool tool) {
        if (tool != MapTool::Place)
            views_.world->disarm();
        commands_.action("world.waypoints")->setChecked(tool == MapTool::Waypoint);
    });
}

void WorldEditor::setServer(const link::LinkStatus& status) {
    const bool same = status.host == host_ && status.port == port_ && port_ != 0;
    if (status.state == link::LinkState::Disconnected) {
        port_ = 0;
        if (std::exchange(opened_, false))
            link_.close();
        known_.clear();
        used_names_.clear();
        deleted_.clear();
        ground_.reset(); // The next server may have another world.
        own_objects_.clear();
        setClasses();
    } else if (status.state == link::LinkState::Connected && !same) {
        host_ = status.host;
        port_ = status.port;
        opened_ = false;
    }
    refresh();
}

void WorldEditor::setWorld(const server::WorldPicture& world) {
    ground_ = world.ground;
    own_objects_ = world.objects;
    setClasses();
}

/// Sets the classes that the server is asked about to find out which objects belong to them.
void WorldEditor::setClasses() {
    std::vector<std::string> classes;
    for (const sim::ObjectKind& kind : sim::objectKinds())
        classes.emplace_back(kind.name);
    for (const auto& [name, class_name] : own_objects_)
        if (const std::string bare_name = class_name.section('.', -1).toStdString();
            std::ranges::find(classes, bare_name) == classes.end())
            classes.push_back(bare_name);
    link_.setClasses(classes);
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
    for (const mission::WorldThing& thing : link_.view().things) {
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
        object.speed_m_s = thing.velocity_in_map_m_s.norm() / factor;
        if (const auto known = known_.find(object.name); known != known_.end())
            object.waypoints_in_map_m = known->second.way_m;
        objects.push_back(std::move(object));
    }
    return objects;
}

void WorldEditor::show() {
    const bool none_before = shown_.empty();
    shown_ = objects();
    std::erase_if(known_, [this](const auto& known) {
        return std::ranges::find(shown_, known.first, &MapObject::name) == shown_.end();
    });
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

/// Switches the map to placing the object that is chosen in the palette, or back if none is.
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
    if (const auto& world = views_.map->content().world_in_map; world && !world->contains(at_m))
        return say(tr("There is no ground outside the world's frame. Drop the object inside it."));
    const auto class_name = protocol::Token::make(choice->class_name.toStdString());
    if (!class_name)
        return say(QString::fromStdString(class_name.error().text()));
    const QString name = unusedName(choice->class_name);
    used_names_.insert(name);
    protocol::CreateObject created{*class_name};
    created.object_name = protocol::Name::mended(name.toStdString());
    const double rise_m = choice->size_m.z() / 2.0 + (choice->conveyor ? 0.0 : drop_height_m);
    created.start = Pose{Vec3(at_m.x(), at_m.y(), ground_m(at_m) + rise_m)};
    if (!choice->scale.isApprox(Vec3::Ones()))
        created.scale = choice->scale;
    send(created);
    awaited_ = name;
    if (!again)
        views_.world->disarm();
}

void WorldEditor::moveTo(const QString& name, const Vec2& center_m) {
    select(name);
    const MapObject* const object = selected();
    if (!object)
        return;
    Pose moved = object->body_in_map;
    moved.position_m.z() += ground_m(center_m) - ground_m(Vec2(moved.position_m.head<2>()));
    moved.position_m.head<2>() = center_m;
    send(protocol::PlaceObject{tokenOf(name), moved});
}

void WorldEditor::turn(double angle_rad) {
    Pose shift;
    shift.yaw_rad = angle_rad;
    send(protocol::ShiftObject{tokenOf(selected_), shift});
}

void WorldEditor::spin() {
    bool& spins = known_[selected_].spins;
    spins = !spins;
    send(protocol::SpinObject{tokenOf(selected_), Vec3(0.0, 0.0, spins ? spin_rad_s : 0.0)});
}

/// Returns the command that would create this object again; nullopt if neither the server nor the embedded world tells
/// its class.
std::optional<protocol::CreateObject> WorldEditor::creationOf(const MapObject& object) const {
    const auto bare = [](const QString& class_name) { return class_name.section('.', -1).toStdString(); };
    const auto own = own_objects_.find(object.name);
    const bool is_own = own != own_objects_.end() && (own->second.isEmpty() || object.kind.isEmpty() ||
                                                      sameWord(bare(own->second), bare(object.kind)));
    if (object.kind.isEmpty() && !is_own)
        return std::nullopt;
    protocol::CreateObject created{
        tokenOf(is_own ? own->second : object.kind)}; // A server finds an object without class by its name.
    created.object_name = protocol::Name::mended(object.name.toStdString());
    created.start = object.body_in_map;
    const sim::ObjectKind* const kind = is_own ? nullptr : sim::findObjectKind(object.kind.toStdString());
    if (!kind)
        return created; // With the usual size of its class.
    if (const Vec3 scale = object.size_m.cwiseQuotient(kind->size_m); !scale.isApprox(Vec3::Ones(), 0.02))
        created.scale = scale;
    return created;
}

void WorldEditor::keepForUndo(std::vector<protocol::CreateObject> deleted, const QStringList& lost) {
    if (!deleted.empty())
        deleted_.push_back(std::move(deleted));
    if (deleted_.size() > most_undo)
        deleted_.erase(deleted_.begin());
    if (!lost.isEmpty())
        say(tr("%1 cannot be brought back: the server does not tell of which class it was. Put another object there "
               "if one is needed.")
                .arg(lost.join(", ")));
}

void WorldEditor::remove(const QString& name) {
    const auto object = std::ranges::find(shown_, name, &MapObject::name);
    if (object == shown_.end())
        return;
    const auto created = creationOf(*object);
    keepForUndo(created ? std::vector{*created} : std::vector<protocol::CreateObject>(),
                created ? QStringList() : QStringList(name));
    send(protocol::KillObject{tokenOf(name)});
}

void WorldEditor::removeAll() {
    std::vector<protocol::CreateObject> all;
    QStringList lost;
    for (const MapObject& object : shown_)
        if (const auto created = creationOf(object))
            all.push_back(*created);
        else
            lost << object.name;
    keepForUndo(std::move(all), lost);
    send(protocol::KillAllObjects{});
}

void WorldEditor::undo() {
    for (const protocol::CreateObject& created : deleted_.back())
        send(created);
    deleted_.pop_back();
    commands_.refresh();
}

void WorldEditor::addWaypoint(const Vec2& at_m) {
    const MapObject* const object = selected();
    if (!object)
        return say(tr("Select an object first; then its way points are set by clicks on the map."));
    const double over_ground_m =
        object->body_in_map.position_m.z() - ground_m(Vec2(object->body_in_map.position_m.head<2>()));
    known_[selected_].way_m.push_back(at_m);
    send(protocol::AddWaypoints{tokenOf(selected_), {Vec3(at_m.x(), at_m.y(), ground_m(at_m) + over_ground_m)}});
    show();
}

void WorldEditor::clearWay() {
    known_[selected_].way_m.clear();
    send(protocol::ClearWaypoints{tokenOf(selected_)});
    show();
}

/// Starts or stops the selected object's motion along its way points. A conveyor without way points runs its belt.
void WorldEditor::follow(bool moving) {
    const MapObject* const object = selected();
    if (!object)
        return;
    const double speed_m_s = views_.world->speed_m_s();
    if (object->carries && object->waypoints_in_map_m.empty())
        return send(protocol::RunConveyor{tokenOf(selected_), moving ? speed_m_s : 0.0});
    if (views_.map->tool() == MapTool::Waypoint)
        views_.map->setTool(MapTool::Pan);
    send(protocol::FollowWaypoints{
        tokenOf(selected_), protocol::WaypointSpeed{std::abs(speed_m_s)}, views_.world->loop(), {}, moving});
}

void WorldEditor::send(const protocol::Command& command) {
    link_.send(command);
}

void WorldEditor::say(const QString& text) {
    notices_.say(Severity::Warning, "world", text);
}

double WorldEditor::ground_m(const Vec2& at_m) const {
    if (ground_ && !ground_->empty() && ground_->extent().contains(at_m))
        return ground_->height_m(at_m);
    if (const auto probe = views_.map->heights().probe(at_m))
        return double(probe->height_m);
    double z_m = 0.0;
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const protocol::StartPose& pose : views_.map->content().start_poses)
        if (const double d = (pose.pose_in_map.position_m.head<2>() - at_m).norm(); d < nearest_m) {
            nearest_m = d;
            z_m = pose.pose_in_map.position_m.z();
        }
    return z_m;
}

QString WorldEditor::unusedName(const QString& class_name) const {
    const QString bare = class_name.section('.', -1);
    for (int number = 1;; ++number)
        if (const QString name = bare + QString::number(number);
            !used_names_.contains(name) && std::ranges::find(shown_, name, &MapObject::name) == shown_.end())
            return name;
}

} // namespace usar::app
