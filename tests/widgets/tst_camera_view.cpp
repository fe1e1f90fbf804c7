// The camera view by itself: what it shows, and what it asks for.
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QWheelEvent>

#include "core/base/geometry.h"
#include "tests/suite/suite.h"
#include "widgets/drive/camera_view.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/theme.h"

namespace tst_camera_view {

using namespace usar;
using namespace usar::widgets;

namespace {

QImage picture(int width = 320, int height = 240) {
    QImage image(width, height, QImage::Format_RGB32);
    image.fill(Qt::red);
    return image;
}

/// A view that is seen.
struct Shown {
    Shown() {
        view.resize(400, 400);
        view.show();
    }
    CameraCanvas& canvas() { return *view.findChild<CameraCanvas*>(); }
    EmptyState& empty() { return *view.findChild<EmptyState*>(); }
    bool says(const QString& words) {
        for (const QLabel* label : view.findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(words))
                return true;
        return false;
    }

    CameraView view;
};

} // namespace

class tst_CameraView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(Theme::Dark); }

    void aPictureKeepsItsShape_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("as a camera's") << QSize(320, 240);
        QTest::newRow("wide") << QSize(640, 100);
        QTest::newRow("tall") << QSize(10, 400);
    }

    void aPictureKeepsItsShape() {
        QFETCH(QSize, size);
        Shown shown;
        shown.view.setPicture(picture(size.width(), size.height()), 10.0);
        const QRect place = shown.canvas().pictureRect();
        QVERIFY(shown.canvas().rect().contains(place));
        QVERIFY(place.width() == shown.canvas().width() || place.height() == shown.canvas().height());
        QVERIFY(std::abs(place.width() * size.height() - place.height() * size.width()) <=
                std::max(size.width(), size.height()));
        const QImage seen = shown.canvas().grab().toImage();
        QCOMPARE(seen.pixelColor(place.center()), QColor(Qt::red));
    }

    void theRateAndTheAgeAreTold() {
        Shown shown;
        shown.view.setSource("R1", {"Camera"}, "Camera");
        shown.view.setPicture(picture(), 9.75);
        QVERIFY(shown.says("9.8 frames/s"));
        QVERIFY(shown.says("R1 · Camera"));
        QCOMPARE(shown.view.pictureCount(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(shown.says("s old"), 4000); // nobody sends a second one
    }

    void theOverlayMarksTheCenterAndACorner_data() {
        QTest::addColumn<bool>("shown");
        QTest::newRow("shown") << true;
        QTest::newRow("hidden") << false;
    }

    void theOverlayMarksTheCenterAndACorner() {
        QFETCH(bool, shown);
        Shown view;
        view.view.setSource("R1", {"Camera"}, "Camera");
        view.view.setOverlayShown(shown);
        const QImage original = picture();
        view.view.setPicture(original, 10.0);
        const QImage seen = view.canvas().grab().toImage();
        const QRect place = view.canvas().pictureRect();
        const auto colorAt = [&seen](const QPoint& at) { return seen.pixelColor(at).rgb(); };
        const QRgb red = QColor(Qt::red).rgb();
        QCOMPARE(colorAt(place.center()), red); // what is aimed at stays visible
        QCOMPARE(colorAt(place.center() + QPoint(9, 0)), shown ? tokens().accent.rgb() : red);
        QCOMPARE(colorAt(place.center() + QPoint(0, 9)), shown ? tokens().accent.rgb() : red);
        QCOMPARE(colorAt(place.center() + QPoint(9, -1)), shown ? tokens().background.rgb() : red);
        QCOMPARE(colorAt(place.bottomLeft() + QPoint(gap::small - 1, -gap::small)) != red, shown);
        QCOMPARE(colorAt(place.topRight() + QPoint(-gap::small, gap::small)), red);
        QCOMPARE(view.view.picture(), original); // this one is saved
    }

    void theOverlayIsShownAtFirst() {
        Shown shown;
        shown.view.setPicture(picture(), 10.0);
        const QPoint on_cross = shown.canvas().pictureRect().center() + QPoint(9, 0);
        QCOMPARE(shown.canvas().grab().toImage().pixelColor(on_cross).rgb(), tokens().accent.rgb());
        shown.view.setOverlayShown(false);
        QCOMPARE(shown.canvas().grab().toImage().pixelColor(on_cross).rgb(), QColor(Qt::red).rgb());
    }

    void theNoteTells_data() {
        QTest::addColumn<QStringList>("cameras");
        QTest::addColumn<QString>("shown");
        QTest::addColumn<QString>("first_line");
        QTest::newRow("one camera") << QStringList{"Camera"} << "Camera"
                                    << "R1 · Camera";
        QTest::newRow("one of two") << QStringList{"Front", "Rear"} << "Rear"
                                    << "R1 · Rear";
        QTest::newRow("a camera without a name") << QStringList{} << QString() << "R1";
    }

    void theNoteTells() {
        QFETCH(QStringList, cameras);
        QFETCH(QString, shown);
        QFETCH(QString, first_line);
        Shown seen;
        seen.view.setPicture(picture(), 9.75);
        seen.view.setSource("R1", cameras, shown);
        seen.view.setZoom({1.0, 0.5, 2.0});
        const QStringList lines = seen.canvas().note().split('\n');
        QCOMPARE(lines.size(), 2);
        QCOMPARE(lines[0], first_line);
        QVERIFY2(lines[1].startsWith("9.8 frames/s · 0.") && lines[1].endsWith("s · 57°"), qPrintable(lines[1]));
        seen.view.setZoom({0.5, 0.5, 2.0});
        QVERIFY(seen.canvas().note().endsWith("s · 29°"));
        QTRY_VERIFY_WITH_TIMEOUT(seen.canvas().note().endsWith("s old · 29°"), 4000); // nobody sends a second one
    }

    void anEmptyStateSaysWhatToDoAndGoesWithThePicture() {
        Shown shown;
        QAction mend("Mend");
        shown.view.setEmpty("No image server", "Start one.", &mend);
        QVERIFY(shown.empty().isVisible() && shown.view.isEmpty());
        QCOMPARE(shown.empty().accessibleName(), QString("No image server"));
        QVERIFY(!shown.view.findChild<QSlider*>()->isEnabled());
        shown.view.setPicture(picture(), 1.0);
        QVERIFY(!shown.empty().isVisible() && !shown.view.isEmpty());
        QVERIFY(shown.view.findChild<QSlider*>()->isEnabled());
    }

    void draggingTakesTheSceneAlong() {
        Shown shown;
        shown.view.setZoom({1.0, 0.5, 2.0});
        shown.view.setPicture(picture(), 1.0);
        QSignalSpy turned(&shown.view, &CameraView::turnRequested);
        const QPoint from = shown.canvas().rect().center();
        QTest::mousePress(&shown.canvas(), Qt::LeftButton, {}, from);
        QTest::mouseMove(&shown.canvas(), from + QPoint(shown.canvas().pictureRect().width() / 4, 20));
        QTest::mouseRelease(&shown.canvas(), Qt::LeftButton, {}, from);
        QCOMPARE(turned.size(), 1);
        QVERIFY(std::abs(turned[0][0].toDouble() + 0.25) < 0.01); // to the left, a quarter of the angle of view
        QVERIFY(turned[0][1].toDouble() > 0.0);                   // and up
    }

    void arrowKeysTurn() {
        Shown shown;
        shown.view.setPicture(picture(), 1.0);
        QSignalSpy turned(&shown.view, &CameraView::turnRequested);
        QTest::keyClick(&shown.canvas(), Qt::Key_Left);
        QTest::keyClick(&shown.canvas(), Qt::Key_Up);
        QCOMPARE(turned.size(), 2);
        QVERIFY(turned[0][0].toDouble() < 0.0 && turned[0][1].toDouble() == 0.0);
        QVERIFY(turned[1][0].toDouble() == 0.0 && turned[1][1].toDouble() > 0.0);
    }

    void theSliderAsksForAnglesWithinTheLimits() {
        Shown shown;
        shown.view.setZoom({1.0, 0.5, 2.0});
        shown.view.setPicture(picture(), 1.0);
        QSignalSpy zoomed(&shown.view, &CameraView::zoomRequested);
        auto* const slider = shown.view.findChild<QSlider*>();
        QVERIFY(std::abs(slider->value() - 50) <= 1); // half way by factors
        slider->setValue(slider->maximum());
        slider->setValue(slider->minimum());
        QCOMPARE(zoomed.size(), 2);
        QVERIFY(std::abs(zoomed[0][0].toDouble() - 0.5) < 1e-9);
        QVERIFY(std::abs(zoomed[1][0].toDouble() - 2.0) < 1e-9);
        QVERIFY(shown.says("57°"));
    }

    void aFixedLensCannotBeZoomed() {
        Shown shown;
        shown.view.setZoom({1.0, 1.0, 1.0});
        shown.view.setPicture(picture(), 1.0);
        QVERIFY(!shown.view.findChild<QSlider*>()->isEnabled());
    }

    void severalCamerasCanBeChosenFrom() {
        Shown shown;
        auto* const cameras = shown.view.findChild<QComboBox*>();
        shown.view.setSource("R1", {"Front"}, "Front");
        QVERIFY(!cameras->isVisible());
        shown.view.setSource("R1", {"Front", "Rear"}, "Rear");
        QVERIFY(cameras->isVisible());
        QCOMPARE(cameras->currentText(), QString("Rear"));
        QSignalSpy chosen(&shown.view, &CameraView::cameraChosen);
        cameras->setFocus();
        QTest::keyClick(cameras, Qt::Key_Up);
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(chosen[0][0].toString(), QString("Front"));
    }

    void coveredOrHiddenItWantsNoPictures() {
        Shown shown;
        QVERIFY(shown.view.wantsPictures());
        QSignalSpy changed(&shown.view, &CameraView::wantsPicturesChanged);
        shown.view.setUncovered(false);
        QVERIFY(!shown.view.wantsPictures());
        shown.view.setUncovered(true);
        shown.view.hide();
        QVERIFY(!shown.view.wantsPictures());
        QCOMPARE(changed.size(), 3);
    }
};

USAR_TEST(tst_CameraView)

} // namespace tst_camera_view

#include "tst_camera_view.moc"
