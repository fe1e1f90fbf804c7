#include "core/mission/world/object_edits.h"

#include <memory>
#include <utility>

#include "core/mission/world/world_edits.h"

namespace usar::mission {

namespace {

const QString subject = QStringLiteral("world/");

QString nameOf(const protocol::CreateObject& object) {
    return QString::fromStdString(object.object_name.text());
}

} // namespace

ObjectEdits::ObjectEdits(EditHistory& history, Send send, Look look)
    : history_(history)
    , send_(std::move(send))
    , look_(std::move(look)) {}

void ObjectEdits::add(const QString& text, const std::function<void()>& redo, const std::function<void()>& undo) {
    redo();
    history_.add({subject, text, undo, redo});
}

void ObjectEdits::remove(const protocol::Command& deletion, std::vector<protocol::CreateObject> objects) {
    send_(deletion);
    if (objects.empty())
        return;
    const QString text = objects.size() == 1 ? EditHistory::tr("delete %1").arg(nameOf(objects.front()))
                                             : EditHistory::tr("delete %1 objects").arg(objects.size());
    const auto kept = std::make_shared<std::vector<protocol::CreateObject>>(std::move(objects));
    const auto undo = [this, kept] {
        for (const protocol::CreateObject& object : *kept)
            send_(object);
    };
    const auto redo = [this, kept] {
        for (protocol::CreateObject& object : *kept) {
            if (auto now = look_(object.object_name.text()))
                object = *std::move(now);
            send_(protocol::KillObject{tokenOf(object.object_name.text())});
        }
    };
    history_.add({subject, text, undo, redo});
}

void ObjectEdits::place(const protocol::CreateObject& object) {
    add(
        EditHistory::tr("place %1").arg(nameOf(object)), [this, object] { send_(object); },
        [this, object] { send_(protocol::KillObject{tokenOf(object.object_name.text())}); });
}

void ObjectEdits::move(const std::string& name, const Pose& from_in_map, const Pose& to_in_map) {
    const auto put = [this, name](const Pose& pose) {
        return [this, name, pose] { send_(protocol::PlaceObject{tokenOf(name), pose}); };
    };
    add(EditHistory::tr("move %1").arg(QString::fromStdString(name)), put(to_in_map), put(from_in_map));
}

void ObjectEdits::turn(const std::string& name, double angle_rad) {
    const auto by = [this, name](double by_rad) {
        return [this, name, by_rad] {
            Pose shift;
            shift.yaw_rad = by_rad;
            send_(protocol::ShiftObject{tokenOf(name), shift});
        };
    };
    add(EditHistory::tr("turn %1").arg(QString::fromStdString(name)), by(angle_rad), by(-angle_rad));
}

void ObjectEdits::setWay(const std::string& name, const std::vector<Vec2>& before_m, const std::vector<Vec2>& after_m,
                         const SetWay& set) {
    const QString text = after_m.size() > before_m.size() ? EditHistory::tr("add waypoint of %1")
                                                          : EditHistory::tr("clear waypoints of %1");
    add(
        text.arg(QString::fromStdString(name)), [set, after_m] { set(after_m); }, [set, before_m] { set(before_m); });
}

void ObjectEdits::forget() {
    history_.lock([](const QString& edited) { return edited == subject; },
                  EditHistory::tr("it belongs to the world that was left"));
}

} // namespace usar::mission
