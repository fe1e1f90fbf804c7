// The robot of one connection, by a clock of the test.
#include <QTest>

#include "tests/mission/session/session_parts.h"
#include "tests/suite/suite.h"

namespace tst_spawn_life {

using namespace usar;
using namespace usar::mission;

namespace {

using Texts = std::vector<std::string>;

struct Life : test::NoticeBook {
    Life() { spawn.beginConnection(); }
    void ask(const std::string& name = "R1", Seconds wall = Seconds{10.0}) {
        spawn.ask({.robot_name = name, .start_in_map = {}}, true, wall);
    }

    test::SpawnScribe scribe;
    SpawnLife spawn{scribe, notices};
};

} // namespace

class tst_SpawnLife : public QObject {
    Q_OBJECT
private slots:
    void aRobotIsThereAsSoonAsItSpeaks() {
        Life life;
        QVERIFY(!life.spawn.standingInit());
        life.ask();
        QCOMPARE(life.spawn.state(), SpawnState::Asked);
        QCOMPARE(life.scribe.inits, Texts{"R1"});
        QVERIFY(life.spawn.standingInit());
        life.spawn.heard();
        life.spawn.heard();
        QVERIFY(life.spawn.done());
        QCOMPARE(life.scribe.came, Texts{"R1"});
        QVERIFY(life.said.empty());
    }

    void withoutAConnectionNothingIsAsked() {
        Life life;
        life.spawn.ask({.start_in_map = {}}, false, Seconds{0.0});
        QVERIFY(life.scribe.inits.empty());
        QVERIFY(life.saidWords("There is no connection to spawn R1 on. Connect first."));
        life.spawn.connected(Seconds{1.0});
        QCOMPARE(life.topics(), (Texts{"no connection", "-no connection"}));
        QVERIFY(life.scribe.inits.empty()); // nobody waits for it any more
    }

    void aConnectionCarriesOneRobot() {
        Life life;
        life.ask("R1");
        life.ask("R2");
        QVERIFY(life.saidWords("R1 is being spawned here already"));
        life.spawn.heard();
        life.ask("R2");
        QVERIFY(life.saidWords("R1 is spawned here already"));
        QCOMPARE(life.scribe.inits, Texts{"R1"});
    }

    void aNameThatNoLineCarriesFailsAtOnce() {
        Life life;
        life.ask("a}b");
        QVERIFY(life.scribe.inits.empty());
        QCOMPARE(life.spawn.state(), SpawnState::None);
        QCOMPARE(life.topics(), Texts{"spawn"});
        QCOMPARE(life.scribe.failures.size(), std::size_t(1));
    }

    void aStationIsThereAtOnce() {
        Life life;
        life.spawn.ask({.class_name = "USARBot.ComStation", .robot_name = "Base", .start_in_map = {}}, true,
                       Seconds{0.0});
        QVERIFY(life.spawn.done() && life.spawn.isStation());
        QCOMPARE(life.scribe.came, Texts{"Base"});
    }

    void silenceAfterInitIsAFailure() {
        Life life;
        life.spawn.look(Seconds{1000.0}, Seconds{5.0});
        life.ask("R1", Seconds{10.0});
        life.spawn.look(Seconds{15.0}, Seconds{5.0});
        QCOMPARE(life.spawn.state(), SpawnState::Asked);
        life.spawn.look(Seconds{15.1}, Seconds{5.0});
        life.spawn.look(Seconds{16.0}, Seconds{5.0});
        QCOMPARE(life.spawn.state(), SpawnState::Failed);
        QVERIFY(!life.spawn.standingInit());
        QCOMPARE(life.topics(), Texts{"spawn"});
        QVERIFY(
            life.saidWords("Nothing from R1 for 5 s after INIT. Does the server know USARBot.AirRobot, is the start "
                           "pose free and above the ground, and is the simulation running? Spawn again to try once "
                           "more."));
    }

    void aRefusalIsAFailureAtOnce() {
        Life life;
        life.spawn.answered({.type = "Init", .name = "R1"}); // nothing was asked
        life.ask("R1");
        life.spawn.answered({.type = "Camera", .name = "R1"});
        life.spawn.answered({.type = "Init", .name = "R1", .ok = true});
        QCOMPARE(life.spawn.state(), SpawnState::Asked);
        life.spawn.answered({.type = "Init", .name = "R1"});
        QCOMPARE(life.spawn.state(), SpawnState::Failed);
        QCOMPARE(life.topics(), Texts{"spawn"});
        QVERIFY(life.saidWords("The server refused to spawn R1. Does it know USARBot.AirRobot, and is the start pose "
                               "free and above the ground? Its log says what was wrong. Choose another start pose, and "
                               "spawn again."));
    }

    void aLateRobotEndsTheFailure() {
        Life life;
        life.ask("R1", Seconds{0.0});
        life.spawn.look(Seconds{6.0}, Seconds{5.0});
        life.spawn.heard();
        QVERIFY(life.spawn.done());
        QCOMPARE(life.topics(), (Texts{"spawn", "-spawn"}));
        QVERIFY(life.saidWords("R1 has spawned after all."));
    }

    void afterAFailureANewConnectionIsNeeded() {
        Life life;
        life.ask("R1", Seconds{0.0});
        life.spawn.look(Seconds{6.0}, Seconds{5.0});
        life.ask("R2", Seconds{7.0});
        QCOMPARE(life.scribe.reconnects, 1);
        QCOMPARE(life.scribe.inits, Texts{"R1"});
        const SpawnState lost = life.spawn.loseConnection();
        QCOMPARE(life.spawn.state(), SpawnState::Asked);
        life.spawn.reportLoss(lost);
        life.spawn.reportRefusal(lost);
        life.spawn.beginConnection();
        life.spawn.connected(Seconds{8.0});
        QCOMPARE(life.scribe.inits, (Texts{"R1", "R2"}));
        QCOMPARE(life.spawn.robotName(), std::string("R2"));
        QCOMPARE(life.scribe.failures.size(), std::size_t(1)); // the silence only
        life.spawn.look(Seconds{12.0}, Seconds{5.0});          // counts from the newest INIT
        QCOMPARE(life.spawn.state(), SpawnState::Asked);
    }

    void dataOfSomebodyElseIsNoRobotOfOurs() {
        Life life;
        life.spawn.heard();
        QCOMPARE(life.spawn.state(), SpawnState::None);
        QVERIFY(life.scribe.came.empty());
    }

    void aRobotIsLostWithItsConnection() {
        Life life;
        life.ask();
        life.spawn.heard();
        const SpawnState lost = life.spawn.loseConnection();
        QCOMPARE(life.spawn.state(), SpawnState::None);
        life.spawn.reportLoss(lost);
        life.spawn.reportRefusal(lost);
        QVERIFY(life.scribe.failures.empty());
        QVERIFY(life.saidWords("The connection is lost, and R1 with it."));
        life.spawn.beginConnection();
        life.spawn.connected(Seconds{20.0});
        QCOMPARE(life.topics(), (Texts{"link", "-link"}));
        QVERIFY(life.saidWords("Spawn R1 again to continue."));
        QCOMPARE(life.scribe.inits, Texts{"R1"}); // on request only
    }

    void aServerThatHangsUpRefuses() {
        Life life;
        life.ask();
        const SpawnState lost = life.spawn.loseConnection();
        life.spawn.reportLoss(lost);
        life.spawn.reportRefusal(lost);
        QCOMPARE(life.spawn.state(), SpawnState::None);
        QCOMPARE(life.scribe.failures.size(), std::size_t(1));
        QVERIFY(life.saidWords("The server closed the connection before R1 sent anything."));
    }

    void theFirstTimeWithARobotCounts() {
        Life life;
        const auto spawnedAt = [&life] {
            SessionFigures figures;
            life.spawn.describe(figures);
            return figures.spawned_at.count();
        };
        life.spawn.passed(Seconds{3.0});
        life.ask();
        life.spawn.passed(Seconds{4.0});
        QCOMPARE(spawnedAt(), 0.0);
        life.spawn.heard();
        life.spawn.passed(Seconds{0.0}); // the clock is not known yet
        life.spawn.passed(Seconds{5.0});
        life.spawn.passed(Seconds{6.0});
        QCOMPARE(spawnedAt(), 5.0);
        life.spawn.beginConnection();
        QCOMPARE(spawnedAt(), 0.0);
    }

    void aReplayedInitIsFollowedByARobot() {
        Life life;
        life.spawn.sawInit(protocol::Init{"USARBot.P2DX", "R7"});
        QCOMPARE(life.spawn.state(), SpawnState::Asked);
        QCOMPARE(life.spawn.standingInit()->class_name.text(), std::string("USARBot.P2DX"));
        QVERIFY(life.scribe.inits.empty());
        life.spawn.heard();
        QCOMPARE(life.scribe.came, Texts{"R7"});
    }
};

USAR_TEST(tst_SpawnLife)

} // namespace tst_spawn_life

#include "tst_spawn_life.moc"
