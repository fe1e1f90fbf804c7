// The map paints only what has changed, and then looks as if all of it were painted.
#include <algorithm>
#include <cstdlib>
#include <random>
#include <utility>

#include <QPaintEvent>
#include <QScreen>
#include <QTest>

#include "core/mapping/height_map.h"
#include "tests/suite/suite.h"
#include "widgets/map/map_view.h"

namespace tst_map_changes {

using namespace usar;
using namespace usar::widgets;

namespace {

const Rectangle world{Vec2(-50, -50), Vec2(50, 50)};

/// A map that counts the pixels that it is asked to paint.
class CountedMap : public MapView {
public:
    int painted_px = 0;

protected:
    void paintEvent(QPaintEvent* event) override {
        for (const QRect& part_px : event->region())
            painted_px += part_px.width() * part_px.height();
        MapView::paintEvent(event);
    }
};

MapObject crateAt(const Vec3& place_in_map_m) {
    MapObject crate;
    crate.name = QStringLiteral("Crate");
    crate.size_m = {2.0, 1.0, 1.0};
    crate.body_in_map.position_m = place_in_map_m;
    return crate;
}

/// Does to a map what a person and robots do, in any order.
class Happenings {
public:
    /// Robots and all else stay within `reach_m` of the origin, in x and y.
    Happenings(CountedMap& map, unsigned seed, double reach_m) : map_(map), reach_m_(reach_m), random_(seed) {}

    void next() {
        switch (upTo(10)) {
        case 0:
        case 1:
        case 2:
            return move();
        case 3:
            return map_.setGoal(someRobot(), upTo(3) == 0 ? std::nullopt : std::optional(somewhere()));
        case 4:
            return map_.setLaserHits(someRobot(), std::vector<Vec3>(upTo(30), somewhere()));
        case 5:
            return map_.addMarks(
                someRobot(),
                {{upTo(3) == 0 ? agent::MarkKind::Landing : agent::MarkKind::Path, somewhere(), Seconds(1), {1}}});
        case 6:
            return scan();
        case 7:
            return QTest::mouseMove(&map_, map_.transform().toScreen(Vec2(somewhere().head<2>())).toPoint());
        case 8:
            return map_.setRadioLinks({{QStringLiteral("R1"), QStringLiteral("R2"), -20.0 - double(upTo(70))}});
        case 9:
            return map_.update(QRect(int(upTo(500)), int(upTo(400)), 150, 150)); // As if another window had covered it.
        default:
            return select();
        }
    }

private:
    unsigned upTo(unsigned most) { return static_cast<unsigned>(random_() % (most + 1)); }
    QString someRobot() { return QStringLiteral("R%1").arg(1 + upTo(2)); }
    double somePart() { return double(upTo(200)) / 100.0 - 1.0; }
    Vec3 somewhere() { return {reach_m_ * somePart(), reach_m_ * somePart(), 0.0}; }

    void move() {
        const QString name = someRobot();
        const auto known = map_.content().robots.find(name);
        Vec3 at = somewhere();
        if (known != map_.content().robots.end() && upTo(5) > 0)
            at = known->second.robot.base_in_map.position_m + 0.2 * somewhere();
        map_.setRobot({name, name.back().digitValue(), {at, 0, 0, 0.1 * double(upTo(60))}, upTo(9) == 0});
    }

    void select() {
        map_.selectRobot(someRobot());
        map_.setObjects({crateAt(somewhere())});
    }

    void scan() {
        auto tile = std::make_shared<mapping::HeightTile>(tile_);
        for (unsigned beam = 0; beam <= upTo(40); ++beam)
            tile->preview_m[upTo(mapping::HeightTile::cell_count - 1)] = static_cast<float>(upTo(9));
        tile_ = *tile;
        map_.heights().take({tile}, mapping::HeightRange{0.0f, upTo(20) == 0 ? 20.0f : 9.0f});
    }

    CountedMap& map_;
    double reach_m_;
    std::mt19937 random_;
    mapping::HeightTile tile_;
};

/// How many pixels look different. Slanted lines of a pixel's width come out a little otherwise where a part cuts them.
int differentPixels(const QImage& a, const QImage& b) {
    constexpr int shade = 25;
    int different = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb one = a.pixel(x, y);
            const QRgb other = b.pixel(x, y);
            different += std::abs(qRed(one) - qRed(other)) > shade || std::abs(qGreen(one) - qGreen(other)) > shade ||
                         std::abs(qBlue(one) - qBlue(other)) > shade;
        }
    return different;
}

/// Until nothing more is to be painted.
void settle(CountedMap& map) {
    constexpr int longer_than_a_cycle_ms = 45;
    bool busy = false;
    do {
        map.painted_px = 0;
        busy = map.heights().busy();
        QTest::qWait(longer_than_a_cycle_ms);
        // On a busy machine, a cycle may be due at the end of the wait. The first call runs it; the second one paints.
        QCoreApplication::processEvents();
        QCoreApplication::processEvents();
    } while (map.painted_px > 0 || busy || map.heights().busy());
}

} // namespace

class tst_MapChanges : public QObject {
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void partsLookLikeTheWhole_data();
    void partsLookLikeTheWhole();
    void aRobotThatMovesRepaintsItsPlaces();
    void aScannedStripRepaintsItsGround();
    void whatStaysIsNotPainted();
    void rectanglesAreApart_data();
    void rectanglesAreApart();

private:
    std::unique_ptr<CountedMap> map_;
};

void tst_MapChanges::init() {
    map_ = std::make_unique<CountedMap>();
    map_->resize(600, 500);
    map_->setWorld(world, QStringLiteral("tall_test"));
    map_->setStartPoses({{"PlayerStart", {{0, 0, 0}, 0, 0, 0}}, {"HillTop", {{20, 30, 0}, 0, 0, 1}}});
    map_->show();
    QVERIFY(QTest::qWaitForWindowExposed(map_.get()));
    settle(*map_);
}

void tst_MapChanges::cleanup() {
    map_.reset();
}

void tst_MapChanges::partsLookLikeTheWhole_data() {
    QTest::addColumn<unsigned>("seed");
    QTest::addColumn<MapOrientation>("orientation");
    QTest::addColumn<double>("pixels_per_m");
    QTest::newRow("x up") << 1u << MapOrientation::XUp << 4.3;
    QTest::newRow("y up") << 2u << MapOrientation::YUp << 4.3;
    QTest::newRow("from far") << 3u << MapOrientation::XUp << 0.9;
    QTest::newRow("near") << 4u << MapOrientation::YUp << 31.7;
}

void tst_MapChanges::partsLookLikeTheWhole() {
    QFETCH(unsigned, seed);
    QFETCH(MapOrientation, orientation);
    QFETCH(double, pixels_per_m);
    map_->setOrientation(orientation);
    MapTransform transform = map_->transform();
    transform.pixels_per_m = pixels_per_m;
    map_->setTransform(transform);
    map_->setLayer(MapLayer::Radio, {});
    map_->setLayer(MapLayer::Contours, {});
    map_->setArea(Rectangle{Vec2(-20, -15), Vec2(10, 20)});
    Happenings happenings(*map_, seed, 200.0 / pixels_per_m);
    std::mt19937 random(seed);
    for (int step = 0; step < 15; ++step) {
        for (auto changes = random() % 4 + 1; changes > 0; --changes) {
            happenings.next();
            if (random() % 2 == 0) // The next change comes before a part is painted, or while it is waiting.
                QTest::qWait(static_cast<int>(random() % 40));
        }
        settle(*map_);
        const QImage on_screen =
            map_->screen()->grabWindow(map_->winId()).toImage().convertToFormat(QImage::Format_RGB32);
        const QImage whole = map_->grab().toImage().convertToFormat(QImage::Format_RGB32);
        QCOMPARE(on_screen.size(), whole.size());
        const int different = on_screen == whole ? 0 : differentPixels(on_screen, whole);
        if (different > 0) {
            on_screen.save(QStringLiteral("screenshots/map_changes_screen.png"));
            whole.save(QStringLiteral("screenshots/map_changes_whole.png"));
        }
        QVERIFY2(different == 0, qPrintable(QStringLiteral("%1 pixels after step %2").arg(different).arg(step)));
    }
}

void tst_MapChanges::aRobotThatMovesRepaintsItsPlaces() {
    map_->setRobot({QStringLiteral("R1"), 1, {{10, 10, 0}, 0, 0, 0}});
    settle(*map_);
    map_->setRobot({QStringLiteral("R1"), 1, {{10.5, 10, 0}, 0, 0, 0}});
    QTRY_VERIFY(map_->painted_px > 0);
    QVERIFY2(map_->painted_px < 600 * 500 / 20, qPrintable(QString::number(map_->painted_px)));
}

void tst_MapChanges::aScannedStripRepaintsItsGround() {
    auto tile = std::make_shared<mapping::HeightTile>();
    tile->preview_m.fill(1.0f);
    map_->heights().take({tile}, mapping::HeightRange{0.0f, 2.0f});
    settle(*map_);
    auto next = std::make_shared<mapping::HeightTile>(*tile);
    for (std::size_t column = 0; column < 60; ++column)
        next->preview_m[column] = 2.0f;
    map_->heights().take({next}, mapping::HeightRange{0.0f, 2.0f});
    QTRY_VERIFY(map_->painted_px > 0);
    QVERIFY2(map_->painted_px < 600 * 500 / 20, qPrintable(QString::number(map_->painted_px)));
}

void tst_MapChanges::whatStaysIsNotPainted() {
    const MapRobot robot{QStringLiteral("R1"), 1, {{10, 10, 0}, 0, 0, 0}};
    for (const bool again : {false, true}) {
        map_->setRobot(robot);
        map_->setLaserHits(robot.name, {Vec3(1, 2, 3)});
        map_->setObjects({crateAt({3, 3, 0})});
        if (!again)
            settle(*map_);
    }
    QTest::qWait(100);
    QCOMPARE(map_->painted_px, 0);
}

void tst_MapChanges::rectanglesAreApart_data() {
    QTest::addColumn<QList<QRect>>("pieces");
    QTest::addColumn<QList<QRect>>("parts");
    const QRect a(0, 0, 10, 10);
    QTest::newRow("none") << QList<QRect>{} << QList<QRect>{};
    QTest::newRow("one") << QList<QRect>{a} << QList<QRect>{a};
    QTest::newRow("far") << QList<QRect>{a, {50, 5, 10, 20}} << QList<QRect>{a, {50, 5, 10, 20}};
    QTest::newRow("touching") << QList<QRect>{a, {10, 5, 10, 10}} << QList<QRect>{{0, 0, 20, 15}};
    QTest::newRow("in a row") << QList<QRect>{a, {20, 0, 10, 10}, {8, 4, 14, 3}} << QList<QRect>{{0, 0, 30, 10}};
    QTest::newRow("by what another one adds")
        << QList<QRect>{{0, 0, 10, 40}, {10, 30, 30, 10}, {30, 10, 5, 5}} << QList<QRect>{{0, 0, 40, 40}};
}

void tst_MapChanges::rectanglesAreApart() {
    QFETCH(QList<QRect>, pieces);
    QFETCH(QList<QRect>, parts);
    QRegion region;
    for (const QRect& piece : pieces)
        region |= piece;
    std::vector<QRect> found = apart(region);
    std::ranges::sort(found, {}, [](const QRect& part) { return std::pair(part.x(), part.y()); });
    QCOMPARE(QList<QRect>(found.begin(), found.end()), parts);
}

USAR_TEST(tst_MapChanges)

} // namespace tst_map_changes

#include "tst_map_changes.moc"
