#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "core/server/embedded/program_files.h"
#include "tests/suite/suite.h"

namespace tst_program_files {

using namespace usar;

class tst_ProgramFiles : public QObject {
    Q_OBJECT
private slots:
    void findsAWorldByItsName();
    void findsAWorldByItsFolder();
    void anUnknownWorldListsTheKnownOnes();
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
    QCOMPARE(QString::fromStdString(found.error().text()),
             QString("world moon: there is no such world. Known in %1 are: hill, marsh.").arg(worlds.path()));
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
