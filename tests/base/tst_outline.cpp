// Outlines of solids as seen from above, against closed forms.
#include <random>

#include <QTest>

#include "core/base/outline.h"
#include "tests/suite/suite.h"

namespace tst_outline {

using namespace usar;

namespace {

/// Positive: counter-clockwise.
double area_m2(const Outline& outline) {
    double twice = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2& a = outline[i];
        const Vec2& b = outline[(i + 1) % outline.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2.0;
}

} // namespace

class tst_Outline : public QObject {
    Q_OBJECT
private slots:
    void hullHasTheCornersOnly();
    void fewPointsHaveNoArea();
    void boxIsSeenFromAbove_data();
    void boxIsSeenFromAbove();
    void cylinderStandsOrLies();
    void sphereIsRound();
};

void tst_Outline::hullHasTheCornersOnly() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> within(0.01, 0.99);
    std::vector<Vec2> points{{0, 0}, {2, 0}, {2, 1}, {0, 1}, {1, 0}, {2, 1}}; // One on an edge, one twice.
    for (int i = 0; i < 100; ++i)
        points.emplace_back(2.0 * within(random), within(random));
    const Outline hull = hullOf(points);
    QCOMPARE(hull.size(), 4u);
    QCOMPARE(area_m2(hull), 2.0);
}

void tst_Outline::fewPointsHaveNoArea() {
    QVERIFY(hullOf({}).empty());
    for (const std::vector<Vec2>& points :
         {std::vector<Vec2>{{1, 2}}, std::vector<Vec2>{{1, 2}, {3, 4}}, std::vector<Vec2>{{1, 1}, {2, 2}, {3, 3}}})
        QCOMPARE(area_m2(hullOf(points)), 0.0);
}

void tst_Outline::boxIsSeenFromAbove_data() {
    QTest::addColumn<double>("roll_rad");
    QTest::addColumn<double>("pitch_rad");
    QTest::addColumn<double>("area");
    QTest::newRow("level") << 0.0 << 0.0 << 2.0;
    QTest::newRow("on its side") << pi / 2.0 << 0.0 << 6.0;
    QTest::newRow("on its nose") << 0.0 << pi / 2.0 << 3.0;
}

void tst_Outline::boxIsSeenFromAbove() {
    QFETCH(double, roll_rad);
    QFETCH(double, pitch_rad);
    QFETCH(double, area);
    for (const double yaw_rad : {0.0, 0.7, -2.0})
        QVERIFY(std::abs(area_m2(outlineOfBox({{5, 6, 7}, roll_rad, pitch_rad, yaw_rad}, {2, 1, 3})) - area) < 1e-9);
}

void tst_Outline::cylinderStandsOrLies() {
    const double standing = area_m2(outlineOfCylinder({}, {2, 2, 5}));
    QVERIFY(standing > 0.98 * pi && standing < pi);
    const double lying = area_m2(outlineOfCylinder({{}, 0.0, pi / 2.0, 0.0}, {2, 2, 5}));
    QVERIFY(std::abs(lying - 10.0) < 0.1);
}

void tst_Outline::sphereIsRound() {
    for (const Vec2& corner : outlineOfSphere({3, -4}, 0.5))
        QVERIFY(std::abs((corner - Vec2(3, -4)).norm() - 0.5) < 1e-9);
}

USAR_TEST(tst_Outline)

} // namespace tst_outline

#include "tst_outline.moc"
