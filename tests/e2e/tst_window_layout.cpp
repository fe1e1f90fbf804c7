// The window on small screens: what is in a dock can be reached, and no dock makes the window larger than the screen.
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QListView>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QToolBar>
#include <QToolButton>

#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_layout {

using namespace usar;

namespace {

constexpr QSize frame(0, 40); ///< what the window manager takes of a screen

bool isControl(const QWidget* widget) {
    return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
           qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
           qobject_cast<const QAbstractSlider*>(widget) || qobject_cast<const QAbstractItemView*>(widget);
}

/// The scroll area whose content this is; nullptr if it is none.
const QAbstractScrollArea* scrolling(const QWidget* content) {
    const QWidget* const viewport = content->parentWidget();
    const auto* const area = viewport ? qobject_cast<const QAbstractScrollArea*>(viewport->parentWidget()) : nullptr;
    return area && area->viewport() == viewport ? area : nullptr;
}

/// What cannot be reached of this control in words; empty if it is whole, or comes into view by scrolling.
QString cutOff(const QWidget* control) {
    QRect place = control->rect();
    for (const QWidget* part = control; !part->isWindow(); part = part->parentWidget()) {
        place.translate(part->pos());
        if (const QAbstractScrollArea* const area = scrolling(part)) {
            part = area->viewport();
            place = area->viewport()->geometry();
        } else if (!part->parentWidget()->rect().contains(place)) {
            return QStringLiteral("%1 '%2' lies outside of %3")
                .arg(control->metaObject()->className(), control->accessibleName(),
                     part->parentWidget()->metaObject()->className());
        }
    }
    return {};
}

/// The first control of the dock that cannot be reached; empty if all can.
QString unreachable(const QDockWidget* dock) {
    for (const QWidget* control : dock->widget()->findChildren<QWidget*>())
        if (isControl(control) && control->isVisible() && !control->visibleRegion().isEmpty())
            if (const QString words = cutOff(control); !words.isEmpty())
                return dock->objectName() + ": " + words;
    return {};
}

/// Width in pixels that the words of this label, button or number need; 0 for other widgets.
int neededWidth_px(const QWidget* widget) {
    const auto width_px = [widget](const QString& text) {
        return widget->fontMetrics().size(Qt::TextShowMnemonic, text).width();
    };
    if (const auto* const label = qobject_cast<const QLabel*>(widget))
        return label->wordWrap() || label->text().isEmpty() ? 0 : label->sizeHint().width();
    if (const auto* const tool = qobject_cast<const QToolButton*>(widget);
        tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull())
        return 0;
    if (const auto* const button = qobject_cast<const QAbstractButton*>(widget))
        return button->text().isEmpty() ? 0 : width_px(button->text());
    if (const auto* const box = qobject_cast<const QAbstractSpinBox*>(widget->parentWidget()))
        return qobject_cast<const QLineEdit*>(widget) ? width_px(box->text()) : 0;
    return 0;
}

/// All words below `root` that are cut. What elides itself says so by "…" and tells the rest in its tooltip.
QStringList cutWords(const QWidget* root) {
    QStringList cut;
    for (const QWidget* widget : root->findChildren<QWidget*>())
        if (const int needed_px = neededWidth_px(widget);
            widget->isVisible() && widget->width() < needed_px && !widget->inherits("usar::widgets::ElidedLabel"))
            cut << QStringLiteral("%1 '%2' has %3 of %4 px")
                       .arg(widget->metaObject()->className(), widget->property("text").toString())
                       .arg(widget->width())
                       .arg(needed_px);
    return cut;
}

void openInFront(WindowPage& page, const QDockWidget* dock) {
    if (dock->visibleRegion().isEmpty())
        page.window().commands().action("view.dock." + dock->objectName())->trigger();
}

} // namespace

class tst_WindowLayout : public QObject {
    Q_OBJECT
private slots:
    void everyDockFitsTheScreen_data();
    void everyDockFitsTheScreen();
    void messagesAreReadWithoutScrollingSideways();
    void openingLayersKeepsTheWindowsHeight();
    void startIsReachableAtTwiceTheScale();
    void atAFirstStartTheMapHasTheWindow_data();
    void atAFirstStartTheMapHasTheWindow();
    void whatHasSomethingToShowOpens();
    void allRobotsAreSeenWhereThereIsRoom();
    void theReasonOfAFailureIsWholeInAWideWindow();
};

void tst_WindowLayout::everyDockFitsTheScreen_data() {
    QTest::addColumn<QSize>("screen");
    QTest::newRow("1024x768") << QSize(1024, 768);
    QTest::newRow("1280x800") << QSize(1280, 800);
    QTest::newRow("half of 1920x1080") << QSize(960, 1080);
    QTest::newRow("1920x1080 at 200 %") << QSize(960, 540);
}

void tst_WindowLayout::everyDockFitsTheScreen() {
    QFETCH(QSize, screen);
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    const QSize room = screen - frame;
    page.window().resize(room);
    QTRY_COMPARE(page.window().size(), room);
    for (const QDockWidget* dock : page.window().views().docks) {
        openInFront(page, dock);
        QTRY_VERIFY2(!dock->visibleRegion().isEmpty(), qPrintable(dock->objectName()));
        QTRY_COMPARE(unreachable(dock), QString());
        QTRY_VERIFY2(cutWords(dock).isEmpty(), qPrintable(dock->objectName() + ": " + cutWords(dock).join(u'\n')));
        QVERIFY2(page.window().size() == room, qPrintable(dock->objectName()));
        QVERIFY2(page.window().minimumSizeHint().height() <= room.height(), qPrintable(dock->objectName()));
    }
    for (const QToolBar* bar : page.window().findChildren<QToolBar*>())
        QVERIFY2(screen.width() < 1024 || cutWords(bar).isEmpty(), qPrintable(cutWords(bar).join(u'\n')));
    page.screenshot(QStringLiteral("layout_%1x%2").arg(screen.width()).arg(screen.height()));
}

void tst_WindowLayout::messagesAreReadWithoutScrollingSideways() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.window().resize(QSize(1024, 768) - frame);
    QVERIFY(page.spawnAt("PlayerStart")); // Its instruments take room, too.
    const widgets::WindowViews& views = page.window().views();
    openInFront(page, views.messages_dock);
    QTRY_VERIFY(!views.messages_dock->visibleRegion().isEmpty());
    QTRY_VERIFY(views.traffic->text().contains("in"));
    const auto* const scrolled = qobject_cast<const QScrollArea*>(views.messages_dock->widget());
    QVERIFY(scrolled);
    QTRY_COMPARE(scrolled->horizontalScrollBar()->maximum(), 0);
    protocol::TrafficCounts hours;
    hours.lines_in = 1'042'123;
    hours.lines_out = 322'000;
    views.traffic->setText(widgets::trafficSummary(hours));
    scrolled->widget()->layout()->activate(); // Before the next lines bring the true numbers back.
    const int needed_px = scrolled->widget()->minimumSizeHint().width();
    QVERIFY2(needed_px <= scrolled->viewport()->width(),
             qPrintable(QString("%1 of %2 px").arg(needed_px).arg(scrolled->viewport()->width())));
}

void tst_WindowLayout::openingLayersKeepsTheWindowsHeight() {
    WindowPage page;
    page.window().setAnimated(false); // So that docks are in their places at once.
    page.window().resize(1280, 760);
    QTRY_COMPARE(page.window().height(), 760);
    page.window().commands().action("view.dock.layers")->trigger();
    QTRY_VERIFY(page.window().views().layers->isVisible());
    QTRY_VERIFY(!page.window().views().layers->visibleRegion().isEmpty());
    QCOMPARE(page.window().height(), 760);
    page.window().commands().action("view.operate")->trigger();
    QTRY_VERIFY(!page.window().views().layers->isVisible());
    QCOMPARE(page.window().height(), 760);
}

void tst_WindowLayout::startIsReachableAtTwiceTheScale() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.window().resize(QSize(960, 540) - frame);
    QTRY_COMPARE(page.window().size(), QSize(960, 540) - frame);
    for (const QPushButton* button : page.window().views().behavior->findChildren<QPushButton*>())
        if (button->text() == "Start")
            QTRY_COMPARE(button->visibleRegion().boundingRect(), button->rect());
    QVERIFY(page.window().rect().contains(QRect(page.window().views().stop_all->mapTo(&page.window(), QPoint()),
                                                page.window().views().stop_all->size())));
}

void tst_WindowLayout::atAFirstStartTheMapHasTheWindow_data() {
    QTest::addColumn<QSize>("screen");
    QTest::newRow("1024x768") << QSize(1024, 768);
    QTest::newRow("1280x800") << QSize(1280, 800);
    QTest::newRow("1920x1080") << QSize(1920, 1080);
}

void tst_WindowLayout::atAFirstStartTheMapHasTheWindow() {
    QFETCH(QSize, screen);
    WindowPage page({.first_start = true});
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.window().resize(screen - frame);
    QTRY_COMPARE(page.window().size(), screen - frame);
    QStringList open;
    for (const QDockWidget* dock : page.window().views().docks)
        if (!dock->isHidden())
            open << dock->objectName();
    QCOMPARE(open, (QStringList{"robots", "behavior"}));
    const auto part = [&] {
        const double whole = static_cast<double>(page.window().width()) * page.window().height();
        return page.map().width() * page.map().height() / whole;
    };
    QTRY_VERIFY2(part() >= 0.45, qPrintable(QString::number(part())));
    widgets::RobotList& robots = *page.window().views().robots;
    for (int number = 1; number <= 9; ++number)
        robots.updateRobot({{number}, number, "R", "AirRobot", "idle", {}});
    const auto* const list = robots.findChild<QListView*>();
    const auto last = [&] { return list->visualRect(robots.model().index(8)); };
    QTRY_VERIFY2(list->viewport()->rect().contains(last()), qPrintable(QString::number(robots.height())));
    QCOMPARE(list->verticalScrollBar()->maximum(), 0);
    for (const QWidget* part :
         {static_cast<QWidget*>(page.window().views().behavior->startButton()), // It has room, too.
          static_cast<QWidget*>(page.window().views().behavior->choice())})
        QCOMPARE(part->visibleRegion().boundingRect(), part->rect());
    page.screenshot(QStringLiteral("first_start_%1x%2").arg(screen.width()).arg(screen.height()));
}

void tst_WindowLayout::whatHasSomethingToShowOpens() {
    WindowPage page({.first_start = true});
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    const widgets::WindowViews& views = page.window().views();
    QVERIFY(!views.sensors->isVisible() && !views.laser->isVisible() && !views.plots->isVisible());
    QVERIFY(page.spawnAt("PlayerStart"));
    QTRY_VERIFY(views.sensors->isVisible() && views.laser->isVisible());
    emit views.sensors->plotRequested("SEN Sonar/F1/range", "m");
    QTRY_VERIFY(views.plots->isVisible());
    page.window().commands().action("view.dock.sensors")->trigger(); // Closes it.
    QTRY_VERIFY(!views.sensors->isVisible());
    page.window().commands().action("view.operate")->trigger();
    QTRY_VERIFY(views.sensors->isVisible()); // It has been open, so it belongs to the layout.
}

void tst_WindowLayout::allRobotsAreSeenWhereThereIsRoom() {
    WindowPage page;
    page.window().resize(1920, 1040);
    QTRY_COMPARE(page.window().height(), 1040);
    widgets::RobotList& robots = *page.window().views().robots;
    for (int number = 1; number <= 9; ++number)
        robots.updateRobot({{number}, number, "R", "AirRobot", "idle", {}});
    const auto heights = [&] { return QString("%1 of %2").arg(robots.height()).arg(robots.wholeHeight_px()); };
    QTRY_VERIFY2(robots.height() >= robots.wholeHeight_px(), qPrintable(heights()));
    page.window().commands().action("view.operate")->trigger();
    QTRY_VERIFY2(robots.height() >= robots.wholeHeight_px(), qPrintable(QString::number(robots.height())));
    for (const QPushButton* button : page.window().views().behavior->findChildren<QPushButton*>())
        if (button->text() == "Start")
            QVERIFY(!button->visibleRegion().isEmpty());
    page.screenshot("layout_nine_robots");
}

void tst_WindowLayout::theReasonOfAFailureIsWholeInAWideWindow() {
    WindowPage page;
    page.window().resize(1920, 1040);
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.connectToServer("127.0.0.1", 1);
    const QLabel* state = nullptr;
    for (const QLabel* label : page.window().views().connection->findChildren<QLabel*>())
        if (label->accessibleName() == "State of the connection")
            state = label;
    QVERIFY(state);
    QTRY_VERIFY2_WITH_TIMEOUT(state->text().contains("127.0.0.1"), qPrintable(state->text()), soon_ms);
    QTRY_VERIFY2(state->width() >= state->fontMetrics().horizontalAdvance(state->text()),
                 qPrintable(QString::number(state->width()) + " px for " + state->text()));
}

USAR_TEST(tst_WindowLayout)

} // namespace tst_window_layout

#include "tst_window_layout.moc"
