// The tour in the real window: each step at the real widget, left at any moment, offered once.
#include <QComboBox>
#include <QLabel>
#include <QStyle>
#include <QTest>

#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_tour {

using namespace usar;

namespace {

constexpr int steps = 5;
constexpr QSize frame(0, 40); ///< what the window manager takes of a screen

template <class Part>
Part* partOf(WindowPage& page) {
    return page.window().findChild<Part*>(QString(), Qt::FindDirectChildrenOnly);
}

/// The ring has no class of its own for the meta-object system.
const widgets::TourRing& ringOf(WindowPage& page) {
    for (QWidget* child : page.window().findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (const auto* const ring = dynamic_cast<widgets::TourRing*>(child))
            return *ring;
    qFatal("no ring");
}

widgets::TourCard& cardOf(WindowPage& page) {
    return *partOf<widgets::TourCard>(page);
}

QRect inWindow(const WindowPage& page, const QWidget* widget) {
    return {widget->mapTo(&const_cast<WindowPage&>(page).window(), QPoint()), widget->size()};
}

void begin(WindowPage& page) {
    page.window().commands().action("help.tour")->trigger();
}

bool shows(WindowPage& page, int step) {
    return cardOf(page).isVisible() && cardOf(page).accessibleName().contains(QString("step %1 of").arg(step));
}

QPushButton* offer(WindowPage& page) {
    for (QPushButton* const button : page.window().views().hint->findChildren<QPushButton*>())
        if (button->text() == "Take the tour")
            return button;
    return nullptr;
}

/// Where the text of a label or button is, in the window.
QRect textOf(const WindowPage& page, const QWidget* widget) {
    if (const auto* const label = qobject_cast<const QLabel*>(widget); label && !label->wordWrap())
        return QStyle::alignedRect(Qt::LeftToRight, label->alignment(),
                                   label->fontMetrics().size(0, label->text()).boundedTo(label->size()),
                                   label->contentsRect())
            .translated(inWindow(page, widget).topLeft());
    return inWindow(page, widget);
}

/// What the ring crosses, in words.
QStringList cutByTheRing(WindowPage& page) {
    const QRegion band = QRegion(ringOf(page).outside()) - QRegion(ringOf(page).inside());
    QStringList cut;
    for (const QWidget* widget : page.window().findChildren<QWidget*>()) {
        const QString text = widget->property("text").toString();
        if (!text.isEmpty() && widget->isVisible() && widget->window() == &page.window() &&
            !cardOf(page).isAncestorOf(widget) && band.intersects(textOf(page, widget)))
            cut << text;
    }
    return cut;
}

} // namespace

class tst_WindowTour : public QObject {
    Q_OBJECT
private slots:
    void itIsOfferedOnce();
    void itGoesOnAsThePersonDoesTheSteps();
    void itEndsAtAnyMoment_data();
    void itEndsAtAnyMoment();
    void theRingCutsNoLabel_data();
    void theRingCutsNoLabel();
};

void tst_WindowTour::itIsOfferedOnce() {
    QTemporaryDir settings;
    {
        WindowPage page({.first_start = true, .settings_folder = settings.path()});
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        QVERIFY(offer(page)->isVisible());
        page.screenshot("tour_offer");
        QTest::mouseClick(offer(page), Qt::LeftButton);
        QVERIFY(shows(page, 1) && !offer(page)->isVisible());
        QTest::mouseClick(cardOf(page).leave(), Qt::LeftButton);
        QVERIFY(!cardOf(page).isVisible() && !ringOf(page).isVisible());
        page.window().close();
    }
    WindowPage again({.first_start = true, .settings_folder = settings.path()});
    QTRY_VERIFY_WITH_TIMEOUT(again.hasStartPoses(), soon_ms);
    QVERIFY(again.window().views().hint->isVisible() && !offer(again)->isVisible());
    begin(again); // From the menu at any time.
    QVERIFY(shows(again, 1));
}

void tst_WindowTour::itGoesOnAsThePersonDoesTheSteps() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    begin(page);
    QVERIFY(shows(page, 1));
    QVERIFY(ringOf(page).inside().intersects(inWindow(page, page.window().views().connection)));
    const test::Beats looks(300);
    QVERIFY(test::holdsUntil([&] { return shows(page, 1); }, [&] { return looks.count() >= 5; }, soon_ms));
    QVERIFY(shows(page, 1)); // What was done before waits for Next.
    QVERIFY(cardOf(page).next()->hasFocus());
    QTest::keyClick(cardOf(page).next(), Qt::Key_Return);
    QVERIFY(shows(page, 2));
    QVERIFY(inWindow(page, &page.map()).contains(ringOf(page).inside()));
    page.screenshot("tour_2");
    QVERIFY(page.spawnAt("PlayerStart"));
    QTRY_VERIFY(shows(page, 3));
    QComboBox* const choice = page.window().views().behavior->choice();
    QTRY_VERIFY(ringOf(page).inside().contains(inWindow(page, choice)));
    QTRY_VERIFY(choice->isEnabled());
    QVERIFY(!cardOf(page).geometry().intersects(inWindow(page, page.window().views().behavior)));
    page.screenshot("tour_3");
    QTest::keyClick(choice, Qt::Key_Down);
    QTest::keyClick(choice, Qt::Key_Home);
    QTRY_VERIFY(shows(page, 4));
    page.screenshot("tour_4");
    page.typeArea({Vec2(-10.0, -10.0), Vec2(10.0, 10.0)});
    QTRY_VERIFY(ringOf(page).inside().contains(inWindow(page, page.window().views().behavior->startButton())));
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(shows(page, 5), soon_ms);
    page.chooseSpeed("max");
    QTRY_VERIFY_WITH_TIMEOUT(!page.map().heights().empty(), flight_ms);
    QTRY_VERIFY(cardOf(page).isVisible());
    page.screenshot("tour_5");
    QTest::mouseClick(cardOf(page).next(), Qt::LeftButton);
    QVERIFY(!cardOf(page).isVisible() && !ringOf(page).isVisible());
}

void tst_WindowTour::itEndsAtAnyMoment_data() {
    QTest::addColumn<int>("step");
    for (int step = 1; step <= steps; ++step)
        QTest::addRow("step %d", step) << step;
}

void tst_WindowTour::itEndsAtAnyMoment() {
    QFETCH(int, step);
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    begin(page);
    for (int i = 1; i < step; ++i)
        QTest::mouseClick(cardOf(page).next(), Qt::LeftButton);
    QVERIFY(shows(page, step));
    page.pressKey(Qt::Key_Escape);
    QVERIFY(!cardOf(page).isVisible() && !ringOf(page).isVisible());
    begin(page);
    QVERIFY(shows(page, 1));
}

void tst_WindowTour::theRingCutsNoLabel_data() {
    QTest::addColumn<QSize>("screen");
    QTest::newRow("1024x768") << QSize(1024, 768);
    QTest::newRow("1280x800") << QSize(1280, 800);
    QTest::newRow("1920x1080") << QSize(1920, 1080);
}

void tst_WindowTour::theRingCutsNoLabel() {
    QFETCH(QSize, screen);
    WindowPage page({.first_start = true});
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.window().setAnimated(false); // So that docks are in their places at once.
    page.window().resize(screen - frame);
    QTRY_COMPARE(page.window().size(), screen - frame);
    begin(page);
    for (int step = 1; step <= steps; ++step) {
        QVERIFY(shows(page, step));
        QTRY_COMPARE(cutByTheRing(page), QStringList());
        QTRY_VERIFY(page.window().rect().contains(ringOf(page).outside()));
        QTRY_VERIFY(page.window().rect().contains(cardOf(page).geometry()));
        QTRY_VERIFY2(step == steps || !cardOf(page).geometry().intersects(ringOf(page).outside()),
                     qPrintable(QString::number(step)));
        page.screenshot(QStringLiteral("tour_%1_%2").arg(screen.width()).arg(step));
        QTest::mouseClick(cardOf(page).next(), Qt::LeftButton);
    }
    QVERIFY(!cardOf(page).isVisible());
}

USAR_TEST(tst_WindowTour)

} // namespace tst_window_tour

#include "tst_window_tour.moc"
