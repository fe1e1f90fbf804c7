#include <QTest>

#include "core/modules/query.h"
#include "core/protocol/command_writer.h"
#include "core/protocol/reader.h"
#include "tests/suite/suite.h"

namespace tst_query {

using namespace usar;
using namespace usar::modules;

namespace {

template <class Module>
QByteArray sent(Module& module, double now_s) {
    const std::optional<protocol::Command> command = module.next(Seconds(now_s));
    return command ? QByteArray::fromStdString(protocol::write(*command)) : QByteArray();
}

template <class Module>
void hear(Module& module, const std::string& line) {
    protocol::Reader reader;
    module.take(reader.read(line));
}

constexpr const char* sonar_geometry =
    "GEO {Type Sonar} {Name F1 Location 1,0,0 Orientation 0,0,0 Mount HARD} {Name F2 "
    "Location 2,0,0 Orientation 0,0,0 Mount HARD}";

} // namespace

class tst_Query : public QObject {
    Q_OBJECT
private slots:
    void anAnswerMakesItReady();
    void oneQuestionIsOutstandingAtATime();
    void asksAgainAfterASecond();
    void failsAfterThreeTriesAndCanBeAskedAgain();
    void saysWhichQuestionsFailedAndWhy();
    void aLostQuestionLetsOthersPass();
    void aLateAnswerStillCounts();
    void anUnaskedAnswerChangesOnlyWhatWasAskedFor();
    void askingTwiceChangesNothing();
    void aBareHeadMeansNoSuchThing_data();
    void aBareHeadMeansNoSuchThing();
    void matchesAnswersByTypeAndName_data();
    void matchesAnswersByTypeAndName();
    void configurationsWorkAlike();
};

void tst_Query::anAnswerMakesItReady() {
    GeometryModule geometry;
    QVERIFY(geometry.state("Sonar") == QueryState::Unknown);
    QVERIFY(sent(geometry, 0).isEmpty());
    geometry.query("Sonar");
    QVERIFY(geometry.state("sonar") == QueryState::Pending);
    QVERIFY(!geometry.answer("Sonar"));
    QCOMPARE(sent(geometry, 0), QByteArray("GETGEO {Type Sonar}"));
    QVERIFY(geometry.state("Sonar") == QueryState::Pending);
    hear(geometry, sonar_geometry);
    QVERIFY(geometry.state("Sonar") == QueryState::Ready);
    QCOMPARE(geometry.answer("Sonar")->items.size(), std::size_t(2));
    QVERIFY(sent(geometry, 9).isEmpty());
}

void tst_Query::oneQuestionIsOutstandingAtATime() {
    GeometryModule geometry;
    geometry.query("Sonar");
    geometry.query("Robot");
    QCOMPARE(sent(geometry, 0.0), QByteArray("GETGEO {Type Sonar}"));
    QVERIFY(sent(geometry, 0.2).isEmpty());
    QVERIFY(sent(geometry, 0.99).isEmpty());
    hear(geometry, sonar_geometry);
    QCOMPARE(sent(geometry, 0.99), QByteArray("GETGEO {Type Robot}"));
}

void tst_Query::asksAgainAfterASecond() {
    GeometryModule geometry;
    geometry.query("Sonar", "F1");
    QCOMPARE(sent(geometry, 10.0), QByteArray("GETGEO {Type Sonar} {Name F1}"));
    QVERIFY(sent(geometry, 10.9).isEmpty());
    QCOMPARE(sent(geometry, 11.0), QByteArray("GETGEO {Type Sonar} {Name F1}"));
    QVERIFY(sent(geometry, 11.9).isEmpty());
}

void tst_Query::failsAfterThreeTriesAndCanBeAskedAgain() {
    GeometryModule geometry;
    geometry.query("Laser");
    for (const double now_s : {0.0, 1.0, 2.0})
        QVERIFY(!sent(geometry, now_s).isEmpty());
    QVERIFY(geometry.state("Laser") == QueryState::Pending);
    QVERIFY(sent(geometry, 3.0).isEmpty());
    QVERIFY(geometry.state("Laser") == QueryState::Failed);
    geometry.query("Laser");
    QVERIFY(geometry.state("Laser") == QueryState::Pending);
    for (const double now_s : {4.0, 5.0, 6.0})
        QVERIFY(!sent(geometry, now_s).isEmpty());
    QVERIFY(sent(geometry, 7.0).isEmpty());
    QVERIFY(geometry.state("Laser") == QueryState::Failed);
}

void tst_Query::saysWhichQuestionsFailedAndWhy() {
    GeometryModule geometry;
    geometry.query("Laser");
    sent(geometry, 0);
    hear(geometry, "GEO {Type Laser}");
    geometry.query("Sonar", "F9");
    for (int now_s = 1; now_s < 9; ++now_s)
        sent(geometry, now_s);
    const auto failures = geometry.takeFailures();
    QCOMPARE(failures.size(), std::size_t(2));
    QCOMPARE(failures[0].type, std::string("Laser"));
    QVERIFY(failures[0].no_such_thing);
    QCOMPARE(failures[1].name, std::string("F9"));
    QVERIFY(!failures[1].no_such_thing);
    QVERIFY(geometry.takeFailures().empty());
}

void tst_Query::aLostQuestionLetsOthersPass() {
    GeometryModule geometry;
    geometry.query("Laser");
    geometry.query("Sonar");
    QCOMPARE(sent(geometry, 0.0), QByteArray("GETGEO {Type Laser}"));
    QCOMPARE(sent(geometry, 1.0), QByteArray("GETGEO {Type Sonar}"));
    hear(geometry, sonar_geometry);
    QCOMPARE(sent(geometry, 1.2), QByteArray("GETGEO {Type Laser}"));
}

void tst_Query::aLateAnswerStillCounts() {
    GeometryModule geometry;
    geometry.query("Sonar");
    geometry.query("Robot");
    sent(geometry, 0.0);
    QCOMPARE(sent(geometry, 1.0), QByteArray("GETGEO {Type Robot}"));
    hear(geometry, sonar_geometry);
    QVERIFY(geometry.state("Sonar") == QueryState::Ready);
    QVERIFY(sent(geometry, 1.2).isEmpty()); // the robot is still being asked about
    hear(geometry, "GEO {Type AerialVehicle} {Name AirRobot} {Dimensions 1,1,0.2}");
    QVERIFY(sent(geometry, 1.4).isEmpty()); // and the sonars are not asked again
}

void tst_Query::anUnaskedAnswerChangesOnlyWhatWasAskedFor() {
    ConfigurationModule configuration;
    hear(configuration, "CONF {Type Camera} {Name Camera}{CameraDefFov 80.0000}");
    QVERIFY(configuration.state("Camera") == QueryState::Unknown);
    configuration.query("Camera");
    hear(configuration, "CONF {Type Camera} {Name Camera}{CameraDefFov 70.0000}");
    QVERIFY(configuration.state("Camera") == QueryState::Ready);
    QCOMPARE(configuration.answer("Camera")->items[0].number("CameraDefFov").value(), 70.0);
    QVERIFY(sent(configuration, 0.0).isEmpty());
}

void tst_Query::askingTwiceChangesNothing() {
    GeometryModule geometry;
    geometry.query("Sonar");
    geometry.query("SONAR");
    sent(geometry, 0.0);
    geometry.query("Sonar");
    hear(geometry, sonar_geometry);
    geometry.query("Sonar");
    QVERIFY(geometry.state("Sonar") == QueryState::Ready);
    QVERIFY(sent(geometry, 5.0).isEmpty());
}

void tst_Query::aBareHeadMeansNoSuchThing_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("body");
    QTest::newRow("of a type") << QByteArray() << QByteArray("{Type Laser}");
    QTest::newRow("of a name") << QByteArray("Nobody") << QByteArray("{Type Laser} {Name Nobody}");
}

void tst_Query::aBareHeadMeansNoSuchThing() {
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, body);
    GeometryModule geometry;
    geometry.query("Laser", name.toStdString());
    sent(geometry, 0.0);
    hear(geometry, "GEO " + body.toStdString());
    QVERIFY(geometry.state("Laser", name.toStdString()) == QueryState::Failed);
    QVERIFY(!geometry.answer("Laser", name.toStdString()));
    QVERIFY(sent(geometry, 5.0).isEmpty());

    ConfigurationModule configuration;
    configuration.query("Laser", name.toStdString());
    sent(configuration, 0.0);
    hear(configuration, "CONF " + body.toStdString());
    QVERIFY(configuration.state("Laser", name.toStdString()) == QueryState::Failed);
}

void tst_Query::matchesAnswersByTypeAndName_data() {
    QTest::addColumn<QByteArray>("type");
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<bool>("matches");
    const auto row = [](const char* title, const char* type, const char* name, const char* answer, bool matches) {
        QTest::newRow(title) << QByteArray(type) << QByteArray(name) << QByteArray(answer) << matches;
    };
    row("the type", "Sonar", "", sonar_geometry, true);
    row("another type", "Camera", "", sonar_geometry, false);
    row("a name among them, any case", "Sonar", "f2", sonar_geometry, true);
    row("another name", "Sonar", "F9", sonar_geometry, false);
    row("a bare head of another type", "Sonar", "F9", "GEO {Type Laser}", false);
    row("a robot by its kind", "Robot", "", "GEO {Type AerialVehicle} {Name AirRobot} {Dimensions 1,1,0.2}", true);
    row("a robot by its class", "robot", "R1", "GEO {Type AerialVehicle} {Name AirRobot} {Dimensions 1,1,0.2}", true);
    row("UDK's robot without a kind", "Robot", "", "GEO {Name AirRobot}", true);
    row("sonars are no robot", "Robot", "", sonar_geometry, false);
    row("a robot is no sonar", "Sonar", "", "GEO {Type AerialVehicle} {Name AirRobot} {Dimensions 1,1,0.2}", false);
    row("links of a package by its name", "MisPkg", "CameraPanTilt",
        "GEO {Type MisPkg} {Name CameraPanTilt} {Link 1} {ParentLink -1} {Location 1,0,0} {Orientation 0,0,0}", true);
    row("no answer at all", "Sonar", "", "STA {Time 1} {Battery 5}", false);
}

void tst_Query::matchesAnswersByTypeAndName() {
    QFETCH(QByteArray, type);
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, answer);
    QFETCH(bool, matches);
    GeometryModule geometry;
    geometry.query(type.toStdString(), name.toStdString());
    sent(geometry, 0.0);
    hear(geometry, answer.toStdString());
    QVERIFY(geometry.state(type.toStdString(), name.toStdString()) ==
            (matches ? QueryState::Ready : QueryState::Pending));
}

void tst_Query::configurationsWorkAlike() {
    ConfigurationModule configuration;
    configuration.query("Robot");
    QCOMPARE(sent(configuration, 0.0), QByteArray("GETCONF {Type Robot}"));
    hear(configuration, "CONF {Type Sonar} {Name F1} {MaxRange 5.0}");
    QVERIFY(configuration.state("Robot") == QueryState::Pending);
    hear(configuration, "CONF {Type AerialVehicle} {Name AirRobot} {MaxLinearVelocity 5.0}");
    QCOMPARE(configuration.answer("Robot")->items[0].number("maxlinearvelocity").value(), 5.0);
}

USAR_TEST(tst_Query)

} // namespace tst_query

#include "tst_query.moc"
