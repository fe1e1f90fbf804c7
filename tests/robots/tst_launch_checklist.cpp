#include <optional>

#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/launch_checklist.h"
#include "tests/suite/suite.h"

namespace tst_launch_checklist {

using namespace usar;
using namespace usar::airrobot;

class tst_LaunchChecklist : public QObject {
    Q_OBJECT

    std::optional<modules::RobotModules> robot;
    agent::CommandPort port;
    LaunchChecklist checklist;
    std::uint64_t line = 0;
    double now_s = 100.0;
    std::vector<std::string> asked;

    void tell(protocol::InfoMessage message) { robot->take({LineNumber{++line}, "", std::move(message), {}}); }

    /// One tick of a server that answers what `answers` says; then the step.
    LaunchState tick(bool answers) {
        now_s += 0.2;
        for (const auto& question : {robot->geometry.next(Seconds(now_s)), robot->configuration.next(Seconds(now_s))}) {
            if (!question)
                continue;
            if (const auto* geometry = std::get_if<protocol::GetGeometry>(&*question)) {
                asked.push_back("GEO " + geometry->type.text());
                protocol::GeometryInfo answer;
                answer.type = geometry->type;
                answer.items = {{geometry->type == "Sonar" ? "F1" : "Scanner7", {}, "HARD"}};
                if (answers)
                    tell(answer);
            } else {
                const auto type = std::get<protocol::GetConfiguration>(*question).type;
                asked.push_back("CONF " + type.text());
                if (answers)
                    tell(protocol::ConfigurationInfo{
                        type == "Robot" ? "AerialVehicle" : type.text(),
                        {{"X", {{"MaxRange", "7", 7.0}, {"MaxLinearVelocity", "1.5", 1.5}}}}});
            }
        }
        return checklist.step(Seconds(now_s), *robot, port);
    }
    LaunchState run(bool answers, int ticks) {
        LaunchState state = LaunchState::Waiting;
        for (int i = 0; i < ticks && state == LaunchState::Waiting; ++i)
            state = tick(answers);
        return state;
    }
    void tellAllSensors(const std::string& sonar, const std::string& scanner) {
        tell(protocol::InsReading{{}, "INS", {}});
        tell(protocol::SonarReadings{{}, {{sonar, 5.0}}});
        tell(protocol::RangeScan{{}, scanner, 0.1, 0.2, {1.0, 1.0, 1.0}});
    }

private slots:
    void init() {
        robot.emplace();
        port = {};
        checklist = {};
        line = 0;
        now_s = 100.0;
        asked.clear();
    }

    void asksOneThingAfterTheOther() {
        tellAllSensors("F1", "Scanner7");
        QCOMPARE(run(true, 50), LaunchState::Ready);
        QCOMPARE(asked, (std::vector<std::string>{"CONF Robot", "GEO Sonar", "CONF Sonar", "GEO RangeScanner",
                                                  "CONF RangeScanner"}));
    }

    void usesWhatItWasTold() {
        tellAllSensors("F1", "Scanner7");
        run(true, 50);
        QCOMPARE(checklist.layout().sonars.size(), std::size_t(1));
        QCOMPARE(checklist.layout().sonars[0].maximum_m, 7.0);
        QCOMPARE(checklist.layout().scanner_name, std::string("Scanner7"));
        QCOMPARE(checklist.layout().maximum_speed_m_s, 1.5);
        QVERIFY(port.takePublished().empty());
    }

    void takesTheStockRobotWhereTheServerIsSilentAndSaysSo() {
        tell(protocol::InsReading{{}, "INS", {}});
        protocol::SonarReadings sonars;
        for (const SonarMount& mount : stockLayout().sonars)
            sonars.ranges.push_back({mount.name, 5.0});
        tell(sonars);
        tell(protocol::RangeScan{{}, "Scanner1", 0.1, 0.2, {1.0, 1.0, 1.0}});
        QCOMPARE(run(false, 500), LaunchState::Ready);
        QVERIFY(checklist.layout() == stockLayout());
        QCOMPARE(port.takePublished().size(), std::size_t(5)); // a warning for each question
    }

    void waitsForEverySensorAndNamesTheMissing() {
        tellAllSensors("F2", "Scanner7");
        QCOMPARE(run(true, 20), LaunchState::Waiting);
        QVERIFY(checklist.words().find("Sonar F1") != std::string::npos);
    }

    void failsWhenASensorNeverSpeaks() {
        QCOMPARE(run(true, 200), LaunchState::Failed);
        QCOMPARE(checklist.missing(), (std::vector<std::string>{"INS", "RangeScanner", "Sonar F1"}));
        QVERIFY(checklist.words().find("INS, RangeScanner, Sonar F1") != std::string::npos);
    }
};

USAR_TEST(tst_LaunchChecklist)

} // namespace tst_launch_checklist

#include "tst_launch_checklist.moc"
