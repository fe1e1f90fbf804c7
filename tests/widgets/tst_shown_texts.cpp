// What people read in lists, chips, forms and figures: words, units, limits.
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/bars/connection_bar.h"
#include "widgets/bars/replay_bar.h"
#include "widgets/drive/control_badge.h"
#include "widgets/models/figures.h"
#include "widgets/models/parameter_display.h"
#include "widgets/models/ranges.h"
#include "widgets/models/robot_list_model.h"

namespace tst_shown_texts {

using namespace usar;
using namespace usar::widgets;
using agent::ParameterValue;

namespace {

RobotRow airRobot() {
    RobotRow row;
    row.id = {2};
    row.number = 2;
    row.name = "R2";
    row.class_name = "AirRobot";
    row.state = "idle";
    return row;
}

agent::ParameterSpec specOf(const char* unit, const ParameterValue& value) {
    return {"key", "Label", "Group", unit, value, 0.0, 10.0, "Helps.", {}};
}

} // namespace

class tst_ShownTexts : public QObject {
    Q_OBJECT
private slots:
    void whoDrivesIsSaidInAFewWords_data();
    void whoDrivesIsSaidInAFewWords();
    void chipNamesTheRobotUnlessItIsBare();
    void robotsRowIsASentence_data();
    void robotsRowIsASentence();
    void onlyNineRobotsHaveAKey_data();
    void onlyNineRobotsHaveAKey();
    void bytesHaveDecimalUnits_data();
    void bytesHaveDecimalUnits();
    void figuresKeepSignAndWidth_data();
    void figuresKeepSignAndWidth();
    void durationsChangeTheirUnitsInTime_data();
    void durationsChangeTheirUnitsInTime();
    void agesChangeTheirUnitsInTime_data();
    void agesChangeTheirUnitsInTime();
    void anglesAreShownInDegrees_data();
    void anglesAreShownInDegrees();
    void valuesHaveTheirUnit_data();
    void valuesHaveTheirUnit();
    void toolTipOfAParameterSaysWhatItKnows_data();
    void toolTipOfAParameterSaysWhatItKnows();
    void valuesThatOnlyRoundingTellsApartAreTheSame_data();
    void valuesThatOnlyRoundingTellsApartAreTheSame();
    void linkIsSaidInWords_data();
    void linkIsSaidInWords();
    void badgeSaysWhetherItRecords();
    void sonarsWithOddNamesComeLast();
};

void tst_ShownTexts::whoDrivesIsSaidInAFewWords_data() {
    QTest::addColumn<int>("driver");
    QTest::addColumn<QString>("by");
    QTest::addColumn<QString>("words");
    QTest::newRow("nobody") << int(Driver::Nobody) << ""
                            << "idle";
    QTest::newRow("nobody, whatever the name") << int(Driver::Nobody) << "keys"
                                               << "idle";
    QTest::newRow("a behavior without a name") << int(Driver::Behavior) << ""
                                               << "a behavior drives";
    QTest::newRow("a behavior") << int(Driver::Behavior) << "Terrain survey"
                                << "Terrain survey drives";
    QTest::newRow("the user") << int(Driver::Person) << ""
                              << "you drive";
    QTest::newRow("the user with a device") << int(Driver::Person) << "pad"
                                            << "you drive · pad";
}

void tst_ShownTexts::whoDrivesIsSaidInAFewWords() {
    QFETCH(int, driver);
    QFETCH(QString, by);
    QTEST(controlText({"R1", static_cast<Driver>(driver), by}), "words");
}

void tst_ShownTexts::chipNamesTheRobotUnlessItIsBare() {
    ControlBadge badge;
    QCOMPARE(badge.text(), QStringLiteral("No robot"));
    badge.setWords({"R1", Driver::Person, "keys"});
    QCOMPARE(badge.text(), QStringLiteral("R1: you drive · keys"));
    QCOMPARE(badge.accessibleName(), badge.text());
    QVERIFY(badge.toolTip().contains(badge.text()));
    badge.setBare(true);
    QCOMPARE(badge.text(), QStringLiteral("you drive · keys"));
    badge.setWords({});
    QCOMPARE(badge.text(), QStringLiteral("No robot"));
}

void tst_ShownTexts::robotsRowIsASentence_data() {
    QTest::addColumn<QString>("state");
    QTest::addColumn<double>("battery_pct");
    QTest::addColumn<bool>("driven");
    QTest::addColumn<bool>("stale");
    QTest::addColumn<QString>("sentence");
    const double unknown = -1.0;
    QTest::newRow("idle") << "idle" << unknown << false << false << "R2, AirRobot, idle";
    QTest::newRow("no state yet") << "" << unknown << false << false << "R2, AirRobot";
    QTest::newRow("battery") << "idle" << 62.4 << false << false << "R2, AirRobot, idle, battery 62 %";
    QTest::newRow("empty battery") << "idle" << 0.0 << false << false << "R2, AirRobot, idle, battery 0 %";
    QTest::newRow("battery that is no number")
        << "idle" << qQNaN() << false << false << "R2, AirRobot, idle, battery – %";
    QTest::newRow("driven") << "idle" << unknown << true << false << "R2, AirRobot, idle, you drive · keys";
    QTest::newRow("silent") << "idle" << unknown << false << true << "R2, AirRobot, idle, no news";
    QTest::newRow("all of it") << "scanning" << 99.0 << true << true
                               << "R2, AirRobot, scanning, you drive · keys, battery 99 %, no news";
}

void tst_ShownTexts::robotsRowIsASentence() {
    QFETCH(QString, state);
    QFETCH(double, battery_pct);
    QFETCH(bool, driven);
    QFETCH(bool, stale);
    RobotRow row = airRobot();
    row.state = state;
    row.stale = stale;
    if (!(battery_pct < 0.0))
        row.battery_pct = battery_pct;
    if (driven)
        row.driver = {"R2", Driver::Person, "keys"};
    RobotListModel model;
    model.updateRobot(row);
    QTEST(model.data(model.index(0), Qt::DisplayRole).toString(), "sentence");
    QCOMPARE(model.data(model.index(0), Qt::AccessibleTextRole), model.data(model.index(0), Qt::DisplayRole));
    QVERIFY(!model.data(model.index(0), Qt::DecorationRole).isValid());
    QVERIFY(!model.data({}, Qt::DisplayRole).isValid());
}

void tst_ShownTexts::onlyNineRobotsHaveAKey_data() {
    QTest::addColumn<int>("number");
    QTest::addColumn<QString>("end");
    QTest::newRow("none") << 0 << "idle";
    QTest::newRow("first") << 1 << "\nKey 1 selects";
    QTest::newRow("last") << 9 << "\nKey 9 selects";
    QTest::newRow("beyond") << 10 << "idle";
}

void tst_ShownTexts::onlyNineRobotsHaveAKey() {
    QFETCH(int, number);
    QFETCH(QString, end);
    RobotRow row = airRobot();
    row.number = number;
    RobotListModel model;
    model.updateRobot(row);
    const QString tip = model.data(model.index(0), Qt::ToolTipRole).toString();
    QVERIFY2(tip.endsWith(end), qPrintable(tip));
}

void tst_ShownTexts::bytesHaveDecimalUnits_data() {
    QTest::addColumn<double>("bytes");
    QTest::addColumn<QString>("text");
    QTest::newRow("none") << 0.0 << "0 B";
    QTest::newRow("below a kilobyte") << 999.0 << "999 B";
    QTest::newRow("a kilobyte") << 1000.0 << "1.0 kB";
    QTest::newRow("one decimal") << 1500.0 << "1.5 kB";
    QTest::newRow("no decimal from a hundred on") << 100'000.0 << "100 kB";
    QTest::newRow("a megabyte") << 1e6 << "1.0 MB";
    QTest::newRow("a gigabyte") << 3.2e9 << "3.2 GB";
    QTest::newRow("a terabyte") << 2.5e12 << "2.5 TB";
    QTest::newRow("no larger unit") << 1e16 << "10000 TB";
    QTest::newRow("not a number") << qQNaN() << "– B";
}

void tst_ShownTexts::bytesHaveDecimalUnits() {
    QFETCH(double, bytes);
    QTEST(bytesText(bytes), "text");
}

void tst_ShownTexts::figuresKeepSignAndWidth_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("decimals");
    QTest::addColumn<int>("width");
    QTest::addColumn<QString>("text");
    QTest::newRow("longer than its width") << 1234.0 << 0 << 2 << "1234";
    QTest::newRow("negative") << -8.0 << 0 << 4 << "\u2007\u2007−8";
    QTest::newRow("rounded up to a longer one") << 999.96 << 1 << 0 << "1000.0";
    QTest::newRow("negative that rounds to zero") << -0.001 << 2 << 0 << "0.00";
    QTest::newRow("large") << -1e9 << 0 << 0 << "−1000000000";
    QTest::newRow("minus infinity") << -qInf() << 1 << 3 << "\u2007\u2007–";
}

void tst_ShownTexts::figuresKeepSignAndWidth() {
    QFETCH(double, value);
    QFETCH(int, decimals);
    QFETCH(int, width);
    QTEST(figure(value, decimals, width), "text");
}

void tst_ShownTexts::durationsChangeTheirUnitsInTime_data() {
    QTest::addColumn<double>("seconds");
    QTest::addColumn<QString>("clock");
    QTest::addColumn<QString>("words");
    QTest::newRow("rounds up to a minute") << 59.5 << "00:00:59"
                                           << "1 min 00 s";
    QTest::newRow("just below an hour") << 3599.4 << "00:59:59"
                                        << "59 min 59 s";
    QTest::newRow("rounds up to an hour") << 3599.5 << "00:59:59"
                                          << "1 h 00 min";
    QTest::newRow("a day") << 86399.0 << "23:59:59"
                           << "23 h 59 min";
    QTest::newRow("more than two digits") << 360000.0 << "100:00:00"
                                          << "100 h 00 min";
    QTest::newRow("endless") << qInf() << "–"
                             << "–";
}

void tst_ShownTexts::durationsChangeTheirUnitsInTime() {
    QFETCH(double, seconds);
    QTEST(clockText(Seconds(seconds)), "clock");
    QTEST(durationText(Seconds(seconds)), "words");
}

void tst_ShownTexts::agesChangeTheirUnitsInTime_data() {
    QTest::addColumn<double>("seconds");
    QTest::addColumn<QString>("text");
    QTest::newRow("now") << 0.0 << "0.0 s";
    QTest::newRow("the last tenths") << 9.94 << "9.9 s";
    QTest::newRow("whole seconds") << 9.96 << "10 s";
    QTest::newRow("the last seconds") << 99.4 << "99 s";
    QTest::newRow("minutes") << 99.6 << "2 min";
    QTest::newRow("the last minutes") << 5969.0 << "99 min";
    QTest::newRow("hours") << 5971.0 << "2 h";
    QTest::newRow("days are hours, too") << 360000.0 << "100 h";
    QTest::newRow("never") << qInf() << "–";
    QTest::newRow("not a number") << qQNaN() << "–";
}

void tst_ShownTexts::agesChangeTheirUnitsInTime() {
    QFETCH(double, seconds);
    QTEST(ageText(Seconds(seconds)), "text");
}

void tst_ShownTexts::anglesAreShownInDegrees_data() {
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("turned");
    QTest::newRow("angle") << "rad"
                           << "°" << true;
    QTest::newRow("rate of turn") << "rad/s"
                                  << "°/s" << true;
    QTest::newRow("angular acceleration") << "rad/s2"
                                          << "°/s²" << true;
    QTest::newRow("acceleration") << "m/s2"
                                  << "m/s²" << false;
    QTest::newRow("length") << "m"
                            << "m" << false;
    QTest::newRow("none") << ""
                          << "" << false;
    QTest::newRow("unknown") << "parsec"
                             << "parsec" << false;
}

void tst_ShownTexts::anglesAreShownInDegrees() {
    QFETCH(QString, unit);
    QFETCH(bool, turned);
    const DisplayUnit shown = displayUnit(unit.toStdString());
    QTEST(shown.text, "text");
    QCOMPARE(shown.factor, turned ? 180.0 / pi : 1.0);
}

void tst_ShownTexts::valuesHaveTheirUnit_data() {
    QTest::addColumn<QString>("unit");
    QTest::addColumn<ParameterValue>("value");
    QTest::addColumn<QString>("text");
    QTest::newRow("on") << "" << ParameterValue(true) << "yes";
    QTest::newRow("off") << "m" << ParameterValue(false) << "no";
    QTest::newRow("whole number") << "m" << ParameterValue(7LL) << "7\u00a0m";
    QTest::newRow("whole number without a unit") << "" << ParameterValue(-3LL) << "-3";
    QTest::newRow("no trailing zeros") << "m" << ParameterValue(6.5) << "6.5\u00a0m";
    QTest::newRow("as many decimals as needed") << "" << ParameterValue(0.125) << "0.125";
    QTest::newRow("angle") << "rad" << ParameterValue(pi / 6.0) << "30\u00a0°";
    QTest::newRow("text") << "m" << ParameterValue(std::string("both")) << "both";
}

void tst_ShownTexts::valuesHaveTheirUnit() {
    QFETCH(QString, unit);
    QFETCH(ParameterValue, value);
    QTEST(valueText(specOf(unit.toLatin1().constData(), value), value), "text");
}

void tst_ShownTexts::toolTipOfAParameterSaysWhatItKnows_data() {
    QTest::addColumn<QString>("unit");
    QTest::addColumn<ParameterValue>("value");
    QTest::addColumn<QStringList>("lines");
    QTest::newRow("number with a unit") << "m" << ParameterValue(6.5) << QStringList{"<b>Label</b>",
                                                                                     "Helps.",
                                                                                     "Unit: m",
                                                                                     "Range: 0\u00a0m to 10\u00a0m",
                                                                                     "Default: 6.5\u00a0m",
                                                                                     "In files: key"};
    QTest::newRow("whole number without one")
        << "" << ParameterValue(4LL)
        << QStringList{"<b>Label</b>", "Helps.", "Range: 0 to 10", "Default: 4", "In files: key"};
    QTest::newRow("a switch has no range")
        << "" << ParameterValue(true) << QStringList{"<b>Label</b>", "Helps.", "Default: yes", "In files: key"};
    QTest::newRow("text is no HTML") << "" << ParameterValue(std::string("<a>"))
                                     << QStringList{"<b>Label</b>", "Helps.", "Default: &lt;a&gt;", "In files: key"};
}

void tst_ShownTexts::toolTipOfAParameterSaysWhatItKnows() {
    QFETCH(QString, unit);
    QFETCH(ParameterValue, value);
    QFETCH(QStringList, lines);
    agent::ParameterSpec spec = specOf(unit.toLatin1().constData(), value);
    QCOMPARE(parameterToolTip(spec).split("<br>"), lines);
    spec.help.clear();
    lines.removeOne("Helps.");
    QCOMPARE(parameterToolTip(spec).split("<br>"), lines);
}

void tst_ShownTexts::valuesThatOnlyRoundingTellsApartAreTheSame_data() {
    QTest::addColumn<ParameterValue>("a");
    QTest::addColumn<ParameterValue>("b");
    QTest::addColumn<bool>("same");
    QTest::newRow("rounding") << ParameterValue(1.0) << ParameterValue(1.0 + 1e-12) << true;
    QTest::newRow("another number") << ParameterValue(1.0) << ParameterValue(1.001) << false;
    QTest::newRow("rounding of a large one") << ParameterValue(1e12) << ParameterValue(1e12 + 1.0) << true;
    QTest::newRow("almost nothing") << ParameterValue(0.0) << ParameterValue(1e-10) << true;
    QTest::newRow("not a number") << ParameterValue(qQNaN()) << ParameterValue(qQNaN()) << false;
    QTest::newRow("whole and real") << ParameterValue(2LL) << ParameterValue(2.0) << false;
    QTest::newRow("equal texts") << ParameterValue(std::string("a")) << ParameterValue(std::string("a")) << true;
    QTest::newRow("switches") << ParameterValue(true) << ParameterValue(false) << false;
}

void tst_ShownTexts::valuesThatOnlyRoundingTellsApartAreTheSame() {
    QFETCH(ParameterValue, a);
    QFETCH(ParameterValue, b);
    QTEST(sameValue(a, b), "same");
    QCOMPARE(sameValue(b, a), sameValue(a, b));
}

void tst_ShownTexts::linkIsSaidInWords_data() {
    QTest::addColumn<int>("state");
    QTest::addColumn<QString>("where");
    QTest::addColumn<QString>("reason");
    QTest::addColumn<double>("retry_in_s");
    QTest::addColumn<QString>("words");
    const QString no_answer = "No answer.";
    QTest::newRow("off") << int(ConnectionState::Disconnected) << ""
                         << "" << 0.0 << "Not connected";
    QTest::newRow("off for a reason") << int(ConnectionState::Disconnected) << "" << no_answer << 0.0 << no_answer;
    QTest::newRow("connecting") << int(ConnectionState::Connecting) << "tall_test"
                                << "" << 0.0 << "Connecting…";
    QTest::newRow("connected") << int(ConnectionState::Connected) << ""
                               << "" << 0.0 << "Connected";
    QTest::newRow("connected to a world") << int(ConnectionState::Connected) << "tall_test"
                                          << "" << 9.0 << "Connected · tall_test";
    QTest::newRow("waiting") << int(ConnectionState::Waiting) << "" << no_answer << 4.0
                             << "No answer. Retrying in 4 s.";
    QTest::newRow("about to try") << int(ConnectionState::Waiting) << "" << no_answer << 0.2
                                  << "No answer. Retrying now.";
    QTest::newRow("waiting without a reason") << int(ConnectionState::Waiting) << ""
                                              << "" << 8.0 << "Retrying in 8 s.";
}

void tst_ShownTexts::linkIsSaidInWords() {
    QFETCH(int, state);
    QFETCH(QString, where);
    QFETCH(QString, reason);
    QFETCH(double, retry_in_s);
    ConnectionBar bar;
    bar.setStatus({ConnectionState::Connecting, {}, {}, Seconds(0.0)});
    bar.setStatus({static_cast<ConnectionState>(state), where, reason, Seconds(retry_in_s)});
    QTEST(bar.statusText(), "words");
}

void tst_ShownTexts::badgeSaysWhetherItRecords() {
    RecordBadge badge;
    QCOMPARE(badge.text(), QStringLiteral("not recorded"));
    QAction record;
    record.setCheckable(true);
    badge.setAction(&record);
    record.setChecked(true);
    QCOMPARE(badge.text(), QStringLiteral("REC ready"));
    badge.setState(RecordState{Seconds(751.0), 12'340'000, "/runs/r1.usarrec"});
    QCOMPARE(badge.text(), QStringLiteral("00:12:31 12.3 MB"));
    QVERIFY(badge.toolTip().contains("/runs/r1.usarrec"));
    record.setChecked(false); // The file is still being written.
    QCOMPARE(badge.text(), QStringLiteral("00:12:31 12.3 MB"));
    badge.setState(std::nullopt);
    QCOMPARE(badge.text(), QStringLiteral("not recorded"));
    QVERIFY(badge.toolTip().isEmpty());
}

void tst_ShownTexts::sonarsWithOddNamesComeLast() {
    const std::map<std::string, double> ranges_m = {{"R2", 1.0}, {"X9", 2.0}, {"M0", 3.0},
                                                    {"L1", 4.0}, {"R", 5.0},  {"L10", 6.0}};
    QStringList names;
    for (const agent::SonarZone& column : zonesOf(ranges_m, 5.0).zones) {
        names << QString::fromStdString(column.name);
        QCOMPARE(column.range_m, ranges_m.at(column.name));
        QCOMPARE(column.maximum_m, 5.0);
        QCOMPARE(column.low_risk_below_m, 0.0);
    }
    QCOMPARE(names, QStringList({"L10", "L1", "M0", "R2", "R", "X9"}));
    QVERIFY(zonesOf({}, 5.0).zones.empty());
}

USAR_TEST(tst_ShownTexts)

} // namespace tst_shown_texts

#include "tst_shown_texts.moc"
