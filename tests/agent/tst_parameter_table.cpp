// Tables that link the members of a behavior's settings to its parameters.
#include <QTest>

#include "core/agent/parameters.h"
#include "tests/suite/suite.h"

namespace tst_parameter_table {

using namespace usar;
using namespace usar::agent;

namespace {

struct Settings {
    double turn_rad = 1.5;
    long long tries = 3;
    bool loud = false;
    double slope_rad = -0.25;
    bool operator==(const Settings&) const = default;
};

constexpr ParameterRow<Settings> rows[] = {
    {&Settings::turn_rad, "turn_rad", "Turn", "Getting out", "rad", 0.5, 3.0, "How far it turns."},
    {&Settings::tries, "tries", "Tries", "Getting out", "", 1.0, 9.0, "How often it tries."},
    {&Settings::loud, "loud", "Loud", "Sound", "", 0.0, 0.0, "Whether it beeps."},
    {&Settings::slope_rad, "slope_rad", "Slope", "Ground", "rad", -1.0, 1.0, "What it can climb.", "any slope"},
};
constexpr ParameterTable<Settings> table{rows};

} // namespace

class tst_ParameterTable : public QObject {
    Q_OBJECT
private slots:
    void specsAreTheRowsWithTheDefaultsOfTheSettings() {
        const std::vector<ParameterSpec> specs = table.specs();
        QCOMPARE(specs.size(), std::size(rows));
        const ParameterValue defaults[] = {1.5, 3LL, false, -0.25};
        for (std::size_t i = 0; i < specs.size(); ++i) {
            QCOMPARE(specs[i].id, std::string(rows[i].id));
            QCOMPARE(specs[i].label, std::string(rows[i].label));
            QCOMPARE(specs[i].group, std::string(rows[i].group));
            QCOMPARE(specs[i].unit, std::string(rows[i].unit));
            QCOMPARE(specs[i].help, std::string(rows[i].help));
            QCOMPARE(specs[i].minimum_words, std::string(rows[i].minimum_words));
            QCOMPARE(specs[i].minimum, rows[i].minimum);
            QCOMPARE(specs[i].maximum, rows[i].maximum);
            QVERIFY(specs[i].default_value == defaults[i]);
            QVERIFY(specs[i].choices.empty());
        }
    }

    void theDefaultsGiveTheDefaultSettings() {
        const auto set = ParameterSet::make(table.specs());
        QVERIFY(set);
        QVERIFY(table.settings(*set) == Settings());
    }

    void eachValueReachesItsMemberAndNoOther_data() {
        QTest::addColumn<QString>("id");
        QTest::addColumn<ParameterValue>("value");
        QTest::addColumn<Settings>("settings");
        QTest::newRow("a real") << "turn_rad" << ParameterValue(2.5) << Settings{.turn_rad = 2.5};
        QTest::newRow("a whole number for a real") << "turn_rad" << ParameterValue(2LL) << Settings{.turn_rad = 2.0};
        QTest::newRow("a whole number") << "tries" << ParameterValue(9LL) << Settings{.tries = 9};
        QTest::newRow("a flag") << "loud" << ParameterValue(true) << Settings{.loud = true};
        QTest::newRow("a second real") << "slope_rad" << ParameterValue(1.0) << Settings{.slope_rad = 1.0};
    }
    void eachValueReachesItsMemberAndNoOther() {
        QFETCH(QString, id);
        QFETCH(ParameterValue, value);
        QFETCH(Settings, settings);
        const auto set = ParameterSet::make(table.specs(), {{id.toStdString(), value}});
        QVERIFY2(set, set ? "" : set.error().text().c_str());
        QVERIFY(table.settings(*set) == settings);
    }

    void anEmptyTableHasNoParameters() {
        constexpr ParameterTable<Settings> none{};
        QVERIFY(none.specs().empty());
        QVERIFY(none.settings(ParameterSet()) == Settings());
    }
};

USAR_TEST(tst_ParameterTable)

} // namespace tst_parameter_table

#include "tst_parameter_table.moc"
