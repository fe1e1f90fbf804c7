#include <limits>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/agent/parameters.h"
#include "tests/suite/suite.h"

namespace tst_parameters {

using namespace usar;
using namespace usar::agent;

class tst_Parameters : public QObject {
    Q_OBJECT

    const std::vector<ParameterSpec> specs{
        {"scan_altitude_m", "Scan altitude", "Flight", "m", 6.0, 2.0, 15.0, "Height over ground.", {}},
        {"calm_cycles", "Calm cycles", "Evasion", "", 6LL, 1.0, 50.0, "Before the old goal.", {}},
        {"take_off", "Take off", "Flight", "", true, 0.0, 0.0, "Whether to fly at all.", {}},
        {"pattern", "Pattern", "Survey", "", std::string("lanes"), 0.0, 0.0, "Shape.", {"lanes", "spiral"}},
    };

private slots:
    void givesDefaultsWhereNothingIsSet() {
        const auto set = ParameterSet::make(specs);
        QVERIFY(set);
        QCOMPARE(set->real("scan_altitude_m"), 6.0);
        QCOMPARE(set->integer("calm_cycles"), 6);
        QCOMPARE(set->flag("take_off"), true);
        QCOMPARE(set->text("pattern"), std::string("lanes"));
    }

    void takesWhatIsInRange_data() {
        QTest::addColumn<QString>("id");
        QTest::addColumn<ParameterValue>("value");
        QTest::addColumn<ParameterValue>("stored");
        QTest::newRow("a real") << "scan_altitude_m" << ParameterValue(7.5) << ParameterValue(7.5);
        QTest::newRow("its lowest value") << "scan_altitude_m" << ParameterValue(2.0) << ParameterValue(2.0);
        QTest::newRow("its highest value") << "scan_altitude_m" << ParameterValue(15.0) << ParameterValue(15.0);
        QTest::newRow("a whole number for a real") << "scan_altitude_m" << ParameterValue(7LL) << ParameterValue(7.0);
        QTest::newRow("a whole number") << "calm_cycles" << ParameterValue(9LL) << ParameterValue(9LL);
        QTest::newRow("a flag") << "take_off" << ParameterValue(false) << ParameterValue(false);
        QTest::newRow("one of the choices")
            << "pattern" << ParameterValue(std::string("spiral")) << ParameterValue(std::string("spiral"));
    }
    void takesWhatIsInRange() {
        QFETCH(QString, id);
        QFETCH(ParameterValue, value);
        QFETCH(ParameterValue, stored);
        const auto set = ParameterSet::make(specs, {{id.toStdString(), value}});
        QVERIFY(set);
        QVERIFY(set->values().at(id.toStdString()) == stored);
    }

    void refusesTheRestAndSaysWhatWouldDo_data() {
        QTest::addColumn<QString>("id");
        QTest::addColumn<ParameterValue>("value");
        QTest::addColumn<QString>("said");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("too low") << "scan_altitude_m" << ParameterValue(1.0) << "2 to 15 m";
        QTest::newRow("too high, whole") << "scan_altitude_m" << ParameterValue(99LL) << "2 to 15 m";
        QTest::newRow("not a number") << "scan_altitude_m" << ParameterValue(nan) << "out of range";
        QTest::newRow("a count out of range") << "calm_cycles" << ParameterValue(0LL) << "1 to 50";
        QTest::newRow("a real for a whole number") << "calm_cycles" << ParameterValue(6.5) << "Give a whole number";
        QTest::newRow("a text for a real")
            << "scan_altitude_m" << ParameterValue(std::string("six")) << "\"six\" is a text";
        QTest::newRow("a number for a flag") << "take_off" << ParameterValue(1LL) << "Give a yes or no";
        QTest::newRow("none of the choices") << "pattern" << ParameterValue(std::string("zigzag")) << "lanes, spiral";
        QTest::newRow("a misspelt id") << "scan_altitude" << ParameterValue(6.0) << "Did you mean scan_altitude_m?";
        QTest::newRow("a far id") << "calmcycles" << ParameterValue(6LL) << "Did you mean calm_cycles?";
    }
    void refusesTheRestAndSaysWhatWouldDo() {
        QFETCH(QString, id);
        QFETCH(ParameterValue, value);
        QFETCH(QString, said);
        const auto set = ParameterSet::make(specs, {{id.toStdString(), value}});
        QVERIFY(!set);
        const QString text = QString::fromStdString(set.error().text());
        QVERIFY2(text.contains(said), qPrintable(text));
        QVERIFY2(text.contains(id), qPrintable(text));
    }

    void hasNothingToSuggestWithoutSpecs() {
        const auto set = ParameterSet::make({}, {{"speed", 1.0}});
        QVERIFY(!set);
        QCOMPARE(set.error().mend, std::string("This behavior has none"));
    }
};

USAR_TEST(tst_Parameters)

} // namespace tst_parameters

#include "tst_parameters.moc"
