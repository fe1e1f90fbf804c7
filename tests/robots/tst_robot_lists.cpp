#include <cmath>
#include <limits>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/agent/behavior_host.h"
#include "robots/airrobot/descriptions.h"
#include "robots/airrobot/settings.h"
#include "robots/ers/descriptions.h"
#include "robots/ers/settings.h"
#include "robots/p2dx/descriptions.h"
#include "robots/p2dx/settings.h"
#include "robots/sample/hop.h"
#include "robots/submarine/descriptions.h"
#include "robots/submarine/settings.h"
#include "tests/suite/suite.h"

namespace tst_robot_lists {

using namespace usar;
using namespace usar::agent;

namespace {

using Specs = std::vector<ParameterSpec>;

/// The parameters of all robots by the robot's name.
std::map<std::string, Specs> allSpecs() {
    return {{"AirRobot", airrobot::Settings::parameters.specs()},
            {"P2DX", p2dx::Settings::parameters.specs()},
            {"Submarine", submarine::Settings::parameters.specs()},
            {"ERS", ers::Settings::parameters.specs()},
            {"sample", sample::hopParameters()}};
}

std::map<std::string, std::shared_ptr<const RobotPlugin>> allRobots() {
    return {{"AirRobot", std::make_shared<airrobot::AirRobot>()},
            {"P2DX", std::make_shared<p2dx::P2dxRobot>()},
            {"Submarine", std::make_shared<submarine::SubmarineRobot>()},
            {"ERS", std::make_shared<ers::ErsRobot>()}};
}

bool isNumber(const ParameterSpec& spec) {
    return !std::holds_alternative<bool>(spec.default_value);
}

/// One row for each of these parameters of each robot.
template <class Wanted = bool (*)(const std::string&, const ParameterSpec&)>
void eachParameter(const Wanted& wanted = [](const std::string&, const ParameterSpec&) { return true; }) {
    QTest::addColumn<QString>("robot");
    QTest::addColumn<QString>("id");
    for (const auto& [robot, specs] : allSpecs())
        for (const ParameterSpec& spec : specs)
            if (wanted(robot, spec))
                QTest::addRow("%s %s", robot.c_str(), spec.id.c_str())
                    << QString::fromStdString(robot) << QString::fromStdString(spec.id);
}

const ParameterSpec& specOf(const Specs& specs, const QString& id) {
    return *std::ranges::find(specs, id.toStdString(), &ParameterSpec::id);
}

/// `number` in the type of the parameter.
ParameterValue valueFor(const ParameterSpec& spec, double number) {
    if (std::holds_alternative<long long>(spec.default_value))
        return static_cast<long long>(number);
    return number;
}

/// A value that the parameter accepts and that is not its default.
ParameterValue anotherValue(const ParameterSpec& spec) {
    if (const bool* flag = std::get_if<bool>(&spec.default_value))
        return !*flag;
    const ParameterValue least = valueFor(spec, spec.minimum);
    return least == spec.default_value ? valueFor(spec, spec.maximum) : least;
}

/// Whether another value of this parameter, with the defaults of all others, gives other settings.
template <class Settings>
bool changesSettings(const ParameterSpec& spec) {
    const auto changed = ParameterSet::make(Settings::parameters.specs(), {{spec.id, anotherValue(spec)}});
    return changed && Settings::parameters.settings(*changed) != Settings{};
}

std::unique_ptr<Behavior> made(const RobotPlugin& robot, const BehaviorDescription& behavior) {
    auto context = BehaviorContext{{"R1", {}, {}}, ParameterSet::make(behavior.parameters).value()};
    return robot.createBehavior(behavior.id, std::move(context)).value();
}

} // namespace

class tst_RobotLists : public QObject {
    Q_OBJECT

private slots:
    void takesItsLimitsAndNothingBeyondThem_data() {
        eachParameter([](const std::string&, const ParameterSpec& spec) { return isNumber(spec); });
    }
    void takesItsLimitsAndNothingBeyondThem() {
        QFETCH(QString, robot);
        QFETCH(QString, id);
        const Specs specs = allSpecs().at(robot.toStdString());
        const ParameterSpec& spec = specOf(specs, id);
        const bool whole = std::holds_alternative<long long>(spec.default_value);
        for (const double limit : {spec.minimum, spec.maximum}) {
            QVERIFY(ParameterSet::make(specs, {{spec.id, valueFor(spec, limit)}}));
            const double outward = limit == spec.minimum ? -1.0 : 1.0;
            const double beyond = whole ? limit + outward : std::nextafter(limit, outward * 1e9);
            const auto refused = ParameterSet::make(specs, {{spec.id, valueFor(spec, beyond)}});
            QVERIFY(!refused);
            const QString text = QString::fromStdString(refused.error().text());
            QVERIFY2(text.contains("out of range") && text.contains("parameter " + id), qPrintable(text));
        }
        if (!whole)
            QVERIFY(!ParameterSet::make(specs, {{spec.id, std::numeric_limits<double>::quiet_NaN()}}));
    }

    void refusesATextAndSaysWhatItNeeds_data() { eachParameter(); }
    void refusesATextAndSaysWhatItNeeds() {
        QFETCH(QString, robot);
        QFETCH(QString, id);
        const auto refused =
            ParameterSet::make(allSpecs().at(robot.toStdString()), {{id.toStdString(), std::string("much")}});
        QVERIFY(!refused);
        const QString text = QString::fromStdString(refused.error().text());
        QVERIFY2(text.contains("\"much\" is a text") && text.contains("parameter " + id), qPrintable(text));
    }

    void suggestsTheNameThatWasMeant_data() { eachParameter(); }
    void suggestsTheNameThatWasMeant() {
        QFETCH(QString, robot);
        QFETCH(QString, id);
        const auto refused = ParameterSet::make(allSpecs().at(robot.toStdString()), {{id.toStdString() + "x", 1.0}});
        QVERIFY(!refused);
        const QString text = QString::fromStdString(refused.error().text());
        QVERIFY2(text.contains("Did you mean " + id + "?"), qPrintable(text));
    }

    void reachesTheSettings_data() {
        eachParameter([](const std::string& robot, const ParameterSpec&) { return robot != "sample"; });
    }
    void reachesTheSettings() {
        QFETCH(QString, robot);
        QFETCH(QString, id);
        const Specs specs = allSpecs().at(robot.toStdString());
        const ParameterSpec& spec = specOf(specs, id);
        const std::map<QString, bool (*)(const ParameterSpec&)> changes{
            {"AirRobot", changesSettings<airrobot::Settings>},
            {"P2DX", changesSettings<p2dx::Settings>},
            {"Submarine", changesSettings<submarine::Settings>},
            {"ERS", changesSettings<ers::Settings>}};
        QVERIFY(changes.at(robot)(spec));
    }

    void namesItsUnit_data() { eachParameter(); }
    void namesItsUnit() {
        QFETCH(QString, robot);
        QFETCH(QString, id);
        const std::map<std::string, QString> suffixes{{"m", "_m"},         {"m/s", "_m_s"}, {"s", "_s"},
                                                      {"rad/s", "_rad_s"}, {"rad", "_rad"}, {"%", "_pct"},
                                                      {"m/s²", "_m_s2"}};
        const Specs specs = allSpecs().at(robot.toStdString());
        const ParameterSpec& spec = specOf(specs, id);
        if (!spec.unit.empty())
            QVERIFY(id.endsWith(suffixes.at(spec.unit)));
        else
            for (const auto& [unit, suffix] : suffixes)
                QVERIFY2(!id.endsWith(suffix), qPrintable(suffix));
    }

    void explainsItselfInSentences_data() { eachParameter(); }
    void explainsItselfInSentences() {
        QFETCH(QString, robot);
        QFETCH(QString, id);
        const Specs specs = allSpecs().at(robot.toStdString());
        const QString help = QString::fromStdString(specOf(specs, id).help);
        QVERIFY(!help.isEmpty() && help.front().isUpper() && help.endsWith('.'));
        QVERIFY(!help.contains("  ") && help.size() < 260); // It is a tooltip
    }

    void hasAnIdAndALabelOfItsOwn_data() {
        QTest::addColumn<QString>("robot");
        for (const auto& [robot, specs] : allSpecs())
            QTest::newRow(robot.c_str()) << QString::fromStdString(robot);
    }
    void hasAnIdAndALabelOfItsOwn() {
        QFETCH(QString, robot);
        std::set<std::string> ids;
        std::set<std::pair<std::string, std::string>> labels;
        const Specs specs = allSpecs().at(robot.toStdString());
        for (const ParameterSpec& spec : specs) {
            QVERIFY2(ids.insert(spec.id).second, spec.id.c_str());
            QVERIFY2(labels.insert({spec.group, spec.label}).second, spec.label.c_str());
        }
    }

    void refusesABehaviorThatItDoesNotHave_data() {
        QTest::addColumn<QString>("robot");
        QTest::addColumn<QString>("instead");
        QTest::newRow("AirRobot") << "AirRobot"
                                  << "Use airrobot/cpp or airrobot/posh";
        QTest::newRow("P2DX") << "P2DX"
                              << "Use p2dx/cpp or p2dx/posh";
        QTest::newRow("Submarine") << "Submarine"
                                   << "Use submarine/cpp";
        QTest::newRow("ERS") << "ERS"
                             << "Use ers/cpp";
    }
    void refusesABehaviorThatItDoesNotHave() {
        QFETCH(QString, robot);
        QFETCH(QString, instead);
        for (const char* id : {"", "dance", "sample/hop", "ERS/CPP"}) {
            const auto refused = allRobots().at(robot.toStdString())->createBehavior(id, {});
            QVERIFY(!refused);
            const QString text = QString::fromStdString(refused.error().text());
            QVERIFY2(text.contains("the " + robot + " has no such behavior"), qPrintable(text));
            QVERIFY2(text.contains(instead), qPrintable(text));
        }
    }

    void standsStillWithItsSafeCommand_data() { eachBehavior(); }
    void standsStillWithItsSafeCommand() {
        QFETCH(QString, robot);
        QFETCH(int, index);
        const auto plugin = allRobots().at(robot.toStdString());
        const auto behavior = made(*plugin, plugin->description().behaviors.at(static_cast<std::size_t>(index)));
        const protocol::Command safe = behavior->safeCommand();
        if (robot == "AirRobot")
            QVERIFY(safe == protocol::Command(protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}));
        else if (robot == "P2DX")
            QVERIFY(safe == protocol::Command(protocol::SkidDrive{0.0, 0.0}));
        else if (robot == "Submarine")
            QVERIFY(safe == protocol::Command(protocol::NauticDrive{0.0, 0.0, 0.0}));
        else
            QCOMPARE(std::get<protocol::MultiDrive>(safe).joints.size(), std::size_t(12));
    }

    void endsWithoutSuccessWhenItIsStoppedBeforeItsFirstTick_data() { eachBehavior(); }
    void endsWithoutSuccessWhenItIsStoppedBeforeItsFirstTick() {
        QFETCH(QString, robot);
        QFETCH(int, index);
        const auto plugin = allRobots().at(robot.toStdString());
        const BehaviorDescription behavior = plugin->description().behaviors.at(static_cast<std::size_t>(index));
        if (!behavior.plan_text.empty())
            return; // A plan decides at its next tick
        BehaviorHost host(made(*plugin, behavior), behavior.id);
        const auto output = host.order(Order::LandNow);
        QVERIFY(host.finished() && !host.broke());
        const auto* const ending = std::get_if<BehaviorFinished>(&output.published.back());
        QVERIFY(ending && !ending->success);
        const bool says_so =
            ending->reason == "Landed on request." || ending->reason == "A person asked the robot to stop.";
        QVERIFY2(says_so, ending->reason.c_str());
        QVERIFY(host.order(Order::Resume).commands.empty()); // It is over
    }

    void describesItsSensesAndActsForThePalette_data() {
        QTest::addColumn<QString>("robot");
        QTest::addColumn<int>("senses");
        QTest::addColumn<int>("acts");
        QTest::newRow("AirRobot") << "AirRobot" << 26 << 31;
        QTest::newRow("P2DX") << "P2DX" << 8 << 7;
        QTest::newRow("Submarine") << "Submarine" << 0 << 0;
        QTest::newRow("ERS") << "ERS" << 0 << 0;
    }
    void describesItsSensesAndActsForThePalette() {
        QFETCH(QString, robot);
        QFETCH(int, senses);
        QFETCH(int, acts);
        const auto primitives = allRobots().at(robot.toStdString())->description().primitives;
        const auto are = [](PrimitiveKind kind) { return [kind](const auto& one) { return one.kind == kind; }; };
        QCOMPARE(std::ranges::count_if(primitives, are(PrimitiveKind::Sense)), senses);
        QCOMPARE(std::ranges::count_if(primitives, are(PrimitiveKind::Act)), acts);
        for (const PrimitiveDescription& one : primitives) {
            const QString help = QString::fromStdString(one.help);
            QVERIFY2(!help.isEmpty() && help.front().isUpper() && help.endsWith('.'), one.name.c_str());
            QVERIFY2(one.kind == PrimitiveKind::Act || one.answer != AnswerType::Any, one.name.c_str());
            QVERIFY2(one.minimum <= one.maximum, one.name.c_str());
        }
    }

    void answersWithTheTypeRangeAndUnitThatPlansMayCompare_data() {
        QTest::addColumn<QString>("robot");
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("answer");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("maximum");
        QTest::addColumn<int>("choices");
        QTest::newRow("margin") << "AirRobot"
                                << "BatteryMargin" << int(AnswerType::Real) << "" << 1.0 << 0;
        QTest::newRow("time") << "AirRobot"
                              << "AvoidanceTime" << int(AnswerType::Real) << "s" << 0.0 << 0;
        QTest::newRow("risk") << "AirRobot"
                              << "SonarRisk" << int(AnswerType::Symbol) << "" << 0.0 << 3;
        QTest::newRow("yes or no") << "AirRobot"
                                   << "OnGround" << int(AnswerType::Boolean) << "" << 0.0 << 0;
        QTest::newRow("of a member") << "AirRobot"
                                     << "ThreatMatters" << int(AnswerType::Boolean) << "" << 0.0 << 0;
        QTest::newRow("of the checklist") << "AirRobot"
                                          << "GeoReceived" << int(AnswerType::Boolean) << "" << 0.0 << 0;
        QTest::newRow("age") << "P2DX"
                             << "ScanAge" << int(AnswerType::Real) << "s" << 0.0 << 0;
        QTest::newRow("danger") << "P2DX"
                                << "IsInDanger" << int(AnswerType::Boolean) << "" << 0.0 << 0;
    }
    void answersWithTheTypeRangeAndUnitThatPlansMayCompare() {
        QFETCH(QString, robot);
        QFETCH(QString, name);
        QFETCH(int, answer);
        QFETCH(QString, unit);
        QFETCH(double, maximum);
        QFETCH(int, choices);
        const auto primitives = allRobots().at(robot.toStdString())->description().primitives;
        const auto one = std::ranges::find(primitives, name.toStdString(), &PrimitiveDescription::name);
        QVERIFY(one != primitives.end());
        QCOMPARE(int(one->answer), answer);
        QCOMPARE(QString::fromStdString(one->unit), unit);
        QCOMPARE(one->maximum, maximum);
        QCOMPARE(one->choices.size(), std::size_t(choices));
    }

    void climbsToAHeightThatThePlanMayLeaveToTheMission() {
        const auto primitives = airrobot::AirRobot().description().primitives;
        const auto climb = std::ranges::find(primitives, "ClimbTo", &PrimitiveDescription::name);
        QVERIFY(climb != primitives.end());
        QCOMPARE(climb->parameters.size(), std::size_t(1));
        QCOMPARE(climb->parameters[0].name, std::string("altitude"));
        QCOMPARE(climb->parameters[0].maximum, 30.0);
        QVERIFY(climb->parameters[0].default_value == posh::Value(0.0));
    }

private:
    static void eachBehavior() {
        QTest::addColumn<QString>("robot");
        QTest::addColumn<int>("index");
        for (const auto& [name, robot] : allRobots()) {
            const auto behaviors = robot->description().behaviors;
            for (std::size_t i = 0; i < behaviors.size(); ++i)
                QTest::newRow(behaviors[i].id.c_str()) << QString::fromStdString(name) << static_cast<int>(i);
        }
    }
};

USAR_TEST(tst_RobotLists)

} // namespace tst_robot_lists

#include "tst_robot_lists.moc"
