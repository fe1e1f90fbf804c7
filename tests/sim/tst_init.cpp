// INIT: the names that robots get, the classes that clients send, and starts that are refused.
#include <QObject>
#include <QString>
#include <QTest>

#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_init {

using namespace usar;
using namespace usar::sim;

namespace {

/// Level ground of 64 m, under a ceiling at 3 m.
World hall() {
    World world = flatWorld();
    world.boxes.push_back({.center_in_map = {.position_m = {0.0, 0.0, 3.25}}, .size_m = {64.0, 64.0, 0.5}});
    return world;
}

QStringList namesIn(const Simulation& simulation) {
    QStringList names;
    for (const RobotTruth& robot : simulation.robots())
        names << QString::fromStdString(robot.name);
    return names;
}

QString logOf(Simulation& simulation) {
    QStringList lines;
    for (const std::string& line : simulation.takeLog())
        lines << QString::fromStdString(line);
    return lines.join('\n');
}

} // namespace

class tst_Init : public QObject {
    Q_OBJECT

private slots:
    void everyRobotHasANameOfItsOwn_data() {
        QTest::addColumn<QStringList>("wanted");
        QTest::addColumn<QStringList>("got");
        QTest::addColumn<QString>("said");
        QTest::newRow("different ones") << QStringList{"R1", "R2"} << QStringList{"R1", "R2"} << "";
        QTest::newRow("none") << QStringList{"", ""} << QStringList{"P2DX_1", "P2DX_2"}
                              << "spawned USARBot.P2DX 'P2DX_1'; it is called so because INIT has no Name";
        QTest::newRow("one that is taken, in another case")
            << QStringList{"R1", "r1", "R1"} << QStringList{"R1", "r1_2", "R1_3"}
            << "spawned USARBot.P2DX 'r1_2'; it is called so because there is a 'r1' already";
        QTest::newRow("one that was invented") << QStringList{"P2DX_1", ""} << QStringList{"P2DX_1", "P2DX_2"} << "";
    }
    void everyRobotHasANameOfItsOwn() {
        QFETCH(const QStringList, wanted);
        QFETCH(const QStringList, got);
        QFETCH(const QString, said);
        const auto simulation = simulationOf(flatWorld());
        std::vector<Talker> talkers;
        for (int i = 0; i < wanted.size(); ++i) {
            talkers.emplace_back(*simulation);
            const QString name = wanted[i].isEmpty() ? "" : " {Name " + wanted[i] + "}";
            talkers.back().say(
                QString("INIT {ClassName USARBot.P2DX}%1 {Location %2,0,-0.2}").arg(name).arg(4 * i).toStdString());
        }
        steps(*simulation, 2);
        QCOMPARE(namesIn(*simulation), got);
        const QString log = logOf(*simulation);
        QVERIFY2(log.contains(said), qPrintable(log));
        QCOMPARE(log.count('\n') + 1, wanted.size());
    }

    void stationsShareTheNamesOfRobots_data() {
        QTest::addColumn<QStringList>("classes");
        QTest::addColumn<QStringList>("got");
        QTest::newRow("two stations") << QStringList{"ComStation", "ComStation"} << QStringList{"A", "A_2"};
        QTest::newRow("a station after a robot") << QStringList{"P2DX", "ComStation"} << QStringList{"A", "A_2"};
        QTest::newRow("a robot after a station") << QStringList{"ComStation", "P2DX"} << QStringList{"A", "A_2"};
    }
    void stationsShareTheNamesOfRobots() {
        QFETCH(const QStringList, classes);
        QFETCH(const QStringList, got);
        const auto simulation = simulationOf(flatWorld());
        std::vector<Talker> talkers;
        for (const QString& one : classes) {
            talkers.emplace_back(*simulation);
            talkers.back().say(("INIT {ClassName USARBot." + one + "} {Name A} {Location 0,0,-0.2}").toStdString());
        }
        steps(*simulation, 2);
        QStringList names;
        for (const RadioStation& radio : simulation->radios())
            names << QString::fromStdString(radio.name);
        QCOMPARE(names, got);
        QVERIFY(logOf(*simulation).contains("'A_2'"));
    }

    void aRefusedInitIsAnsweredWithWhatItWanted_data() {
        QTest::addColumn<QString>("segments");
        QTest::addColumn<QString>("name");
        QTest::newRow("a class") << "{ClassName USARBot.P2DX} {Name R1} {Location nan,0,0}"
                                 << "USARBot.P2DX";
        QTest::newRow("no class") << "{Name R1} {Location 0,0,-1}"
                                  << "R1";
        QTest::newRow("too high") << "{ClassName USARBot.P2DX} {Name R1} {Location 0,0,-1e300}"
                                  << "USARBot.P2DX";
    }
    void aRefusedInitIsAnsweredWithWhatItWanted() {
        QFETCH(const QString, segments);
        QFETCH(const QString, name);
        const auto simulation = simulationOf(flatWorld());
        Talker talker(*simulation);
        talker.hearText();
        talker.say("INIT " + segments.toStdString());
        steps(*simulation, 1);
        const auto answers = talker.hearText();
        QCOMPARE(answers.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(answers[0]), "RES {Time 0.00} {Type Init} {Name " + name + "} {Status Failed}");
    }

    void aRobotBesideItsPlaceIsToldWhatIsThere_data() {
        QTest::addColumn<QString>("thing");
        QTest::addColumn<QString>("said");
        QTest::newRow("a robot") << ""
                                 << "beside the wanted place, where robot 'First' is";
        QTest::newRow("a crate") << "CONTROL {Type Create} {ClassName Crate} {Name C1} {Location 5,5,-0.5}"
                                 << "beside the wanted place, where 'C1' is";
    }
    void aRobotBesideItsPlaceIsToldWhatIsThere() {
        QFETCH(const QString, thing);
        QFETCH(const QString, said);
        const auto simulation = simulationOf(flatWorld());
        Talker first(*simulation);
        first.say("INIT {ClassName USARBot.P2DX} {Name First} {Location 0,0,-0.2}");
        Talker controller(*simulation);
        controller.say("INIT {ClassName WorldController} {Name WC}");
        controller.say(thing.toStdString());
        steps(*simulation, 5);
        Talker second(*simulation);
        second.say(std::string("INIT {ClassName USARBot.P2DX} {Name Second} {Location ") +
                   (thing.isEmpty() ? "0,0,-0.2}" : "5,5,-0.2}"));
        steps(*simulation, 2);
        const QString log = logOf(*simulation);
        QVERIFY2(log.contains(said), qPrintable(log));
    }

    void stationsFarFromTheWorldAreRefused_data() {
        QTest::addColumn<QString>("place");
        QTest::addColumn<bool>("refused");
        QTest::newRow("in it") << "1,2,-3" << false;
        QTest::newRow("beside it") << "100,0,-1" << false;
        QTest::newRow("far beside it") << "0,2000,-1" << true;
        QTest::newRow("in the sky") << "0,0,-20000" << true;
        QTest::newRow("beyond any number") << "0,0,-1e300" << true;
    }
    void stationsFarFromTheWorldAreRefused() {
        QFETCH(const QString, place);
        QFETCH(const bool, refused);
        const auto simulation = simulationOf(flatWorld());
        Talker station(*simulation);
        station.say("INIT {ClassName USARBot.ComStation} {Name Base} {Location " + place.toStdString() + "}");
        steps(*simulation, 1);
        QCOMPARE(simulation->radios().empty(), refused);
        QCOMPARE(logOf(*simulation).isEmpty(), !refused);
    }

    void clientsOfTheYearsGetARobot_data() {
        QTest::addColumn<QString>("robot");
        QTest::newRow("Kurt3D") << "P2AT";
        QTest::newRow("USARBot.p3at") << "P3AT";
        QTest::newRow("USARBot.P3DX") << "P2DX";
        QTest::newRow("USARBot.QuadRotor") << "AirRobot";
        QTest::newRow("USARBot.BasicAckermanRobot") << "Sedan";
    }
    void clientsOfTheYearsGetARobot() {
        QFETCH(const QString, robot);
        const auto simulation = simulationOf(flatWorld());
        Talker talker(*simulation);
        talker.say("INIT {ClassName " + std::string(QTest::currentDataTag()) + "} {Name R1} {Location 0,0,-0.6}");
        steps(*simulation, 2);
        talker.hearText();
        talker.say("GETCONF {Type Robot}");
        steps(*simulation, 1);
        QVERIFY(QString::fromStdString(talker.hearText().at(0)).contains("{Name " + robot + "}"));
    }

    void startsThatCannotBeAreRefusedInOneLine_data() {
        QTest::addColumn<World>("world");
        QTest::addColumn<QString>("place");
        QTest::addColumn<QString>("said");
        const QString not_numbers = "Location and Rotation must be numbers";
        for (const char* const pose :
             {"{Location nan,0,-1}", "{Location 0, -inf ,0}", "{Location 0,0,1e400}",
              "{Location 0,0,-1} {Rotation 0,0,-1.#IND}", "{Rotation nan,0,0}", "{Location nan 0 -1}",
              "{Rotation 0 0 nan}", "{Start Nowhere} {Location inf,3,-1}", "{Location 0,0,-1e300}"})
            QTest::newRow(pose) << flatWorld() << pose << not_numbers;
        QTest::newRow("beside the world")
            << flatWorld() << "{Location 40,0,-1}"
            << "refused the start of 'R1': it is beside the world, which reaches from -32.00,-32.00 to 32.00,32.00 m";
        for (const char* const height : {"{Location 0,0,-2000}", "{Location 0,0,-1e14}", "{Location 0,0,2000}"})
            QTest::newRow(height) << flatWorld() << height
                                  << "refused the start of 'R1': it is more than 1 km above or below the world";
        QTest::newRow("under the ceiling, where it has no room but above") << hall() << "{Location 0,0,-2.97}"
                                                                           << "no room to spawn a robot there";
        QTest::newRow("over the ceiling") << hall() << "{Location 0,0,-5}"
                                          << "refused the start of 'R1': it is above the ceiling";
        QTest::newRow("under the ground") << flatWorld() << "{Location 0,0,3}"
                                          << "no room to spawn a robot there";
    }
    void startsThatCannotBeAreRefusedInOneLine() {
        QFETCH(const World, world);
        QFETCH(const QString, place);
        QFETCH(const QString, said);
        const auto simulation = simulationOf(world);
        Talker talker(*simulation);
        talker.say("INIT {ClassName USARBot.P2DX} {Name R1} " + place.toStdString());
        steps(*simulation, 3);
        const QString log = logOf(*simulation);
        QVERIFY2(namesIn(*simulation).isEmpty(), qPrintable(log));
        QVERIFY2(log.contains(said), qPrintable(log));
        QCOMPARE(log.count('\n'), 0);
        for (const RobotTruth& robot : simulation->robots())
            QVERIFY(robot.base_in_map.position_m.allFinite());
        talker.say("INIT {ClassName USARBot.P2DX} {Name R1} {Location 0,0,-0.3}");
        steps(*simulation, 2);
        QCOMPARE(simulation->robots().size(), std::size_t(1)); // the client may try again
    }
};

USAR_TEST(tst_Init)

} // namespace tst_init

#include "tst_init.moc"
