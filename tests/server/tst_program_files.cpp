#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "core/server/embedded/program_files.h"
#include "core/server/embedded/simulator_files.h"
#include "core/sim/world/world_generator.h"
#include "tests/suite/suite.h"

namespace tst_program_files {

using namespace usar;

class tst_ProgramFiles : public QObject {
    Q_OBJECT
private slots:
    void findsAWorldByItsName();
    void findsAWorldByItsFolder();
    void anUnknownWorldListsTheKnownOnes();
    void aNameAndASeedAreAWorldOfItsKind_data();
    void aNameAndASeedAreAWorldOfItsKind();
    void aSeededWorldIsMadeAsByItsGenerator();
    void whereThereIsNoWorldAtAllTheMendIsTold_data();
    void whereThereIsNoWorldAtAllTheMendIsTold();
};

void tst_ProgramFiles::findsAWorldByItsName() {
    QTemporaryDir worlds;
    QVERIFY(QDir(worlds.path()).mkdir("marsh"));
    QCOMPARE(server::findWorldIn(worlds.path(), "marsh").value_or(""), worlds.filePath("marsh"));
}

void tst_ProgramFiles::findsAWorldByItsFolder() {
    QTemporaryDir elsewhere;
    QCOMPARE(server::findWorldIn("/no/worlds", elsewhere.path()).value_or(""), elsewhere.path());
}

void tst_ProgramFiles::anUnknownWorldListsTheKnownOnes() {
    QTemporaryDir worlds;
    QVERIFY(QDir(worlds.path()).mkdir("marsh") && QDir(worlds.path()).mkdir("hill"));
    const auto found = server::findWorldIn(worlds.path(), "moon");
    QVERIFY(!found);
    QCOMPARE(
        QString::fromStdString(found.error().text()),
        QString(
            "world moon: there is no such world. Known in %1 are: hill, marsh; a name and a seed make another one of "
            "its kind, such as town:7.")
            .arg(worlds.path()));
}

void tst_ProgramFiles::aNameAndASeedAreAWorldOfItsKind_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("generator"); // empty: it is no world from a seed
    QTest::addColumn<quint64>("seed");
    QTest::newRow("a seed") << "town:7"
                            << "town" << quint64(7);
    QTest::newRow("zero") << "tall_test:0"
                          << "tall_test" << quint64(0);
    QTest::newRow("the largest") << "town:999999999"
                                 << "town" << quint64(999999999);
    QTest::newRow("too large") << "town:1000000000"
                               << "" << quint64(0);
    QTest::newRow("no seed") << "town:"
                             << "" << quint64(0);
    QTest::newRow("a name alone") << "town"
                                  << "" << quint64(0);
    QTest::newRow("a negative seed") << "town:-1"
                                     << "" << quint64(0);
    QTest::newRow("a path") << "/worlds/town:7"
                            << "" << quint64(0);
}

void tst_ProgramFiles::aNameAndASeedAreAWorldOfItsKind() {
    QFETCH(QString, name);
    QFETCH(QString, generator);
    QFETCH(quint64, seed);
    const auto seeded = server::seededWorld(name);
    QCOMPARE(seeded.has_value(), !generator.isEmpty());
    if (seeded) {
        QCOMPARE(seeded->generator, generator);
        QCOMPARE(seeded->seed, seed);
    }
}

void tst_ProgramFiles::aSeededWorldIsMadeAsByItsGenerator() {
    const auto seventh = server::loadWorld("town:7");
    const auto eighth = server::loadWorld("town:8");
    QVERIFY2(seventh && eighth, seventh ? "" : seventh.error().text().c_str());
    QVERIFY(*seventh == sim::makeWorld("town", 7, {}).value());
    QVERIFY(!(*seventh == *eighth));
    QVERIFY2(server::loadWorld("volcano:2"), "the measured heights are not where the programs look for them");
    QCOMPARE(server::loadWorld("moon:1").error().text().substr(0, 41),
             std::string("moon: there is no generator for this worl"));
}

void tst_ProgramFiles::whereThereIsNoWorldAtAllTheMendIsTold_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("a name") << "moon";
    QTest::newRow("a path") << "/no/moon";
    QTest::newRow("nothing") << "";
}

void tst_ProgramFiles::whereThereIsNoWorldAtAllTheMendIsTold() {
    QFETCH(QString, name);
    const auto found = server::findWorldIn("/no/worlds", name);
    QVERIFY(!found);
    const QString text = QString::fromStdString(found.error().text());
    QVERIFY2(text.contains("There is none at all in /no/worlds; build or install"), qPrintable(text));
}

USAR_TEST(tst_ProgramFiles)

} // namespace tst_program_files

#include "tst_program_files.moc"
