// The command lines that say which simulator is started and which server is used.
#include <QTest>

#include "core/server/embedded/server_target.h"
#include "core/server/embedded/simulator_settings.h"
#include "tests/suite/suite.h"

namespace tst_simulator_settings {

using namespace usar;
using namespace usar::server;

namespace {

Result<SimulatorSettings> simulatorOf(const QString& words) {
    QCommandLineParser parser;
    parser.addOptions(simulatorOptions());
    parser.parse(QStringList{"usar-sim"} + words.split(' ', Qt::SkipEmptyParts));
    return readSimulatorSettings(parser);
}

Result<ServerTarget> targetOf(const QString& words) {
    QCommandLineParser parser;
    parser.addOptions(serverOptions());
    parser.parse(QStringList{"mission-control"} + words.split(' ', Qt::SkipEmptyParts));
    return readServerTarget(parser);
}

} // namespace

class tst_SimulatorSettings : public QObject {
    Q_OBJECT
private slots:
    void withoutOptionsAllIsUsual();
    void everyOptionIsRead();
    void aWrongOptionIsNamed_data();
    void aWrongOptionIsNamed();
    void aServerIsNamedByHostAndPort();
    void aWrongServerIsNamed_data();
    void aWrongServerIsNamed();
};

void tst_SimulatorSettings::withoutOptionsAllIsUsual() {
    const auto settings = simulatorOf("");
    QVERIFY(settings);
    QCOMPARE(settings->world, QString("tall_test"));
    QCOMPARE(settings->port, protocol::usual_port::bot);
    QVERIFY(settings->channels == ChannelPorts());
    QVERIFY(settings->pace == Pace::Factor && settings->factor == 1.0 && settings->seed == 1);
    const auto target = targetOf("");
    QVERIFY(target && target->embedded);
    QCOMPARE(target->simulator.world, QString("tall_test"));
}

void tst_SimulatorSettings::everyOptionIsRead() {
    const auto settings = simulatorOf("--world meadow --port 0 --image-port 7 --wireless-port 8 --comserver-port 9 "
                                      "--cominterface-port 10 --seed 5 --speed max --profile udk --image-type raw "
                                      "--image-first --save end.usarsnap");
    QVERIFY(settings);
    QCOMPARE(settings->world, QString("meadow"));
    QCOMPARE(settings->port, quint16(0));
    QVERIFY(settings->channels == (ChannelPorts{7, 8, 9, 10}));
    QVERIFY(settings->seed == 5 && settings->pace == Pace::Fast && settings->profile == protocol::Dialect::Udk);
    QCOMPARE(settings->save, QString("end.usarsnap"));
    QVERIFY(simulatorOf("--speed 0")->pace == Pace::Paused);
    QCOMPARE(simulatorOf("--speed 2.5")->factor, 2.5);
    const auto others = simulatorOf("--bind 0.0.0.0 --allow 10.1.0.0/16 --allow fd00::/8 --battery 60 --tick 0.1 "
                                    "--lockstep-patience 2.5");
    QVERIFY(others && others->access.isOpen());
    QCOMPARE(others->access.networks(), QString("10.1.0.0/16, fd00::/8"));
    QVERIFY(others->battery_life == Seconds{60.0} && others->tick == Seconds{0.1});
    QVERIFY(others->lockstep_patience == std::chrono::milliseconds(2500));
    QVERIFY(simulatorOf("--battery robot")->battery_life == std::nullopt);
    QVERIFY(simulatorOf("")->battery_life == sim::survey_battery_life); // as the embedded simulator
}

void tst_SimulatorSettings::aWrongOptionIsNamed_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("named");
    QTest::newRow("port") << "--port 65536"
                          << "--port";
    QTest::newRow("a channel's port") << "--image-port many"
                                      << "--image-port";
    QTest::newRow("seed") << "--seed -1"
                          << "--seed";
    QTest::newRow("speed") << "--speed quick"
                           << "--speed";
    QTest::newRow("profile") << "--profile unreal"
                             << "--profile";
    QTest::newRow("type of picture") << "--image-type best"
                                     << "--image-type";
    QTest::newRow("an address without a network") << "--bind 0.0.0.0"
                                                  << "--allow";
    QTest::newRow("a network without an address") << "--allow 10.0.0.0/8"
                                                  << "--bind";
    QTest::newRow("no address") << "--bind here --allow 10.0.0.0/8"
                                << "--bind";
    QTest::newRow("no network") << "--bind 0.0.0.0 --allow 10.0.0/x"
                                << "--allow";
    QTest::newRow("battery") << "--battery 0"
                             << "--battery";
    QTest::newRow("a tick that is no whole number of steps") << "--tick 0.005"
                                                             << "--tick";
    QTest::newRow("patience") << "--lockstep-patience never"
                              << "--lockstep-patience";
    QTest::newRow("a word too much") << "meadow"
                                     << "meadow";
}

void tst_SimulatorSettings::aWrongOptionIsNamed() {
    QFETCH(QString, words);
    QFETCH(QString, named);
    const auto settings = simulatorOf(words);
    QVERIFY(!settings);
    QVERIFY2(QString::fromStdString(settings.error().text()).contains(named), settings.error().text().c_str());
}

void tst_SimulatorSettings::aServerIsNamedByHostAndPort() {
    const auto target = targetOf("--connect robots.example:3001 --wireless-port 50001");
    QVERIFY(target && !target->embedded);
    QCOMPARE(target->host, QString("robots.example"));
    QCOMPARE(target->port, quint16(3001));
    QCOMPARE(target->simulator.channels.wireless, quint16(50001));
    const auto six = targetOf("--connect [fd00::7]:3001");
    QVERIFY(six);
    QCOMPARE(six->host, QString("fd00::7"));
    QCOMPARE(six->port, quint16(3001));
    const auto open = targetOf("--bind 0.0.0.0 --allow 10.0.0.0/8 --battery 300");
    QVERIFY(open && open->simulator.access.isOpen() && open->simulator.battery_life == Seconds{300.0});
}

void tst_SimulatorSettings::aWrongServerIsNamed_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("named");
    QTest::newRow("no port") << "--connect robots.example"
                             << "--connect";
    QTest::newRow("IPv6 without brackets") << "--connect ::1:3000"
                                           << "[::1]:3000";
    QTest::newRow("no number") << "--connect robots.example:bot"
                               << "--connect";
    QTest::newRow("seed") << "--seed x"
                          << "--seed";
    QTest::newRow("port") << "--port 70000"
                          << "--port";
}

void tst_SimulatorSettings::aWrongServerIsNamed() {
    QFETCH(QString, words);
    QFETCH(QString, named);
    const auto target = targetOf(words);
    QVERIFY(!target);
    QVERIFY2(QString::fromStdString(target.error().text()).contains(named), target.error().text().c_str());
}

USAR_TEST(tst_SimulatorSettings)

} // namespace tst_simulator_settings

#include "tst_simulator_settings.moc"
