#include <algorithm>
#include <cmath>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLockFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/mission/fleet/fleet.h"
#include "tests/doubles/fake_robot_server.h"
#include "tests/suite/suite.h"

namespace tst_fleet {

using namespace usar;
using namespace usar::mission;
using usar::test::FakeRobotServer;

namespace {

const Rectangle no_area{};
const Rectangle small{{0.0, 0.0}, {4.0, 2.0}};

QJsonObject objectIn(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

} // namespace

/// Robots of a window, without the window and without a simulator.
class tst_Fleet : public QObject {
    Q_OBJECT
private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        server_ = std::make_unique<FakeRobotServer>();
        server_->answers_init = false;
        QVERIFY(server_->listen());
        fleet_ = std::make_unique<Fleet>(QString());
        fleet_->setResultFolder(folder_->path());
        fleet_->setRecording(false);
        fleet_->plugins().scan({QString(USAR_BINARY_DIR) + "/tests/mission_plugins"});
        QVERIFY(fleet_->plugins().behavior("test/hop"));
    }

    void cleanup() {
        fleet_.reset();
        server_.reset();
        folder_.reset();
    }

    void withoutALinkNothingIsSpawned() {
        const auto spawned = fleet_->spawn({});
        QVERIFY(!spawned.has_value());
        QCOMPARE(QString::fromStdString(spawned.error().text()),
                 QString("R1: there is no link to a server yet. Connect first, then spawn."));
        QVERIFY(!fleet_->connectionOf({}).valid());
    }

    void theConnectionThatWaitsLearnsTheStartPoses() {
        QStringList told;
        connect(fleet_.get(), &Fleet::linkChanged, this, [&](const link::LinkStatus& status) {
            if (status.state == link::LinkState::Connected)
                told << "link";
        });
        connect(fleet_.get(), &Fleet::nextConnected, this, [&] { told << "next"; });
        QVERIFY(connectNow());
        QCOMPARE(fleet_->startPoses().size(), std::size_t(2));
        QCOMPARE(fleet_->level(), QString("tall_test"));
        QVERIFY2(told.size() >= 2 && told.at(0) == "link" && told.at(1) == "next", qPrintable(told.join(' ')));
        QVERIFY(fleet_->connectionOf({}).valid());
        QVERIFY(fleet_->robots().empty());
    }

    void fiftyRobotsAreTheMost() {
        QVERIFY(connectNow());
        QSignalSpy added(fleet_.get(), &Fleet::robotAdded);
        for (int id = 1; id <= 50; ++id) {
            QCOMPARE(fleet_->nextRobotName(), QString("R%1").arg(id));
            const auto spawned = spawnNow();
            QVERIFY2(spawned.has_value(), spawned ? "" : spawned.error().text().c_str());
            QCOMPARE(spawned->value, id);
            QCOMPARE(fleet_->robot({id})->view().spawn.robot_name, "R" + std::to_string(id));
        }
        QCOMPARE(added.size(), 50);
        const auto another = spawnNow();
        QVERIFY(!another.has_value());
        QCOMPARE(another.error().what, std::string("there can be no more than 50 robots"));

        QSignalSpy removed(fleet_.get(), &Fleet::robotRemoved);
        fleet_->remove({1});
        QCOMPARE(removed.at(0), (QVariantList{QVariant::fromValue(RobotId{1}), "R1", QVariant::fromValue(RobotId{2})}));
        const auto twin = spawnNow("R2");
        QVERIFY(!twin.has_value());
        QCOMPARE(twin.error().what, std::string("a robot already has this name"));
        QCOMPARE(spawnNow("Rex").value_or(RobotId{}).value, 1);
    }

    void linesGoWhereAConnectionIs() {
        QVERIFY(textOf(fleet_->checkLine(fleet_->connectionOf({}))).startsWith("There is no connection to send it on"));
        QVERIFY(connectNow());
        QVERIFY(fleet_->sendLine(fleet_->connectionOf({}), "GETGEO {Type Robot}", by::Other{"test"}));
        QTRY_COMPARE(server_->heardOf("GETGEO {Type Robot}").size(), 1);
    }

    void checksBeforeItStarts() {
        QVERIFY(textOf(fleet_->startBehavior({1}, "test/hop", small, {}, {})).startsWith("1: there is no such robot"));
        QVERIFY(connectNow());
        QCOMPARE(spawnNow().value_or(RobotId{}).value, 1);
        fleet_->setWorldExtent({{-10.0, -10.0}, {10.0, 10.0}});
        QVERIFY(textOf(fleet_->startAgain({1})).startsWith("1: no behavior has been started on it"));
        QVERIFY(textOf(fleet_->startBehavior({1}, "test/hip", small, {}, {})).contains("no loaded plugin"));
        QVERIFY(textOf(fleet_->startBehavior({1}, "test/hop", no_area, {}, {})).contains("it needs a mission area"));
        QVERIFY(
            textOf(fleet_->startBehavior({1}, "test/hop", {{10, 0}, {40, 2}}, {}, {})).contains("outside the world"));
        QVERIFY(textOf(fleet_->startBehavior({1}, "test/hop", small, {}, "none.lap")).contains("not run by a plan"));
        QVERIFY(!fleet_->robot({1})->started());
        QCOMPARE(textOf(fleet_->startBehavior({1}, "test/hop", small, {}, {})), QString());
        QVERIFY(fleet_->robot({1})->started());
        QVERIFY(textOf(fleet_->startAgain({1})).startsWith("R1: the robot is gone")); // it never came
    }

    void anAreaThatIsPartlyOutsideIsFlownWithAWarning() {
        QVERIFY(connectNow());
        QCOMPARE(spawnNow().value_or(RobotId{}).value, 1);
        fleet_->setWorldExtent({{-10.0, -10.0}, {10.0, 10.0}});
        QSignalSpy noticed(fleet_.get(), &Fleet::noticed);
        QCOMPARE(textOf(fleet_->startBehavior({1}, "test/hop", {{0, 0}, {40, 2}}, {}, {})), QString());
        QVERIFY(fleet_->robot({1})->started());
        const auto said = std::ranges::find_if(noticed, [](const auto& told) { return told[0] == "mission-1/area"; });
        QVERIFY(said != noticed.end());
        const auto notice = (*said)[1].value<Notice>();
        QVERIFY(notice.severity == Severity::Warning && notice.text.starts_with("75 % of the mission area"));
    }

    void leavingTheServerIsToldInOrder() {
        QVERIFY(connectNow());
        QCOMPARE(spawnNow().value_or(RobotId{}).value, 1);
        QStringList told;
        connect(fleet_.get(), &Fleet::robotRemoved, this, [&] { told << "robot"; });
        connect(fleet_.get(), &Fleet::serverLeft, this, [&] { told << "server"; });
        connect(fleet_.get(), &Fleet::linkChanged, this, [&] { told << "link"; });
        fleet_->disconnectFromServer();
        QCOMPARE(told, (QStringList{"robot", "server", "link"}));
        QVERIFY(fleet_->robots().empty() && fleet_->startPoses().empty() && fleet_->level().isEmpty());
        QVERIFY(!fleet_->connectionOf({}).valid());
    }

    void aWindowsResultHasTheKeysOfARunWithoutOne() {
        server_->answers_init = true;
        speakToTheRobot();
        QVERIFY(connectNow());
        fleet_->setSeed(7);
        QCOMPARE(spawnNow().value_or(RobotId{}).value, 1);
        QTRY_VERIFY(fleet_->robot({1})->view().figures.spawned);
        fleet_->setTruth("R1", {.collisions = 3, .distance_m = 9.8765});
        fleet_->setTruth("R2", {.collisions = 5});
        fleet_->setTruthMaker([] {
            const auto level = [](const Vec2&) { return 0.0; };
            return Truth{level, level};
        });
        QVERIFY(fleet_->startBehavior({1}, "test/hop", small, {}, {}));
        QSignalSpy written(fleet_.get(), &Fleet::resultsWritten);
        const auto over = [&] { return fleet_->robot({1})->view().finished.has_value(); };
        QVERIFY(QTest::qWaitFor([&] {
            if (!over())
                server_->tick();
            return over();
        }));
        QTRY_COMPARE(written.size(), 1);
        QTRY_VERIFY(!fleet_->anythingToSave());
        QCOMPARE(written.front().at(2).toString(), QString("R1"));

        const QStringList files = QDir(folder_->path()).entryList({"*.json"});
        QCOMPARE(files.size(), 1);
        const QJsonObject summary = objectIn(folder_->filePath(files.front()));
        QStringList keys = toJson(RunSummary{}).keys() + QStringList{"map", "marks"};
        keys.sort();
        QCOMPARE(summary.keys(), keys);
        QVERIFY(summary["success"].toBool());
        QCOMPARE(summary["reason"].toString(), QString("Hopped enough."));
        QCOMPARE(summary["behavior"].toString(), QString("test/hop"));
        QCOMPARE(summary["distance_m"].toDouble(), 5.0);
        QCOMPARE(summary["charges"].toInt(), 1);
        QCOMPARE(summary["seed"].toInt(), 7);
        QCOMPARE(summary["collisions"].toInt(), 3);
        QVERIFY(summary["rmse_m"].isDouble());
        const auto told = written.front().at(1).value<RunSummary>();
        QCOMPARE(told.files.size(), summary["files"].toArray().size());
        QVERIFY(told.heights.has_value());
        QCOMPARE(summary["true_distance_m"].toDouble(), 9.88);
        QVERIFY(summary["cells"].toInt() > 0);
        QVERIFY(summary["wall_s"].toDouble() > 0.0);
        QVERIFY(summary["mission"].isNull() && summary["plan"].isNull());
        const double shown_pct = fleet_->robot({1})->coverage_pct().value();
        QVERIFY(shown_pct > 0.0);
        QCOMPARE(summary["coverage_pct"].toDouble(), std::round(shown_pct * 100.0) / 100.0);
    }

    void aStopTakesBackAStartThatWaitsForItsRobot() {
        server_->on_command = [this](const QByteArray& line) {
            if (line.startsWith("INIT"))
                server_->keepClient(); // The connection that comes next has no robot.
        };
        QVERIFY(connectNow());
        QCOMPARE(spawnNow().value_or(RobotId{}).value, 1);
        QCOMPARE(textOf(fleet_->startBehavior({1}, "test/hop", small, {}, {})), QString());
        fleet_->robot({1})->stop();
        QTRY_COMPARE(server_->heardOf("INIT").size(), 1);
        server_->tick();
        QTRY_VERIFY(fleet_->robot({1})->view().figures.spawned);
        QVERIFY(!fleet_->robot({1})->view().figures.behavior_running);
    }

    void aCancelledSaveIsToldAndTheScanIsKept() {
        server_->answers_init = true;
        QVERIFY(connectNow());
        QCOMPARE(spawnNow().value_or(RobotId{}).value, 1);
        QTRY_VERIFY(fleet_->robot({1})->view().figures.spawned);
        QLockFile other(folder_->filePath(".usar_scan.lock")); // Another program saves, so this takes long.
        QVERIFY(other.lock());
        QSignalSpy saving(fleet_.get(), &Fleet::savingChanged), written(fleet_.get(), &Fleet::resultsWritten);
        QSignalSpy failed(fleet_.get(), &Fleet::exportFailed), noticed(fleet_.get(), &Fleet::noticed);
        fleet_->exportResults({1});
        QTRY_COMPARE(saving.size(), 1);
        QCOMPARE(saving[0][0].toString(), QString("R1"));
        fleet_->cancelSaving();
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY2(failed[0][1].toString().contains("cancelled"), qPrintable(failed[0][1].toString()));
        const auto said = std::ranges::find_if(noticed, [](const auto& told) { return told[0] == "export"; });
        QVERIFY(said != noticed.end() && (*said)[1].value<Notice>().severity == Severity::Note);
        QCOMPARE(saving.last()[0].toString(), QString());
        QVERIFY(fleet_->robot({1})->view().unsaved);
        QVERIFY(QDir(folder_->path()).entryList(QDir::Files).isEmpty());
        QVERIFY(written.empty());
        other.unlock();
        fleet_->exportResults({1}); // The next save is not cancelled.
        QTRY_VERIFY(!QDir(folder_->path()).entryList({"*.json"}).isEmpty());
    }

    void anExportIsToldAlsoIfItFailsOrIsCancelled_data() {
        QTest::addColumn<bool>("cancels");
        QTest::addColumn<QString>("words");
        QTest::newRow("nothing was scanned") << false << "nothing was scanned";
        QTest::newRow("cancelled while another program saves") << true << "cancelled";
    }

    void anExportIsToldAlsoIfItFailsOrIsCancelled() {
        QFETCH(bool, cancels);
        QFETCH(QString, words);
        server_->answers_init = true;
        speakToTheRobot();
        QVERIFY(connectNow());
        QCOMPARE(spawnNow().value_or(RobotId{}).value, 1);
        QTRY_VERIFY(fleet_->robot({1})->view().figures.spawned);
        if (cancels) {
            QCOMPARE(textOf(fleet_->startBehavior({1}, "test/hop", small, {}, {})), QString());
            QVERIFY(QTest::qWaitFor([&] {
                server_->tick();
                return !fleet_->robot({1})->view().tiles.empty();
            }));
            QVERIFY(fleet_->robot({1})->running()); // Its end would be saved, too.
        }
        QLockFile other(folder_->filePath(".usar_scan.lock"));
        QVERIFY(!cancels || other.lock());
        QSignalSpy saving(fleet_.get(), &Fleet::savingChanged), noticed(fleet_.get(), &Fleet::noticed);
        fleet_->exportMap({1}, *readFormatList("tif", {}), folder_->path());
        QVERIFY(fleet_->anythingToSave()); // The window must not close before.
        QTRY_VERIFY(!saving.empty());
        if (cancels)
            fleet_->cancelSaving();
        const auto told = [&] {
            return std::ranges::find_if(noticed, [](const auto& one) { return one[0] == "map_export"; });
        };
        QTRY_VERIFY(told() != noticed.end());
        const auto notice = (*told())[1].value<Notice>();
        QVERIFY2(QString::fromStdString(notice.text).contains(words), notice.text.c_str());
        QCOMPARE(notice.severity, cancels ? Severity::Note : Severity::Error);
        QTRY_COMPARE(saving.last()[0].toString(), QString());
        QVERIFY(QDir(folder_->path()).entryList({"*.tif"}).isEmpty());
    }

    void withNothingToSaveItClosesAtOnce() {
        QSignalSpy ready(fleet_.get(), &Fleet::readyToClose);
        fleet_->prepareToClose();
        QCOMPARE(ready.size(), 1);
        QVERIFY(fleet_->closing());
        fleet_->stayOpen();
        QVERIFY(!fleet_->closing());
    }

private:
    /// The robot's connection is the one to speak to, whichever came last.
    void speakToTheRobot() {
        server_->on_line = [this, obey = server_->on_line](const QByteArray& line) {
            if (line.startsWith("INIT"))
                server_->keepClient();
            obey(line);
        };
    }

    bool connectNow() {
        fleet_->openLink("127.0.0.1", server_->port(), false);
        return QTest::qWaitFor([&] { return !fleet_->startPoses().empty(); });
    }

    /// When the connection that waits is there.
    Result<RobotId> spawnNow(const std::string& name = {}) {
        if (!QTest::qWaitFor([&] { return fleet_->checkLine(fleet_->connectionOf({})).has_value(); }))
            return failure("no connection waits", name);
        return fleet_->spawn({.class_name = "USARBot.AirRobot", .robot_name = name, .start_in_map = {}});
    }

    static QString textOf(const Result<void>& result) {
        return result ? QString() : QString::fromStdString(result.error().text());
    }

    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<FakeRobotServer> server_;
    std::unique_ptr<Fleet> fleet_;
};

USAR_TEST(tst_Fleet)

} // namespace tst_fleet

#include "tst_fleet.moc"
