#include <memory>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QTest>

#include "core/protocol/reader.h"
#include "widgets/empty_state.h"
#include "widgets/message_list.h"
#include "widgets/notification_center.h"
#include "widgets/parameter_form.h"
#include "widgets/plot_view.h"
#include "widgets/robot_list.h"
#include "widgets/theme.h"

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

std::unique_ptr<QWidget> filledRobots() {
    auto robots = std::make_unique<RobotList>();
    robots->updateRobot({1, 1, QStringLiteral("R1"), QStringLiteral("AirRobot"), QStringLiteral("idle"), 50.0, false});
    return robots;
}

std::unique_ptr<QWidget> filledNotifications() {
    auto center = std::make_unique<NotificationCenter>();
    center->push(QStringLiteral("link"), Severity::Error, QStringLiteral("No answer."), QDateTime());
    return center;
}

std::unique_ptr<QWidget> filledMessages() {
    auto list = std::make_unique<MessageList>();
    protocol::Reader reader;
    list->takeLine(reader.read("STA {Time 1}"), Seconds(1));
    return list;
}

using Maker = std::unique_ptr<QWidget> (*)();

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

Q_DECLARE_METATYPE(Maker)

class tst_PanelReach : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void everyControlHasAName_data() { panels(); }
    void everyControlHasAName();
    void everyControlIsLargeEnough_data() { panels(); }
    void everyControlIsLargeEnough();
    void everyControlIsReachedByTab_data() { panels(); }
    void everyControlIsReachedByTab();
    void everyListHasAName_data() { panels(); }
    void everyListHasAName();
    void bothThemesReachTheGround_data() { panels(); }
    void bothThemesReachTheGround();
    void narrowPanelsStayNarrow_data() { panels(); }
    void narrowPanelsStayNarrow();

private:
    static void panels();
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
    panel->resize(280, 400);
    QCOMPARE(panel->width(), 280);
}

QTEST_MAIN(tst_PanelReach)
#include "tst_panel_reach.moc"
