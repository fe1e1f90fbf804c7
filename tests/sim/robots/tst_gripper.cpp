// An arm and its gripper, over the protocol's bytes alone: reach for a crate, close, lift, open.
#include <cmath>

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTest>

#include "core/sim/world/world_generator.h"
#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_gripper {

using namespace usar;
using namespace usar::sim;

namespace {

World room() {
    return makeWorld("vmac_room", 1, USAR_SOURCE_DIR "/resources/worlds").value();
}

/// A TeleMax that has driven up to the crate of vmac_room, and its client.
struct Handling {
    std::unique_ptr<Simulation> simulation;
    Talker talker;

    explicit Handling(protocol::Dialect profile = protocol::Dialect::Ut2004, World world = room())
        : simulation(simulationOf(std::move(world), optionsOf(profile)))
        , talker(*simulation) {
        talker.say("INIT {ClassName USARBot.TeleMax} {Name R1} {Location 15.4,-4,-0.25}");
        steps(*simulation, 5);
        say("DRIVE {Left 2} {Right 2}", 23);
        say("DRIVE {Left 0} {Right 0}", 5);
    }
    /// MISPKG with the crate's distance and this height above the floor.
    void reach(double height_m, int ticks) {
        const Pose base_in_map = simulation->robots().at(0).base_in_map;
        const Vec3 at_m = simulation->objects().objects.at(0).object_in_map.position_m;
        const double ahead_m = (at_m - base_in_map.position_m).head<2>().norm();
        say("MISPKG {Name TeleMaxArm} {Location " + std::to_string(start_ahead_m_.value_or(ahead_m)) + ",0," +
                std::to_string(base_in_map.position_m.z() - height_m) + "}",
            ticks);
        start_ahead_m_ = start_ahead_m_.value_or(ahead_m);
    }
    static SimulationOptions optionsOf(protocol::Dialect profile) {
        SimulationOptions options;
        options.profile = profile;
        return options;
    }
    void say(const std::string& line, int ticks) {
        talker.say(line);
        steps(*simulation, ticks);
    }
    double crate_m() const { return simulation->objects().objects.at(0).object_in_map.position_m.z(); }
    QString log() {
        QStringList lines;
        for (const std::string& line : simulation->takeLog())
            lines << QString::fromStdString(line);
        return lines.join('\n');
    }
    QString answer(const std::string& question, const std::string& word) {
        talker.hearText();
        say(question, 1);
        for (const std::string& line : talker.hearText())
            if (line.starts_with(word))
                return QString::fromStdString(line);
        return {};
    }

private:
    std::optional<double> start_ahead_m_; ///< how far off the crate was when the arm first reached for it
};

} // namespace

class tst_Gripper : public QObject {
    Q_OBJECT

private slots:
    void liftsACrate_data() {
        QTest::addColumn<bool>("udk");
        QTest::addColumn<QString>("close");
        QTest::addColumn<QString>("open");
        QTest::newRow("UT2004, SET") << false << "SET {Type Gripper} {Name Gripper1} {Opcode CLOSE}"
                                     << "SET {Type Gripper} {Name Gripper1} {Opcode OPEN}";
        QTest::newRow("UT2004, without name") << false << "SET {Type Gripper} {Opcode Close} {Params 0.0000}"
                                              << "SET {Type Gripper} {Opcode GRIP} {Params 0}";
        QTest::newRow("UDK, SET") << true << "SET {Type Gripper} {Name Gripper1} {Opcode GRIP} {Params 1}"
                                  << "SET {Type Gripper} {Name Gripper1} {Opcode OPEN}";
        QTest::newRow("UDK, the arm's command") << true << "MISPKG {Name TeleMaxArm} {Gripper 1}"
                                                << "ACT {Name TeleMaxArm} {Gripper 0}";
    }
    void liftsACrate() {
        QFETCH(const bool, udk);
        QFETCH(const QString, close);
        QFETCH(const QString, open);
        Handling hand(udk ? protocol::Dialect::Udk : protocol::Dialect::Ut2004);
        const double lies_m = hand.crate_m();
        QVERIFY2(std::abs(lies_m - 0.1) < 0.01, qPrintable(QString::number(lies_m)));
        hand.reach(0.45, 50);
        hand.reach(0.14, 30);
        QVERIFY2(std::abs(hand.crate_m() - lies_m) < 0.01, qPrintable(QString::number(hand.crate_m())));
        hand.say(close.toStdString(), 15);
        hand.reach(0.5, 40);
        qInfo("the crate is %.3f m higher", hand.crate_m() - lies_m);
        QVERIFY(hand.crate_m() > lies_m + 0.25);
        const double held_m = hand.crate_m();
        steps(*hand.simulation, 50); // It does not slip in 10 s.
        QVERIFY2(std::abs(hand.crate_m() - held_m) < 0.005, qPrintable(QString::number(hand.crate_m() - held_m)));
        hand.say(open.toStdString(), 15);
        QVERIFY2(hand.crate_m() < held_m - 0.15, qPrintable(QString::number(hand.crate_m())));
        QVERIFY2(!hand.log().contains("cannot reach"), "a pose was out of reach");
    }

    void anOpenGripperLiftsNothing() {
        Handling hand;
        const double lies_m = hand.crate_m();
        hand.reach(0.45, 50);
        hand.reach(0.14, 30);
        hand.reach(0.5, 40);
        QVERIFY(std::abs(hand.crate_m() - lies_m) < 0.01);
    }

    void unreachableIsSaid() {
        Handling hand;
        hand.log();
        hand.talker.hearText();
        hand.say("MISPKG {Name TeleMaxArm} {Location 5,0,0}", 2);
        const QString log = hand.log();
        QVERIFY2(log.contains("TeleMaxArm cannot reach that pose: it comes no nearer than 3."), qPrintable(log));
        std::optional<protocol::Response> answer;
        std::optional<protocol::PackageState> arm;
        for (const protocol::InfoLine& line : hand.talker.hear()) {
            if (const auto* const one = std::get_if<protocol::Response>(&line.message))
                answer = *one;
            if (const auto* const one = std::get_if<protocol::PackageState>(&line.message))
                arm = *one;
        }
        QVERIFY(answer && !answer->ok && answer->type == "MisPkg" && answer->name == "TeleMaxArm");
        QVERIFY(arm && std::abs(arm->links.at(1).value) < 0.02); // It stays where it was.
    }

    void answersForArmAndGripper() {
        Handling hand;
        const QString arm = hand.answer("GETGEO {Type MisPkg} {Name TeleMaxArm}", "GEO");
        QVERIFY2(
            arm.startsWith("GEO {Type MisPkg} {Name TeleMaxArm} {Link 1} {ParentLink -1} {Location 0.1800,0.0000,") &&
                arm.contains("{Link 3} {ParentLink 2}"),
            qPrintable(arm));
        QVERIFY(hand.answer("GETCONF {Type MisPkg}", "CONF").contains("{Link 3} {JointType Revolute}"));
        QCOMPARE(hand.answer("GETCONF {Type Gripper}", "CONF"),
                 QString("CONF {Type Gripper} {Name Gripper1} {Opcode Grip} {MaxVal 1} {MinVal 0} {Opcode Close} "
                         "{Opcode Open}"));
        QVERIFY(hand.answer("GETGEO {Type Gripper}", "GEO").contains("Mount TeleMaxArm_Link3"));
        QVERIFY(hand.answer("SET {Type Gripper} {Name Gripper1} {Opcode CLOSE}", "RES")
                    .endsWith("{Type Gripper} {Name Gripper1} {Status OK}"));
        QVERIFY(hand.answer("SET {Type Gripper} {Name Other} {Opcode CLOSE}", "RES").endsWith("{Status Failed}"));
        QVERIFY(hand.answer("TEST", "EFF").isEmpty()); // UT2004's effecters send nothing by themselves.
    }

    void aGripperOfUdkTellsItsState() {
        Handling hand(protocol::Dialect::Udk);
        QVERIFY(hand.answer("TEST", "EFF").contains("{Type Gripper} {Name Gripper1} {Status OPEN}"));
        hand.say("SET {Type Gripper} {Name Gripper1} {Opcode CLOSE}", 1);
        QVERIFY(hand.answer("TEST", "EFF").contains("{Status CLOSED}"));
        const QString geometry = hand.answer("GETGEO {Type Gripper}", "GEO");
        QVERIFY2(geometry.contains("{Mount TeleMaxArm} {MountLink 3} {Tip 0.53,-0.00,-0.00}"), qPrintable(geometry));
    }
};

USAR_TEST(tst_Gripper)

} // namespace tst_gripper

#include "tst_gripper.moc"
