#include "core/sim/world/plant_csv.h"

#include <QByteArray>
#include <QObject>
#include <QTemporaryDir>
#include <QTest>

#include "tests/doubles/test_files.h"
#include "tests/doubles/test_worlds.h"
#include "tests/suite/suite.h"

namespace tst_plant_csv {

using usar::doubles::pathOf;
using usar::doubles::writeAll;

namespace {

const QByteArray heading = "kind,x,y,z,trunk_radius,trunk_height,crown_radius,crown_height\n";

} // namespace

class tst_PlantCsv : public QObject {
    Q_OBJECT

private slots:
    void writtenPlantsReadBackEqual() {
        const std::vector<usar::sim::Plant> plants = usar::doubles::woodedWorld(4, 200).plants;
        QVERIFY(usar::sim::writePlantCsv(plants, file()));
        const auto back = usar::sim::readPlantCsv(file());
        QVERIFY(back);
        QVERIFY(*back == plants);
    }

    void acceptsHandWrittenTables_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("plants");
        QTest::newRow("no plant") << heading << 0;
        QTest::newRow("a tree and a bush") << heading + "cone,1,2,3,0.2,4,1,5\nround,1,2,3,0,0,0.5,0\n" << 2;
        QTest::newRow("no line end at the end") << heading + "round,1,2,3,.2,4,1,0" << 1;
        QTest::newRow("line ends of another system")
            << QByteArray(
                   "kind,x,y,z,trunk_radius,trunk_height,crown_radius,crown_height\r\nround,-1,2e1,3,0.2,4,1,0\r\n")
            << 1;
        QTest::newRow("empty lines") << heading + "\nround,1,2,3,0.2,4,1,0\n\n" << 1;
    }
    void acceptsHandWrittenTables() {
        QFETCH(QByteArray, text);
        QFETCH(int, plants);
        writeAll(file(), text.toStdString());
        const auto read = usar::sim::readPlantCsv(file());
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QCOMPARE(static_cast<int>(read->size()), plants);
    }

    void refusesTheLineAndSaysWhich_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("line");
        const QByteArray good = "round,1,2,3,0.2,4,1,0\n";
        QTest::newRow("another heading") << QByteArray("x,y,z\n") << 1;
        QTest::newRow("unknown kind") << heading + good + "palm,1,2,3,0.2,4,1,0\n" << 3;
        QTest::newRow("too few columns") << heading + "round,1,2,3,0.2,4,1\n" << 2;
        QTest::newRow("too many columns") << heading + good + good + "round,1,2,3,0.2,4,1,0,9\n" << 4;
        QTest::newRow("only a kind") << heading + "round\n" << 2;
        QTest::newRow("a word for a number") << heading + "round,1,two,3,0.2,4,1,0\n" << 2;
        QTest::newRow("empty field") << heading + "\n" + "round,1,,3,0.2,4,1,0\n" << 3;
        QTest::newRow("not a number") << heading + "round,nan,2,3,0.2,4,1,0\n" << 2;
        QTest::newRow("infinite") << heading + "round,1,2,inf,0.2,4,1,0\n" << 2;
        QTest::newRow("negative radius") << heading + "round,1,2,3,-0.2,4,1,0\n" << 2;
        QTest::newRow("flat cone") << heading + "cone,1,2,3,0.2,4,1,0\n" << 2;
    }
    void refusesTheLineAndSaysWhich() {
        QFETCH(QByteArray, text);
        QFETCH(int, line);
        writeAll(file(), text.toStdString());
        const auto read = usar::sim::readPlantCsv(file());
        QVERIFY(!read);
        QCOMPARE(read.error().where, file().string() + ":" + std::to_string(line));
        QVERIFY(!read.error().what.empty() && !read.error().mend.empty());
    }

    void refusesAMissingFile() { QVERIFY(!usar::sim::readPlantCsv(pathOf(folder_) / "none.csv")); }

private:
    std::filesystem::path file() const { return pathOf(folder_) / "plants.csv"; }
    QTemporaryDir folder_;
};

USAR_TEST(tst_PlantCsv)

} // namespace tst_plant_csv

#include "tst_plant_csv.moc"
