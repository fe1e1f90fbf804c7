// The 3D view in the window: a replayed flight makes its surface grow, and mouse, keys and themes reach it.
#include <QAbstractButton>
#include <QFileDialog>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>

#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_relief {

using namespace usar;

namespace {

widgets::ReliefCanvas& canvasOf(WindowPage& page) {
    return page.window().views().relief->canvas();
}

/// Pixels that show something else than background.
std::ptrdiff_t surfacePixels(WindowPage& page) {
    const auto& frame = canvasOf(page).frame();
    return !frame ? 0 : std::ranges::count_if(frame->picture.nearness_per_m, [](float near) { return near > 0.0f; });
}

void turn(WindowPage& page, const QPoint& by) {
    widgets::ReliefCanvas& canvas = canvasOf(page);
    const QPoint middle = canvas.rect().center();
    QTest::mousePress(&canvas, Qt::LeftButton, {}, middle);
    QTest::mouseMove(&canvas, middle + by);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, middle + by);
}

void replayTheSample(WindowPage& page) {
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.window().commands().action("sample.flight")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.replay, soon_ms);
}

void goTo(WindowPage& page, double part) {
    page.window().control().robot({1})->orderReplay({.seek = part * page.robot(1)->figures.replay->span});
}

} // namespace

class tst_WindowRelief : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }

    void theSurfaceGrowsWithTheMap() {
        WindowPage page;
        widgets::ReliefView* const view = page.window().views().relief;
        QVERIFY(!view->isVisible());
        page.pressKey(Qt::Key_3, Qt::ControlModifier | Qt::AltModifier);
        QTRY_VERIFY_WITH_TIMEOUT(view->isVisible() && view->emptyState()->isVisible(), soon_ms);
        page.screenshot("relief_empty");
        replayTheSample(page);
        goTo(page, 0.4);
        QTRY_VERIFY_WITH_TIMEOUT(surfacePixels(page) > 1000, flight_ms);
        QVERIFY(!view->emptyState()->isVisible());
        // From now on the camera stays, so that more of the map is more of the picture.
        goTo(page, 1.0);
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.replay->position == page.robot(1)->figures.replay->span,
                                 flight_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!view->renderer().busy() && !page.map().heights().busy(), soon_ms);
        canvasOf(page).setCamera(canvasOf(page).camera());
        QTRY_VERIFY_WITH_TIMEOUT(!view->renderer().busy(), soon_ms);
        const std::ptrdiff_t whole = surfacePixels(page);
        goTo(page, 0.4);
        QTRY_VERIFY_WITH_TIMEOUT(surfacePixels(page) > 1000 && surfacePixels(page) < whole * 9 / 10, flight_ms);
        goTo(page, 1.0);
        QTRY_VERIFY_WITH_TIMEOUT(surfacePixels(page) > whole * 98 / 100, flight_ms);
        page.screenshot("relief_flight");
    }

    void thePictureIsSaved_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("saved");
        QTest::newRow("a file") << "view.png" << true;
        QTest::newRow("no folder") << "no/such/view.png" << false;
    }

    void thePictureIsSaved() {
        QFETCH(QString, name);
        QFETCH(bool, saved);
        const QTemporaryDir folder;
        WindowPage page;
        QAction* const save = page.window().commands().action("relief.save");
        QVERIFY(!save->isEnabled());
        page.pressKey(Qt::Key_3, Qt::ControlModifier | Qt::AltModifier);
        replayTheSample(page);
        goTo(page, 1.0);
        QTRY_VERIFY_WITH_TIMEOUT(surfacePixels(page) > 1000 && save->isEnabled(), flight_ms);
        save->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(page.window().findChild<QFileDialog*>(), soon_ms);
        auto* const dialog = page.window().findChild<QFileDialog*>();
        const QString path = folder.filePath(name);
        dialog->findChild<QLineEdit*>("fileNameEdit")->setText(path);
        for (QAbstractButton* const button : dialog->findChildren<QAbstractButton*>())
            if (button->text().remove('&') == "Save")
                QTest::mouseClick(button, Qt::LeftButton);
        if (saved) {
            QTRY_VERIFY_WITH_TIMEOUT(!page.notified("Saved the picture").isEmpty(), soon_ms);
            QCOMPARE(QImage(path).size(), canvasOf(page).picture().size());
        } else {
            QTRY_VERIFY_WITH_TIMEOUT(page.notified("cannot write").contains("Choose another folder"), soon_ms);
            QVERIFY(page.notified("cannot write").contains(path));
        }
    }

    void aDragOrbitsAndTheViewComesBackAsItWas() {
        const QTemporaryDir settings;
        double yaw_rad = 0.0;
        {
            WindowPage page({.settings_folder = settings.path()});
            page.pressKey(Qt::Key_3, Qt::ControlModifier | Qt::AltModifier);
            replayTheSample(page);
            goTo(page, 1.0);
            QTRY_VERIFY_WITH_TIMEOUT(surfacePixels(page) > 1000, flight_ms);
            const double before_rad = canvasOf(page).camera().yaw_rad;
            turn(page, {80, 0});
            yaw_rad = canvasOf(page).camera().yaw_rad;
            QVERIFY(std::abs(yaw_rad - before_rad) > 0.2);
            QTRY_COMPARE_WITH_TIMEOUT(canvasOf(page).frame()->camera.yaw_rad, yaw_rad, soon_ms);
            QTest::mouseMove(&canvasOf(page), canvasOf(page).rect().center());
            QTRY_VERIFY_WITH_TIMEOUT(canvasOf(page).probe().contains("z "), soon_ms);
            const std::uint32_t sky = canvasOf(page).frame()->picture.argb.front();
            page.window().commands().action("view.dark")->trigger();
            QTRY_VERIFY_WITH_TIMEOUT(canvasOf(page).frame()->picture.argb.front() != sky, soon_ms);
            page.screenshot("relief_other_theme");
            page.window().close(); // It writes the settings.
        }
        WindowPage page({.settings_folder = settings.path()});
        QVERIFY(std::abs(canvasOf(page).camera().yaw_rad - yaw_rad) < 1e-6);
        QTRY_VERIFY_WITH_TIMEOUT(page.window().views().relief->isVisible(), soon_ms);
    }
};

USAR_TEST(tst_WindowRelief)

} // namespace tst_window_relief

#include "tst_window_relief.moc"
