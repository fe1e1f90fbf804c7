// What is said about a world file that has a wrong part: the whole sentence, as a user reads it.
#include <QDir>
#include <QFile>
#include <QObject>
#include <QString>
#include <QTemporaryDir>
#include <QTest>

#include "core/sim/world/world_reader.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"

namespace tst_world_messages {

using namespace usar;
using namespace usar::sim;
using doubles::pathOf;
using doubles::writeAll;

namespace {

/// A static model of one collision with this geometry.
QString model(const QString& geometry, const QString& pose = "0 0 0 0 0 0") {
    return "<model name=\"m\"><static>true</static><pose>" + pose +
           "</pose><link name=\"l\"><collision name=\"c\"><geometry>" + geometry +
           "</geometry></collision></link></model>\n";
}

QString box(const QString& size) {
    return "<box><size>" + size + "</size></box>";
}

QString plane(const QString& size, const QString& normal = "0 0 1") {
    return "<plane><normal>" + normal + "</normal><size>" + size + "</size></plane>";
}

const QString ground = model(plane("10 10"));
const QString start = "<usar:start_pose name=\"S\">0 0 0 0 0 0</usar:start_pose>\n";

/// A thing that falls, with these parts of its link.
QString thing(const QString& parts) {
    return "<model name=\"t\"><link name=\"l\">" + parts + "</link></model>\n";
}

const QString inertial = "<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>";

QString collision(const QString& geometry) {
    return "<collision name=\"c\"><geometry>" + geometry + "</geometry></collision>";
}

} // namespace

class tst_WorldMessages : public QObject {
    Q_OBJECT

private slots:
    void aSoundWorldIsRead() {
        const auto world = read(ground + start + thing(inertial + collision(box("1 1 1"))));
        QVERIFY2(world, world ? "" : world.error().text().c_str());
        QCOMPARE(world->name, std::string("w"));
        QCOMPARE(world->objects.size(), std::size_t{1});
        QCOMPARE(world->start_poses.size(), std::size_t{1});
    }

    void saysWhatIsWrong_data() {
        QTest::addColumn<QString>("parts");
        QTest::addColumn<QString>("what");
        QTest::newRow("nothing at all") << ""
                                        << "the world has no ground: no collision with a height map, a plane or a box";
        QTest::newRow("no ground") << start
                                   << "the world has no ground: no collision with a height map, a plane or a box";
        QTest::newRow("no start") << ground << "the world has no usar:start_pose, so no robot can start";
        const QString lies = "a plane is a floor: it must lie level and along x and y";
        QTest::newRow("a floor on end") << model(plane("10 10", "1 0 0")) + start << lies;
        QTest::newRow("a floor upside down") << model(plane("10 10", "0 0 -1")) + start << lies;
        QTest::newRow("a floor askew") << model(plane("10 10"), "0 0 0 0.01 0 0") + start << lies;
        QTest::newRow("a floor turned") << model(plane("10 10"), "0 0 0 0 0 0.5") + start << lies;
        const QString sides =
            "the sides of the plane need a common measure that is not too small, such as 1 m or 0.1 m, above zero";
        QTest::newRow("a floor of no width") << model(plane("0 10")) + start << sides;
        QTest::newRow("a floor of odd sides") << model(plane("10 3.14159265358979")) + start << sides;
        QTest::newRow("two floors") << ground + model(plane("5 5")).replace("\"m\"", "\"n\"") + start
                                    << "the world has two grounds: there may be one height map or one plane";
        QTest::newRow("a flat house") << model(box("3 0 2")) + start << "model \"m\" has a box without size";
        QTest::newRow("a round house") << model("<cylinder><radius>1</radius><length>2</length></cylinder>") + start
                                       << "model \"m\" has a shape that is neither a box nor a plane nor a height map";
        QTest::newRow("a thing without weight")
            << ground + start + thing(collision(box("1 1 1"))) << "the object \"t\" needs an inertial with its mass";
        QTest::newRow("a thing without shape")
            << ground + start + thing(inertial) << "the object \"t\" has no collision, so it would fall forever";
        QTest::newRow("a thing without size") << ground + start + thing(inertial + collision(box("1 0 1")))
                                              << "the object \"t\" has a shape without size";
        QTest::newRow("a thing without an end")
            << ground + start + thing(inertial + collision(plane("1 1")))
            << "the object \"t\" has a shape that is neither a box, a sphere, a cylinder nor a capsule";
        QTest::newRow("a scatter of nothing") << ground + start + "<usar:scatter/>"
                                              << "a usar:scatter needs a usar:uri";
        QTest::newRow("a sea without a surface") << ground + start + "<usar:water/>"
                                                 << "a usar:water needs a usar:surface_z and a usar:density above zero";
        QTest::newRow("a start in five numbers") << ground + "<usar:start_pose name=\"S\">0 0 0 0 0</usar:start_pose>"
                                                 << "a usar:start_pose needs a name and x y z roll pitch yaw";
        QTest::newRow("two starts of one name") << ground + start + start << "there are two start poses named \"S\"";
        QTest::newRow("a tag without an id") << ground + start + "<usar:rfid_tag>1 2 3</usar:rfid_tag>"
                                             << "a usar:rfid_tag needs a whole number from 0 up as its id, and x y z";
        QTest::newRow("a victim whom nobody finds") << ground + start + "<usar:victim name=\"V\"/>"
                                                    << "the victim \"V\" has no usar:part, so nobody can find it";
        QTest::newRow("a sound without a loudness") << ground + start + "<usar:sound name=\"N\">1 2 3</usar:sound>"
                                                    << "a usar:sound needs a name, a loudness in dB, and x y z";
        QTest::newRow("a gas of no density") << ground + start + "<usar:gas gas=\"CO2\">1 2 3</usar:gas>"
                                             << "a usar:gas needs a gas such as CO2, a density from 0 up, and x y z";
        QTest::newRow("a place off the earth")
            << ground + start + "<usar:gps_reference latitude=\"0\" longitude=\"180.5\"/>"
            << "a usar:gps_reference needs a latitude within +-90 and a longitude within +-180 degrees";
        QTest::newRow("an element nobody knows") << ground + start + "<usar:moon/>"
                                                 << "there is no element named usar:moon in a world";
    }
    void saysWhatIsWrong() {
        QFETCH(const QString, parts);
        QFETCH(const QString, what);
        const auto world = read(parts);
        QVERIFY(!world);
        QCOMPARE(QString::fromStdString(world.error().what), what);
        QVERIFY2(world.error().where.starts_with(file().string() + ":"), world.error().where.c_str());
        QCOMPARE(world.error().mend, std::string("Fix the file or generate the world again"));
    }

    void oneFileIsOneWorld() {
        writeAll(file(),
                 "<?xml version=\"1.0\"?>\n<sdf version=\"1.9\">\n<world name=\"a\"/>\n<world name=\"b\"/>\n</sdf>\n");
        const auto world = readWorld(pathOf(folder_));
        QVERIFY(!world);
        QVERIFY(!world.error().what.empty());
        QVERIFY(world.error().where.starts_with(file().string()));
    }

    /// A log would be open as long as the program runs.
    void noLogIsKeptInTheHomeFolder() {
        QVERIFY(!read("<broken>"));
        for (const QString& open :
             QDir("/proc/self/fd").entryList(QDir::NoDotAndDotDot | QDir::AllEntries | QDir::System))
            QVERIFY2(!QFile::symLinkTarget("/proc/self/fd/" + open).contains(".sdformat"), qPrintable(open));
        QCOMPARE(qgetenv("HOME"), QDir::homePath().toLocal8Bit());
    }

private:
    Result<World> read(const QString& parts) const {
        const QString head =
            "<?xml version=\"1.0\"?>\n"
            "<sdf version=\"1.9\" xmlns:usar=\"urn:usar-mission-control:world\">\n<world name=\"w\">\n";
        writeAll(file(), (head + parts + "</world>\n</sdf>\n").toStdString());
        return readWorld(pathOf(folder_));
    }
    std::filesystem::path file() const { return pathOf(folder_) / "world.sdf"; }

    QTemporaryDir folder_;
};

USAR_TEST(tst_WorldMessages)

} // namespace tst_world_messages

#include "tst_world_messages.moc"
