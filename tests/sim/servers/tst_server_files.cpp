// The files for real servers: what is written can be read back as the robot files say, and the copies in resources are
// those that the program writes.
#include <algorithm>

#include <QFile>
#include <QObject>
#include <QTest>

#include "core/sim/servers/server_reader.h"
#include "core/sim/servers/server_writer.h"
#include "tests/doubles/shipped_robots.h"
#include "tests/suite/suite.h"

namespace tst_server_files {

using namespace usar;
using namespace usar::sim;
using protocol::Dialect;

namespace {

QString fileOf(Dialect dialect) {
    return QString(USAR_SOURCE_DIR "/resources/robots/usarsim/") +
           (dialect == Dialect::Udk ? "DefaultUSAR.ini" : "USARBot.ini");
}

std::string textIn(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

bool mentions(const std::vector<std::string>& sentences, const std::string& words) {
    return std::ranges::any_of(sentences, [&](const std::string& one) { return one.find(words) != std::string::npos; });
}

QString joined(const std::vector<std::string>& sentences) {
    QString text;
    for (const std::string& sentence : sentences)
        text += QString::fromStdString(sentence) + '\n';
    return text;
}

/// True if the writer said that the server has this setting for all robots, so that this one's wish is not met.
bool isExplained(const std::string& difference, const RobotModel& robot, const std::vector<std::string>& left_out) {
    const std::pair<std::string, std::string> shared[] = {{"Sonar", "BeamAngle"}, {"RangeScanner", "MaxRange"}};
    return std::ranges::any_of(shared, [&](const auto& one) {
        const auto& [type, key] = one;
        return mentions(left_out, robot.class_name + ": its " + type + " wants a " + key + " of ") &&
               difference.find(": " + type + " ") != std::string::npos &&
               difference.find(" wants a " + key + " of ") != std::string::npos;
    });
}

const ServerItem* itemOf(const ServerFile& file, const std::string& robot, const std::string& name) {
    const ServerRobot* const found = file.robot(robot);
    if (!found)
        return nullptr;
    const auto item = std::ranges::find(found->items, name, &ServerItem::name);
    return item == found->items.end() ? nullptr : &*item;
}

} // namespace

class tst_ServerFiles : public QObject {
    Q_OBJECT

    const RobotCatalog& robots = *doubles::shippedRobots();

private slots:
    void theCopiesAreUpToDate_data() {
        QTest::addColumn<int>("dialect");
        QTest::newRow("UT2004") << int(Dialect::Ut2004);
        QTest::newRow("UDK") << int(Dialect::Udk);
    }
    void theCopiesAreUpToDate() {
        QFETCH(const int, dialect);
        const QString path = fileOf(Dialect(dialect));
        const std::string now = writeServerFile(robots, Dialect(dialect)).text;
        QVERIFY2(textIn(path) == now,
                 qPrintable(path + " differs from the robot files. Write it again: usar-mission server-files "
                                   "resources/robots/usarsim"));
    }

    /// All that a robot file says of a sensor comes back, but for what the writer said that it left out.
    void everySensorIsReadBack_data() {
        QTest::addColumn<int>("dialect");
        QTest::addColumn<QString>("robot");
        for (const Dialect dialect : {Dialect::Ut2004, Dialect::Udk})
            for (const RobotModel& robot : robots)
                QTest::addRow("%s %s", dialect == Dialect::Udk ? "UDK" : "UT2004", robot.class_name.c_str())
                    << int(dialect) << QString::fromStdString(robot.class_name);
    }
    void everySensorIsReadBack() {
        QFETCH(const int, dialect);
        QFETCH(const QString, robot);
        const auto server = readServerFile(textIn(fileOf(Dialect(dialect))));
        QVERIFY(server);
        QVERIFY(server->dialect == Dialect(dialect));
        const RobotModel& ours = *findRobot(robots, robot.toStdString());
        const auto left_out = writeServerFile(robots, Dialect(dialect)).left_out;
        const ServerRobot* const theirs = server->robot(ours.class_name);
        if (!theirs) {
            const QStringList others = dialect == int(Dialect::Udk)
                                           ? QStringList{"ATRVJr", "ERS",        "OmniP2AT",  "P2AT",  "P2DX",
                                                         "Sedan",  "StereoP2AT", "Submarine", "Talon", "TeleMax"}
                                           : QStringList{"KR60", "P3AT"};
            QVERIFY(others.contains(robot));
            return;
        }
        std::vector<std::string> open = differencesOf(ours, *server);
        std::erase_if(open, [&](const std::string& difference) { return isExplained(difference, ours, left_out); });
        QVERIFY2(open.empty(), qPrintable(joined(open)));
        for (const SensorModel& sensor : ours.sensors)
            QVERIFY2(itemOf(*server, ours.class_name, sensor.name) ||
                         mentions(left_out, ours.class_name + ": " + sensor.type + " " + sensor.name),
                     sensor.name.c_str());
    }

    /// The thesis's AirRobot, spelled out: nine sonars on the ring, the scanner at the belly looking down.
    void theAirRobotIsTheThesiss_data() {
        QTest::addColumn<QString>("line");
        QTest::newRow("left-most sonar")
            << R"(Sensors=(ItemClass=class'USARBot.SonarSensor',ItemName="L4",Position=(X=0.154508,Y=-0.475528,Z=0.000000),Direction=(X=0.000000,Y=0.000000,Z=-1.256637)))";
        QTest::newRow("front sonar")
            << R"(Sensors=(ItemClass=class'USARBot.SonarSensor',ItemName="M0",Position=(X=0.500000,Y=0.000000,Z=0.000000),Direction=(X=0.000000,Y=0.000000,Z=0.000000)))";
        QTest::newRow("right-most sonar")
            << R"(Sensors=(ItemClass=class'USARBot.SonarSensor',ItemName="R4",Position=(X=0.154508,Y=0.475528,Z=0.000000),Direction=(X=0.000000,Y=0.000000,Z=1.256637)))";
        QTest::newRow("scanner")
            << R"(Sensors=(ItemClass=class'USARBot.RangeScanner',ItemName="Scanner1",Position=(X=0.000000,Y=0.000000,Z=0.100000),Direction=(X=0.000000,Y=-1.570796,Z=0.000000)))";
        QTest::newRow("battery") << "batteryLife=604800";
        QTest::newRow("invisible scanner") << "[USARBot.RangeScanner]\nHiddenSensor=True\nMaxRange=20.000000\n";
        QTest::newRow("beam of a sonar") << "BeamAngle=0.261799";
    }
    void theAirRobotIsTheThesiss() {
        QFETCH(const QString, line);
        const QString text = QString::fromStdString(writeServerFile(robots, Dialect::Ut2004).text);
        QVERIFY2(text.contains(line + (line.endsWith('\n') ? "" : "\n")), qPrintable(text));
    }

    void saysWhatADifferentFileLacks_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("words");
        QTest::newRow("another name") << "ItemName=\"L4\""
                                      << "ItemName=\"F1\""
                                      << "Sonar L4 is missing";
        QTest::newRow("another class") << "SonarSensor',ItemName=\"L4\""
                                       << "INS',ItemName=\"L4\""
                                       << "Sonar L4 is missing";
        QTest::newRow("looks forward") << "Y=-1.570796"
                                       << "Y=0.0"
                                       << "Scanner1 stands elsewhere or looks elsewhere";
        QTest::newRow("stands higher") << "Z=0.100000"
                                       << "Z=-0.1"
                                       << "Scanner1 stands elsewhere";
        QTest::newRow("on another part") << "ItemName=\"Scanner1\""
                                         << "ItemName=\"Scanner1\",Parent=\"Arm\""
                                         << "Scanner1 stands elsewhere";
        QTest::newRow("a shorter reach") << "MaxRange=20.000000"
                                         << "MaxRange=4"
                                         << "wants a MaxRange of 20, and the server has 4";
        QTest::newRow("no reach") << "MaxRange=20.000000\n"
                                  << ""
                                  << "wants a MaxRange of 20, and the server says none";
        QTest::newRow("no robot") << "[USARBot.AirRobot]"
                                  << "[USARBot.Zerg]"
                                  << "has no section";
    }
    void saysWhatADifferentFileLacks() {
        QFETCH(const QString, from);
        QFETCH(const QString, to);
        QFETCH(const QString, words);
        QString text = QString::fromStdString(textIn(fileOf(Dialect::Ut2004)));
        QVERIFY(text.contains(from));
        const auto server = readServerFile(text.replace(from, to).toStdString());
        QVERIFY(server);
        const auto differences = differencesOf(*findRobot(robots, "AirRobot"), *server);
        QVERIFY2(mentions(differences, words.toStdString()), qPrintable(joined(differences)));
    }

    void refusesAFileWithoutRobots() {
        const auto read = readServerFile("[URL]\nPort=7777\n");
        QVERIFY(!read);
        QVERIFY(read.error().what.find("no section of a robot") != std::string::npos);
    }
};

USAR_TEST(tst_ServerFiles)

} // namespace tst_server_files

#include "tst_server_files.moc"
