#include <QObject>
#include <QString>
#include <QTest>

#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_world_controller {

using namespace usar;
using namespace usar::sim;

namespace {

/// A world, and a world controller's connection.
struct Controlled {
    std::unique_ptr<Simulation> simulation;
    Talker talker;

    explicit Controlled(World world = flatWorld()) : simulation(simulationOf(std::move(world))), talker(*simulation) {
        talker.hearText();
        talker.say("INIT {ClassName USARBot.WorldController} {Name WC}");
    }
    void steps(int count) {
        for (int i = 0; i < count; ++i)
            simulation->step();
    }
    std::vector<protocol::WorldObject> states(const std::string& which = {}) {
        talker.hearText();
        talker.say("CONTROL {Type GetSTA}" + which);
        simulation->step();
        const auto found = talker.hearLast<protocol::WorldObjects>();
        return found ? found->objects : std::vector<protocol::WorldObject>();
    }
    bool logged(const char* words) {
        for (const std::string& sentence : simulation->takeLog())
            if (sentence.find(words) != std::string::npos)
                return true;
        return false;
    }
};

} // namespace

class tst_WorldController : public QObject {
    Q_OBJECT

private slots:
    void createsThingsThatFallAndRest() {
        Controlled world;
        world.talker.say("CONTROL {Type Create} {ClassName USARModels.Box} {Name B1} {Location 2,-3,-2} {Memory left "
                         "here}");
        world.steps(20);
        const auto states = world.states();
        QCOMPARE(states.size(), std::size_t(1));
        QCOMPARE(states[0].name, std::string("B1"));
        const Vec3 at_m = states[0].object_in_map.position_m;
        QVERIFY2((at_m - Vec3(2, 3, 0.25)).norm() < 0.1 && std::abs(at_m.z() - 0.25) < 0.01,
                 qPrintable(QString("%1 %2 %3").arg(at_m.x()).arg(at_m.y()).arg(at_m.z())));
        QVERIFY(states[0].size_m && (*states[0].size_m - Vec3(0.5, 0.5, 0.5)).norm() < 0.02);
        QCOMPARE(states[0].memory, std::string("left here"));
    }

    void whatTheWorldBeganWithComesBackAsItWas() {
        World meadow = flatWorld();
        BodyDescription statue;
        statue.mass_kg = 40.0;
        statue.parts = {{CylinderShape{0.2, 1.4}, Pose{}}, {SphereShape{0.15}, Pose{.position_m = {0.0, 0.0, 0.8}}}};
        BodyDescription ball;
        ball.parts = {{SphereShape{0.5}, Pose{}}};
        meadow.objects = {{"Venus", "Mine.Statue", statue, Pose{.position_m = {3.0, 1.0, 0.7}}},
                          {"Big", "USARModels.Ball", ball, Pose{.position_m = {-3.0, 1.0, 0.5}}}};
        Controlled world(meadow);
        const auto sizeOf = [&](const char* which) {
            const auto states = world.states(which);
            return states.size() == 1 && states[0].size_m ? *states[0].size_m : Vec3(Vec3::Zero());
        };
        const Vec3 was_m = sizeOf(" {ClassName Statue}");
        QVERIFY(was_m.z() > 1.4);
        world.talker.say("CONTROL {Type KillAll}");
        QVERIFY(world.states().empty());
        world.talker.say("CONTROL {Type Create} {ClassName Mine.Statue} {Name Venus} {Location 3,-1,-0.7}");
        world.talker.say("CONTROL {Type Create} {ClassName USARModels.Ball} {Name Big} {Location -3,-1,-0.5}");
        world.talker.say("CONTROL {Type Create} {ClassName Statue} {Location 6,-1,-0.7}");
        world.talker.say("CONTROL {Type Create} {ClassName Ball} {Name Small} {Location -6,-1,-0.5}");
        QCOMPARE(world.states().size(), std::size_t(4));
        QCOMPARE(sizeOf(" {Name Venus}"), was_m);
        QCOMPARE(sizeOf(" {Name Statue3}"), was_m);
        QVERIFY2(sizeOf(" {Name Big}").x() > 0.9, "the world's own, by its name");
        QVERIFY2(sizeOf(" {Name Small}").x() < 0.3, "our kind");
        world.talker.say("CONTROL {Type Create} {ClassName Statue} {Location 9,-1,-0.7} {Scale 2,2,2}");
        world.talker.say("CONTROL {Type Create} {ClassName Fountain} {Location 9,-1,-0.7}");
        world.steps(1);
        const auto refused = world.simulation->takeRefused();
        const auto said = [&](const char* words) {
            return std::ranges::any_of(refused,
                                       [&](const auto& one) { return one.reason.find(words) != std::string::npos; });
        };
        QVERIFY(said("cannot be scaled"));
        QVERIFY(said("Conveyor, ") && said("WCCrate") && said("Statue"));
        QVERIFY2(!world.logged("Fountain"), "whoever asks for the refused objects needs no line of the log");
    }

    void killsOneAllAndThoseInABox() {
        Controlled world;
        for (const char* at : {"0,0,-1", "5,0,-1", "10,0,-1", "15,0,-1"})
            world.talker.say(std::string("CONTROL {Type Create} {ClassName Ball} {Location ") + at + "}");
        QCOMPARE(world.states().size(), std::size_t(4));
        world.talker.say("CONTROL {Type KillAll} {MinPos -1,-1,-5} {MaxPos 6,1,5}");
        QCOMPARE(world.states().size(), std::size_t(2));
        const std::string name = world.states().front().name;
        world.talker.say("CONTROL {Type Kill} {Name " + name + "}");
        QCOMPARE(world.states().size(), std::size_t(1));
        QVERIFY(world.states(" {Name " + name + "}").empty());
        world.talker.say("CONTROL {Type KillAll}");
        QVERIFY(world.states().empty());
    }

    void movesAbsolutelyAndByAStep() {
        Controlled world;
        world.talker.say("CONTROL {Type Create} {ClassName Box} {Name B} {Location 0,0,-0.25}");
        world.talker.say("CONTROL {Type AbsMove} {Name B} {Location 4,1,-0.26} {Rotation 0,0,1}");
        world.talker.say("CONTROL {Type RelMove} {Name B} {Location 1,0,0} {Rotation 0,0,0}");
        const auto states = world.states();
        QCOMPARE(states.size(), std::size_t(1));
        QVERIFY((states[0].object_in_map.position_m.head<2>() - Vec2(5, -1)).norm() < 0.02);
        QVERIFY(std::abs(states[0].object_in_map.yaw_rad + 1.0) < 0.02);
    }

    void turnsAThingAtItsRate() {
        Controlled world;
        world.talker.say("CONTROL {Type Create} {ClassName Box} {Name B} {Location 0,0,-1}");
        world.talker.say("CONTROL {Type Rotate} {Name B} {Speed 0,0,0.5}");
        world.steps(10);
        const double before_rad = world.states()[0].object_in_map.yaw_rad;
        world.steps(4); // and one that states() takes: a second
        const double after_rad = world.states()[0].object_in_map.yaw_rad;
        QVERIFY2(std::abs(normalizedAngle(after_rad - before_rad) + 0.5) < 0.01,
                 qPrintable(QString::number(after_rad - before_rad)));
    }

    void walksItsWayPoints_data() {
        QTest::addColumn<QString>("pace");
        QTest::addColumn<int>("ticks");
        QTest::newRow("at a speed") << "{Speed 2}" << 20; // 8 m
        QTest::newRow("within a time") << "{Time 4}" << 20;
    }
    void walksItsWayPoints() {
        QFETCH(QString, pace);
        QFETCH(int, ticks);
        Controlled world;
        world.talker.say("CONTROL {Type Create} {ClassName Box} {Name B} {Location 0,0,-1}");
        world.talker.say("CONTROL {Type AddWP} {Name B} {WP 4,0,-1;4,4,-1}");
        world.talker.say("CONTROL {Type SetWP} {Name B} " + pace.toStdString() + " {Moving true}");
        world.steps(ticks / 2);
        const Vec3 half_m = world.states()[0].object_in_map.position_m;
        QVERIFY2((half_m - Vec3(4, 0, 1)).norm() < 0.6, qPrintable(QString::number(half_m.x())));
        world.steps(ticks / 2 + 1);
        QVERIFY((world.states()[0].object_in_map.position_m.head<2>() - Vec2(4, -4)).norm() < 0.05);
    }

    void aBeltCarriesWhatLiesOnItAndStays_data() {
        QTest::addColumn<double>("yaw_rad");
        QTest::addColumn<double>("speed_m_s");
        QTest::newRow("forward") << 0.0 << 0.4;
        QTest::newRow("backward") << 0.0 << -0.4;
        QTest::newRow("turned") << pi / 2.0 << 0.4;
    }
    void aBeltCarriesWhatLiesOnItAndStays() {
        QFETCH(double, yaw_rad);
        QFETCH(double, speed_m_s);
        Controlled world;
        world.talker.say("CONTROL {Type Create} {ClassName Conveyor} {Name C} {Location 0,0,-0.15} {Rotation 0,0," +
                         std::to_string(-yaw_rad) + "} {Scale 2,1,1}");
        world.talker.say("CONTROL {Type Create} {ClassName Box} {Name B} {Location 0,0,-0.56}");
        world.steps(5);
        world.talker.say("CONTROL {Type Conveyor} {Name C} {Speed " + std::to_string(speed_m_s) + "}");
        world.steps(5); // it slips until it has the belt's speed: v / (mu g), less than 0.1 s
        const Vec3 before_m = world.states(" {Name B}")[0].object_in_map.position_m;
        world.steps(14); // and one that states() takes: 3 s
        const Vec3 way_m = world.states(" {Name B}")[0].object_in_map.position_m - before_m;
        const Vec2 along(std::cos(yaw_rad), std::sin(yaw_rad));
        QVERIFY2(std::abs(way_m.head<2>().dot(along) - 3.0 * speed_m_s) < 0.02 &&
                     (way_m.head<2>() - 3.0 * speed_m_s * along).norm() < 0.05 && std::abs(way_m.z()) < 0.01,
                 qPrintable(QString("%1 %2 %3").arg(way_m.x()).arg(way_m.y()).arg(way_m.z())));
        const Pose belt = world.states(" {Name C}")[0].object_in_map;
        QVERIFY((belt.position_m - Vec3(0, 0, 0.15)).norm() < 1e-6);
        world.talker.say("CONTROL {Type Conveyor} {Name C} {Speed 0}");
        world.steps(3);
        const Vec3 stopped_m = world.states(" {Name B}")[0].object_in_map.position_m;
        world.steps(5);
        QVERIFY((world.states(" {Name B}")[0].object_in_map.position_m - stopped_m).norm() < 0.01);
    }

    void theEndsOfABeltPushNobodyAway() {
        Controlled world;
        world.talker.say("CONTROL {Type Create} {ClassName Conveyor} {Name C} {Location 0,0,-0.15}");
        world.talker.say("CONTROL {Type Create} {ClassName Box} {Name B} {Location 1.76,0,-0.26}");
        world.talker.say("CONTROL {Type Conveyor} {Name C} {Speed 0.5}");
        world.steps(15);
        QVERIFY(std::abs(world.states(" {Name B}")[0].object_in_map.position_m.x() - 1.76) < 0.03);
    }

    void aRobotIsCarriedByABelt() {
        Controlled world;
        world.talker.say("CONTROL {Type Create} {ClassName Conveyor} {Name C} {Location 0,0,-0.15} {Scale 3,2,1}");
        Talker robot(*world.simulation);
        robot.say("INIT {ClassName P2DX} {Name R} {Location -2,0,-0.55}");
        world.steps(10);
        const double before_m = world.simulation->robots()[0].base_in_map.position_m.x();
        world.talker.say("CONTROL {Type Conveyor} {Name C} {Speed 0.3}");
        world.steps(25);
        const double way_m = world.simulation->robots()[0].base_in_map.position_m.x() - before_m;
        QVERIFY2(std::abs(way_m - 1.5) < 0.1, qPrintable(QString::number(way_m)));
    }

    void whatIsPutIntoTheGroundOrAThingComesToLieOnIt() {
        Controlled world;
        world.talker.say("CONTROL {Type Create} {ClassName Crate} {Name C} {Location 0,0,3}");
        world.talker.say("CONTROL {Type Create} {ClassName Box} {Name B} {Location 0,0,-0.5}");
        world.steps(10);
        QVERIFY(std::abs(world.states(" {Name C}")[0].object_in_map.position_m.z() - 0.5) < 0.02);
        QVERIFY(std::abs(world.states(" {Name B}")[0].object_in_map.position_m.z() - 1.25) < 0.03);
    }

    void thingsLeaveWithTheControllerUnlessPermanent() {
        auto simulation = simulationOf(flatWorld());
        {
            Talker first(*simulation);
            first.say("INIT {ClassName WorldController} {Name A}");
            first.say("CONTROL {Type Create} {ClassName Box} {Name Goes} {Location 0,0,-1}");
            first.say("CONTROL {Type Create} {ClassName Box} {Name Stays} {Location 3,0,-1} {Permanent true}");
            simulation->step();
            simulation->disconnect(first.id());
        }
        Talker second(*simulation);
        second.say("INIT {ClassName WorldController} {Name B}");
        second.say("CONTROL {Type GetSTA}");
        simulation->step();
        const auto left = second.hearLast<protocol::WorldObjects>();
        QVERIFY(left);
        QCOMPARE(left->objects.size(), std::size_t(1));
        QCOMPARE(left->objects[0].name, std::string("Stays"));
    }

    void refusesWithAWord_data() {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("words");
        QTest::newRow("unknown class") << "CONTROL {Type Create} {ClassName Unicorn}"
                                       << "known are Box";
        QTest::newRow("unknown thing") << "CONTROL {Type Kill} {Name Nobody}"
                                       << "no object 'Nobody'";
        QTest::newRow("unknown start") << "CONTROL {Type Create} {ClassName Box} {Start Moon}"
                                       << "no start pose 'Moon'";
        QTest::newRow("no conveyor") << "CONTROL {Type Conveyor} {Name Nobody} {Speed 1}"
                                     << "no object 'Nobody'";
        QTest::newRow("no size") << "CONTROL {Type Create} {ClassName Box} {Scale 0,1,1}"
                                 << "scale must be above 0";
    }
    void refusesWithAWord() {
        QFETCH(QString, line);
        QFETCH(QString, words);
        Controlled world;
        world.talker.say(line.toStdString());
        world.steps(1);
        const std::vector<RefusedObject> refused = world.simulation->takeRefused();
        QCOMPARE(refused.size(), std::size_t(line.contains("Create") ? 1 : 0));
        QVERIFY(refused.empty() ? world.logged(words.toUtf8().constData())
                                : QString::fromStdString(refused.front().reason).contains(words));
        QVERIFY(world.states().empty());
    }

    void placesThatCannotBeAreRefusedInOneLine_data() {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("words");
        const auto row = [](const char* name, const char* type, const char* segments, const char* words) {
            QTest::newRow(name) << QString("CONTROL {Type %1} {ClassName Box} {Name B} %2").arg(type, segments)
                                << words;
        };
        const char* const no_numbers = "Location and Rotation must be numbers";
        const char* const too_far = "more than 1 km outside the world";
        row("made nowhere", "Create", "{Location nan,0,-1}", no_numbers);
        row("made beyond any number", "Create", "{Location 0,0,-1e300}", no_numbers);
        row("made far away", "Create", "{Location 0,0,-5000}", too_far);
        row("moved nowhere", "AbsMove", "{Location 0,inf,-1}", no_numbers);
        row("turned nowhere", "AbsMove", "{Location 0,0,-1} {Rotation 0,0,nan}", no_numbers);
        row("moved far away", "AbsMove", "{Location 1e9,0,-1}", too_far);
        row("shifted nowhere", "RelMove", "{Location nan,0,0}", no_numbers);
        row("shifted far away", "RelMove", "{Location 0,-4000,0}", too_far);
    }
    void placesThatCannotBeAreRefusedInOneLine() {
        QFETCH(const QString, line);
        QFETCH(const QString, words);
        Controlled world;
        if (!line.contains("Create"))
            world.talker.say("CONTROL {Type Create} {ClassName Box} {Name B} {Location 2,0,-0.25}");
        world.steps(10);
        world.simulation->takeLog();
        world.talker.say(line.toStdString());
        world.steps(1);
        QStringList said;
        for (const std::string& sentence : world.simulation->takeLog())
            said << QString::fromStdString(sentence);
        for (const RefusedObject& refused : world.simulation->takeRefused())
            said << QString::fromStdString(refused.reason);
        QCOMPARE(said.size(), 1);
        QVERIFY2(said[0].contains(words), qPrintable(said[0]));
        const auto states = world.states();
        QCOMPARE(states.size(), std::size_t(line.contains("Create") ? 0 : 1));
        for (const protocol::WorldObject& box : states)
            QVERIFY((box.object_in_map.position_m.head<2>() - Vec2(2.0, 0.0)).norm() < 0.01);
    }

    void onlyAControllerControls() {
        auto simulation = simulationOf(flatWorld());
        Talker robot(*simulation);
        robot.say("INIT {ClassName P2DX} {Name R} {Location 0,0,-0.2}");
        robot.say("CONTROL {Type Create} {ClassName Box} {Name B} {Location 3,0,-1}");
        simulation->step();
        bool said = false;
        for (const std::string& sentence : simulation->takeLog())
            said |= sentence.find("not a world controller's") != std::string::npos;
        QVERIFY(said);
    }

    void aRobotSeesAndPushesWhatStandsInItsWay() {
        Controlled world;
        Talker robot(*world.simulation);
        robot.say("INIT {ClassName P2DX} {Name R} {Location 0,0,-0.2}");
        world.steps(5);
        world.talker.say("CONTROL {Type Create} {ClassName Box} {Name B} {Location 1.5,0,-0.16} {Scale 0.6,0.6,0.6}");
        world.steps(3);
        robot.hearText();
        world.steps(1);
        double ahead_m = 0.0;
        for (const protocol::InfoLine& line : robot.hear())
            if (const auto* const scan = std::get_if<protocol::RangeScan>(&line.message))
                ahead_m = scan->ranges_m.at(90);
        QVERIFY2(std::abs(ahead_m - (1.35 - 0.056)) < 0.03, qPrintable(QString::number(ahead_m)));
        robot.say("DRIVE {Left 6} {Right 6}");
        world.steps(30);
        QVERIFY(world.states()[0].object_in_map.position_m.x() > 2.0);
    }

    void aBaseStationHearsNothing() {
        auto simulation = simulationOf(flatWorld());
        Talker station(*simulation);
        station.hearText();
        station.say("INIT {ClassName USARBot.ComStation} {Name Base} {Location 0,0,0}");
        for (int i = 0; i < 5; ++i)
            simulation->step();
        QVERIFY(station.hearText().empty());
        QVERIFY(simulation->robots().empty());
    }
};

USAR_TEST(tst_WorldController)

} // namespace tst_world_controller

#include "tst_world_controller.moc"
