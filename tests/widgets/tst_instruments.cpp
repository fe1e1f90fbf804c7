#include <algorithm>
#include <cmath>

#include <QHelpEvent>
#include <QTest>
#include <QToolTip>

#include "tests/suite/suite.h"
#include "widgets/panels/instruments.h"
#include "widgets/panels/status_strip.h"
#include "widgets/style/theme.h"

namespace tst_instruments {

using namespace usar;
using namespace usar::widgets;

namespace {

protocol::RangeScan flatGround(double altitude_m, double maximum_m = 20.0) {
    protocol::RangeScan scan;
    scan.resolution_rad = radians(1.0);
    scan.fov_rad = radians(180.0);
    for (std::size_t i = 0; i < 181; ++i) {
        scan.ranges_m.push_back(0.0);
        const double slant_m = altitude_m / std::max(1e-9, std::cos(scan.beamAngle_rad(i)));
        scan.ranges_m.back() = std::min(slant_m, maximum_m);
    }
    return scan;
}

agent::SonarZones nineZones(agent::Risk middle) {
    agent::SonarZones zones;
    for (const char* name : {"L4", "L3", "L2", "L1", "M0", "R1", "R2", "R3", "R4"})
        zones.zones.push_back({name, 0.0, 5.0, 5.0, 4.4, 4.2, agent::Risk::None});
    zones.zones[4].risk = middle;
    zones.zones[4].range_m = 2.0;
    return zones;
}

/// Whether a pixel near `ink` is on the picture; antialiasing leaves none of thin strokes, so some slack.
int pixelsNear(const QWidget& widget, const QRect& where, const QColor& ink) {
    const QImage image = const_cast<QWidget&>(widget).grab().toImage();
    int found = 0;
    for (int y = where.top(); y <= where.bottom(); ++y)
        for (int x = where.left(); x <= where.right(); ++x) {
            const QColor c = image.pixelColor(x, y);
            found +=
                std::abs(c.red() - ink.red()) + std::abs(c.green() - ink.green()) + std::abs(c.blue() - ink.blue()) < 90
                    ? 1
                    : 0;
        }
    return found;
}

QString readout(const StatusStrip& strip, const QString& caption) {
    for (const Readout* one : strip.findChildren<Readout*>())
        if (one->accessibleName() == caption)
            return one->text();
    return QStringLiteral("no such readout");
}

/// Width of the field that its figure is right-aligned in, without the unit.
int field(const StatusStrip& strip, const QString& caption) {
    for (const Readout* one : strip.findChildren<Readout*>())
        if (one->accessibleName() == caption)
            return one->fieldWidth_px();
    return -1;
}

} // namespace

class tst_Instruments : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(Theme::Dark); }
    void stripShowsTheBehaviorsFigures();
    void stripTellsTheSpreadOfTheEnd();
    void stripShowsOnlyWhatTheRobotCanHave();
    void unknownFiguresAreADash();
    void readoutKeepsItsWidth();
    void finishedMissionCanStillBeRead();
    void staleStripSaysSo();
    void figuresOfAColumnEndOnOneLine();
    void meterWarnsInWordAndColor();
    void raysLieWhereTheyShould();
    void missesAreNoHits();
    void depthIsRound_data();
    void depthIsRound();
    void fanDrawsGroundUnderTheRobot();
    void fanDrawsWhatIsAheadOverTheRobot();
    void sonarsComeInRingOrder();
    void riskIsColorAndWord_data();
    void riskIsColorAndWord();
    void staleIsGrey();
    void theHeadTellsTheRateWhereThereIsRoom_data();
    void theHeadTellsTheRateWhereThereIsRoom();
    void theRateRepaintsOnlyWhenItsTextChanges();
    void theTooltipTellsRateAndAge();
    void profileIsBrokenWhereTheMapIs();
    void emptyViewsSayWhatWillAppear();
};

void tst_Instruments::stripShowsTheBehaviorsFigures() {
    StatusStrip strip;
    agent::BehaviorStatus status;
    status.state = "scanning lane 4 of 9";
    status.elapsed = Seconds(751.0);
    status.distance_to_goal_m = 38.04;
    status.range_left_m = 412.3;
    status.distance_flown_m = 1204.0;
    status.charges = 1;
    strip.setStatus(status);
    const auto labels = strip.findChildren<QLabel*>();
    const auto state = std::ranges::find(labels, QStringLiteral("State of the behavior"), &QLabel::accessibleName);
    QCOMPARE((*state)->text(), QStringLiteral("scanning lane 4 of 9"));
    QCOMPARE(readout(strip, QStringLiteral("elapsed")), QStringLiteral("00:12:31"));
    QCOMPARE(readout(strip, QStringLiteral("to goal")), QStringLiteral("38.0"));
    QCOMPARE(readout(strip, QStringLiteral("range left")), QStringLiteral("412"));
    strip.setBattery(71.0);
    QCOMPARE(strip.findChildren<Meter*>()[0]->value(), std::optional(71.0));
    QCOMPARE(strip.findChildren<Meter*>()[0]->accessibleName(), QStringLiteral("Battery"));
}

void tst_Instruments::stripTellsTheSpreadOfTheEnd() {
    StatusStrip strip;
    const auto labels = strip.findChildren<QLabel*>();
    const QLabel* const end =
        *std::ranges::find(labels, QStringLiteral("Spread of the time left"), &QLabel::accessibleName);
    agent::BehaviorStatus status;
    status.time_left = Seconds(760.0);
    status.time_left_range = TimeRange{Seconds(710.0), Seconds(3810.0)};
    const int before = strip.sizeHint().height();
    strip.setStatus(status);
    QCOMPARE(readout(strip, QStringLiteral("time left")), QStringLiteral("00:12:40"));
    QCOMPARE(end->text(), QStringLiteral("Ends in 11:50 to 1:03:30"));
    QCOMPARE(strip.sizeHint().height(), before);
    status.time_left_range.reset();
    strip.setStatus(status);
    QVERIFY(end->text().trimmed().isEmpty());
    status.time_left_range = TimeRange{};
    strip.setStatus(status);
    strip.setIdle(QStringLiteral("Idle"));
    QVERIFY(end->text().trimmed().isEmpty());
}

void tst_Instruments::stripShowsOnlyWhatTheRobotCanHave() {
    StatusStrip strip;
    const auto shown = [&](const QString& caption) {
        const auto readouts = strip.findChildren<Readout*>();
        return std::ranges::any_of(readouts, [&](const Readout* one) {
            return one->accessibleName() == caption && !one->isHidden() && !one->toolTip().isEmpty();
        });
    };
    QVERIFY(shown(QStringLiteral("flown")) && shown(QStringLiteral("charges")) && shown(QStringLiteral("range left")));
    strip.setAbilities(protocol::VehicleKind::Ground, false);
    QVERIFY(!shown(QStringLiteral("charges")) && !shown(QStringLiteral("range left")));
    QVERIFY(!shown(QStringLiteral("flown")) && shown(QStringLiteral("driven")));
    QVERIFY(shown(QStringLiteral("elapsed")) && shown(QStringLiteral("to goal")));
    strip.setAbilities(protocol::VehicleKind::Nautic, false);
    QVERIFY(!shown(QStringLiteral("driven")) && shown(QStringLiteral("traveled")));
    strip.setAbilities(protocol::VehicleKind::Legged, false);
    QVERIFY(shown(QStringLiteral("walked")));
    strip.setAbilities(protocol::VehicleKind::Aerial, true);
    QVERIFY(shown(QStringLiteral("flown")) && shown(QStringLiteral("charges")));
}

void tst_Instruments::unknownFiguresAreADash() {
    StatusStrip strip;
    strip.setStatus({});
    QCOMPARE(readout(strip, QStringLiteral("to goal")), QStringLiteral("–"));
    QCOMPARE(readout(strip, QStringLiteral("time left")), QStringLiteral("–"));
    QVERIFY(!strip.findChildren<Meter*>()[1]->value());
}

void tst_Instruments::readoutKeepsItsWidth() {
    Readout one(QStringLiteral("to goal"), QStringLiteral("m"), QStringLiteral("000.0"));
    const QSize before = one.sizeHint();
    one.setText(QStringLiteral("1.0"));
    QCOMPARE(one.sizeHint(), before);
    QCOMPARE(one.accessibleDescription(), QStringLiteral("1.0 m"));
}

void tst_Instruments::finishedMissionCanStillBeRead() {
    StatusStrip strip;
    agent::BehaviorStatus status;
    status.elapsed = Seconds(60.0);
    status.distance_to_goal_m = 3.0;
    strip.setStatus(status);
    strip.setIdle(QStringLiteral("Finished: the area is scanned"), StateShape::Good);
    QCOMPARE(readout(strip, QStringLiteral("elapsed")), QStringLiteral("00:01:00"));
    QCOMPARE(readout(strip, QStringLiteral("to goal")), QStringLiteral("–"));
    strip.clear(QStringLiteral("No behavior runs"));
    QCOMPARE(readout(strip, QStringLiteral("elapsed")), QStringLiteral("–"));
}

void tst_Instruments::staleStripSaysSo() {
    StatusStrip strip;
    agent::BehaviorStatus status;
    strip.setStatus(status);
    strip.setBattery(10.0);
    strip.show();
    auto* word = strip.findChild<QLabel*>(QStringLiteral("stale"));
    auto* battery = strip.findChildren<Meter*>()[0];
    const QRect whole(QPoint(), battery->size());
    QVERIFY(!word->isVisible());
    QVERIFY(pixelsNear(*battery, whole, tokens().danger) > 50);
    strip.setStale(true);
    QVERIFY(word->isVisible());
    QCOMPARE(word->text(), QStringLiteral("stale"));
    QCOMPARE(strip.findChild<StateDot*>()->state(), StateShape::Off);
    strip.setStatus(status);
    QCOMPARE(strip.findChild<StateDot*>()->state(), StateShape::Off);
    QCOMPARE(pixelsNear(*battery, whole, tokens().danger), 0);
    for (const Readout* readout : strip.findChildren<Readout*>())
        QVERIFY(readout->stale());
    strip.setStale(false);
    QVERIFY(!word->isVisible());
    QCOMPARE(strip.findChild<StateDot*>()->state(), StateShape::Good);
    QVERIFY(pixelsNear(*battery, whole, tokens().danger) > 50);
}

void tst_Instruments::figuresOfAColumnEndOnOneLine() {
    StatusStrip strip;
    for (const char* caption : {"elapsed", "time left"})
        QCOMPARE(field(strip, QString::fromLatin1(caption)), field(strip, QStringLiteral("elapsed")));
    QCOMPARE(field(strip, QStringLiteral("to goal")), field(strip, QStringLiteral("range left")));
    QCOMPARE(field(strip, QStringLiteral("flown")), field(strip, QStringLiteral("charges")));
}

void tst_Instruments::meterWarnsInWordAndColor() {
    Meter meter(QStringLiteral("Battery"), nullptr, 30.0, 15.0);
    meter.resize(300, 20);
    meter.setValue(50.0);
    const QRect bar(100, 6, 60, 8);
    QVERIFY(pixelsNear(meter, bar, tokens().ok) > 50);
    meter.resize(1000, 20); // so that the bar of a low value is long enough
    meter.setValue(10.0);
    QVERIFY(pixelsNear(meter, bar, tokens().danger) > 50);
    QCOMPARE(meter.accessibleDescription(), QStringLiteral("10 %"));
    meter.setValue(std::nullopt);
    QCOMPARE(pixelsNear(meter, bar, tokens().ok), 0);
}

void tst_Instruments::raysLieWhereTheyShould() {
    const LaserSection section = laserSection(flatGround(6.0), 20.0);
    QCOMPARE(section.rays.size(), std::size_t(181));
    QVERIFY(section.rays[0].end_m.x() > 19.9); // the first beam looks right
    QVERIFY(section.rays[180].end_m.x() < -19.9);
    QVERIFY(qAbs(section.rays[90].end_m.x()) < 1e-9 && qAbs(section.rays[90].end_m.y() - 6.0) < 1e-9);
    for (const LaserRay& ray : section.rays)
        if (ray.hit)
            QVERIFY(qAbs(ray.end_m.y() - 6.0) < 1e-6);
    QVERIFY(section.clearance_m && qAbs(*section.clearance_m - 6.0) < 1e-6);
    QVERIFY(section.nearest_m && qAbs(*section.nearest_m - 6.0) < 1e-6);
}

void tst_Instruments::missesAreNoHits() {
    protocol::RangeScan scan = flatGround(6.0);
    scan.ranges_m[90] = qQNaN();
    scan.ranges_m[91] = 20.0;
    const LaserSection section = laserSection(scan, 20.0);
    QVERIFY(!section.rays[90].hit && !section.rays[91].hit && section.rays[92].hit);
    const LaserSection nothing = laserSection(flatGround(50.0), 20.0);
    QVERIFY(!nothing.clearance_m && !nothing.nearest_m);
    QVERIFY(laserSection({}, 20.0).rays.empty());
}

void tst_Instruments::depthIsRound_data() {
    QTest::addColumn<double>("altitude_m");
    QTest::addColumn<double>("depth_m");
    QTest::newRow("scanning height") << 6.0 << 8.0;
    QTest::newRow("a little lower gives the same picture") << 5.5 << 8.0;
    QTest::newRow("landing") << 0.5 << 2.0;
    QTest::newRow("near the limit") << 19.0 << 24.0;
    QTest::newRow("nothing in range") << 30.0 << 20.0;
}

void tst_Instruments::depthIsRound() {
    QFETCH(double, altitude_m);
    QTEST(laserSection(flatGround(altitude_m), 20.0).depthShown_m(), "depth_m");
}

void tst_Instruments::fanDrawsGroundUnderTheRobot() {
    LaserFanView view;
    view.resize(300, 180);
    view.setScan(flatGround(6.0));
    const double head = view.fontMetrics().height() + 12.0;
    const int ground = int(head + 6.0 * (180 - head - 8.0) / 8.0);
    QVERIFY(pixelsNear(view, QRect(60, ground - 2, 180, 5), tokens().ok) > 150);
    QCOMPARE(pixelsNear(view, QRect(60, ground - 40, 60, 5), tokens().ok), 0);
    QVERIFY(view.accessibleDescription().contains(QStringLiteral("6.00 m")));
}

void tst_Instruments::fanDrawsWhatIsAheadOverTheRobot() {
    LaserFanView view;
    view.resize(300, 180);
    view.setScan(flatGround(6.0), 20.0, ScanPlane::Ahead); // a wall across, six meters away
    const double head = view.fontMetrics().height() + 12.0;
    const double room = 180 - head - 8.0;
    const int wall = int(head + room - 6.0 * room / 8.0);
    QVERIFY(pixelsNear(view, QRect(60, wall - 3, 180, 7), tokens().ok) > 50);
    QCOMPARE(pixelsNear(view, QRect(60, wall + 20, 60, 5), tokens().ok), 0);
    QCOMPARE(view.accessibleDescription(), QStringLiteral("6.00 m ahead"));
}

void tst_Instruments::sonarsComeInRingOrder() {
    const auto columns =
        zonesOf({{"F1", 1.0}, {"L1", 1.0}, {"L4", 4.0}, {"M0", 1.0}, {"R1", 1.0}, {"R4", 1.0}, {"L10", 1.0}}, 5.0)
            .zones;
    QStringList names;
    for (const agent::SonarZone& column : columns)
        names << QString::fromStdString(column.name);
    QCOMPARE(names.join(u' '), QStringLiteral("L10 L4 L1 M0 R1 R4 F1"));
    QCOMPARE(columns[1].range_m, 4.0);
    QCOMPARE(columns[1].low_risk_below_m, 0.0);
}

void tst_Instruments::riskIsColorAndWord_data() {
    QTest::addColumn<agent::Risk>("risk");
    QTest::addColumn<QColor>("color");
    QTest::addColumn<QString>("word");
    QTest::newRow("free") << agent::Risk::None << tokens(Theme::Dark).ok << QString();
    QTest::newRow("low") << agent::Risk::Low << tokens(Theme::Dark).caution << QStringLiteral("low");
    QTest::newRow("high") << agent::Risk::High << tokens(Theme::Dark).danger << QStringLiteral("high");
}

void tst_Instruments::riskIsColorAndWord() {
    QFETCH(agent::Risk, risk);
    QFETCH(QColor, color);
    SonarColumnsView view;
    view.resize(300, 160);
    view.setZones(nineZones(risk));
    QVERIFY(pixelsNear(view, QRect(134, 80, 32, 60), color) > 60);
    QTEST(riskWord(risk), "word");
    QCOMPARE(view.accessibleDescription().contains(QStringLiteral("1 at risk")), risk != agent::Risk::None);
}

void tst_Instruments::staleIsGrey() {
    SonarColumnsView view;
    view.resize(300, 160);
    view.setZones(nineZones(agent::Risk::High));
    view.setStale(true);
    QCOMPARE(pixelsNear(view, QRect(134, 40, 32, 100), tokens().danger), 0);
    view.setStale(false);
    QVERIFY(pixelsNear(view, QRect(134, 40, 32, 100), tokens().danger) > 60);
    LaserFanView fan;
    fan.resize(300, 180);
    fan.setScan(flatGround(6.0));
    fan.setStale(true);
    QCOMPARE(pixelsNear(fan, fan.rect(), tokens().ok), 0);
    TerrainProfileView terrain;
    terrain.resize(300, 110);
    terrain.setProfile({{{-1.0, 0.0f}, {0.0, 1.0f}, {1.0, 0.0f}}, 1.0, 6.0});
    terrain.setStale(true);
    QCOMPARE(pixelsNear(terrain, terrain.rect(), tokens().ok), 0);
}

void tst_Instruments::theHeadTellsTheRateWhereThereIsRoom_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<double>("period_s");
    QTest::addColumn<bool>("stale");
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("painted");
    QTest::newRow("five times a second") << 300 << 0.2 << false << "5.0 Hz" << true;
    QTest::newRow("once in two seconds") << 300 << 2.0 << false << "0.5 Hz" << true;
    QTest::newRow("one reading so far") << 300 << 0.0 << false << "" << false;
    QTest::newRow("stale") << 300 << 0.2 << true << "" << false;
    QTest::newRow("no room") << 60 << 0.2 << false << "5.0 Hz" << false;
}

/// Where it is not painted, everything looks as without a rate.
void tst_Instruments::theHeadTellsTheRateWhereThereIsRoom() {
    QFETCH(int, width);
    QFETCH(double, period_s);
    QFETCH(bool, stale);
    QFETCH(bool, painted);
    SonarColumnsView view;
    view.resize(width, 160);
    view.setZones(nineZones(agent::Risk::None));
    view.setStale(stale, Seconds(0.1));
    const QImage without = view.grab().toImage();
    view.setStale(stale, Seconds(0.1), period_s > 0.0 ? std::optional(Seconds(period_s)) : std::nullopt);
    QTEST(view.rateText(), "text");
    QCOMPARE(view.grab().toImage() != without, painted);
}

void tst_Instruments::theRateRepaintsOnlyWhenItsTextChanges() {
    struct Paints : QObject {
        int count = 0;
        bool eventFilter(QObject*, QEvent* event) override {
            count += event->type() == QEvent::Paint ? 1 : 0;
            return false;
        }
    } paints;
    SonarColumnsView view;
    view.setZones(nineZones(agent::Risk::None));
    view.setStale(false, Seconds(0.0), Seconds(0.2));
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    QCoreApplication::processEvents();
    view.installEventFilter(&paints);
    const auto tick = [&view](double age_s, double period_s) {
        view.setStale(false, Seconds(age_s), Seconds(period_s));
        QCoreApplication::processEvents();
    };
    for (int i = 0; i < 20; ++i)
        tick(0.01 * i, 0.2 + 0.00005 * i);
    QCOMPARE(paints.count, 0);
    tick(0.0, 0.25);
    QCOMPARE(paints.count, 1);
}

void tst_Instruments::theTooltipTellsRateAndAge() {
    LaserFanView fan;
    fan.setScan(flatGround(6.0));
    QCOMPARE(fan.toolTipNow(), fan.toolTip());
    fan.setStale(false, Seconds(0.12), Seconds(0.2));
    QCOMPARE(fan.toolTipNow(), fan.toolTip() + QStringLiteral("\n5.0 Hz, newest 0.1 s old"));
    QHelpEvent hover(QEvent::ToolTip, {5, 5}, fan.mapToGlobal(QPoint(5, 5)));
    QCoreApplication::sendEvent(&fan, &hover);
    QCOMPARE(QToolTip::text(), fan.toolTipNow());
    QToolTip::hideText();
    fan.setStale(true, Seconds(3.2), Seconds(0.2));
    QCOMPARE(fan.toolTipNow(), fan.toolTip() + QStringLiteral("\nnewest 3.2 s old"));
}

void tst_Instruments::profileIsBrokenWhereTheMapIs() {
    mapping::CourseProfile profile{{}, 10.0, 6.0};
    for (int i = -10; i <= 10; ++i)
        profile.points.push_back({double(i), i < 4 ? std::optional(1.0f) : std::nullopt});
    TerrainProfileView view;
    view.resize(300, 110);
    view.setProfile(profile);
    QVERIFY(pixelsNear(view, QRect(10, 40, 190, 62), tokens().ok) > 180);
    QCOMPARE(pixelsNear(view, QRect(210, 40, 80, 62), tokens().ok), 0);
    QVERIFY(view.accessibleDescription().contains(QStringLiteral("5.0 m above")));
    profile.points.clear();
    profile.points.push_back({0.0, std::nullopt});
    view.setProfile(profile);
    QCOMPARE(view.clearanceText(), QStringLiteral("unmapped here"));
}

void tst_Instruments::emptyViewsSayWhatWillAppear() {
    for (QWidget* view :
         std::initializer_list<QWidget*>{new SonarColumnsView, new LaserFanView, new TerrainProfileView}) {
        view->resize(300, 160);
        QVERIFY(pixelsNear(*view, view->rect(), tokens().text_muted) > 100);
        delete view;
    }
}

USAR_TEST(tst_Instruments)

} // namespace tst_instruments

#include "tst_instruments.moc"
