#include <memory>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QTest>

#include "core/protocol/reader.h"
#include "tests/suite/suite.h"
#include "tests/widgets/plan_samples.h"
#include "widgets/bars/connection_bar.h"
#include "widgets/bars/strips.h"
#include "widgets/bars/time_bar.h"
#include "widgets/commands/command_palette.h"
#include "widgets/drive/drive_panel.h"
#include "widgets/map/layers_panel.h"
#include "widgets/map/map_view.h"
#include "widgets/map/spawn_card.h"
#include "widgets/map/world_panel.h"
#include "widgets/messages/message_list.h"
#include "widgets/messages/notification_center.h"
#include "widgets/messages/toast_stack.h"
#include "widgets/panels/behavior_panel.h"
#include "widgets/panels/behavior_parts.h"
#include "widgets/panels/instruments.h"
#include "widgets/panels/parameter_form.h"
#include "widgets/panels/plot_canvas.h"
#include "widgets/panels/plot_view.h"
#include "widgets/panels/robot_list.h"
#include "widgets/panels/sensor_panel.h"
#include "widgets/panels/status_strip.h"
#include "widgets/plan/plan_panel.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/theme.h"

namespace tst_panel_reach {

using namespace usar;
using namespace usar::widgets;

namespace {

std::unique_ptr<QWidget> filledForm() {
    auto form = std::make_unique<ParameterForm>();
    form->setSpecs({
        {"a_m", "A", "G", "m", 6.0, 2.0, 40.0, "", {}},
        {"b", "B", "G", "", true, 0.0, 0.0, "", {}},
        {"c", "C", "G", "", std::string("x"), 0.0, 0.0, "", {"x", "y"}},
        {"d", "D", "G", "", std::string("t"), 0.0, 0.0, "", {}},
    });
    form->setValues({{"a_m", 7.0}, {"b", false}});
    return form;
}

std::unique_ptr<QWidget> filledPlot() {
    auto plot = std::make_unique<PlotView>();
    plot->addSeries(QStringLiteral("SEN Sonar/F1/range"));
    return plot;
}

std::unique_ptr<QWidget> filledPlan() {
    auto panel = std::make_unique<PlanPanel>();
    panel->setPlan(planOf(courier_plan));
    panel->setPlanText(courier_plan, {});
    panel->view().find(QStringLiteral("a"));
    return panel;
}

std::unique_ptr<QWidget> filledRobots() {
    auto robots = std::make_unique<RobotList>();
    robots->updateRobot({1, 1, QStringLiteral("R1"), QStringLiteral("AirRobot"), QStringLiteral("idle"), 50.0, false});
    return robots;
}

std::unique_ptr<QWidget> filledNotifications() {
    auto center = std::make_unique<NotificationCenter>();
    center->push(QStringLiteral("link"), Severity::Error, QStringLiteral("No answer."), std::nullopt, {}, QDateTime());
    return center;
}

std::unique_ptr<QWidget> filledMessages() {
    auto list = std::make_unique<MessageList>();
    protocol::Reader reader;
    list->takeLine(reader.read("STA {Time 1}"), Seconds(1));
    return list;
}

template <class Widget>
std::unique_ptr<QWidget> plain() {
    return std::make_unique<Widget>();
}

std::unique_ptr<QWidget> realServerBar() {
    auto bar = std::make_unique<ConnectionBar>();
    bar->setServer(ServerChoice::Real);
    return bar;
}

std::unique_ptr<QWidget> runningBehavior() {
    auto panel = std::make_unique<BehaviorPanel>(filledForm().release());
    panel->setBehaviors({{"airrobot/cpp", "Terrain survey", "Scans.", true, {}}});
    auto* start = new QAction(panel.get());
    start->setEnabled(false);
    panel->setActions(start, new QAction(panel.get()), new QAction(panel.get()), new QAction(panel.get()));
    panel->setRunState(RunState::Running, QStringLiteral("R1"));
    return panel;
}

std::unique_ptr<QWidget> filledSensors() {
    auto panel = std::make_unique<SensorPanel>();
    panel->take({{1}, {}, protocol::InsReading{{}, "INS", {{1, 2, 3}, 0, 0, 0}}, {}}, Seconds(1));
    panel->refresh();
    return panel;
}

std::unique_ptr<QWidget> openSpawnCard() {
    auto under = std::make_unique<QWidget>();
    under->resize(480, 400);
    auto* card = new SpawnCard(under.get());
    card->setRobots({{"USARBot.AirRobot", "AirRobot", {}, {}}});
    card->openFor(0, QStringLiteral("PlayerStart"), QStringLiteral("R1"), QPoint());
    return under;
}

std::unique_ptr<QWidget> openToast() {
    auto under = std::make_unique<QWidget>();
    auto* model = new NotificationModel(under.get());
    new ToastStack(under.get(), model);
    model->push(QStringLiteral("link"), Severity::Error, QStringLiteral("No answer."), QDateTime());
    return under;
}

std::unique_ptr<QWidget> drivenRobot() {
    auto panel = std::make_unique<DrivePanel>();
    panel->setState({.robot = QStringLiteral("R1"),
                     .control = {QStringLiteral("R1"), Driver::Person, QStringLiteral("keys")},
                     .can_take = true,
                     .taken = true,
                     .axes = {true, true, true, true}});
    return panel;
}

std::unique_ptr<QWidget> palette() {
    auto under = std::make_unique<QWidget>();
    auto* commands = new CommandRegistry(under.get());
    auto* palette = new CommandPalette(*commands, under.get());
    palette->setWindowFlags(Qt::Widget);
    palette->show();
    return under;
}

using Maker = std::unique_ptr<QWidget> (*)();

/// What draws its figures itself: nothing but the tooltip says what they are and in which unit.
bool isPaintedView(const QWidget* widget) {
    return qobject_cast<const Readout*>(widget) || qobject_cast<const Meter*>(widget) ||
           qobject_cast<const LaserFanView*>(widget) || qobject_cast<const TerrainProfileView*>(widget) ||
           qobject_cast<const SonarColumnsView*>(widget) || qobject_cast<const PlotCanvas*>(widget);
}

bool isControl(const QWidget* widget) {
    return widget->isVisible() && widget->isEnabled() &&
           (qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
            qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget));
}

/// What Qt puts inside its own editors, views and menus is Qt's.
bool isQtsOwn(const QWidget* widget) {
    const QWidget* parent = widget->parentWidget();
    return qobject_cast<const QLineEdit*>(parent) || qobject_cast<const QAbstractSpinBox*>(parent) ||
           qobject_cast<const QComboBox*>(parent) || qobject_cast<const QAbstractItemView*>(parent) ||
           qobject_cast<const QMenu*>(parent);
}

QString nameOf(const QWidget* widget) {
    return QStringLiteral("%1 '%2'").arg(QString::fromLatin1(widget->metaObject()->className()), widget->objectName());
}

} // namespace

class tst_PanelReach : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void everyControlHasAName_data() { everything(); }
    void everyControlHasAName();
    void everyControlIsLargeEnough_data() { everything(); }
    void everyControlIsLargeEnough();
    void everyControlIsReachedByTab_data() { everything(); }
    void everyControlIsReachedByTab();
    void nothingFocusableIsNameless_data() { everything(); }
    void nothingFocusableIsNameless();
    void everyControlSaysWhatItDoes_data() { everything(); }
    void everyControlSaysWhatItDoes();
    void everyListHasAName_data() { panels(); }
    void everyListHasAName();
    void bothThemesReachTheGround_data() { panels(); }
    void bothThemesReachTheGround();
    void narrowPanelsStayNarrow_data() { panels(); }
    void narrowPanelsStayNarrow();

private:
    static void panels();
    static void everything();
    std::unique_ptr<QWidget> shown();
    static QList<QWidget*> controls(const QWidget& panel);
};

void tst_PanelReach::initTestCase() {
    applyTheme(Theme::Dark);
}

void tst_PanelReach::panels() {
    QTest::addColumn<Maker>("make");
    QTest::newRow("parameters") << Maker(filledForm);
    QTest::newRow("plots") << Maker(filledPlot);
    QTest::newRow("robots") << Maker(filledRobots);
    QTest::newRow("notifications") << Maker(filledNotifications);
    QTest::newRow("messages") << Maker(filledMessages);
    QTest::newRow("plan") << Maker(filledPlan);
    QTest::newRow("drive") << Maker(drivenRobot);
}

void tst_PanelReach::everything() {
    panels();
    QTest::newRow("connection, embedded") << Maker(plain<ConnectionBar>);
    QTest::newRow("connection, real server") << Maker(realServerBar);
    QTest::newRow("time") << Maker(plain<TimeBar>);
    QTest::newRow("hints") << Maker(plain<HintStrip>);
    QTest::newRow("behavior") << Maker(runningBehavior);
    QTest::newRow("spawn card") << Maker(openSpawnCard);
    QTest::newRow("mission area") << Maker(plain<AreaForm>);
    QTest::newRow("layers") << Maker(plain<LayersPanel>);
    QTest::newRow("world") << Maker(plain<WorldPanel>);
    QTest::newRow("map") << Maker(plain<MapView>);
    QTest::newRow("status") << Maker(plain<StatusStrip>);
    QTest::newRow("laser") << Maker(plain<LaserFanView>);
    QTest::newRow("terrain profile") << Maker(plain<TerrainProfileView>);
    QTest::newRow("sonars") << Maker(plain<SonarColumnsView>);
    QTest::newRow("sensors") << Maker(filledSensors);
    QTest::newRow("toast") << Maker(openToast);
    QTest::newRow("command palette") << Maker(palette);
}

std::unique_ptr<QWidget> tst_PanelReach::shown() {
    QFETCH(Maker, make);
    std::unique_ptr<QWidget> panel = make();
    panel->resize(480, 400);
    panel->show();
    panel->activateWindow();
    return QTest::qWaitForWindowActive(panel.get()) ? std::move(panel) : nullptr;
}

QList<QWidget*> tst_PanelReach::controls(const QWidget& panel) {
    QList<QWidget*> found;
    for (QWidget* widget : panel.findChildren<QWidget*>())
        if (isControl(widget) && !isQtsOwn(widget))
            found << widget;
    return found;
}

void tst_PanelReach::everyControlHasAName() {
    const auto panel = shown();
    QVERIFY(panel);
    for (const QWidget* control : controls(*panel)) {
        const auto* button = qobject_cast<const QAbstractButton*>(control);
        const bool named = !control->accessibleName().isEmpty() || (button && !button->text().isEmpty());
        QVERIFY2(named, qPrintable(nameOf(control)));
    }
}

void tst_PanelReach::nothingFocusableIsNameless() {
    const auto panel = shown();
    QVERIFY(panel);
    auto widgets = panel->findChildren<QWidget*>();
    widgets << panel.get();
    for (const QWidget* widget : std::as_const(widgets)) {
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        if (!widget->isVisible() || (widget->focusPolicy() == Qt::NoFocus && !isPaintedView(widget)) ||
            isQtsOwn(widget) || (button && !button->text().isEmpty()))
            continue;
        QVERIFY2(!widget->accessibleName().isEmpty(), qPrintable(nameOf(widget)));
    }
}

void tst_PanelReach::everyControlSaysWhatItDoes() {
    const auto panel = shown();
    QVERIFY(panel);
    auto widgets = panel->findChildren<QWidget*>();
    widgets << panel.get();
    for (const QWidget* widget : std::as_const(widgets))
        if (qobject_cast<const PlotCanvas*>(widget)) // A tooltip would lie over the curve; it has a readout.
            QVERIFY(!widget->accessibleDescription().isEmpty());
        else if (!isQtsOwn(widget) && (isControl(widget) || isPaintedView(widget)))
            QVERIFY2(!widget->toolTip().isEmpty() || !widget->parentWidget()->toolTip().isEmpty(),
                     qPrintable(nameOf(widget) + u' ' + widget->accessibleName()));
}

void tst_PanelReach::everyControlIsLargeEnough() {
    const auto panel = shown();
    QVERIFY(panel);
    for (const QWidget* control : controls(*panel))
        QVERIFY2(control->height() >= minimum_target && control->width() >= minimum_target,
                 qPrintable(nameOf(control) + QStringLiteral(" %1 x %2").arg(control->width()).arg(control->height())));
}

void tst_PanelReach::everyControlIsReachedByTab() {
    const auto panel = shown();
    QVERIFY(panel);
    QSet<QWidget*> missing;
    for (QWidget* control : controls(*panel))
        if (!qobject_cast<const Toast*>(control->parentWidget())) // comes and goes; its tab keeps the text
            missing << control;
    for (int i = 0; i < 60 && !missing.isEmpty(); ++i) {
        QTest::keyClick(panel->window()->focusWidget() ? panel->window()->focusWidget() : panel.get(), Qt::Key_Tab);
        missing.remove(panel->window()->focusWidget());
    }
    for (const QWidget* control : missing)
        QVERIFY2(false, qPrintable(nameOf(control)));
}

void tst_PanelReach::everyListHasAName() {
    const auto panel = shown();
    QVERIFY(panel);
    for (const QAbstractItemView* view : panel->findChildren<QAbstractItemView*>())
        if (view->isVisible() &&
            !QString::fromLatin1(view->metaObject()->className()).contains(QStringLiteral("Header")))
            QVERIFY2(!view->accessibleName().isEmpty(), qPrintable(nameOf(view)));
}

void tst_PanelReach::bothThemesReachTheGround() {
    const auto panel = shown();
    QVERIFY(panel);
    const auto share = [&](const QColor& color) {
        const QImage image = panel->grab().toImage().convertToFormat(QImage::Format_RGB32);
        int same = 0;
        for (int y = 0; y < image.height(); y += 4)
            for (int x = 0; x < image.width(); x += 4)
                same += image.pixel(x, y) == color.rgb() ? 1 : 0;
        return 16.0 * same / (image.width() * image.height());
    };
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        applyTheme(theme);
        const Theme other = theme == Theme::Dark ? Theme::Light : Theme::Dark;
        QVERIFY(share(tokens(theme).surface) + share(tokens(theme).background) > 0.5);
        QVERIFY(share(tokens(other).surface) + share(tokens(other).background) < 0.01);
    }
}

void tst_PanelReach::narrowPanelsStayNarrow() {
    const auto panel = shown();
    QVERIFY(panel);
    const int least_px = QTest::currentDataTag() == QByteArray("plots") ? 340 : 280; // Its dock lies below the map.
    panel->resize(least_px, 400);
    QCOMPARE(panel->width(), least_px);
}

USAR_TEST(tst_PanelReach)

} // namespace tst_panel_reach

#include "tst_panel_reach.moc"
