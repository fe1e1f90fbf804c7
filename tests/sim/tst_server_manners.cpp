#include <algorithm>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/base/random.h"
#include "tests/protocol/corpus.h"
#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_server_manners {

using namespace usar;
using namespace usar::sim;

namespace {} // namespace

/// What anybody may say to the server, and what it does to the others: nothing.
class tst_ServerManners : public QObject {
    Q_OBJECT

private slots:
    void everyCommandOfTheCorpusIsAcceptedOrIgnored_data() {
        QTest::addColumn<QString>("init");
        QTest::newRow("P2DX") << init_p2dx;
        QTest::newRow("AirRobot") << "INIT {ClassName AirRobot} {Location 0,0,-3}";
        QTest::newRow("ERS") << "INIT {ClassName ERS} {Location 0,0,-0.3}";
        QTest::newRow("Sedan") << "INIT {ClassName Sedan} {Location 0,0,-0.6}";
        QTest::newRow("Submarine") << "INIT {ClassName Submarine} {Location 0,0,-25}";
        QTest::newRow("world controller") << "INIT {ClassName WorldController} {Name WC}";
        QTest::newRow("nothing yet") << "";
    }
    void everyCommandOfTheCorpusIsAcceptedOrIgnored() {
        QFETCH(QString, init);
        const auto simulation = simulationOf(init.contains("Submarine") ? lake() : flatWorld());
        Talker talker(*simulation);
        if (!init.isEmpty())
            talker.say(init.toStdString());
        steps(*simulation, 3);
        const std::size_t robots = simulation->robots().size();
        int said = 0;
        for (const corpus::Line& line : corpus::commandLines()) {
            if (line.source.find("50000") != std::string::npos ||
                QString::fromStdString(line.text).startsWith("INIT", Qt::CaseInsensitive))
                continue; // another port's, or a second robot
            talker.say(line.text);
            simulation->step();
            ++said;
            for (const protocol::InfoLine& answer : talker.hear())
                QVERIFY2(answer.diagnostics.empty(), (line.place + ": " + answer.text).c_str());
        }
        QVERIFY(said > 20);
        QCOMPARE(simulation->robots().size(), robots);
        for (const RobotTruth& truth : simulation->robots())
            QVERIFY(truth.base_in_map.position_m.allFinite());
        talker.say("GETSTARTPOSES");
        QVERIFY(talker.hearLast<protocol::StartPoses>());
    }

    void everyInitOfTheCorpusSpawnsOrIsRefused() {
        for (const corpus::Line& line : corpus::commandLines()) {
            if (!line.text.starts_with("INIT {Class"))
                continue;
            const auto simulation = simulationOf(flatWorld());
            Talker talker(*simulation);
            talker.hearText();
            talker.say(line.text);
            steps(*simulation, 3);
            const std::vector<std::string> heard = talker.hearText();
            for (const std::string& one : heard)
                if (simulation->robots().empty())
                    QVERIFY2(one.starts_with("RES ") && one.ends_with("{Status Failed}"), line.place.c_str());
            QVERIFY2(!heard.empty() || simulation->robots().empty(), line.place.c_str());
        }
    }

    void aClientThatSendsGarbageChangesNothingForTheOthers_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("random bytes") << 0;
        QTest::newRow("a line without end") << 1;
        QTest::newRow("half commands") << 2;
        QTest::newRow("a flood of commands without a robot") << 3;
        QTest::newRow("comes and goes") << 4;
        QTest::newRow("never reads") << 5;
    }
    void aClientThatSendsGarbageChangesNothingForTheOthers() {
        QFETCH(int, kind);
        const auto alone = simulationOf(flatWorld());
        const std::string expected = heardBy(*alone, init_p2dx, 60);
        const auto shared = simulationOf(flatWorld());
        Random random = seeded(5, static_cast<std::uint64_t>(kind));
        std::optional<ClientId> other;
        const std::string heard = heardBy(*shared, init_p2dx, 60, [&](int) {
            if (!other)
                other = shared->connect();
            std::string bytes;
            switch (kind) {
            case 0:
                for (int i = 0; i < 20000; ++i)
                    bytes += static_cast<char>(random());
                break;
            case 1:
                bytes = std::string(200000, 'x');
                break;
            case 2:
                bytes = "DRIVE {Left 1\r\nINIT {ClassN\r\n{{{{}}}\r\nSET {Type";
                break;
            case 3:
                for (int i = 0; i < 2000; ++i)
                    bytes += "DRIVE {Left 1} {Right 1}\r\n";
                break;
            case 4:
                shared->disconnect(*other);
                other = shared->connect();
                bytes = "GETSTARTPOSES\r\n";
                break;
            default:
                bytes = "GETSTARTPOSES\r\n";
            }
            shared->receive(*other, bytes);
        });
        QVERIFY(heard == expected);
        QVERIFY(expected.size() > 50'000);
    }

    void sixteenRobotsAndMoreLiveTogether() {
        const auto simulation = simulationOf(flatWorld());
        std::vector<Talker> talkers;
        const char* const classes[] = {"P2DX", "AirRobot", "ERS", "P2AT"};
        for (int i = 0; i < 20; ++i)
            talkers.emplace_back(*simulation)
                .say("INIT {ClassName " + std::string(classes[i % 4]) + "} {Name R" + std::to_string(i) +
                     "} {Location " + std::to_string(4 * (i % 5) - 8) + "," + std::to_string(4 * (i / 5) - 8) +
                     ",-0.4}");
        steps(*simulation, 10);
        QCOMPARE(simulation->robots().size(), std::size_t(20));
        for (Talker& talker : talkers)
            QVERIFY(talker.hearLast<protocol::RobotState>());
    }
};

USAR_TEST(tst_ServerManners)

} // namespace tst_server_manners

#include "tst_server_manners.moc"
