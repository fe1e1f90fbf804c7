#include <cmath>

#include <QTest>

#include "core/protocol/reader.h"
#include "tests/suite/suite.h"
#include "widgets/models/plot/plot_model.h"
#include "widgets/models/plot/plot_texts.h"

namespace tst_plot_model {

using namespace usar;
using namespace usar::widgets;

namespace {

const std::string f1 = "SEN Sonar/F1/range";
const std::string f2 = "SEN Sonar/F2/range";

protocol::InfoLine sonar(double time_s, double range_m) {
    protocol::Reader reader;
    return reader.read("SEN {Time " + std::to_string(time_s) + "} {Type Sonar} {Name F1 Range " +
                       std::to_string(range_m) + "} {Name F2 Range 1.5}");
}

std::vector<std::string> labels(const PlotModel& model) {
    std::vector<std::string> all;
    for (const ShownSeries& each : model.shown())
        all.push_back(labelOf(each.key).toStdString());
    return all;
}

using Labels = std::vector<std::string>;

} // namespace

class tst_PlotModel : public QObject {
    Q_OBJECT
private slots:
    void seriesFollowTheSelectedRobot();
    void theOtherRobotHasItsPast();
    void pinnedSeriesStayWithTheirRobot();
    void twoRobotsBecomeOneLineWhileFollowing();
    void aRobotThatIsGoneCostsNoMemory();
    void aSeriesOfNobodyIsThatOfTheSelectedRobot();
    void linesOfOtherRobotsChangeNothingThatIsShown();
    void canvasesComeAndGo();
    void colorsCountThroughAllCanvases();
    void frozenShowsNothingLater();
    void aClockThatBeginsAgainRestartsOnlyItsRobot();
    void cursorsArePlacedMovedAndRemoved();
    void theNearestCursorIsTaken();
    void cursorsReadDifferenceAndSlope_data();
    void cursorsReadDifferenceAndSlope();
    void statisticsAreThoseBetweenTheCursors();
    void cursorsAreToldInSentences();
    void namesAreSaidOnce();
    void momentsHaveTenths();
    void figuresOfStatisticsHaveUnits();
    void csvMergesTheTimes();
    void csvQuotesCommas();
    void tableNamesRobotAndUnit();
};

void tst_PlotModel::seriesFollowTheSelectedRobot() {
    PlotModel model;
    model.setRobot("R1");
    QVERIFY(model.add(0, f1));
    QVERIFY(!model.add(0, f1));
    QVERIFY(!model.add(0, ""));
    QCOMPARE(labels(model), Labels{"R1 · Sonar F1 range"});
    model.setRobot("R2");
    QCOMPARE(labels(model), Labels{"R2 · Sonar F1 range"});
}

void tst_PlotModel::theOtherRobotHasItsPast() {
    PlotModel model;
    model.setRobot("R1");
    model.add(0, f1);
    QVERIFY(model.take("R1", sonar(1.0, 2.0), {}));
    for (int i = 0; i < 5; ++i)
        QVERIFY(!model.take("R2", sonar(i, 3.0), {})); // not shown, but recorded
    model.setRobot("R2");
    QCOMPARE(model.shown()[0].series->samples.size(), 5U);
    model.setRobot("R1");
    QCOMPARE(model.shown()[0].series->samples.size(), 1U);
}

void tst_PlotModel::pinnedSeriesStayWithTheirRobot() {
    PlotModel model;
    model.setFollowRobot(false);
    model.setRobot("R1");
    model.add(0, f1);
    model.setRobot("R2");
    model.add(0, f1);
    QCOMPARE(labels(model), (Labels{"R1 · Sonar F1 range", "R2 · Sonar F1 range"}));
    model.take("R3", sonar(1.0, 1.0), {});
    QCOMPARE(model.store().series().size(), 2U); // nobody wants the third robot's
}

void tst_PlotModel::twoRobotsBecomeOneLineWhileFollowing() {
    PlotModel model;
    model.setFollowRobot(false);
    for (const char* robot : {"R1", "R2"}) {
        model.setRobot(robot);
        model.add(0, f1);
    }
    model.setFollowRobot(true);
    QCOMPARE(labels(model), Labels{"R2 · Sonar F1 range"});
    model.setFollowRobot(false);
    QCOMPARE(labels(model).size(), 2U);
}

void tst_PlotModel::aRobotThatIsGoneCostsNoMemory() {
    PlotModel model;
    model.setRobot("R1");
    model.add(0, f1);
    model.take("R1", sonar(1.0, 1.0), {});
    model.take("R2", sonar(1.0, 1.0), {});
    QCOMPARE(model.store().series().size(), 2U);
    model.forget("R2");
    QCOMPARE(model.store().series().size(), 1U);
    model.forget("R1"); // is still shown
    QCOMPARE(model.shown()[0].series->samples.size(), 1U);
}

void tst_PlotModel::aSeriesOfNobodyIsThatOfTheSelectedRobot() {
    PlotModel model;
    model.add(0, f1); // before any robot
    QCOMPARE(labels(model), Labels{"Sonar F1 range"});
    model.setRobot("R1");
    QCOMPARE(labels(model), Labels{"R1 · Sonar F1 range"});
    model.setFollowRobot(false);
    QCOMPARE(labels(model), Labels{"R1 · Sonar F1 range"}); // it belongs to nobody in particular
}

void tst_PlotModel::linesOfOtherRobotsChangeNothingThatIsShown() {
    PlotModel model;
    model.setRobot("R1");
    QVERIFY(!model.take("R1", sonar(1.0, 1.0), {})); // nothing is plotted
    model.add(0, f1);
    QVERIFY(model.take("R1", sonar(2.0, 1.0), {}));
    QVERIFY(!model.take("R2", sonar(9.0, 1.0), {}));
    QCOMPARE(model.newest_s(), std::optional(2.0));
    QCOMPARE(model.oldest_s(), std::optional(2.0));
}

void tst_PlotModel::canvasesComeAndGo() {
    PlotModel model;
    QVERIFY(!model.removeCanvas(0));
    QVERIFY(model.addCanvas());
    model.add(0, f1);
    model.add(1, f2);
    model.add(1, f1);
    QCOMPARE(model.shown()[2].canvas, 1U);
    QVERIFY(model.remove(1, {"", f1}));
    QVERIFY(!model.remove(1, {"", f1}));
    QCOMPARE(model.shown().size(), 2U);
    QVERIFY(model.removeCanvas(0));
    QCOMPARE(labels(model), Labels{"Sonar F2 range"});
    QCOMPARE(model.store().series().size(), 1U);
    while (model.addCanvas()) {
    }
    QCOMPARE(model.layout().canvases.size(), PlotLayout::most_canvases);
    QVERIFY(!model.add(99, f1));
}

void tst_PlotModel::colorsCountThroughAllCanvases() {
    PlotModel model;
    model.addCanvas();
    model.add(0, f1);
    model.add(1, f2);
    QCOMPARE(model.shown()[0].color, 0);
    QCOMPARE(model.shown()[1].color, 1);
}

void tst_PlotModel::frozenShowsNothingLater() {
    PlotModel model;
    model.add(0, f1);
    model.take("", sonar(5.0, 1.0), {});
    model.setFrozen(true);
    model.take("", sonar(6.0, 1.0), {});
    QCOMPARE(model.newest_s(), std::optional(5.0));
    QCOMPARE(model.statistics(*model.shown()[0].series, 0.0, 100.0).count, 1U);
    model.setFrozen(false);
    QCOMPARE(model.newest_s(), std::optional(6.0));
}

void tst_PlotModel::aClockThatBeginsAgainRestartsOnlyItsRobot() {
    PlotModel model;
    model.setFollowRobot(false);
    for (const char* robot : {"R1", "R2"}) {
        model.setRobot(robot);
        model.add(0, f1);
        model.take(robot, sonar(100.0, 1.0), {});
    }
    model.take("R1", sonar(0.5, 1.0), {});
    QCOMPARE(model.shown()[0].series->samples.oldest_s(), 0.5);
    QCOMPARE(model.shown()[1].series->samples.oldest_s(), 100.0);
}

void tst_PlotModel::cursorsArePlacedMovedAndRemoved() {
    PlotCursors cursors;
    QVERIFY(!cursors.move(1.0));
    QVERIFY(!cursors.remove());
    cursors.place(CursorName::A, 10.0);
    QVERIFY(!cursors.difference_s());
    cursors.place(CursorName::B, 12.0);
    QVERIFY(cursors.move(-0.5));
    QCOMPARE(cursors.difference_s(), std::optional(1.5));
    QVERIFY(cursors.remove());
    QVERIFY(!cursors.b_s);
    QVERIFY(cursors.active == CursorName::A);
    QVERIFY(cursors.move(1.0));
    QCOMPARE(cursors.a_s, std::optional(11.0));
    QVERIFY(cursors.remove());
    QVERIFY(cursors == PlotCursors{});
}

void tst_PlotModel::theNearestCursorIsTaken() {
    PlotCursors cursors;
    QVERIFY(!cursors.near(10.0, 100.0));
    cursors.place(CursorName::A, 10.0);
    cursors.place(CursorName::B, 12.0);
    QVERIFY(cursors.near(10.5, 3.0) == CursorName::A);
    QVERIFY(cursors.near(11.5, 3.0) == CursorName::B);
    QVERIFY(!cursors.near(14.0, 1.0));
}

void tst_PlotModel::cursorsReadDifferenceAndSlope_data() {
    QTest::addColumn<double>("a_s");
    QTest::addColumn<double>("b_s");
    QTest::addColumn<double>("difference");
    QTest::addColumn<double>("slope");
    QTest::newRow("forward") << 2.0 << 6.0 << 8.0 << 2.0;
    QTest::newRow("backward") << 6.0 << 2.0 << -8.0 << 2.0;
    QTest::newRow("between samples") << 2.9 << 5.1 << 6.0 << 6.0 / 2.2;
    QTest::newRow("at one time") << 4.0 << 4.0 << 0.0 << std::nan("");
    QTest::newRow("before the first sample") << -1.0 << 4.0 << std::nan("") << std::nan("");
}

void tst_PlotModel::cursorsReadDifferenceAndSlope() {
    QFETCH(double, a_s);
    QFETCH(double, b_s);
    QFETCH(double, difference);
    QFETCH(double, slope);
    SampleHistory line;
    for (int i = 0; i < 10; ++i)
        line.append({i * 1.0, i * 2.0});
    PlotCursors cursors;
    cursors.place(CursorName::A, a_s);
    QVERIFY(!cursorRow(line, cursors).difference);
    cursors.place(CursorName::B, b_s);
    const CursorRow row = cursorRow(line, cursors);
    QCOMPARE(row.difference.has_value(), !std::isnan(difference));
    QCOMPARE(row.slope_per_s.has_value(), !std::isnan(slope));
    if (row.difference)
        QCOMPARE(*row.difference, difference);
    if (row.slope_per_s)
        QCOMPARE(*row.slope_per_s, slope);
}

void tst_PlotModel::statisticsAreThoseBetweenTheCursors() {
    PlotModel model;
    model.add(0, f1);
    for (int i = 0; i < 10; ++i)
        model.take("", sonar(i, i), {});
    const Series& series = *model.shown()[0].series;
    QCOMPARE(model.statistics(series, 2.0, 8.0).count, 7U);
    model.cursors().place(CursorName::B, 3.0);
    QCOMPARE(model.statistics(series, 2.0, 8.0).count, 7U);
    model.cursors().place(CursorName::A, 6.0);
    const Statistics between = model.statistics(series, 2.0, 8.0);
    QCOMPARE(between.count, 4U);
    QCOMPARE(between.least, 3.0);
    QCOMPARE(between.most, 6.0);
    QCOMPARE(between.mean, 4.5);
    QCOMPARE(between.deviation, std::sqrt(5.0 / 3.0));
}

void tst_PlotModel::cursorsAreToldInSentences() {
    PlotModel model;
    model.setRobot("R1");
    model.add(0, f1);
    for (int i = 0; i < 10; ++i)
        model.take("R1", sonar(i, i * 2.0), {});
    QVERIFY(cursorSentences(model).isEmpty());
    model.cursors().place(CursorName::A, 2.0);
    QCOMPARE(cursorSentences(model), QString("Cursor A is at 00:00:02.0. R1 · Sonar F1 range: at A 4.00 m."));
    model.cursors().place(CursorName::B, 6.0);
    QCOMPARE(
        cursorSentences(model),
        QString("Cursor A is at 00:00:02.0. Cursor B is at 00:00:06.0. B is +4.00 s from A. R1 · Sonar F1 range: at "
                "A 4.00 m, at B 12.00 m, difference +8.00 m, slope +2.00 m/s."));
}

void tst_PlotModel::namesAreSaidOnce() {
    QCOMPARE(labelOf({"R1", "SEN INS/INS/yaw"}), QString("R1 · INS yaw"));
    QCOMPARE(labelOf({"R1", f1}), QString("R1 · Sonar F1 range"));
    QCOMPARE(labelOf({"", "STA/battery"}), QString("STA battery"));
}

void tst_PlotModel::momentsHaveTenths() {
    QCOMPARE(momentText(62.34), QString("00:01:02.3"));
    QCOMPARE(momentText(59.96), QString("00:01:00.0"));
    QCOMPARE(momentText(-1.5), QChar(0x2212) + QString("00:00:01.5"));
}

void tst_PlotModel::figuresOfStatisticsHaveUnits() {
    const auto texts = statisticsTexts({4, 1.0, 3.0, 2.0, 0.0123, true}, "m");
    QCOMPARE(texts, (std::vector<QString>{"4", "1.00 m", "3.00 m", "2.00 m", "0.0123 m"}));
    QVERIFY(statisticsTexts({4, 1.0, 3.0, 2.0, 0.5, false}, "m")[1].startsWith(QString("≈")));
    QCOMPARE(statisticsTexts({}, "m")[3], QString("–"));
    QCOMPARE(readingText(Reading{0.5, true}, "rad"), QString("28.65 °"));
    QCOMPARE(differenceText(0.5, "rad", "/s"), QString("+28.65 °/s"));
}

void tst_PlotModel::csvMergesTheTimes() {
    const std::vector<TableColumn> columns{{"a [m]", {{1.0, 0.1}, {2.0, std::nan("")}, {3.0, 3.0}}},
                                           {"b", {{2.0, -20.0}, {2.5, 25.0}}}};
    QCOMPARE(csvOf(columns), std::string("time_s,a [m],b\n1,0.1,\n2,,-20\n2.5,,25\n3,3,\n"));
    QCOMPARE(csvOf({}), std::string("time_s\n"));
}

void tst_PlotModel::csvQuotesCommas() {
    QCOMPARE(csvOf({{"a,\"b\"", {}}}), std::string("time_s,\"a,\"\"b\"\"\"\n"));
}

void tst_PlotModel::tableNamesRobotAndUnit() {
    PlotModel model;
    model.setRobot("R1");
    model.addCanvas();
    model.add(0, f1);
    model.add(1, f1); // twice on the screen, once in the table
    model.take("R1", sonar(1.0, 2.5), {});
    QCOMPARE(csvOf(tableOf(model)), std::string("time_s,R1 SEN Sonar/F1/range [m]\n1,2.5\n"));
}

USAR_TEST(tst_PlotModel)

} // namespace tst_plot_model

#include "tst_plot_model.moc"
