#include "widgets/window/window_docks.h"

#include <algorithm>
#include <cmath>

#include <QLayout>
#include <QScreen>

namespace usar::widgets {

namespace {

/// The docks that have nothing to show at a first start, or nothing that a person must see then.
QList<QDockWidget*> waitingDocks(const WindowViews& views) {
    static const QStringList needed{"robots", "behavior"};
    QList<QDockWidget*> docks;
    for (QDockWidget* const dock : views.docks)
        if (!needed.contains(dock->objectName()))
            docks << dock;
    return docks;
}

} // namespace

WindowDocks::WindowDocks(QMainWindow& window, const WindowViews& views, CommandRegistry& commands, LayoutKeeper& own)
    : window_(window)
    , views_(views)
    , commands_(commands)
    , own_(own)
    , opener_(waitingDocks(views)) {}

void WindowDocks::registerCommands() {
    addLayout("view.operate", nullptr, 0.0);
    addLayout("view.analyse", views_.plots_dock, 0.6);
    addLayout("view.debug", views_.messages_dock, 0.6);
    addLayout("view.plan", views_.plan_dock, 0.6);
    for (QDockWidget* const dock : views_.docks)
        addCommand(dock);
}

void WindowDocks::addCommand(QDockWidget* dock) {
    const CommandSpec spec{.id = "view.dock." + dock->objectName(),
                           .text = dock->windowTitle(),
                           .group = tr("View"),
                           .help = tr("Shows this dock, or hides it if it is in front"),
                           .shortcuts = dock->widget() == views_.relief ? QList{QKeySequence("Ctrl+Alt+3")}
                                                                        : QList<QKeySequence>(),
                           .checkable = true,
                           .wish = tr("Show %1").arg(dock->windowTitle())};
    QAction* const shown = commands_.add(spec, [this, dock](bool on) {
        if (!on && !dock->isHidden() && !dock->visibleRegion().isEmpty()) // It may be behind another tab.
            return dock->hide();
        const bool opens = dock->isHidden();
        dock->show();
        dock->raise();
        if (opens && dock->widget() == views_.relief)
            giveRoom(dock, 0.5);
        if (opens && dock->widget() == views_.campaign)
            giveRoom(dock, 0.45); // A table with a head needs it.
    });
    connect(dock, &QDockWidget::visibilityChanged, shown, [dock, shown] { shown->setChecked(!dock->isHidden()); });
}

void WindowDocks::giveRoom(QDockWidget* dock, double part) {
    if (dock->isFloating() || window_.dockWidgetArea(dock) != Qt::BottomDockWidgetArea)
        return;
    const int whole_px = window_.centralWidget()->height() + dock->height();
    const int wanted_px = static_cast<int>(std::lround(part * whole_px));
    if (dock->height() < wanted_px)
        window_.resizeDocks({dock}, {wanted_px}, Qt::Vertical);
}

void WindowDocks::wire() {
    connect(views_.robots, &RobotList::wholeHeightChanged, this, &WindowDocks::giveRobotsRoom);
    connect(views_.sensors, &SensorPanel::plotRequested, this, [this] { opener_.showFirst(views_.plots_dock); });
}

void WindowDocks::showForRobot() {
    for (QDockWidget* const dock : views_.docks)
        if (dock->objectName() == "instruments" || dock->objectName() == "sensors")
            opener_.showFirst(dock);
}

void WindowDocks::resizeToScreen() {
    window_.layout()->invalidate(); // Otherwise the minimum size would be that of all docks before they became tabs.
    window_.layout()->activate();
    constexpr int frame_px = 40; // Title bar and borders, which the size does not include.
    window_.resize(QSize(1280, 800).boundedTo(window_.screen()->availableSize() - QSize(0, frame_px)));
}

void WindowDocks::keepFirstLayout() {
    resizeToScreen();
    first_layout_ = state();
}

void WindowDocks::restore(bool sized, const QByteArray& state, const QStringList& waiting) {
    window_.restoreState(state, version);
    opener_.begin(waiting);
    if (!sized)
        resizeToScreen(); // It may be smaller now, because docks are closed.
}

void WindowDocks::addLayout(const char* id, QDockWidget* raised, double bottom_part) {
    const QString name = commandSpec(id).text.section(": ", 1);
    commands_.add(commandSpec(id), [this, name, raised, bottom_part](bool) {
        own_.rearrange(name, [=, this] { arrange(raised, bottom_part); });
    });
}

void WindowDocks::arrange(QDockWidget* raised, double bottom_part) {
    opener_.keepDuring(raised, [this, raised] {
        window_.restoreState(first_layout_, version);
        if (raised)
            raised->show();
    });
    if (raised) {
        raised->raise();
        const int whole_px = window_.centralWidget()->parentWidget()->height();
        window_.resizeDocks({raised}, {static_cast<int>(std::lround(bottom_part * whole_px))}, Qt::Vertical);
    }
    giveRobotsRoom();
}

void WindowDocks::giveRobotsRoom() {
    QDockWidget* const dock = views_.robots_dock;
    if (dock->isHidden() || dock->isFloating() || !window_.tabifiedDockWidgets(dock).isEmpty())
        return;
    constexpr int least_px = 110;  // The list is never lower, even when it is empty.
    constexpr int others_px = 300; // The docks below it need this.
    const int column_px = window_.height() - window_.centralWidget()->y();
    constexpr int rounding_px = 4; // The main window deals out heights in whole shares.
    const int title_px = dock->height() - views_.robots->height() + rounding_px;
    const int most_px = std::max(least_px, column_px - others_px);
    const int robots_px = std::max(least_px, views_.robots->heightWithin_px(most_px - title_px) + title_px);
    window_.resizeDocks({dock, views_.docks[1]}, {robots_px, column_px - robots_px}, Qt::Vertical);
}

} // namespace usar::widgets
