#include "widgets/window/dock_arranger.h"

#include <algorithm>
#include <utility>

#include <QDockWidget>
#include <QGuiApplication>
#include <QLayout>
#include <QScreen>
#include <QStyle>
#include <QTabBar>

namespace usar::widgets {

namespace {

const std::pair<const char*, Qt::DockWidgetArea> dock_edges[] = {{"left", Qt::LeftDockWidgetArea},
                                                                 {"right", Qt::RightDockWidgetArea},
                                                                 {"top", Qt::TopDockWidgetArea},
                                                                 {"bottom", Qt::BottomDockWidgetArea}};

bool isWide(Qt::DockWidgetArea edge) {
    return edge == Qt::TopDockWidgetArea || edge == Qt::BottomDockWidgetArea;
}

/// A group of tabs, and where it is in the window.
struct TabGroup {
    DockPlace place;
    QRect rect; ///< with the bar of its tabs; null if nothing in it is open
};

/// The tab bar that has this dock; nullptr if it shares its place with no other open dock.
const QTabBar* barOf(const QMainWindow& window, const QDockWidget* dock) {
    for (const QTabBar* bar : window.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
        for (int i = 0; bar->isVisible() && i < bar->count(); ++i)
            if (bar->tabData(i).value<quintptr>() == reinterpret_cast<quintptr>(dock))
                return bar;
    return nullptr;
}

/// The docks that share a place with this one and itself, in the order of the tabs; closed ones come last.
QList<QDockWidget*> mates(const QMainWindow& window, QDockWidget* dock) {
    QList<QDockWidget*> all = window.tabifiedDockWidgets(dock);
    all.prepend(dock);
    const auto place = [&](QDockWidget* one) {
        const QTabBar* const bar = barOf(window, one);
        for (int i = 0; bar && i < bar->count(); ++i)
            if (bar->tabData(i).value<quintptr>() == reinterpret_cast<quintptr>(one))
                return i;
        return one->isHidden() ? 1000 : 0;
    };
    std::ranges::stable_sort(all, {}, place);
    return all;
}

TabGroup tabGroupOf(const QMainWindow& window, QDockWidget* dock) {
    TabGroup group;
    for (const QDockWidget* const one : mates(window, dock)) {
        group.place.tabs << one->objectName();
        if (one->isHidden()) {
            group.place.closed << one->objectName();
        } else if (one->geometry().right() >= 0) { // Qt keeps the others outside of the window.
            group.place.front = one->objectName();
            group.rect = one->geometry();
            if (const QTabBar* const bar = barOf(window, one); bar && bar->geometry().right() >= 0)
                group.rect |= bar->geometry();
        }
    }
    return group;
}

int beginOf(const QRect& rect, bool side_by_side) {
    return side_by_side ? rect.left() : rect.top();
}

int endOf(const QRect& rect, bool side_by_side) {
    return side_by_side ? rect.right() : rect.bottom();
}

QRect around(const std::vector<TabGroup>& groups) {
    QRect rect;
    for (const TabGroup& group : groups)
        rect |= group.rect;
    return rect;
}

/// Cuts the groups into parts along straight lines across all of them.
std::vector<std::vector<TabGroup>> cut(std::vector<TabGroup> groups, bool side_by_side) {
    std::ranges::stable_sort(groups, {}, [&](const TabGroup& group) { return beginOf(group.rect, side_by_side); });
    std::vector<std::vector<TabGroup>> parts;
    int end = -1;
    for (TabGroup& group : groups) {
        if (parts.empty() || beginOf(group.rect, side_by_side) > end)
            parts.emplace_back();
        end = std::max(end, endOf(group.rect, side_by_side));
        parts.back().push_back(std::move(group));
    }
    return parts;
}

/// The splits that lead to these places. A window cuts its docks by straight lines, so there is always such a cut.
DockPlace splitOf(const std::vector<TabGroup>& groups, bool side_by_side) {
    if (groups.size() == 1)
        return groups.front().place;
    auto parts = cut(groups, side_by_side);
    if (parts.size() < 2)
        parts = cut(groups, side_by_side = !side_by_side);
    DockPlace place;
    place.side_by_side = side_by_side;
    if (parts.size() < 2) { // While docks are moved by an animation.
        parts.clear();
        for (const TabGroup& group : groups)
            parts.push_back({group});
    }
    double whole_px = 0.0;
    for (const auto& part : parts) {
        const QRect rect = around(part);
        const int size_px = side_by_side ? rect.width() : rect.height();
        place.parts.push_back(splitOf(part, !side_by_side));
        place.parts.back().share = size_px;
        whole_px += size_px;
    }
    for (DockPlace& part : place.parts)
        part.share /= std::max(1.0, whole_px);
    return place;
}

/// Appends places where nothing is open, in the direction of the edge.
DockPlace withClosed(DockPlace open, const std::vector<DockPlace>& closed, bool side_by_side) {
    if (closed.empty())
        return open;
    std::vector<DockPlace> parts;
    if (!open.parts.empty() && open.side_by_side == side_by_side)
        parts = std::move(open.parts);
    else if (!open.docks().isEmpty())
        parts = {std::move(open)};
    if (parts.size() == 1 && parts.front().share == 0.0)
        parts.front().share = 1.0;
    parts.insert(parts.end(), closed.begin(), closed.end());
    if (parts.size() == 1)
        return parts.front();
    return {{}, {}, {}, side_by_side, std::move(parts), 0.0};
}

DockEdge edgeOf(const QMainWindow& window, Qt::DockWidgetArea edge, QList<QDockWidget*> docks) {
    std::ranges::stable_sort(docks, {},
                             &QDockWidget::isHidden); // Only an open dock tells which closed ones are its tabs.
    std::vector<TabGroup> open;
    std::vector<DockPlace> closed;
    QStringList done;
    for (QDockWidget* const dock : docks) {
        if (dock->isFloating() || window.dockWidgetArea(dock) != edge || done.contains(dock->objectName()))
            continue;
        TabGroup group = tabGroupOf(window, dock);
        done << group.place.tabs;
        if (group.rect.isNull())
            closed.push_back(std::move(group.place));
        else
            open.push_back(std::move(group));
    }
    DockEdge result;
    const QRect rect = around(open);
    if (!open.empty()) {
        result.place = splitOf(open, isWide(edge));
        result.share = isWide(edge) ? static_cast<double>(rect.height()) / std::max(1, window.height())
                                    : static_cast<double>(rect.width()) / std::max(1, window.width());
    }
    result.place = withClosed(std::move(result.place), closed, isWide(edge));
    return result;
}

/// Gives docks the places of one layout.
class Arranger {
public:
    explicit Arranger(QMainWindow& window) : window_(window) {
        for (QDockWidget* const dock : window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
            docks_[dock->objectName()] = dock;
    }

    void arrange(const DockLayout& layout) {
        const std::map<QString, QDockWidget*> all = docks_;
        QList<std::pair<QDockWidget*, Qt::DockWidgetArea>> others;
        QStringList named;
        for (const auto& [name, edge] : layout.edges)
            named << edge.place.docks();
        for (const FloatingDock& one : layout.floating)
            named << one.dock;
        for (const auto& [name, dock] : all) {
            if (!named.contains(name))
                others.emplaceBack(dock, window_.dockWidgetArea(dock));
            dock->setFloating(false);
            window_.removeDockWidget(dock);
        }
        for (const auto& [name, edge] : dock_edges)
            if (const auto found = layout.edges.find(name); found != layout.edges.end())
                placeEdge(found->second.place, edge);
        for (const auto& [dock, edge] : others) {
            window_.addDockWidget(edge == Qt::NoDockWidgetArea ? Qt::RightDockWidgetArea : edge, dock);
            dock->hide();
        }
        for (const FloatingDock& one : layout.floating)
            floatDock(one);
        window_.layout()->activate();
        for (const auto& [name, edge] : dock_edges)
            if (const auto found = layout.edges.find(name); found != layout.edges.end())
                sizeEdge(found->second, edge);
    }

private:
    QDockWidget* dock(const QString& name) const {
        const auto found = docks_.find(name);
        return found == docks_.end() ? nullptr : found->second;
    }
    /// The first dock of a place that the window has; it stands for the place until the others come.
    QDockWidget* first(const DockPlace& place) const {
        for (const QString& name : place.docks())
            if (QDockWidget* const found = dock(name))
                return found;
        return nullptr;
    }
    /// The first that is open; nullptr if none is.
    QDockWidget* firstOpen(const DockPlace& place) const {
        for (const QString& name : place.docks())
            if (QDockWidget* const found = dock(name); found && !found->isHidden())
                return found;
        return nullptr;
    }

    void placeEdge(const DockPlace& place, Qt::DockWidgetArea edge) {
        QDockWidget* const anchor = first(place);
        if (!anchor)
            return;
        window_.addDockWidget(edge, anchor, place.side_by_side ? Qt::Horizontal : Qt::Vertical);
        anchor->show();
        fill(place);
        close(place);
    }

    /// Puts the docks of a place beside its first one, which stands there already.
    void fill(const DockPlace& place) {
        QDockWidget* last = first(place);
        for (const DockPlace& part : place.parts) {
            QDockWidget* const next = first(part);
            if (!next || next == last)
                continue;
            window_.splitDockWidget(last, next, place.side_by_side ? Qt::Horizontal : Qt::Vertical);
            next->show();
            last = next;
        }
        for (const DockPlace& part : place.parts)
            fill(part);
        for (const QString& name : place.tabs)
            if (QDockWidget* const tab = dock(name); tab && tab != first(place)) {
                window_.tabifyDockWidget(std::exchange(last, tab), tab);
                tab->show();
            }
    }

    /// Hides what is closed, and brings the front tabs to the front; when all stand in their places.
    void close(const DockPlace& place) {
        for (const DockPlace& part : place.parts)
            close(part);
        for (const QString& name : place.closed)
            if (QDockWidget* const tab = dock(name))
                tab->hide();
        if (QDockWidget* const front = dock(place.front))
            front->raise();
    }

    void floatDock(const FloatingDock& one) {
        QDockWidget* const found = dock(one.dock);
        if (!found)
            return;
        window_.addDockWidget(Qt::RightDockWidgetArea, found);
        found->setFloating(true);
        QRect at = one.geometry;
        const auto holds = [&](const QScreen* screen) { return screen->availableGeometry().intersects(at); };
        if (std::ranges::none_of(QGuiApplication::screens(), holds))
            at.moveTopLeft(QGuiApplication::primaryScreen()->availableGeometry().topLeft());
        found->setGeometry(at);
        found->setVisible(one.open);
    }

    void sizeEdge(const DockEdge& edge, Qt::DockWidgetArea where) {
        Sizes sizes;
        const int whole_px = isWide(where) ? window_.height() : window_.width();
        if (edge.share > 0.0)
            spread(edge.place, !isWide(where), qRound(edge.share * whole_px), sizes);
        if (!sizes.docks.isEmpty())
            window_.resizeDocks(sizes.docks, sizes.px, isWide(where) ? Qt::Vertical : Qt::Horizontal);
        window_.layout()->activate();
        sizeParts(edge.place);
    }

    /// Docks and what they get.
    struct Sizes {
        QList<QDockWidget*> docks;
        QList<int> px;
    };

    /// Appends docks by which the place gets this width, or height. An edge is as large as the docks in a split along
    /// that direction together, so each of them needs its share; of those across it, one is enough.
    void spread(const DockPlace& place, bool wide, int size_px, Sizes& sizes) const {
        std::vector<const DockPlace*> open;
        double whole = 0.0;
        for (const DockPlace& part : place.parts)
            if (firstOpen(part)) {
                open.push_back(&part);
                whole += part.share;
            }
        if (open.empty()) {
            if (QDockWidget* const tab = firstOpen(place)) {
                sizes.docks << tab;
                sizes.px << std::max(1, size_px);
            }
            return;
        }
        if (place.side_by_side != wide)
            return spread(*open.front(), wide, size_px, sizes);
        const double shared_px = size_px - gap_px() * static_cast<int>(open.size() - 1);
        for (const DockPlace* const part : open)
            spread(*part, wide, qRound(whole > 0.0 ? part->share / whole * shared_px : shared_px), sizes);
    }

    /// Between two docks of a split.
    int gap_px() const { return window_.style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, &window_); }

    /// The present size of a split in its direction.
    int extent_px(const DockPlace& place) const {
        QRect rect;
        for (const QString& name : place.docks())
            if (const QDockWidget* const one = dock(name); one && !one->isHidden() && one->geometry().right() >= 0)
                rect |= one->geometry();
        return place.side_by_side ? rect.width() : rect.height();
    }

    void sizeParts(const DockPlace& place) {
        QList<QDockWidget*> docks;
        QList<int> sizes;
        const int whole_px = extent_px(place); // Larger sizes would make the whole edge larger.
        for (const DockPlace& part : place.parts)
            if (QDockWidget* const open = firstOpen(part)) {
                docks << open;
                sizes << std::max(1, qRound(part.share * whole_px));
            }
        if (docks.size() > 1) {
            window_.resizeDocks(docks, sizes, place.side_by_side ? Qt::Horizontal : Qt::Vertical);
            window_.layout()->activate();
        }
        for (const DockPlace& part : place.parts)
            sizeParts(part);
    }

    QMainWindow& window_;
    std::map<QString, QDockWidget*> docks_; ///< by name
};

} // namespace

DockLayout layoutOf(const QMainWindow& window) {
    const auto docks = window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly);
    DockLayout layout;
    for (const auto& [name, edge] : dock_edges)
        if (DockEdge docked = edgeOf(window, edge, docks); !docked.place.docks().isEmpty())
            layout.edges[name] = std::move(docked);
    for (const QDockWidget* const dock : docks)
        if (dock->isFloating())
            layout.floating.push_back({dock->objectName(), dock->geometry(), !dock->isHidden()});
    std::ranges::sort(layout.floating, {}, &FloatingDock::dock); // As the window's own order depends on the past.
    return layout;
}

void arrangeDocks(QMainWindow& window, const DockLayout& layout) {
    const bool animated = window.isAnimated();
    window.setAnimated(false);
    window.setUpdatesEnabled(false);
    Arranger(window).arrange(layout);
    window.setUpdatesEnabled(true);
    window.setAnimated(animated);
}

} // namespace usar::widgets
