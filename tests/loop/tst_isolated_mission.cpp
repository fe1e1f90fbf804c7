#include <algorithm>
#include <optional>

#include <QJsonDocument>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/link/recording_reader.h"
#include "core/mission/runs/mission_runner.h"
#include "core/server/embedded/headless_simulator.h"
#include "tests/doubles/test_worlds.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"

namespace tst_isolated_mission {

using namespace usar;
using namespace usar::mission;
using usar::server::HeadlessSimulator;

namespace {

struct Flown {
    int exit_code = -1;
    QJsonObject summary;
    std::vector<std::string> commands; ///< cause and line of each, in order
};

std::vector<std::string> commandsIn(const QString& recording) {
    std::vector<std::string> commands;
    const auto reader = link::RecordingReader::open(recording);
    if (!reader)
        return commands;
    while (const auto record = (*reader)->next())
        if (record->kind == link::RecordKind::Out)
            commands.push_back(std::to_string(record->trigger.value) + " " + std::string(record->name) + " " +
                               std::string(record->bytes));
    return commands;
}

void areTheSame(const Flown& one, const Flown& other) {
    QVERIFY2(one.exit_code == 0, QJsonDocument(one.summary).toJson());
    QVERIFY2(other.exit_code == 0, QJsonDocument(other.summary).toJson());
    QVERIFY(one.commands.size() > 200);
    for (std::size_t i = 0; i < std::min(one.commands.size(), other.commands.size()); ++i)
        QVERIFY2(one.commands[i] == other.commands[i],
                 ("command " + std::to_string(i) + ": " + one.commands[i] + " / " + other.commands[i]).c_str());
    QCOMPARE(other.commands.size(), one.commands.size());
    for (const char* key : {"duration_s", "distance_m", "cells", "coverage_pct"})
        QCOMPARE(other.summary[key], one.summary[key]);
}

} // namespace

/// Missions whose behavior has a process of its own, and missions at several speeds: command by command the same.
class tst_IsolatedMission : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void isCommandByCommandTheMissionWithoutIsolation_data();
    void isCommandByCommandTheMissionWithoutIsolation();
    void isTheSameAtAnySpeed();
    void aBehaviorThatGoesWrongEndsTheMissionWithItsReason_data();
    void aBehaviorThatGoesWrongEndsTheMissionWithItsReason();

private:
    /// `in_memory`: the simulator shares the thread of the mission, as in `usar-mission run` at full speed.
    Flown fly(const Mission& mission, std::optional<double> speed_x = {}, bool in_memory = false);

    agent::PluginLoader plugins_;
};

void tst_IsolatedMission::initTestCase() {
    const QString build = USAR_BINARY_DIR;
    plugins_.scan({build + "/tests/plugins/faulty.so", build + "/robots"});
    QVERIFY(plugins_.behavior("faulty/segfault"));
    QVERIFY(plugins_.behavior("airrobot/posh"));
}

Flown tst_IsolatedMission::fly(const Mission& mission, std::optional<double> speed_x, bool in_memory) {
    QTemporaryDir folder;
    auto simulator =
        HeadlessSimulator::serve(doubles::flatWorld(), {.seed = 7, .speed_x = speed_x, .own_thread = !in_memory});
    if (!simulator)
        return {};
    RunOptions options;
    options.port = (*simulator)->port();
    options.in_process = (*simulator)->inProcess();
    options.result_folder = folder.path();
    options.recording = folder.filePath("flight.usarrec");
    options.behavior_host = QStringLiteral(USAR_BINARY_DIR "/bin/usar-behavior-host");
    Flown flown;
    {
        MissionRunner runner(mission, plugins_, options);
        QSignalSpy finished(&runner, &MissionRunner::finished);
        runner.start();
        if (test::waitForSignal(&runner, &MissionRunner::finished, 110000))
            flown.exit_code = finished.at(0).at(0).toInt();
        flown.summary = runner.summary();
    }
    flown.commands = commandsIn(options.recording);
    return flown;
}

void tst_IsolatedMission::isCommandByCommandTheMissionWithoutIsolation_data() {
    QTest::addColumn<std::string>("behavior");
    QTest::newRow("state machine") << std::string("airrobot/cpp");
    QTest::newRow("POSH plan") << std::string("airrobot/posh");
}

void tst_IsolatedMission::isCommandByCommandTheMissionWithoutIsolation() {
    QFETCH(std::string, behavior);
    Mission mission;
    mission.name = "Small field";
    mission.behavior = behavior;
    mission.area_in_map = {{-12.0, -8.0}, {12.0, 8.0}};
    const Flown here = fly(mission);
    areTheSame(here, fly(mission, {}, true));
    mission.isolate = true;
    areTheSame(here, fly(mission));
    areTheSame(here, fly(mission, {}, true));
}

void tst_IsolatedMission::isTheSameAtAnySpeed() {
    Mission mission;
    mission.name = "Small field";
    mission.area_in_map = {{-12.0, -8.0}, {12.0, 8.0}};
    const Flown at_once = fly(mission);
    areTheSame(at_once, fly(mission, 20.0));
    areTheSame(at_once, fly(mission, 100.0));
}

void tst_IsolatedMission::aBehaviorThatGoesWrongEndsTheMissionWithItsReason_data() {
    QTest::addColumn<std::string>("behavior");
    QTest::addColumn<bool>("isolate");
    QTest::addColumn<QString>("words");
    QTest::addColumn<bool>("in_memory");
    QTest::newRow("dies") << std::string("faulty/segfault") << true << "died by SIGSEGV" << false;
    QTest::newRow("aborts") << std::string("faulty/abort") << true << "died by SIGABRT" << true;
    QTest::newRow("throws") << std::string("faulty/throw") << true << "faulty/throw failed: lost my way" << false;
    QTest::newRow("throws in this process")
        << std::string("faulty/throw") << false << "faulty/throw failed: lost my way" << true;
    QTest::newRow("hangs") << std::string("faulty/loop") << true << "faulty/loop hangs" << false;
    QTest::newRow("hangs in this process") << std::string("faulty/loop") << false << "faulty/loop hangs" << false;
    QTest::newRow("hangs beside a simulator in memory")
        << std::string("faulty/loop") << false << "faulty/loop hangs" << true;
}

void tst_IsolatedMission::aBehaviorThatGoesWrongEndsTheMissionWithItsReason() {
    QFETCH(std::string, behavior);
    QFETCH(bool, isolate);
    QFETCH(QString, words);
    QFETCH(bool, in_memory);
    Mission mission;
    mission.name = "Fault";
    mission.behavior = behavior;
    mission.isolate = isolate;
    const Flown flown = fly(mission, {}, in_memory);
    QCOMPARE(flown.exit_code, int(MissionFailed));
    QVERIFY2(flown.summary["reason"].toString().contains(words), qPrintable(flown.summary["reason"].toString()));
    const auto last_drive =
        std::ranges::find_if(flown.commands.rbegin(), flown.commands.rend(),
                             [](const auto& command) { return command.find(" DRIVE ") != std::string::npos; });
    QVERIFY(last_drive != flown.commands.rend());
    QVERIFY2(last_drive->find("{AltitudeVelocity 0}") != std::string::npos, last_drive->c_str());
}

USAR_TEST(tst_IsolatedMission)

} // namespace tst_isolated_mission

#include "tst_isolated_mission.moc"
