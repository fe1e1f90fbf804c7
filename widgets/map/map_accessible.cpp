#include "widgets/map/map_accessible.h"

#include <map>
#include <optional>
#include <vector>

#include <QAccessibleWidget>
#include <QPointer>

#include "widgets/map/map_view.h"
#include "widgets/models/figures.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

/// A thing on the map, in words.
struct MapThing {
    QString name; ///< "Start pose PlayerStart": tells the thing from all others
    QString description;
    Vec2 place_in_map_m = Vec2::Zero();
};

QString placeText(const Vec2& place_m) {
    return QObject::tr("x %1 m, y %2 m").arg(figure(place_m.x(), 1), figure(place_m.y(), 1));
}

std::vector<MapThing> thingsOn(const MapContent& content) {
    std::vector<MapThing> things;
    for (const protocol::StartPose& start : content.start_poses) {
        const Vec2 place_m = start.pose_in_map.position_m.head<2>();
        things.push_back(
            {QObject::tr("Start pose %1").arg(QString::fromStdString(start.name)), placeText(place_m), place_m});
    }
    for (const auto& [name, on_map] : content.robots) {
        const Vec2 place_m = on_map.robot.base_in_map.position_m.head<2>();
        const QString where = placeText(place_m);
        things.push_back({QObject::tr("Robot %1").arg(name),
                          on_map.robot.stale ? QObject::tr("%1, out of date").arg(where) : where, place_m});
    }
    for (const MapObject& object : content.objects.objects)
        things.push_back({QObject::tr("Object %1").arg(object.name), placeText(object.body_in_map.position_m.head<2>()),
                          object.body_in_map.position_m.head<2>()});
    return things;
}

/// One thing. It finds itself by its name each time, so it never shows what was; it is invalid once the thing is gone.
class AccessibleThing : public QAccessibleInterface {
public:
    AccessibleThing(MapView& map, const QString& name) : map_(&map), name_(name) {}

    bool isValid() const override { return map_ && thing(); }
    QObject* object() const override { return nullptr; }
    QWindow* window() const override { return map_ ? map_->window()->windowHandle() : nullptr; }
    QAccessibleInterface* parent() const override { return QAccessible::queryAccessibleInterface(map_); }
    QAccessibleInterface* childAt(int, int) const override { return nullptr; }
    QAccessibleInterface* child(int) const override { return nullptr; }
    int childCount() const override { return 0; }
    int indexOfChild(const QAccessibleInterface*) const override { return -1; }
    QAccessible::Role role() const override { return QAccessible::Graphic; }
    void setText(QAccessible::Text, const QString&) override {}
    QString text(QAccessible::Text what) const override {
        const auto found = thing();
        return !found                             ? QString()
               : what == QAccessible::Name        ? found->name
               : what == QAccessible::Description ? found->description
                                                  : QString();
    }
    QRect rect() const override {
        const auto found = thing();
        if (!found)
            return {};
        const QPoint middle = map_->transform().toScreen(found->place_in_map_m).toPoint();
        const QRect box(middle - QPoint(minimum_target, minimum_target) / 2, QSize(minimum_target, minimum_target));
        return {map_->mapToGlobal(box.topLeft()), box.size()};
    }
    QAccessible::State state() const override {
        QAccessible::State state;
        const bool seen =
            map_ && map_->isVisible() && thing() && map_->rect().contains(map_->mapFromGlobal(rect().center()));
        state.invisible = !seen;
        state.offscreen = !seen;
        return state;
    }

private:
    std::optional<MapThing> thing() const {
        for (MapThing& one : thingsOn(map_->content()))
            if (one.name == name_)
                return std::move(one);
        return std::nullopt;
    }

    QPointer<MapView> map_;
    QString name_;
};

/// The map; its children are its widgets, then its things.
class AccessibleMap : public QAccessibleWidget {
public:
    explicit AccessibleMap(MapView& map) : QAccessibleWidget(&map, QAccessible::Canvas), map_(map) {}
    ~AccessibleMap() override {
        for (const auto& [name, id] : ids_)
            QAccessible::deleteAccessibleInterface(id);
    }
    Q_DISABLE_COPY_MOVE(AccessibleMap)

    int childCount() const override {
        return QAccessibleWidget::childCount() + static_cast<int>(thingsOn(map_.content()).size());
    }
    QAccessibleInterface* child(int index) const override {
        const int widgets = QAccessibleWidget::childCount();
        if (index < widgets)
            return QAccessibleWidget::child(index);
        const std::vector<MapThing> things = thingsOn(map_.content());
        const auto at = static_cast<std::size_t>(index - widgets);
        if (at >= things.size())
            return nullptr;
        auto& id = ids_[things[at].name];
        if (id == 0)
            id = QAccessible::registerAccessibleInterface(new AccessibleThing(map_, things[at].name));
        return QAccessible::accessibleInterface(id);
    }

private:
    MapView& map_;
    mutable std::map<QString, QAccessible::Id> ids_; ///< of the things that were asked for, by name
};

QAccessibleInterface* accessibleMap(const QString&, QObject* object) {
    auto* const map = qobject_cast<MapView*>(object);
    return map ? new AccessibleMap(*map) : nullptr;
}

} // namespace

void describeMaps() {
    QAccessible::installFactory(accessibleMap);
}

} // namespace usar::widgets
