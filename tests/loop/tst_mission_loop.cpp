#include <QJsonDocument>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/host/true_figures.h"
#include "core/mission/runs/mission_runner.h"
#include "tests/doubles/test_worlds.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"

namespace tst_mission_loop {

using namespace usar;
using namespace usar::mission;
using usar::server::HeadlessSimulator;

/// Whole missions against the simulator, as `usar-mission` flies them.
class tst_MissionLoop : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void hopsAndScoresAgainstTheTruth();
    void surveysASmallFieldWithoutHittingAnything();

private:
    struct Outcome {
        int exit_code = -1;
        QJsonObject summary;
    };
    Outcome run(HeadlessSimulator& simulator, const Mission& mission);

    agent::PluginLoader plugins_;
};

void tst_MissionLoop::initTestCase() {
    const QString build = USAR_BINARY_DIR;
    plugins_.scan({build + "/tests/mission_plugins", build + "/robots"});
    QVERIFY(plugins_.behavior("test/hop"));
    QVERIFY(plugins_.behavior("airrobot/cpp"));
}

tst_MissionLoop::Outcome tst_MissionLoop::run(HeadlessSimulator& simulator, const Mission& mission) {
    QTemporaryDir folder;
    RunOptions options;
    options.port = simulator.port();
    options.result_folder = folder.path();
    options.truth = app::truthOf(simulator);
    options.world_extent = simulator.extent();
    options.true_figures = [&] { return app::trueFiguresOf(simulator); };
    MissionRunner runner(mission, plugins_, options);
    QSignalSpy finished(&runner, &MissionRunner::finished);
    runner.start();
    const bool ended = test::waitForSignal(&runner, &MissionRunner::finished, 110000);
    return {ended ? finished.at(0).at(0).toInt() : -1, runner.summary()};
}

void tst_MissionLoop::hopsAndScoresAgainstTheTruth() {
    auto simulator = HeadlessSimulator::serve(doubles::flatWorld(), {.seed = 1});
    QVERIFY(simulator);
    Mission mission;
    mission.name = "Hop";
    mission.behavior = "test/hop";
    mission.area_in_map = {{0.0, 0.0}, {4.0, 2.0}};
    mission.parameters["ticks"] = 50LL;
    const Outcome outcome = run(**simulator, mission);
    QCOMPARE(outcome.exit_code, 0);
    QVERIFY(outcome.summary["lockstep"].toBool());
    QVERIFY(outcome.summary["collisions"].isDouble());
    QVERIFY(outcome.summary["lines_received"].toInt() > 150);
    QCOMPARE(outcome.summary["lines_malformed"].toInt(), 0);
}

void tst_MissionLoop::surveysASmallFieldWithoutHittingAnything() {
    auto simulator = HeadlessSimulator::serve(doubles::flatWorld(), {.seed = 1});
    QVERIFY(simulator);
    Mission mission;
    mission.name = "Small field";
    mission.area_in_map = {{-12.0, -8.0}, {12.0, 8.0}};
    const Outcome outcome = run(**simulator, mission);
    const QByteArray said = QJsonDocument(outcome.summary).toJson();
    QVERIFY2(outcome.exit_code == 0, said);
    QVERIFY2(outcome.summary["collisions"].toInt(-1) == 0, said);
    QVERIFY2(outcome.summary["coverage_pct"].toDouble() >= 95.0, said);
    QVERIFY2(outcome.summary["rmse_m"].toDouble(9.0) < 0.6, said);
}

USAR_TEST(tst_MissionLoop)

} // namespace tst_mission_loop

#include "tst_mission_loop.moc"
