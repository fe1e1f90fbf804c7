#include <cmath>

#include <QGuiApplication>
#include <QJsonArray>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/mission/runs/mission_runner.h"
#include "tests/doubles/fake_robot_server.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"

namespace tst_mission_runner {

using namespace usar;
using namespace usar::mission;
using usar::test::FakeRobotServer;

class tst_MissionRunner : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        plugins_.scan({QString(USAR_BINARY_DIR) + "/tests/mission_plugins"});
        QVERIFY(plugins_.behavior("test/hop"));
    }

    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        server_ = std::make_unique<FakeRobotServer>();
        server_->ticks_on_step = true;
        QVERIFY(server_->listen());
        options_ = {};
        options_.port = server_->port();
        options_.seed = 7;
        options_.result_folder = folder_->path();
        options_.limits.connect = Seconds{20.0};
        options_.limits.session.link.first_retry = Seconds{0.02};
        options_.limits.session.link.longest_retry = Seconds{0.1};
    }

    void cleanup() {
        runner_.reset();
        server_.reset();
        folder_.reset();
    }

    void fliesAMissionAndWritesItsResults() {
        QCOMPARE(run(hop()), 0);
        const QJsonObject& summary = runner_->summary();
        for (const char* key : {"success", "reason", "duration_s", "distance_m", "charges", "collisions",
                                "coverage_pct", "rmse_m", "cells", "lines_received", "behavior", "seed", "speed_x"})
            QVERIFY2(summary.contains(key), key);
        QCOMPARE(summary["success"].toBool(), true);
        QCOMPARE(summary["reason"].toString(), QString("Hopped enough."));
        QCOMPARE(summary["behavior"].toString(), QString("test/hop"));
        QCOMPARE(summary["seed"].toInt(), 7);
        QCOMPARE(summary["distance_m"].toDouble(), 5.0);
        QCOMPARE(summary["charges"].toInt(), 1);
        QVERIFY(summary["collisions"].isNull() && summary["rmse_m"].isNull()); // nobody can know on a real server
        QVERIFY(summary["cells"].toInt() > 0);
        QVERIFY(summary["coverage_pct"].toDouble() > 0.0);
        QCOMPARE(summary["duration_s"].toDouble(), 0.8); // five ticks from the first to the last
        QVERIFY(summary["lockstep"].toBool());
        const QStringList files = filesInResults();
        QVERIFY2(files.size() == 10, qPrintable(files.join(' ')));
        for (const QJsonValue file : summary["files"].toArray())
            QVERIFY2(QFile::exists(file.toString()), qPrintable(file.toString()));
        QTRY_VERIFY(!server_->hasClient());
        QVERIFY2(server_->heardOf("DRIVE").last().contains("{AltitudeVelocity 0}"), server_->heardOf("DRIVE").last());
    }

    void aPersonsOwnPlanDecides() {
        const QString path = folder_->filePath("own.lap");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("((DC own (goal ((Count 3))) (drives ((count Tick)))))");
        file.close();
        Mission mission;
        mission.name = "Own";
        mission.behavior = "test/planned";
        mission.plan = path.toStdString();
        QCOMPARE(run(mission), 0);
        QCOMPARE(runner_->summary()["plan"].toString(), path);
    }

    void failsWhenTheBehaviorFails() {
        Mission mission = hop();
        mission.parameters["succeeds"] = false;
        QCOMPARE(run(mission), 1);
        QCOMPARE(runner_->summary()["success"].toBool(), false);
        QCOMPARE(filesInResults().size(), 10);
    }

    void aPluginThatThrowsFailsTheMission() {
        Mission mission = hop();
        mission.parameters["throws"] = true;
        QCOMPARE(run(mission), 2);
        QVERIFY2(reason().contains("its plugin threw: no rotor"), qPrintable(reason()));
    }

    void tellsProgress() {
        Mission mission = hop();
        mission.parameters["ticks"] = 1000000LL;
        runner_ = std::make_unique<MissionRunner>(mission, plugins_, options_);
        std::vector<Progress> seen;
        connect(runner_.get(), &MissionRunner::progressed, this,
                [&](const Progress& progress) { seen.push_back(progress); });
        runner_->start();
        QTRY_VERIFY(seen.size() >= 3 && seen.back().percent > 0.0);
        QVERIFY2(seen.back().state.starts_with("hop "), seen.back().state.c_str());
        QVERIFY(seen.back().speed_x > 1.0);
        QVERIFY(seen.back().now > Seconds{0.0});
    }

    void theShortestFlightTellsHowFarItCame() {
        runner_ = std::make_unique<MissionRunner>(hop(), plugins_, options_);
        std::vector<Progress> seen;
        connect(runner_.get(), &MissionRunner::progressed, this,
                [&](const Progress& progress) { seen.push_back(progress); });
        runner_->start();
        QVERIFY(usar::test::waitForSignal(runner_.get(), &MissionRunner::finished, 30000));
        QVERIFY(!seen.empty());
        QCOMPARE(seen.back().percent, 100.0);
        QCOMPARE(seen.back().state, std::string("hop 5"));
        QCOMPARE(seen.back().distance_m, std::optional(5.0));
        const QJsonObject& summary = runner_->summary();
        QVERIFY(std::abs(seen.back().elapsed->count() - summary["duration_s"].toDouble()) < 0.01);
        QVERIFY(std::abs(*seen.back().coverage_pct - summary["coverage_pct"].toDouble()) < 0.01);
        QVERIFY(*seen.back().coverage_pct > 0.0);
        QVERIFY2(!seen.back().range_left_m, "the behavior does not tell it");
    }

    void refusesBeforeAnythingMoves_data() {
        QTest::addColumn<QString>("fault");
        QTest::addColumn<QString>("words");
        QTest::newRow("unknown behavior") << "behavior"
                                          << "airrobot/dance";
        QTest::newRow("unknown parameter") << "unknown"
                                           << "tics";
        QTest::newRow("parameter out of range") << "range"
                                                << "ticks";
        QTest::newRow("area without size") << "empty"
                                           << "it needs a mission area";
        QTest::newRow("area outside the world") << "outside"
                                                << "is entirely outside the world";
    }

    void refusesBeforeAnythingMoves() {
        QFETCH(QString, fault);
        QFETCH(QString, words);
        Mission mission = hop();
        options_.world_extent = Rectangle{{-10.0, -10.0}, {10.0, 10.0}};
        if (fault == "behavior")
            mission.behavior = "airrobot/dance";
        else if (fault == "unknown")
            mission.parameters["tics"] = 3LL;
        else if (fault == "range")
            mission.parameters["ticks"] = 0LL;
        else if (fault == "empty")
            mission.area_in_map.max_m = mission.area_in_map.min_m;
        else
            mission.area_in_map = {{12.0, 5.0}, {15.0, 8.0}};
        QCOMPARE(run(mission), 2);
        QVERIFY2(reason().contains(words), qPrintable(reason()));
        QCOMPARE(server_->connectionCount(), 0);
    }

    void fliesThePartOfAnAreaThatIsInTheWorld() {
        options_.world_extent = Rectangle{{-10.0, -10.0}, {10.0, 10.0}};
        Mission mission = hop();
        mission.area_in_map = {{0.0, 0.0}, {1000.0, 2.0}};
        QCOMPARE(run(mission), 0); // the scan lies in the middle of what the behavior was given
        QVERIFY2(said_.contains("99 % of the mission area") && said_.contains("only the part inside is flown"),
                 qPrintable(said_));
        const QString heights = runner_->summary()["files"].toArray().at(1).toString();
        QVERIFY2(heights.endsWith(".hdr"), qPrintable(heights));
        const QByteArray header = QByteArray::fromStdString(doubles::readAll(heights.toStdString()));
        const double left_m = header.mid(header.indexOf("ULXMAP") + 6).trimmed().split('\n').front().toDouble();
        QVERIFY2(left_m < 10.0, header);
        QVERIFY(runner_->summary()["coverage_pct"].toDouble() < 1.0); // of the whole area
    }

    void aRobotThatVanishesEndsTheRun_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("ends");
        QTest::newRow("ours") << "R1" << true;
        QTest::newRow("another one") << "R2" << false;
    }

    void aRobotThatVanishesEndsTheRun() {
        QFETCH(QString, name);
        QFETCH(bool, ends);
        Mission mission = hop();
        mission.parameters["ticks"] = 60LL;
        server_->on_command = [&](const QByteArray& line) {
            if (line == "STEP" && server_->tickCount() == 20)
                QMetaObject::invokeMethod(
                    runner_.get(), [this, name] { runner_->robotVanished(name); }, Qt::QueuedConnection);
        };
        QCOMPARE(run(mission), ends ? 1 : 0);
        QCOMPARE(runner_->summary()["success"].toBool(), !ends);
        QCOMPARE(reason(), ends
                               ? QString("The simulator has removed the robot R1; what was scanned until then is kept.")
                               : QString("Hopped enough."));
    }

    void refusesAFolderThatCannotBeWritten() {
        QFile file(folder_->filePath("a_file"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        options_.result_folder = folder_->filePath("a_file/below");
        QCOMPARE(run(hop()), 2);
        QVERIFY2(reason().contains("a_file/below") && reason().contains("--out"), qPrintable(reason()));
        QCOMPARE(server_->connectionCount(), 0);
    }

    void anUnknownStartPoseListsTheKnownOnes() {
        Mission mission = hop();
        mission.start = "Roof";
        QCOMPARE(run(mission), 2);
        QVERIFY2(reason().contains("Roof") && reason().contains("PlayerStart, robot1"), qPrintable(reason()));
        QVERIFY(server_->heardOf("INIT").isEmpty());
    }

    void startPosesAreFoundInAnyCase() {
        Mission mission = hop();
        mission.start = "ROBOT1";
        QCOMPARE(run(mission), 0);
        QVERIFY2(server_->heardOf("INIT").at(0).contains("{Location 3,4,-0.5}"), server_->heardOf("INIT").at(0));
    }

    void aDeadServerIsNamedAfterAWhile() {
        options_.limits.connect = Seconds{0.3};
        server_->stopListening();
        QCOMPARE(run(hop()), 2);
        QVERIFY2(reason().startsWith("Nothing listens at 127.0.0.1:"), qPrintable(reason()));
        QVERIFY(!reason().contains("Retrying"));
    }

    void aForeignServerIsNamedAfterAWhile() {
        options_.limits.connect = Seconds{3.0}; // Its line must arrive before, on a busy machine as well.
        server_->greets = server_->answers_lockstep = false;
        server_->on_connect = [&] {
            server_->say("SSH-2.0-OpenSSH_9.2p1\r\n");
            server_->hangUp();
        };
        QCOMPARE(run(hop()), 2);
        QVERIFY2(reason().contains("does not speak USARSim"), qPrintable(reason()));
    }

    void aServerWithoutStartPosesIsNamedAfterAWhile() {
        options_.limits.connect = Seconds{0.3};
        server_->greets = false;
        QCOMPARE(run(hop()), 2);
        QVERIFY2(reason().contains("sent no start poses"), qPrintable(reason()));
    }

    void aRobotThatNeverSpeaksFailsTheMission() {
        options_.limits.session.spawn = Seconds{0.2};
        server_->answers_init = false;
        QCOMPARE(run(hop()), 1);
        QVERIFY2(reason().contains("Nothing from R1"), qPrintable(reason()));
        QVERIFY(filesInResults().isEmpty());
    }

    void aServerThatClosesBeforeTheRobotSpeaksFailsTheMission() {
        server_->answers_init = false;
        server_->on_command = [&](const QByteArray& line) {
            if (line.startsWith("INIT"))
                server_->hangUp();
        };
        QCOMPARE(run(hop()), 1);
        QVERIFY2(reason().contains("closed the connection before R1 sent anything"), qPrintable(reason()));
    }

    void aRobotThatDoesNotComeIsNotWaitedForEver() {
        options_.limits.session.spawn = Seconds{600.0};
        options_.limits.spawn = Seconds{0.3};
        server_->answers_init = false;
        QCOMPARE(run(hop()), 1);
        QVERIFY2(reason().contains("The robot did not appear"), qPrintable(reason()));
    }

    void aServerThatClosesInTheMiddleLeavesTheScan() {
        Mission mission = hop();
        mission.parameters["ticks"] = 1000000LL;
        server_->on_command = [&](const QByteArray& line) {
            if (line == "STEP" && server_->tickCount() == 20)
                server_->hangUp();
        };
        QCOMPARE(run(mission), 1);
        QVERIFY2(reason().contains("connection to the server was lost"), qPrintable(reason()));
        QCOMPARE(filesInResults().size(), 10);
    }

    void timeThatStandsStillFailsTheMission() {
        options_.limits.stall = Seconds{0.5};
        server_->ticks_on_step = false;
        QCOMPARE(run(hop()), 1);
        QVERIFY2(reason().contains("clock has stood still"), qPrintable(reason()));
    }

    void aMissionThatNeverEndsIsEnded() {
        options_.limits.session.flight = Seconds{10.0};
        Mission mission = hop();
        mission.parameters["ticks"] = 1000000LL;
        QCOMPARE(run(mission), 1);
        QVERIFY2(reason().contains("longer than its limit of 10 s"), qPrintable(reason()));
        const double duration_s = runner_->summary()["duration_s"].toDouble();
        QVERIFY2(duration_s > 10.0 && duration_s < 10.5, qPrintable(QString::number(duration_s))); // the next tick
        QCOMPARE(filesInResults().size(), 10);
    }

    void anInterruptKeepsWhatWasScanned() {
        Mission mission = hop();
        mission.parameters["ticks"] = 1000000LL;
        server_->on_command = [&](const QByteArray& line) {
            if (line == "STEP" && server_->tickCount() == 20)
                QMetaObject::invokeMethod(runner_.get(), &MissionRunner::interrupt, Qt::QueuedConnection);
        };
        QCOMPARE(run(mission), 1);
        QVERIFY2(reason().contains("Interrupted"), qPrintable(reason()));
        QCOMPARE(filesInResults().size(), 10);
        QTRY_VERIFY(!server_->hasClient());
        QVERIFY2(server_->heardOf("DRIVE").last().contains("{AltitudeVelocity 0}"), server_->heardOf("DRIVE").last());
    }

    void anInterruptBeforeTheFlightEndsTheRunToo() {
        server_->greets = false;
        server_->on_connect = [&] { runner_->interrupt(); };
        QCOMPARE(run(hop()), 1);
        QVERIFY(filesInResults().isEmpty());
    }

    void aBrokenRobotIsNoSuccess() {
        options_.true_figures = [] { return std::optional(TrueFigures{.collisions = 1, .broken = true}); };
        QCOMPARE(run(hop()), 1);
        QVERIFY2(reason().endsWith("But the robot is broken."), qPrintable(reason()));
        QVERIFY(!runner_->summary()["success"].toBool());
    }

    void theRobotIsWatchedAfterItsStop_data() {
        QTest::addColumn<TrueFigures>("later");
        QTest::addColumn<bool>("closes"); // the server, meanwhile
        QTest::addColumn<bool>("success");
        QTest::addColumn<QJsonValue>("contacts");
        const Seconds flight{10.0};
        const QJsonValue unknown = QJsonValue::Null;
        QTest::newRow("it rests") << TrueFigures{.collisions = 1, .powered_for = flight} << false << true
                                  << QJsonValue(0);
        QTest::newRow("it drifts into something")
            << TrueFigures{.collisions = 3, .powered_for = flight} << false << true << QJsonValue(2);
        QTest::newRow("it slides off and breaks")
            << TrueFigures{.collisions = 2, .broken = true, .powered_for = flight} << false << false << QJsonValue(1);
        QTest::newRow("it falls without power")
            << TrueFigures{.collisions = 2, .powered_for = Seconds{1.0}} << false << true << unknown;
        QTest::newRow("the server closes")
            << TrueFigures{.collisions = 2, .powered_for = flight} << true << true << unknown;
    }

    void theRobotIsWatchedAfterItsStop() {
        QFETCH(TrueFigures, later);
        QFETCH(bool, closes);
        QFETCH(bool, success);
        QFETCH(QJsonValue, contacts);
        constexpr int well_after_the_hop = 12; // ticks
        options_.true_figures = [&] {
            return std::optional(server_->tickCount() < well_after_the_hop ? TrueFigures{.collisions = 1} : later);
        };
        server_->on_command = [&](const QByteArray&) {
            if (closes && server_->tickCount() >= well_after_the_hop)
                server_->hangUp();
        };
        QCOMPARE(run(hop()), success ? 0 : 1);
        const QJsonObject& summary = runner_->summary();
        QCOMPARE(summary["contacts_after_stop"], contacts);
        QCOMPARE(summary["collisions"].toInt(), 1);
        QCOMPARE(summary["duration_s"].toDouble(), 0.8);
        QCOMPARE(summary["success"].toBool(), success);
    }

    void nobodyIsWatchedOnARealServer() {
        QCOMPARE(run(hop()), 0);
        QVERIFY(runner_->summary()["contacts_after_stop"].isNull());
        QVERIFY2(server_->tickCount() < 10, "it ends at once");
    }

    void scoresAgainstTheTruthAndAsksForCollisions() {
        options_.truth = Truth{[](const Vec2&) { return 2.5; }, [](const Vec2&) { return 2.5; }};
        options_.true_figures = [] {
            return std::optional(
                TrueFigures{3, 12.5, Seconds(4.0), 1, 2, Seconds(7.5), HeightOverGround{0.5, 4.0, 0.25}});
        };
        QCOMPARE(run(hop()), 0); // the fake robot sees ground 2 m below its scanner at 5 m: half a metre off
        QVERIFY2(std::abs(runner_->summary()["rmse_m"].toDouble() - 0.5) < 0.05,
                 qPrintable(QString::number(runner_->summary()["rmse_m"].toDouble())));
        QCOMPARE(runner_->summary()["collisions"].toInt(), 3);
        QCOMPARE(runner_->summary()["true_distance_m"].toDouble(), 12.5);
        QCOMPARE(runner_->summary()["longest_stay_s"].toDouble(), 4.0);
        QCOMPARE(runner_->summary()["falls"].toInt(), 1);
        QCOMPARE(runner_->summary()["touches"].toInt(), 2);
        QCOMPARE(runner_->summary()["first_touch_s"].toDouble(), 7.5);
        QCOMPARE(runner_->summary()["least_height_m"].toDouble(), 0.5);
        QCOMPARE(runner_->summary()["mean_height_m"].toDouble(), 4.0);
        QCOMPARE(runner_->summary()["height_spread_m"].toDouble(), 0.25);
    }

private:
    Mission hop() const {
        Mission mission;
        mission.name = "Hop";
        mission.behavior = "test/hop";
        mission.area_in_map = {{0.0, 0.0}, {4.0, 2.0}};
        return mission;
    }

    /// Runs to the end; the exit code, or -1 where it does not come.
    int run(const Mission& mission) {
        runner_ = std::make_unique<MissionRunner>(mission, plugins_, options_);
        QSignalSpy finished(runner_.get(), &MissionRunner::finished);
        said_.clear();
        QObject::connect(runner_.get(), &MissionRunner::noticed,
                         [this](const Notice& notice) { said_ += QString::fromStdString(notice.text) + '\n'; });
        runner_->start();
        if (!usar::test::waitForSignal(runner_.get(), &MissionRunner::finished, 30000))
            return -1;
        return finished.size() == 1 ? finished.at(0).at(0).toInt() : -1;
    }

    QString reason() const { return runner_->summary()["reason"].toString(); }
    QStringList filesInResults() const { return QDir(folder_->path()).entryList(QDir::Files); }

    agent::PluginLoader plugins_;
    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<FakeRobotServer> server_;
    std::unique_ptr<MissionRunner> runner_;
    RunOptions options_;
    QString said_; ///< notices of the newest run
};

USAR_TEST(tst_MissionRunner)

} // namespace tst_mission_runner

#include "tst_mission_runner.moc"
