#include "widgets/window/dock_opener.h"

#include <algorithm>

#include <QMainWindow>

namespace usar::widgets {

DockOpener::DockOpener(const QList<QDockWidget*>& docks, QObject* parent) : QObject(parent), waiting_(docks) {
    for (QDockWidget* const dock : docks)
        connect(dock, &QDockWidget::visibilityChanged, this, &DockOpener::forgetOpen);
    arranging_ = true; // Until `begin`: the first layout has all docks open.
}

QStringList DockOpener::waiting() const {
    QStringList names;
    for (const QDockWidget* const dock : waiting_)
        if (dock->isHidden() || arranging_)
            names << dock->objectName();
    return names;
}

void DockOpener::begin(const QStringList& names) {
    waiting_.removeIf([&](const QDockWidget* dock) { return !names.contains(dock->objectName()); });
    close(nullptr);
    arranging_ = false;
}

void DockOpener::showFirst(QDockWidget* dock) {
    forgetOpen();
    if (!waiting_.contains(dock))
        return;
    const auto* const window = qobject_cast<const QMainWindow*>(dock->parentWidget());
    const QList<QDockWidget*> mates = window ? window->tabifiedDockWidgets(dock) : QList<QDockWidget*>();
    const bool alone = std::ranges::all_of(mates, &QDockWidget::isHidden);
    dock->show();
    if (alone)
        dock->raise();
    forgetOpen();
}

void DockOpener::close(const QDockWidget* except) {
    for (QDockWidget* const dock : waiting_)
        if (dock != except)
            dock->hide();
}

void DockOpener::forgetOpen() {
    if (!arranging_)
        waiting_.removeIf([](const QDockWidget* dock) { return !dock->isHidden(); });
}

} // namespace usar::widgets
