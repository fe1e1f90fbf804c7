// The camera dock in the real window, with pictures from the embedded simulator's image server.
#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QTest>

#include "core/server/image_server.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"
#include "widgets/drive/camera_view.h"
#include "widgets/style/empty_state.h"

namespace tst_window_camera {

using namespace usar;

namespace {

void spawnClass(WindowPage& page, const QString& class_name, const std::string& start = "PlayerStart", int id = 1) {
    page.clickStartPose(start);
    auto* const card = page.window().views().spawn_card;
    QTRY_VERIFY(card->isVisible());
    auto* const classes = card->findChild<QComboBox*>();
    classes->setCurrentText(class_name);
    QCOMPARE(classes->currentText(), class_name);
    page.press("Spawn");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(id) && page.robot(id)->figures.spawned, soon_ms);
}

/// As a click on its tab does.
void raiseCamera(WindowPage& page) {
    auto* const dock = page.window().findChild<QDockWidget*>("camera");
    dock->show();
    dock->raise();
    QTRY_VERIFY(page.window().views().camera->wantsPictures());
}

widgets::CameraView& camera(WindowPage& page) {
    return *page.window().views().camera;
}

QString emptyText(WindowPage& page) {
    const auto* const empty = camera(page).findChild<widgets::EmptyState*>();
    return empty->isVisible() ? empty->accessibleName() + ". " + empty->accessibleDescription() : QString();
}

/// Mean difference of color values; pictures of unequal size are as unequal as can be.
double difference(const QImage& a, const QImage& b) {
    if (a.size() != b.size() || a.isNull())
        return 255.0;
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            sum += std::abs(qRed(a.pixel(x, y)) - qRed(b.pixel(x, y)));
    return sum / (a.width() * a.height());
}

/// True if a cross is painted on the picture.
bool hasCross(WindowPage& page) {
    QImage picture(320, 240, QImage::Format_RGB32);
    picture.fill(Qt::green);
    camera(page).setPicture(picture, 1.0);
    auto* const canvas = camera(page).findChild<widgets::CameraCanvas*>();
    const QPoint on_cross = canvas->pictureRect().center() + QPoint(9, 0);
    return canvas->grab().toImage().pixelColor(on_cross) != QColor(Qt::green);
}

void trigger(WindowPage& page, const char* command) {
    QAction* const action = page.window().commands().action(command);
    QTRY_VERIFY_WITH_TIMEOUT(action->isEnabled(), soon_ms);
    action->trigger();
}

} // namespace

class tst_WindowCamera : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void picturesOfTheSelectedRobotComeAndGoOn();
    void zoomAndTurningChangeThePicture();
    void ofTwoRobotsTheSelectedOnesCameraIsShown();
    void aHiddenDockAsksForNothing();
    void emptyStatesSayWhatToDo();
    void thePictureIsSaved();
    void theOverlayIsFoundAsItWasLeft();
};

void tst_WindowCamera::picturesOfTheSelectedRobotComeAndGoOn() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    raiseCamera(page);
    spawnClass(page, "P2DX");
    QTRY_VERIFY_WITH_TIMEOUT(camera(page).pictureCount() >= 3, soon_ms);
    const int seen = camera(page).pictureCount();
    QTRY_VERIFY_WITH_TIMEOUT(camera(page).pictureCount() >= seen + 5, soon_ms);
    QCOMPARE(camera(page).picture().size(), QSize(320, 240));
    QVERIFY(emptyText(page).isEmpty());
    bool told = false;
    for (const QLabel* label : camera(page).findChildren<QLabel*>())
        told |= label->isVisible() && label->text().contains("frames/s");
    QVERIFY(told);
    page.screenshot("camera");
}

void tst_WindowCamera::zoomAndTurningChangeThePicture() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    raiseCamera(page);
    spawnClass(page, "P2DX");
    QTRY_VERIFY_WITH_TIMEOUT(camera(page).pictureCount() >= 3, soon_ms);
    QVERIFY(page.comesToRest());
    const int at_rest = camera(page).pictureCount();
    QTRY_VERIFY_WITH_TIMEOUT(camera(page).pictureCount() >= at_rest + 2, soon_ms); // the next may be on its way
    const QImage wide = camera(page).picture();
    trigger(page, "camera.zoom_in");
    trigger(page, "camera.zoom_in");
    QTRY_VERIFY_WITH_TIMEOUT(difference(wide, camera(page).picture()) > 4.0, soon_ms);
    trigger(page, "camera.zoom_default");
    QTRY_VERIFY_WITH_TIMEOUT(difference(wide, camera(page).picture()) < 2.0, soon_ms);
    auto* const canvas = camera(page).findChild<widgets::CameraCanvas*>();
    const QPoint middle = canvas->rect().center();
    QTest::mousePress(canvas, Qt::LeftButton, {}, middle);
    QTest::mouseMove(canvas, middle + QPoint(60, 10));
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, middle + QPoint(60, 10));
    QTRY_VERIFY_WITH_TIMEOUT(difference(wide, camera(page).picture()) > 4.0, soon_ms);
    trigger(page, "camera.center");
    QTRY_VERIFY_WITH_TIMEOUT(difference(wide, camera(page).picture()) < 2.0, soon_ms);
    canvas->setFocus();
    QTest::keyClick(canvas, Qt::Key_Right);
    QTRY_VERIFY_WITH_TIMEOUT(difference(wide, camera(page).picture()) > 4.0, soon_ms);
}

/// Without a choice the server would send both cameras as one picture of twice the size.
void tst_WindowCamera::ofTwoRobotsTheSelectedOnesCameraIsShown() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    raiseCamera(page);
    spawnClass(page, "P2DX");
    QTRY_VERIFY_WITH_TIMEOUT(camera(page).pictureCount() >= 3, soon_ms);
    spawnClass(page, "P2AT", "HillTop", 2);
    QVERIFY(page.comesToRest(1) && page.comesToRest(2));
    const int at_rest = camera(page).pictureCount();
    QTRY_VERIFY_WITH_TIMEOUT(camera(page).pictureCount() >= at_rest + 2, soon_ms); // the next may be on its way
    QTRY_COMPARE_WITH_TIMEOUT(camera(page).picture().size(), QSize(320, 240), soon_ms);
    const QImage second = camera(page).picture();
    page.pressKey(Qt::Key_1);
    QTRY_VERIFY_WITH_TIMEOUT(!camera(page).isEmpty() && camera(page).picture().size() == QSize(320, 240) &&
                                 difference(second, camera(page).picture()) > 4.0,
                             soon_ms);
    page.pressKey(Qt::Key_2);
    QTRY_VERIFY_WITH_TIMEOUT(difference(second, camera(page).picture()) < 2.0, soon_ms);
}

void tst_WindowCamera::aHiddenDockAsksForNothing() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    raiseCamera(page);
    spawnClass(page, "P2DX");
    QTRY_VERIFY_WITH_TIMEOUT(camera(page).pictureCount() >= 3, soon_ms);
    page.window().findChild<QDockWidget*>("instruments")->raise();
    QTRY_VERIFY(!camera(page).wantsPictures());
    QVERIFY(page.clockGoesOn(Seconds(1.0))); // the one that was asked for
    const int seen = camera(page).pictureCount();
    QVERIFY(page.holdsWhileClockGoesOn([&] { return camera(page).pictureCount() == seen; }, Seconds(0.8)));
    raiseCamera(page);
    QTRY_VERIFY_WITH_TIMEOUT(camera(page).pictureCount() > seen, soon_ms);
}

void tst_WindowCamera::emptyStatesSayWhatToDo() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    raiseCamera(page);
    QVERIFY2(emptyText(page).contains("No robot") && emptyText(page).contains("P2DX"), qPrintable(emptyText(page)));
    QVERIFY(page.spawnAt("PlayerStart"));
    QTRY_VERIFY2(emptyText(page).contains("R1 has no camera"), qPrintable(emptyText(page)));
    QVERIFY(emptyText(page).contains("AirRobot carries none") && emptyText(page).contains("P2AT"));
    QVERIFY(!emptyText(page).contains("AirRobot,"));
    QCOMPARE(camera(page).pictureCount(), 0);
    QVERIFY(!page.window().commands().action("camera.zoom_in")->isEnabled());
    page.screenshot("camera-empty");
}

void tst_WindowCamera::thePictureIsSaved() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QTemporaryDir folder;
    QImage picture(8, 6, QImage::Format_RGB32);
    picture.fill(Qt::darkGreen);
    page.window().camera().savePicture(picture, folder.filePath("seen.png"));
    QCOMPARE(QImage(folder.filePath("seen.png")).size(), QSize(8, 6));
    page.window().camera().savePicture(picture, folder.filePath("no/such/folder.png"));
    QVERIFY(page.notified("could not be saved").contains("Choose a folder"));
}

void tst_WindowCamera::theOverlayIsFoundAsItWasLeft() {
    const QTemporaryDir settings;
    const WindowSetup setup{.settings_folder = settings.path()};
    {
        WindowPage page(setup);
        raiseCamera(page);
        QVERIFY(page.window().commands().action("camera.overlay")->isChecked() && hasCross(page));
        trigger(page, "camera.overlay");
        QVERIFY(!hasCross(page));
        page.window().quit();
        QTRY_VERIFY_WITH_TIMEOUT(!page.window().isVisible(), soon_ms);
    }
    WindowPage page(setup);
    raiseCamera(page);
    QVERIFY(!page.window().commands().action("camera.overlay")->isChecked() && !hasCross(page));
    trigger(page, "camera.overlay");
    QVERIFY(hasCross(page));
}

USAR_TEST(tst_WindowCamera)

} // namespace tst_window_camera

#include "tst_window_camera.moc"
