// NIST's objects: each class that UDK's world controller knows gives a body, and the families take their variants.
#include <QObject>
#include <QString>
#include <QTest>

#include "core/sim/world/nist_kinds.h"
#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_nist_kinds {

using namespace usar;
using namespace usar::sim;

class tst_NistKinds : public QObject {
    Q_OBJECT

private slots:
    void classesGiveAKind_data() {
        QTest::addColumn<QString>("kind");
        QTest::newRow("WCCrate") << "WCCrate";
        QTest::newRow("USARPhysObj.WCCrate101223") << "WCCrate101223";
        QTest::newRow("USARPhysObj.wccrate11292") << "WCCrate";
        QTest::newRow("WCCrateBlue") << "WCCrate";
        QTest::newRow("WCPallet") << "WCPallet";
        QTest::newRow("USARPhysObj.WCPallet48x40Green") << "WCPallet48x40";
        QTest::newRow("WCKivaPallet") << "WCKivaPallet";
        QTest::newRow("WCBoxSmall") << "WCBoxSmall";
        QTest::newRow("WCTrayLong") << "WCTrayLong";
        QTest::newRow("KitTray5") << "KitTray";
        QTest::newRow("PartC") << "Part";
        QTest::newRow("PartATray") << "Part";
        QTest::newRow("PartTrayE") << "PartTray";
        QTest::newRow("Crate") << "Crate";
        QTest::newRow("WCCrateUnicorn") << "";
        QTest::newRow("PartZ") << "";
        QTest::newRow("WC") << "";
    }
    void classesGiveAKind() {
        QFETCH(const QString, kind);
        const ObjectKind* const found = findObjectKind(QTest::currentDataTag());
        QCOMPARE(found ? QString::fromUtf8(found->name.data(), static_cast<int>(found->name.size())) : QString(), kind);
    }

    /// Every kind is created by its UDK class, lies on the ground, and tells its size.
    void everyKindComesToLieOnTheGround() {
        for (const ObjectKind& kind : nistKinds()) {
            const auto simulation = simulationOf(flatWorld());
            Talker talker(*simulation);
            talker.say("INIT {ClassName USARBotAPI.WorldController} {Name WC}");
            talker.say("CONTROL {Type Create} {ClassName USARPhysObj." + std::string(kind.name) +
                       "} {Name X} {Location 0,0,-1}");
            steps(*simulation, 20);
            talker.hearText();
            talker.say("CONTROL {Type GetSTA} {ClassName WCObject}");
            steps(*simulation, 1);
            const auto states = talker.hearLast<protocol::WorldObjects>();
            QVERIFY2(states && states->objects.size() == 1, kind.name.data());
            const protocol::WorldObject& object = states->objects[0];
            QVERIFY2((object.size_m.value_or(Vec3::Zero()) - kind.size_m).norm() < 1e-3, kind.name.data());
            QVERIFY2(std::abs(object.object_in_map.position_m.z() - kind.size_m.z() / 2.0) < 0.02, kind.name.data());
        }
    }
};

USAR_TEST(tst_NistKinds)

} // namespace tst_nist_kinds

#include "tst_nist_kinds.moc"
