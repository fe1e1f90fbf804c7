#include <QAbstractItemModelTester>
#include <QAction>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "tests/suite/suite.h"
#include "widgets/map/map_view.h"
#include "widgets/map/trace_layer.h"
#include "widgets/map/world_panel.h"
#include "widgets/style/theme.h"

namespace tst_world_panel {

using namespace usar;
using namespace usar::widgets;

namespace {

MapObject object(const char* name, const Vec2& at_m, double yaw_rad = 0.0) {
    MapObject one;
    one.name = QString::fromLatin1(name);
    one.kind = QStringLiteral("Crate");
    one.body_in_map = Pose{Vec3(at_m.x(), at_m.y(), 0.5), 0.0, 0.0, yaw_rad};
    return one;
}

const std::vector<PaletteKind> kinds{{"Crate", "crate", ObjectForm::Box, {1.0, 1.0, 1.0}},
                                     {"Ball", "ball", ObjectForm::Sphere, {0.2, 0.2, 0.2}},
                                     {"Barrel", "barrel", ObjectForm::Cylinder, {0.6, 0.6, 0.9}}};

template <class Widget>
Widget* named(const QWidget& parent, const char* name) {
    for (Widget* child : parent.findChildren<Widget*>())
        if (child->accessibleName() == QLatin1String(name))
            return child;
    QTest::qFail(name, __FILE__, __LINE__);
    return nullptr;
}

/// A map of 40 m, 10 pixels a meter, around the origin.
std::unique_ptr<MapView> mapView() {
    auto map = std::make_unique<MapView>();
    map->resize(400, 400);
    map->show();
    map->setWorld({{-20, -20}, {20, 20}}, "test");
    map->setOrientation(MapOrientation::YUp);
    MapTransform near = map->transform();
    near.center_m = Vec2::Zero();
    near.pixels_per_m = 10.0;
    map->setTransform(near);
    return map;
}

void drag(MapView& map, const QPoint& from, const QPoint& to) {
    QTest::mousePress(&map, Qt::LeftButton, {}, from);
    QTest::mouseMove(&map, (from + to) / 2);
    QTest::mouseMove(&map, to);
    QTest::mouseRelease(&map, Qt::LeftButton, {}, to);
}

} // namespace

class tst_WorldPanel : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(Theme::Dark); }

    void anOutlineIsWhatASunAboveWouldShade_data() {
        QTest::addColumn<int>("form");
        QTest::addColumn<double>("roll_rad");
        QTest::addColumn<double>("yaw_rad");
        QTest::addColumn<double>("area_m2");
        QTest::newRow("a level box") << int(ObjectForm::Box) << 0.0 << 0.3 << 2.0;
        QTest::newRow("a box on its side") << int(ObjectForm::Box) << pi / 2.0 << 0.3 << 6.0;
        QTest::newRow("an upright cylinder") << int(ObjectForm::Cylinder) << 0.0 << 0.0 << pi / 2.0;
        QTest::newRow("a ball that has rolled") << int(ObjectForm::Sphere) << 1.0 << 2.0 << pi / 2.0;
    }
    void anOutlineIsWhatASunAboveWouldShade() {
        QFETCH(int, form);
        QFETCH(double, roll_rad);
        QFETCH(double, yaw_rad);
        QFETCH(double, area_m2);
        MapObject one = object("A", {5, -3}, yaw_rad);
        one.form = static_cast<ObjectForm>(form);
        one.size_m = {2.0, 1.0, 3.0};
        one.body_in_map.roll_rad = roll_rad;
        const std::vector<Vec2> hull = outlineOf(one);
        double doubled_m2 = 0.0;
        for (std::size_t i = 0; i < hull.size(); ++i) {
            const Vec2& a = hull[i];
            const Vec2& b = hull[(i + 1) % hull.size()];
            doubled_m2 += a.x() * b.y() - a.y() * b.x();
        }
        QVERIFY2(std::abs(doubled_m2 / 2.0 - area_m2) < 0.02 * area_m2, qPrintable(QString::number(doubled_m2 / 2.0)));
        QVERIFY(covers(hull, {5, -3}));
        QVERIFY(!covers(hull, {8, -3}));
    }

    void theModelIsSoundAndKeepsTheSelectionByName() {
        WorldPanel panel;
        panel.resize(260, 500);
        panel.show();
        auto* list = panel.findChild<QTreeView*>();
        const QAbstractItemModelTester tester(list->model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        panel.setObjects({object("Crate10", {1, 1}), object("Crate2", {2, 2})});
        QCOMPARE(panel.model().row(0).name, QString("Crate2"));
        panel.selectObject("Crate10");
        QSignalSpy selected(&panel, &WorldPanel::objectSelected);
        panel.setObjects({object("Crate1", {0, 0}), object("Crate10", {3, 1}), object("Crate2", {2, 2})});
        QCOMPARE(list->currentIndex().row(), 2);
        QCOMPARE(selected.count(), 0);
        QTest::keyClick(list, Qt::Key_Up);
        QCOMPARE(selected.last()[0].toString(), QString("Crate2"));
        QSignalSpy removal(&panel, &WorldPanel::removeRequested);
        panel.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&panel));
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Delete);
        QCOMPARE(removal.count(), 1);
        panel.setObjects({});
        QCOMPARE(panel.model().rowCount(), 0);
    }

    void everyButtonHasAWordThatIsSeen() {
        WorldPanel panel;
        panel.setKinds(kinds);
        QAction turn(QStringLiteral("Turn left"));
        turn.setIconText(QStringLiteral("Left"));
        QAction go(QStringLiteral("Start moving"));
        go.setIconText(QStringLiteral("Start"));
        QAction trace(QStringLiteral("Trace"));
        panel.setActions({&turn}, {&go}, &trace);
        panel.resize(280, 500);
        panel.show();
        QCOMPARE(named<QToolButton>(panel, "Turn left")->text(), QString("Left"));
        QCOMPARE(named<QToolButton>(panel, "Start moving")->text(), QString("Start"));
        for (const QToolButton* button : panel.findChildren<QToolButton*>()) {
            if (button->parent() != &panel)
                continue; // that of a field, which clears it
            QVERIFY2(!button->text().isEmpty(), qPrintable(button->accessibleName()));
            QVERIFY2(button->toolButtonStyle() != Qt::ToolButtonIconOnly, qPrintable(button->text()));
            QVERIFY2(button->width() >= button->fontMetrics().horizontalAdvance(button->text()),
                     qPrintable(button->text()));
            QVERIFY2(button->minimumHeight() == 0 || button->minimumHeight() >= button->sizeHint().height(),
                     qPrintable(button->text())); // A low dock leaves the word.
        }
    }

    void sizesGoWithTheFormAndBecomeScales() {
        WorldPanel panel;
        panel.setKinds(kinds);
        panel.show();
        QVERIFY(!panel.choice());
        QTest::mouseClick(named<QToolButton>(panel, "Barrel"), Qt::LeftButton);
        auto* diameter = named<QDoubleSpinBox>(panel, "Length or diameter");
        QCOMPARE(diameter->value(), 0.6);
        QVERIFY(!named<QDoubleSpinBox>(panel, "Width")->isEnabled());
        diameter->setValue(1.2);
        QVERIFY(panel.choice()->scale.isApprox(Vec3(2.0, 2.0, 1.0)));
        QTest::mouseClick(named<QToolButton>(panel, "Ball"), Qt::LeftButton);
        QVERIFY(panel.choice()->scale.isApprox(Vec3::Ones()));
        QVERIFY(!named<QDoubleSpinBox>(panel, "Height")->isEnabled());
        QTest::mouseClick(named<QToolButton>(panel, "Ball"), Qt::LeftButton);
        QVERIFY(!panel.choice());
        QTest::keyClicks(named<QLineEdit>(panel, "Other class"), "USARModels.Pallet");
        QCOMPARE(panel.choice()->class_name, QString("USARModels.Pallet"));
        panel.disarm();
        QVERIFY(!panel.choice());
    }

    void troubleCoversThePaletteAndGoesAgain() {
        WorldPanel panel;
        panel.setKinds(kinds);
        panel.show();
        panel.setTrouble("No world controller", "This server has none.");
        QVERIFY(!named<QToolButton>(panel, "Crate")->isVisible());
        panel.setTrouble({}, {});
        QVERIFY(named<QToolButton>(panel, "Crate")->isVisible());
    }

    void theMapTellsWhatIsDoneWithObjects() {
        const auto map = mapView();
        map->setObjects({object("Crate1", {0, 0}), object("Crate2", {5, 0})});
        QSignalSpy clicked(&map->gestures(), &MapGestures::objectClicked);
        QSignalSpy moved(&map->gestures(), &MapGestures::objectMoved);
        QSignalSpy removal(map.get(), &MapView::objectRemovalRequested);
        QTest::mouseClick(map.get(), Qt::LeftButton, {}, QPoint(200, 200));
        QCOMPARE(clicked.last()[0].toString(), QString("Crate1"));
        drag(*map, {252, 198}, {292, 158});
        QCOMPARE(moved.count(), 1);
        QCOMPARE(moved.last()[0].toString(), QString("Crate2"));
        QVERIFY(moved.last()[1].value<Vec2>().isApprox(Vec2(9, 4), 0.02));
        QTest::keyClick(map.get(), Qt::Key_Delete);
        QCOMPARE(removal.last()[0].toString(), QString("Crate2"));
        QTest::mouseClick(map.get(), Qt::LeftButton, {}, QPoint(100, 300));
        QCOMPARE(clicked.last()[0].toString(), QString());
        map->setLayer(MapLayer::Objects, {false, 1.0});
        clicked.clear();
        QTest::mouseClick(map.get(), Qt::LeftButton, {}, QPoint(200, 200));
        QCOMPARE(clicked.count(), 0);
    }

    void escapeGivesADraggedObjectBack() {
        const auto map = mapView();
        map->setObjects({object("Crate1", {0, 0})});
        QSignalSpy moved(&map->gestures(), &MapGestures::objectMoved);
        QTest::mousePress(map.get(), Qt::LeftButton, {}, QPoint(200, 200));
        QTest::mouseMove(map.get(), QPoint(230, 200));
        QTest::mouseMove(map.get(), QPoint(260, 200));
        QCOMPARE(map->content().objects.held, QString("Crate1"));
        QTest::keyClick(map.get(), Qt::Key_Escape);
        QTest::mouseRelease(map.get(), Qt::LeftButton, {}, QPoint(260, 200));
        QCOMPARE(moved.count(), 0);
        QVERIFY(map->content().objects.held.isEmpty());
    }

    void marksAreBakedAndLookTheSameWhenTheyComeOneByOne() {
        MapTransform transform;
        transform.orientation = MapOrientation::YUp;
        transform.viewport = {200, 200};
        transform.pixels_per_m = 16.0;
        const auto picture = [&transform](const TraceLayer& layer) {
            QImage image(200, 200, QImage::Format_ARGB32_Premultiplied);
            image.fill(Qt::gray);
            QPainter painter(&image);
            layer.paint(painter, transform);
            return image;
        };
        TraceLayer at_once;
        TraceLayer one_by_one;
        const QImage empty = picture(one_by_one);
        for (int i = 0; i < 40; ++i) {
            const Vec2 point_m(-4.0 + 0.2 * i, 0.05 * i);
            at_once.add(point_m, traceColor(protocol::TraceColor::Cyan));
            one_by_one.add(point_m, traceColor(protocol::TraceColor::Cyan));
            picture(one_by_one);
        }
        QVERIFY(picture(at_once) != empty);
        const QImage a = picture(at_once);
        const QImage b = picture(one_by_one);
        int differing = 0;
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                differing += std::abs(qGreen(a.pixel(x, y)) - qGreen(b.pixel(x, y))) > 24;
        QVERIFY2(differing < 10, qPrintable(QString::number(differing)));
        const QColor dot = a.pixelColor(transform.toScreen(Vec2(0.0, 1.0)).toPoint());
        QCOMPARE(dot, traceColor(protocol::TraceColor::Cyan));
        one_by_one.clear();
        QCOMPARE(picture(one_by_one), empty);
    }
};

USAR_TEST(tst_WorldPanel)

} // namespace tst_world_panel

#include "tst_world_panel.moc"
